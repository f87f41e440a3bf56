// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a learned behavior commands: named controls, each a number in [-1, 1].
#include "model/tasking.hpp"
#include "pilot/policy/layout.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// One thing that can be commanded, and how it becomes what a person at the controls would ask for.
struct ControlType {
  std::string_view name;
  std::string_view help;
  /// A bit for each thing that it commands: no two controls of one list command the same.
  std::uint16_t commands = 0;
  /// Where it starts from: what its number is added to, if it is; of a flag 0 if it could do
  /// nothing now.
  double (*from)(const State&) = nullptr;
  /// Writes, from there, a number in SI, or of a flag 1 or 0.
  void (*apply)(double from, double x, model::Manual&) = nullptr;
  Unit unit = {};  ///< of a number
  /// What a file may give as the range; a flag has none and is on above 0.
  double least = 0, most = 0;

  [[nodiscard]] constexpr bool is_flag() const { return least == most; }
};
/// No list has more controls: each commands something that no other one of it does.
inline constexpr std::size_t kMostControls = 16;
/// All there are, in the order of the reference.
[[nodiscard]] std::span<const ControlType> control_types();

/// One number of a policy's answer: -1 is low, 1 is high, and it is not taken beyond them.
struct Control {
  std::uint32_t type = 0;    ///< index into control_types()
  double low = 0, high = 1;  ///< in SI; of a number
  bool cubic = false;        ///< x^3 counts instead of x: fine in the middle, coarse at the ends

  [[nodiscard]] const ControlType& info() const { return control_types()[type]; }
  /// The number in SI, or of a flag 1 or 0, for one in [-1, 1].
  [[nodiscard]] double value(float unit) const;
  /// Its line of a layout, which may command nothing that one before it does; and back.
  static std::optional<Control> read(LayoutLine& line, std::span<const Control> before);
  [[nodiscard]] std::string text() const;
};

/// An ordered list of controls: the layout of what comes out of a policy. As text it has a line for
/// each: the name of a control and, unless it is a flag, a range, and perhaps `cubic`.
///
///   turn -90 deg 90 deg cubic
///   climb -30 deg 30 deg
///   release
class Controls : public Layout<Control> {
 public:
  Controls() = default;
  explicit Controls(std::string_view text, const Location& where = {"controls", 1, 1})
      : Layout(text, where) {}

  /// All that apply() and mask() need to know of a state.
  struct Start {
    TrackId target{};                          ///< whom the pilot attacks; none: nobody
    std::array<double, kMostControls> from{};  ///< of each control
  };
  [[nodiscard]] Start start(const State& state) const;

  /// What a person who wants this would ask for: as the payload of OrderKind::manual it is flown,
  /// and by fly_by_hand() it becomes an action. It attacks the pilot's target. `units`: size() of
  /// them; one that is NaN commands nothing. Allocates nothing.
  [[nodiscard]] model::Manual apply(const Start& start, std::span<const float> units) const;
  [[nodiscard]] model::Manual apply(const State& state, std::span<const float> units) const {
    return apply(start(state), units);
  }
  /// Writes size() times 1 if the control could do anything now, else 0.
  void mask(const Start& start, std::uint8_t* out) const;
};

}  // namespace eyrie::pilot
