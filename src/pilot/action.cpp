// SPDX-License-Identifier: MIT
#include "pilot/action.hpp"

namespace eyrie::pilot {

std::optional<ubf::ImplausiblePart> implausible_part(const Follow& follow) {
  constexpr ubf::Plausible kNumber{-1e9, 1e9};
  const auto part = [&](std::string_view name,
                        const Vec3& v) -> std::optional<ubf::ImplausiblePart> {
    for (const double x : {v.x, v.y, v.z})
      if (!kNumber.holds(x)) [[unlikely]]
        return ubf::ImplausiblePart{name, x};
    return std::nullopt;
  };
  if (const auto wrong = part("position", follow.position))
    return wrong;
  if (const auto wrong = part("velocity", follow.velocity))
    return wrong;
  if (!kNumber.holds(follow.time)) [[unlikely]]
    return ubf::ImplausiblePart{"time", follow.time};
  return part("offset", follow.offset);
}

std::string to_text(const Follow& follow) {
  std::string text;
  const auto add = [&](double meters, const char* positive, const char* negative) {
    if (meters != 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ",
                          format_quantity(std::fabs(meters), Dimension::length),
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
