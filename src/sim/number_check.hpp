// SPDX-License-Identifier: MIT
#pragma once
/// \file  Whether every number of a world is one.
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/fault.hpp"
#include "sim/schema.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// Looks for NaN and infinities in all columns of worlds of one schema, but not in columns of
/// bytes.
class NumberCheck {
 public:
  explicit NumberCheck(const Schema& schema);

  /// The first of them, as a fault of its player: "kinematics.position.x is nan m".
  [[nodiscard]] std::optional<Fault> find(const World& world) const;

 private:
  /// Numbers of one width that lie side by side in every row of a column.
  struct Stretch {
    std::uint32_t column, offset, count;
    Scalar type;
  };
  std::vector<Stretch> stretches_;
};

}  // namespace eyrie::sim
