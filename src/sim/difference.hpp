// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where two worlds part: the step, table, column, row, player and field, in words.
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/id.hpp"
#include "sim/event.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// The first place at which two worlds, or two digests, are not the same.
struct Difference {
  std::uint64_t step = 0;  ///< of the left world
  std::string table{};     ///< empty: in the header of the world
  std::string column{};
  std::optional<std::uint32_t> row{};
  PlayerId player{};    ///< none if it is not about one row
  std::string field{};  ///< empty if only the row is known
  std::string left{};   ///< empty if the values are not known (digests)
  std::string right{};
  std::string rule{};  ///< who broke which rule of a step, if that was found (sim/write_check.hpp)

  /// `step 120: aircraft.kinematics.position.x of player 4 (row 3) is 1.5, and 1.25 in the other`
  [[nodiscard]] std::string text() const;
};

/// Nothing if the worlds are equal: header first, then tables, columns, rows and fields in the
/// order of the schema. Values are compared by their bits. The capacities may differ; worlds of
/// different layouts throw std::logic_error.
[[nodiscard]] std::optional<Difference> first_difference(const World& left, const World& right);

/// Nothing if the rows that both have are the same in one column.
[[nodiscard]] std::optional<Difference> first_difference(const World& left, const World& right,
                                                         std::uint32_t column);

/// Nothing if both steps gave the same events; `step` is only put into the answer.
[[nodiscard]] std::optional<Difference> first_difference(std::uint64_t step,
                                                         std::span<const Event> left,
                                                         std::span<const Event> right);

}  // namespace eyrie::sim
