// SPDX-License-Identifier: MIT
#pragma once
/// \file  Small words of the kernel: what kind an event or an order is, and the parts of a step.
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "core/field.hpp"

namespace eyrie::sim {

/// The kind of an event or an order. The kernel only counts and names kinds; a domain keeps its
/// own `enum class ... : std::uint16_t` and converts without a cast. KindCode 0 means none.
template <class Tag>
struct KindCode {
  std::uint16_t value = 0;

  constexpr KindCode() = default;
  constexpr explicit KindCode(std::uint16_t v) : value(v) {}
  template <class Enum>
  requires std::is_enum_v<Enum> && std::same_as<std::underlying_type_t<Enum>, std::uint16_t>
  constexpr KindCode(Enum e)
      : value(static_cast<std::uint16_t>(e)) {}  // NOLINT: implicit on purpose

  /// The kind as the domain's own enumeration, for a switch.
  template <class Enum>
  [[nodiscard]] constexpr Enum as() const {
    return static_cast<Enum>(value);
  }
  constexpr explicit operator bool() const { return value != 0; }
  friend constexpr auto operator<=>(const KindCode&, const KindCode&) = default;

  static constexpr auto fields() { return field_list(field("value", &KindCode::value)); }
};

using EventKind = KindCode<struct EventTag>;
using OrderKind = KindCode<struct OrderTag>;

/// The parts of a step, in the order in which they run and in which their events are sorted.
enum class Phase : std::uint8_t { orders, perceive, decide, act, move, interact, commit };
inline constexpr std::size_t kPhases = 7;
[[nodiscard]] std::string_view phase_name(Phase phase);

/// A system that writes a column, by its name (a literal), and when.
struct WrittenBy {
  std::string_view system;
  Phase phase = Phase::orders;
  friend constexpr bool operator==(const WrittenBy&, const WrittenBy&) = default;
};

}  // namespace eyrie::sim
