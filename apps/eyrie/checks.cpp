// SPDX-License-Identifier: MIT
#include "checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <utility>
#include <vector>

#include "core/diagnostics.hpp"

namespace eyrie::app {
namespace {

constexpr std::array<std::pair<std::string_view, ExportFormat>, 3> kFormats{
    {{"czml", ExportFormat::czml},
     {"geojson", ExportFormat::geojson},
     {"decisions", ExportFormat::decisions}}};
}  // namespace

std::function<std::string(const std::string&)> whole_number(std::uint64_t least,
                                                            std::uint64_t most) {
  return [=](const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool good = failed == std::errc{} && end == text.data() + text.size() && value >= least &&
                      value <= most;
    return good ? std::string{}
                : fmt::format("{} is no whole number from {} to {}", quote(text), least, most);
  };
}

std::string pace(const std::string& text) {
  constexpr double kSlowest = 0.001, kFastest = 1000;
  double value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool good = failed == std::errc{} && end == text.data() + text.size() &&
                    value >= kSlowest && value <= kFastest;
  return good ? std::string{}
              : fmt::format("{} is no number from {} to {}", quote(text), kSlowest, kFastest);
}

std::optional<ExportFormat> format_named(std::string_view name) {
  for (const auto& [known, format] : kFormats)
    if (known == name)
      return format;
  return std::nullopt;
}

std::string format_problem(const std::string& text) {
  std::vector<std::string_view> names;
  for (const auto& [name, format] : kFormats)
    names.push_back(name);
  return format_named(text) ? std::string{}
                            : fmt::format("must be one of {}, got {}{}", fmt::join(names, ", "),
                                          quote(text), did_you_mean(text, names));
}

}  // namespace eyrie::app
