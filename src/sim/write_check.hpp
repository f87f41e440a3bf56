// SPDX-License-Identifier: MIT
#pragma once
/// \file  Who writes what, and when: the rule of a phase, checked instead of believed.
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "sim/difference.hpp"
#include "sim/system.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

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
