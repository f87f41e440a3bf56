// SPDX-License-Identifier: MIT
#pragma once
/// \file  A flight as the debrief page reads it (viewer/src/run/decode.ts).
#include "debrief/recorded.hpp"

namespace eyrie::page {

/// Told s of simulated time now and then while a run is flown again; false gives up.
using Progress = std::function<bool(double)>;

/// With more players than this decisions are kept when they are other ones than before, and once a
/// second, motions once a second, and what is seen every five seconds.
inline constexpr std::size_t kManyPlayers = 16;
/// With more simulated time than this, summed over the players (s), all of that is kept so much
/// less often that it stays as large as here; and of other decisions ten where one would be kept
/// anyway.
inline constexpr double kManyPlayerSeconds = 60'000;

/// What a page says of a flight besides what was seen of it.
struct FlightFacts {
  std::string file, build, outcome;
  std::uint64_t seed = 0, hash = 0, steps = 0;
};
[[nodiscard]] FlightFacts facts_of(const debrief::Recorded& recorded);

/// Watches a flight and packs what the page shows of it, of a part as well as of the whole.
class Packer : public sim::Observer {
 public:
  /// What had happened in a run before this flight branches off at `world`, step by step: its
  /// story, and whose missiles are in the air. Before it observes anything.
  virtual void remember(const sim::World& world, const debrief::Happened& happened) = 0;
  /// To be called after each step, with its orders: the decisions in it.
  virtual void look(const sim::World& before, const sim::World& after,
                    std::span<const sim::Order> orders) = 0;
  /// What has been seen so far.
  [[nodiscard]] virtual std::string packed(const FlightFacts& facts) const = 0;
  /// What has been seen since the last take(), which is then forgotten, with where everybody is
  /// now: for a page that has the rest (viewer/src/live/grown.ts).
  [[nodiscard]] virtual std::string take(const FlightFacts& facts) = 0;
};
/// The scenario must outlive it; `until` (s) is when the flight ends at the latest. `plenty` is for
/// tests.
[[nodiscard]] std::unique_ptr<Packer> make_packer(const scenario::Scenario& scenario, double until,
                                                  double plenty = kManyPlayerSeconds);

/// A recorded run, flown again for a page without the engine, packed(). Empty if `progress` gave
/// up.
[[nodiscard]] std::string page_data(const debrief::Recorded& recorded,
                                    const Progress& progress = {},
                                    double plenty = kManyPlayerSeconds);

}  // namespace eyrie::page
