// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every const model of a run, shared by all players and threads.
#include "model/aircraft_type.hpp"
#include "model/datalink/datalink.hpp"
#include "model/environment.hpp"
#include "model/fit.hpp"
#include "model/flight/airframe.hpp"
#include "model/flight/guidance.hpp"
#include "model/frames.hpp"
#include "model/jamming.hpp"
#include "model/sensor/infrared.hpp"
#include "model/sensor/radar.hpp"
#include "model/sensor/rwr.hpp"
#include "model/sensor/visual.hpp"
#include "model/track/filter.hpp"
#include "model/vehicle/vehicle.hpp"
#include "model/weapon/countermeasures.hpp"
#include "model/weapon/gun.hpp"
#include "model/weapon/missile.hpp"

namespace eyrie::model {

// what stands on the shelves
using datalink::Datalink;
using flight::Airframe, flight::Route, flight::RouteEnd, flight::Waypoint;
using sensor::Iff, sensor::Irst, sensor::Radar, sensor::Rwr, sensor::Visual;
using track::Tracker;
using vehicle::VehicleType;
using weapon::Dispenser, weapon::GunType, weapon::MissileType;

/// Models of one kind, each under the name that files know it by; a row refers to one by its index.
template <class Model>
class Shelf {
 public:
  /// The index of the new model. std::logic_error if the name is taken or the shelf is full.
  std::uint16_t add(std::string name, Model model) {
    EYRIE_THROW_UNLESS(!find(name), "two models of one kind have the same name");
    EYRIE_THROW_UNLESS(models_.size() < 0xFFFF, "too many models of one kind");
    names_.push_back(std::move(name));
    models_.push_back(std::move(model));
    return static_cast<std::uint16_t>(models_.size() - 1);
  }
  [[nodiscard]] std::optional<std::uint16_t> find(std::string_view name) const {
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (names_[i] == name)
        return static_cast<std::uint16_t>(i);
    return std::nullopt;
  }
  [[nodiscard]] const Model& operator[](std::size_t index) const { return models_[index]; }
  [[nodiscard]] const std::string& name(std::size_t index) const { return names_[index]; }
  [[nodiscard]] std::span<const std::string> names() const { return names_; }
  [[nodiscard]] std::size_t size() const { return models_.size(); }

 private:
  std::vector<std::string> names_;
  std::vector<Model> models_;
};

/// Aircraft that fly together, or vehicles that drive together. Const: who is alive, and who leads,
/// is in the rows.
struct Flight {
  std::string name;
  Side side = Side::none;
  std::vector<PlayerId> members;  ///< by rank at birth, the lead first
  std::vector<Route> routes;      ///< Command::route picks one; 0 is the mission
  std::optional<Vec3> home;       ///< m, local frame
};

/// Built once at load, then const.
struct Library {
  Reference reference;
  Environment environment;
  Shelf<Airframe> airframes;
  Shelf<Radar> radars;
  Shelf<Irst> irsts;
  Shelf<Rwr> rwrs;
  Shelf<Visual> visuals;
  Shelf<Iff> iffs;
  Shelf<Datalink> datalinks;
  Shelf<Tracker> trackers;
  Shelf<MissileType> missiles;
  Shelf<GunType> guns;
  Shelf<Dispenser> dispensers;
  Shelf<Jammer> jammers;
  Shelf<AircraftType> aircraft;  ///< Fit::type
  Shelf<VehicleType> vehicles;   ///< Fit::type of vehicles
  std::vector<Flight> flights;   ///< Fit::flight; convoys behind the flights
};

/// What is wrong with `data.<kind>.<model>.<parameter>`.
struct LibraryProblem {
  std::string_view kind;  ///< "radars", as in files
  std::string model;
  std::string_view parameter;
  std::string problem;
};

/// Of every model on the shelves, flown or not, in steps of `dt` seconds: rates that are no whole
/// number of steps, datalinks slower than their ring, and what would do nothing.
[[nodiscard]] std::vector<LibraryProblem> problems_of(const Library& library, double dt);

}  // namespace eyrie::model
