// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one agent perceived, in columns: its state by fields, tracks, warnings, radar and
/// the zone of the missile in hand.
#include <optional>
#include <string>
#include <vector>

#include "driver/state.hpp"
#include "model/frames.hpp"
#include "page/json.hpp"
#include "page/text_book.hpp"
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
  void add_track(std::int64_t id, PlayerId truth, model::Identity identity, bool target,
                 const Vec3& position, double age);
  void add_warning(const std::string& kind, double bearing, double range, PlayerId truth);
  void add_zone(const pilot::State& state);
  void end_sight();

  struct Tracks {
    Column count, id, truth, identity, target, east{1}, north{1}, up{1}, age{0.1};
  };
  struct Warnings {
    Column count, kind, bearing{1e-3}, range{10}, name;
  };

  const scenario::Scenario& scenario_;
  TextBook& texts_;
  double last_time_ = -1e9;
  Column t_{1e-3};
  std::vector<Column> state_;
  Tracks tracks_;
  Warnings warnings_;
  std::int64_t track_count_ = 0, warning_count_ = 0;
  Column mode_, azimuth_{1e-3}, elevation_{1e-3};
  Column least_{10}, no_escape_{10}, most_{10};
};

}  // namespace eyrie::page
