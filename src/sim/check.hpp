// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a step must not do: leave numbers that are none, or write what only another may.
#include "sim/difference.hpp"
#include "sim/event.hpp"
#include "sim/schema.hpp"
#include "sim/system.hpp"
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
  /// A column with numbers, each row as words of 32 bits. Where a number's exponent lies the mask
  /// has ones, and `lowest` its lowest bit: added to an exponent of ones only, it carries into the
  /// sign.
  struct Words {
    std::uint32_t column = 0;
    std::vector<std::uint32_t> mask = {}, lowest = {};
  };
  std::vector<Words> columns_;
};

/// Watches the systems of a step, one after the other, and keeps the first that breaks a rule:
///   * a column whose writers are described (SchemaBuilder::set_writers) changes only by them, in
///     their phases; ids never change, and marks to leave only in commit;
///   * in a parallel phase a row writes only itself: looked at in one row per step, in turn;
///   * in a parallel phase no row reads what another one writes there: rows that run one by one
///     from the last to the first come to the same.
/// A step costs several times as much with it.
class WriteCheck {
 public:
  explicit WriteCheck(const World& like) : before_(like), last_(like) {}

  /// Before a system runs.
  void begin(const World& world) { before_ = world; }
  /// After it has run in one of the serial phases.
  void end(const World& world, const System& system, Phase phase);
  /// After it has run in a parallel phase; `again` runs it for some rows of another world, and
  /// nobody hears what it tells.
  void end(const World& world, const System& system, Phase phase,
           const std::function<void(World&, Chunk)>& again);

  /// The first breach, until it is taken.
  [[nodiscard]] std::optional<Difference> take() { return std::exchange(found_, std::nullopt); }

 private:
  void compare_columns(const World& world, const System& system, Phase phase);
  void note(std::optional<Difference> difference, const System& system, Phase phase,
            const std::string& rule);

  World before_, last_;
  std::optional<Difference> found_;
};

}  // namespace eyrie::sim
