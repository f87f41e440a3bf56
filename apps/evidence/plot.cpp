// SPDX-License-Identifier: MIT
/// \file  Curves and points as SVG.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "evidence.hpp"

namespace eyrie::evidence {
namespace {

constexpr double kWidth = 640, kHeight = 400;  // of the picture
constexpr double kLeft = 60, kRight = 150, kTop = 36, kBottom = 48;
constexpr const char* kColors[] = {"#1f6fb4", "#d1511f", "#2a8c4a", "#8a4fb0",
                                   "#b08a1f", "#555555", "#c02f6a", "#1f9aa8"};

/// Linear in an interval that ends at round numbers.
struct Scale {
  Scale(double low, double high, double from, double to) : pixel_from(from), pixel_to(to) {
    const double rough = std::max(high - low, 1e-12) / 6;
    double unit = 1;
    while (unit > rough)
      unit /= 10;
    while (unit * 10 <= rough)
      unit *= 10;
    step = rough > 5 * unit ? 10 * unit : rough > 2 * unit ? 5 * unit : 2 * unit;
    first = std::floor(low / step + 1e-9) * step;
    last = std::ceil(high / step - 1e-9) * step;
  }
  [[nodiscard]] double pixel(double value) const {
    return pixel_from + (value - first) / (last - first) * (pixel_to - pixel_from);
  }
  [[nodiscard]] int ticks() const { return static_cast<int>(std::lround((last - first) / step)); }
  [[nodiscard]] double tick(int i) const { return first + i * step; }

  double pixel_from, pixel_to, first = 0, last = 1, step = 1;
};

std::string text(double x, double y, const char* anchor, const std::string& what,
                 const char* more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y,
                     anchor, more, xml_text(what));
}

std::string line(double x1, double y1, double x2, double y2, const char* color) {
  return fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\"/>\n", x1, y1, x2,
      y2, color);
}

}  // namespace

std::string svg(const Plot& plot) {
  double low_x = 1e300, high_x = -1e300, high_y = -1e300;
  for (const Series& s : plot.series)
    for (const Point& p : s.points)
      if (p.y >= plot.from_y) {
        low_x = std::min(low_x, p.x);
        high_x = std::max(high_x, p.x);
        high_y = std::max(high_y, p.y);
      }
  const Scale x(low_x, high_x, kLeft, kWidth - kRight);
  const Scale y(plot.from_y, high_y, kHeight - kBottom, kTop);

  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"11\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      kWidth, kHeight);
  out += text(kLeft, 20, "start", plot.title, " font-size=\"14\"");
  for (int i = 0; i <= x.ticks(); ++i) {
    out += line(x.pixel(x.tick(i)), kTop, x.pixel(x.tick(i)), kHeight - kBottom, "#e4e4e4");
    out += text(x.pixel(x.tick(i)), kHeight - kBottom + 16, "middle",
                fmt::format("{:.6g}", x.tick(i) + 0.0));
  }
  for (int i = 0; i <= y.ticks(); ++i) {
    out += line(kLeft, y.pixel(y.tick(i)), kWidth - kRight, y.pixel(y.tick(i)), "#e4e4e4");
    out += text(kLeft - 6, y.pixel(y.tick(i)) + 4, "end", fmt::format("{:.6g}", y.tick(i) + 0.0));
  }
  out += text((kLeft + kWidth - kRight) / 2, kHeight - 12, "middle", plot.x);
  out += text(kLeft, kTop - 6, "end", plot.y);

  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    const char* color = kColors[i % std::size(kColors)];
    const double beside = kTop + 12 + 16 * static_cast<double>(i);
    out += text(kWidth - kRight + 26, beside + 4, "start", s.name);
    if (s.published) {
      for (const Point& p : s.points)
        out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n",
                           x.pixel(p.x), y.pixel(p.y), color);
      out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\" fill=\"{}\"/>\n",
                         kWidth - kRight + 16, beside, color);
      continue;
    }
    out += line(kWidth - kRight + 8, beside, kWidth - kRight + 22, beside, color);
    std::string path;
    bool drawing = false;
    for (const Point& p : s.points) {
      const bool seen = p.y >= plot.from_y;
      if (seen)
        path += fmt::format("{}{:.1f} {:.1f}", drawing ? " " : "M", x.pixel(p.x), y.pixel(p.y));
      drawing = seen;  // below the picture the curve breaks off
    }
    out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path,
                       color);
  }
  return out + "</svg>\n";
}

}  // namespace eyrie::evidence
