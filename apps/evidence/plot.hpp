// SPDX-License-Identifier: MIT
#pragma once
/// \file  Curves and points as SVG: the same bytes wherever they are drawn.
#include <string>
#include <vector>

namespace eyrie::evidence {

struct Point {
  double x, y;
};

/// A curve, or points that stand for what others have measured or published.
struct Series {
  std::string name;
  std::vector<Point> points;
  bool published = false;  ///< drawn as points, not as a curve
};

/// One picture: docs/models/plots/<file>.svg.
struct Plot {
  std::string file, title, x, y;
  std::vector<Series> series{};
  double from_y = 0;  ///< lowest ordinate shown; curves below are cut off
};

[[nodiscard]] std::string svg(const Plot& plot);

}  // namespace eyrie::evidence
