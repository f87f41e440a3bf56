// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a learned behavior sees: features of the pilot's state, each a number in [-1, 1].
#include "pilot/policy/layout.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// What a feature makes of a state field.
enum class Transform : std::uint8_t {
  linear,   ///< low to high as -1 to 1; beyond them it stays there
  sine,     ///< of an angle
  cosine,   ///< of an angle
  present,  ///< 1 if the field has a value, else 0
};
constexpr auto names_of(Transform) {
  return names_from_zero<Transform>("linear", "sine", "cosine", "present");
}

/// One number of an observation. Without a value of the field it is 0, however it is transformed.
struct Feature {
  std::uint32_t field = 0;  ///< index into ubf::StateFields<State>::all()
  Transform transform = Transform::linear;
  double low = -1, high = 1;  ///< in SI; of linear only

  [[nodiscard]] const ubf::StateFieldInfo& info() const;
  /// Its line of a layout, and back.
  static std::optional<Feature> read(LayoutLine& line, std::span<const Feature> before);
  [[nodiscard]] std::string text() const;
};

/// An ordered list of features: the layout of what goes into a policy. As text it has a line for
/// each, the name of a state field (docs/reference.md), a transform, and for linear a range:
///
///   range linear 0 nmi 40 nmi
///   target_right sine
///   target_right cosine
///   missile_range present
class Observation : public Layout<Feature> {
 public:
  Observation() = default;
  explicit Observation(std::string_view text, const Location& where = {"observation", 1, 1})
      : Layout(text, where) {}
  /// Writes size() numbers in [-1, 1], never NaN. Allocates nothing.
  void write(const State& state, float* out) const;
};

}  // namespace eyrie::pilot
