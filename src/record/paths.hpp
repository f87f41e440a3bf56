// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where everybody was and what led them, kept whole: for formats that are written by player
/// and not by time.
#include "model/frames.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"

namespace eyrie::record {

/// One player or missile.
struct Path {
  struct Point {
    double time = 0;  ///< s
    Geodetic place;   ///< rad, m above the ellipsoid
  };
  /// Which behavior led from `time` on.
  struct Led {
    double time = 0;
    std::string behavior;  ///< label, "nobody"
    float vote = 0;
  };
  /// Whom it attacks from `time` on.
  struct Lock {
    double time = 0;
    PlayerId target;  ///< nobody
  };
  std::string name;  ///< "eagle1"; of a missile "AIM-120 of eagle1"
  std::string type;  ///< "F-15C"
  model::Side side = model::Side::none;
  std::string_view kind;    ///< "missile", or of the player: "aircraft"
  std::string target;       ///< of a missile
  std::vector<Lock> locks;  ///< of a missile: whom it was shot at
  std::vector<Point> points;
  std::vector<Led> led;
  std::string end;  ///< "home", "lost", "kill", "miss", "trashed"; "" until the end of the run
};

/// Watches a run: players every second, missiles five times a second, both also when they appear
/// and when they are seen for the last time. A path that comes to `most` points goes on with every
/// other one of them, at half its rate: a day of a player takes no more memory than five hours.
class Paths final : public sim::Observer {
 public:
  static constexpr std::size_t kMost = 20'000;
  explicit Paths(const scenario::Scenario& scenario, std::size_t most = kMost)
      : scenario_(scenario), most_(most) {}

  void begin(const sim::World& world, double dt) override;
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  void finish(const sim::World& world) override;

  [[nodiscard]] const scenario::Scenario& scenario() const { return scenario_; }
  /// By id: players first.
  [[nodiscard]] const std::map<std::uint32_t, Path>& all() const { return all_; }
  /// s
  [[nodiscard]] double end_time() const { return time_; }
  /// s, between the fixes of the longest path that came to `most` of them; 0 if none did.
  [[nodiscard]] double widest_pause() const { return widest_pause_; }

 private:
  struct Last {
    Vec3 position;
    double seen = 0;   ///< s, when it was there
    double kept = -1;  ///< s, when its last point was kept
    double pause = 0;  ///< s, at least, between two points
  };

  void look(const sim::World& world, bool players, bool missiles);
  void see(PlayerId id, const Vec3& position, bool keep);
  void keep(std::uint32_t id);
  void halve(Path& path, Last& last);
  void happened(const sim::Event& event);

  const scenario::Scenario& scenario_;
  std::size_t most_;
  double time_ = 0, dt_ = 0, widest_pause_ = 0;
  std::uint64_t players_every_ = 50, missiles_every_ = 10;
  std::map<std::uint32_t, Path> all_;
  std::map<std::uint32_t, Last> last_;
};

/// The run for Cesium: a packet per player and missile with its path over time, its attitude along
/// the velocity, and a label, of a player with the behavior that leads and its vote; and a packet
/// per pair with the line from who attacks to whom, from missiles to their targets. Times count
/// from 2026-01-01T12:00:00Z, as in the Tacview file.
/// https://github.com/AnalyticalGraphicsInc/czml-writer/wiki/CZML-Guide (as of 2025).
[[nodiscard]] std::string czml(const Paths& paths);

/// Paths, routes and ends on a map: RFC 7946. Positions are longitude and latitude in degrees, then
/// metres above the ellipsoid. A feature is the way between two fixes, with the times of both
/// (ISO 8601) as `begin` and `end`, as QGIS' temporal controller takes them. A way over the 180th
/// meridian is cut there (section 3.1.9).
[[nodiscard]] std::string geojson(const Paths& paths);

}  // namespace eyrie::record
