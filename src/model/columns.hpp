// SPDX-License-Identifier: MIT
#pragma once
/// \file  The tables of the air war: which row of which topic stands in which column.
#include <cstdint>

#include "model/command.hpp"
#include "model/datalink/datalink_state.hpp"
#include "model/emission.hpp"
#include "model/fit.hpp"
#include "model/flight/flying.hpp"
#include "model/flight/propulsion.hpp"
#include "model/kinematics.hpp"
#include "model/sensor/radar_state.hpp"
#include "model/sensor/rwr_state.hpp"
#include "model/sensor/threats.hpp"
#include "model/track.hpp"
#include "model/vehicle/vehicle_state.hpp"
#include "model/weapon/damage_state.hpp"
#include "model/weapon/gun_state.hpp"
#include "model/weapon/missile_state.hpp"
#include "model/weapon/stores_state.hpp"
#include "sim/schema.hpp"

namespace eyrie::model {

/// The table "aircraft". Who writes a column, and in which phase, is said beside it.
struct AircraftColumns {
  TableId table;
  sim::Column<Fit> fit;                 ///< at birth
  sim::Column<Kinematics> kinematics;   ///< move
  sim::Column<Flying> flying;           ///< move
  sim::Column<Propulsion> propulsion;   ///< move
  sim::Column<Command> command;         ///< decide
  sim::Column<Request> request;         ///< decide
  sim::Column<RadarState> radar;        ///< perceive
  sim::Column<RwrState> rwr;            ///< perceive
  sim::Column<Threats> threats;         ///< perceive
  sim::Column<TrackFile> tracks;        ///< perceive
  sim::Column<DatalinkState> datalink;  ///< perceive
  sim::Column<DatalinkSent> sent;       ///< act
  sim::Column<Emission> emission;       ///< act
  sim::Column<Stores> stores;           ///< act, commit
  sim::Column<GunState> gun;            ///< act, interact
  sim::Column<Damage> damage;           ///< commit

  [[nodiscard]] static AircraftColumns define(sim::SchemaBuilder& builder, std::uint32_t capacity);
};

/// The table "missile": missiles in flight, players like any other.
struct MissileColumns {
  TableId table;
  sim::Column<Kinematics> kinematics;  ///< move
  sim::Column<MissileState> state;     ///< every phase, by the missile system
  sim::Column<Emission> emission;      ///< act

  [[nodiscard]] static MissileColumns define(sim::SchemaBuilder& builder, std::uint32_t capacity);
};

/// The table "vehicle": what drives on the ground.
struct VehicleColumns {
  TableId table;
  sim::Column<Fit> fit;                 ///< at birth
  sim::Column<Kinematics> kinematics;   ///< move
  sim::Column<Driving> driving;         ///< move
  sim::Column<DriveCommand> command;    ///< decide
  sim::Column<Lookout> lookout;         ///< perceive
  sim::Column<DatalinkState> datalink;  ///< perceive
  sim::Column<DatalinkSent> sent;       ///< act

  [[nodiscard]] static VehicleColumns define(sim::SchemaBuilder& builder, std::uint32_t capacity);
};

}  // namespace eyrie::model
