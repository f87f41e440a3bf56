// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one agent perceived, in columns: its state by fields, tracks, warnings, radar and
/// the zone of the missile in hand.
#include <optional>
#include <string>
#include <vector>

#include "driver/state.hpp"
#include "model/frames.hpp"
#include "page/decisions.hpp"
#include "pilot/state.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::page {

/// A place in the scenario's local frame as one on the map.
struct OnMap {
  double east = 0, north = 0, up = 0, turn = 0;
};
[[nodiscard]] OnMap on_map(const Reference& reference, const Vec3& position);

class Sights {
 public:
  Sights(const scenario::Scenario& scenario, TextBook& texts);

  /// `radar` is null for who has none.
  void add(const pilot::State& state, const model::RadarState* radar);
  void add(const driver::State& state);
  /// s, of the last one; before the run if there is none.
  [[nodiscard]] double last_time() const { return last_time_; }
  [[nodiscard]] Json json(ColumnBytes& bytes) const;

 private:
  template <class State>
  void add_state(const State& state);
  void add_track(std::uint32_t id, PlayerId truth, model::Identity identity, bool target,
                 const Vec3& position, double age);
  void add_warning(const std::string& kind, double bearing, double range, PlayerId truth);
  void add_zone(const pilot::State& state);

  const scenario::Scenario& scenario_;
  TextBook& texts_;
  double last_time_ = -1e9;
  Column t_{1e-3};
  std::vector<Column> state_;
  // of tracks and warnings, how many there were each time, and all of them
  Column track_counts_, warning_counts_;
  Columns tracks_{{"id"},   {"truth"}, {"identity"}, {"target"},
                  {"east"}, {"north"}, {"up"},       {"age", 0.1}};
  Columns warnings_{{"kind"}, {"bearing", 1e-3}, {"range", 10}, {"name"}};
  // of pilots only
  Columns scan_{{"mode"}, {"azimuth", 1e-3}, {"elevation", 1e-3}};
  Columns zone_{{"min", 10}, {"no_escape", 10}, {"max", 10}};
};

}  // namespace eyrie::page
