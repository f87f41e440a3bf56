// SPDX-License-Identifier: MIT
#include "arguments.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "commands.hpp"
#include "core/diagnostics.hpp"

namespace eyrie::app {

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

std::string format_problem(const std::string& text) {
  constexpr auto kNames = enum_names<ExportFormat>();
  const bool known = std::find(kNames.begin(), kNames.end(), text) != kNames.end();
  return known ? std::string{}
               : fmt::format("must be one of {}, got {}{}", fmt::join(kNames, ", "), quote(text),
                             did_you_mean(text, kNames));
}

}  // namespace eyrie::app
