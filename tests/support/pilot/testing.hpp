// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: a cockpit made by hand, without a world around it, and a pilot to sit in.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/units.hpp"
#include "model/weapon/gun.hpp"
#include "pilot/controller.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "support/model/flying.hpp"
#include "support/model/stores.hpp"

namespace eyrie::pilot::testing {

inline constexpr double kNmi = si(1, "nmi");
inline constexpr double kDegree = si(1, "deg");
inline constexpr Status kFailure = Status::failure;
inline constexpr Status kRunning = Status::running;
inline constexpr Status kSuccess = Status::success;

/// Missile types of the library, by index.
enum Store : std::uint16_t { kMedium = 0, kShort = 1 };

/// One type of fighter with two missiles of each kind and a gun, and two flights: four blue ones
/// with a route to the north and a home 50 nmi to the south, and four red ones with nothing. The
/// same for every test: finding the zones of the missiles takes a while.
[[nodiscard]] const model::Library& library();
/// The same where the wind blows from the south at 60 m/s.
[[nodiscard]] const model::Library& windy_library();

/// The nodes that decide() and Pilot know: those of pilot/catalog.hpp. What a test adds is known
/// from then on.
[[nodiscard]] Registry& registry();

/// The rows of one aircraft, here eagle1 alone: level at 8000 m over the reference point, heading
/// north at 250 m/s, at 100 s; with all its stores, half of its fuel, and nobody else in the world.
/// The Earth is flat in the rows and axes are north-east-down.
struct Desk {
  model::Kinematics own = model::test::flying({0, 0, -8000}, 0, 250);
  model::Propulsion propulsion{.fuel = 1500};
  model::Flying flying{
      .energy = {.available = 7, .sustained = 4, .corner_speed = 280, .excess_power = 60}};
  model::Stores stores =
      model::weapon::load_stores(library().aircraft[0].stations, library().missiles);
  model::GunState gun = model::weapon::loaded(library().guns[0]);
  model::Decoys decoys;
  model::TrackFile tracks;
  model::RwrState rwr;
  model::Threats threats;
  model::DatalinkState datalink;
  model::Command command{.altitude = 8000, .speed = 250};
  model::Request request;
  Agent agent{.bingo = 500, .tree = 0};
  model::Fit fit{.rank = 1, .side = model::Side::blue};
  Formation formation;
  double time = 100;
  const model::Library* models = &library();

  /// A confirmed track, up to date, `ned` m from the ownship.
  model::Track& track(const Vec3& ned, double heading = kPi, double speed = 250,
                      model::Identity identity = model::Identity::hostile) {
    EYRIE_DEMAND(tracks.count < model::kMaxTracks, "the track file is full");
    model::Track& t = tracks.tracks[tracks.count++];
    t.position = own.position + ned;
    t.velocity = model::test::flying({}, heading, speed).velocity;
    t.time = t.sensed_time = time;
    t.seen_time = model::kNever;
    t.id = TrackId{tracks.next_id++};
    t.truth = PlayerId{4 + t.id.value};
    t.identity = identity;
    t.sources = t.fresh = model::kFromRadar;
    t.hits = 10;
    t.confirmed = 1;
    return t;
  }
  /// A missile is coming: `bearing` is true; without a range a receiver heard it.
  model::InboundMissile& threat(double bearing, std::optional<double> range = {}) {
    model::InboundMissile& m = threats.missiles[threats.count++];
    m.bearing = wrap_pi(bearing);
    m.time = m.first_time = time;
    m.truth = PlayerId{100 + threats.count};
    if (range) {
      m.range = *range;
      m.has_position = 1;
      m.position_time = time;
    }
    return m;
  }
  /// A flight of `count`, of which this is number `rank` from 1; all alive, the others heard of, a
  /// mile apart to the east in the order of their rank, on the own course.
  void in_flight(std::uint32_t count, std::uint32_t rank) {
    datalink.count = count;
    datalink.self = rank - 1;
    fit.rank = static_cast<std::uint8_t>(rank);
    for (std::uint32_t i = 0; i < count; ++i) {
      model::Mate& mate = datalink.members[i];
      mate.id = PlayerId{i + 1};
      mate.alive = 1;
      mate.reported = i != datalink.self;
      mate.time = mate.heard_time = time;
      mate.position = own.position + Vec3{0, (double(i) - double(datalink.self)) * 1852, 0};
      mate.velocity = {float(own.velocity.x), float(own.velocity.y), float(own.velocity.z)};
    }
  }
  void lose(std::uint32_t rank) { datalink.members[rank - 1].alive = 0; }

  [[nodiscard]] State state() const {
    return State({own, propulsion, flying, stores, gun, decoys, tracks, rwr, threats, datalink,
                  command, agent},
                 *models, fit, formation, time);
  }
};

/// What one decision came to.
struct Decided {
  Status status = kFailure;
  Proposal proposal;

  [[nodiscard]] const Action& action() const { return proposal.action; }
};

/// A tree and what it remembers: `Pilot pilot("{break_turn: {dive: 500 m}}");`
class Pilot {
 public:
  explicit Pilot(const std::string& text);

  Decided decide(const Desk& desk);
  /// Decides and carries it out.
  Decided fly(Desk& desk);

 private:
  Tree tree_;
  std::vector<std::uint64_t> slab_;
};

/// One decision of a fresh pilot.
Decided decide(const std::string& text, const Desk& desk);
/// Whether a condition holds for a fresh pilot.
bool holds(const std::string& text, const Desk& desk);

}  // namespace eyrie::pilot::testing
