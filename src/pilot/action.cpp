// SPDX-License-Identifier: MIT
#include "pilot/action.hpp"

#include <fmt/format.h>

#include <cmath>

namespace eyrie::pilot {

std::string to_text(const Follow& follow) {
  std::string text;
  const auto add = [&](double meters, const char* positive, const char* negative) {
    if (meters != 0)
      text += fmt::format("{}{:.0f} m {}", text.empty() ? "" : ", ", std::fabs(meters),
                          meters > 0 ? positive : negative);
  };
  add(follow.offset.x, "ahead", "behind");
  add(follow.offset.y, "right", "left");
  add(follow.offset.z, "below", "above");
  return text.empty() ? "in its place" : text;
}

std::string to_text(const Release& release) {
  return fmt::format("store {} at #{}", release.store, release.track.value);
}

}  // namespace eyrie::pilot
