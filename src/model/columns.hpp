// SPDX-License-Identifier: MIT
#pragma once
/// \file  The tables of the air war: which row of which topic stands in which column, and who
/// writes it when.
#include "model/command.hpp"
#include "model/datalink/datalink.hpp"
#include "model/emission.hpp"
#include "model/fit.hpp"
#include "model/flight/flying.hpp"
#include "model/kinematics.hpp"
#include "model/sensor/radar.hpp"
#include "model/sensor/rwr.hpp"
#include "model/sensor/threats.hpp"
#include "model/tasking.hpp"
#include "model/track.hpp"
#include "model/vehicle/vehicle.hpp"
#include "model/weapon/countermeasures.hpp"
#include "model/weapon/damage_state.hpp"
#include "model/weapon/gun.hpp"
#include "model/weapon/missile.hpp"
#include "model/weapon/stores.hpp"
#include "sim/columns.hpp"

namespace eyrie::model {

// the rows and what they are made of, in every layer above known as parts of model
using datalink::DatalinkSent, datalink::DatalinkState, datalink::Mate;
using flight::Flying, flight::NavState, flight::Propulsion;
using sensor::InboundMissile, sensor::RadarState, sensor::RwrState, sensor::RwrWarning,
    sensor::Threats;
using vehicle::DriveCommand, vehicle::Driving, vehicle::Lookout, vehicle::Sighted;
using weapon::Damage, weapon::Decoys, weapon::GunState, weapon::kMaxStations, weapon::MissileState,
    weapon::Station, weapon::Stores;

/// The table "aircraft".
struct AircraftColumns : sim::Table<AircraftColumns> {
  sim::Column<Fit> fit;
  sim::Column<Kinematics> kinematics;
  sim::Column<Flying> flying;
  sim::Column<Propulsion> propulsion;
  sim::Column<Command> command;
  sim::Column<Request> request;
  sim::Column<RadarState> radar;
  sim::Column<RwrState> rwr;
  sim::Column<Threats> threats;
  sim::Column<TrackFile> tracks;
  sim::Column<DatalinkState> datalink;
  sim::Column<DatalinkSent> sent;
  sim::Column<Emission> emission;
  sim::Column<Stores> stores;
  sim::Column<Decoys> decoys;
  sim::Column<GunState> gun;
  sim::Column<Damage> damage;
  sim::Column<Tasking> tasking;

  static constexpr std::string_view table_name = "aircraft";
  static constexpr auto columns() {
    using C = AircraftColumns;
    using sim::column, sim::WrittenBy;
    using enum sim::Phase;
    return Lines{
        column("fit", &C::fit),
        column("kinematics", &C::kinematics, WrittenBy{"flight", move}, WrittenBy{"remote", move}),
        column("flying", &C::flying, WrittenBy{"flight", move}),
        column("propulsion", &C::propulsion, WrittenBy{"flight", move}),
        column("command", &C::command, WrittenBy{"pilot", decide}),
        column("request", &C::request, WrittenBy{"pilot", decide}),
        column("radar", &C::radar, WrittenBy{"sensors", perceive}),
        column("rwr", &C::rwr, WrittenBy{"sensors", perceive}),
        column("threats", &C::threats, WrittenBy{"sensors", perceive}),
        column("tracks", &C::tracks, WrittenBy{"sensors", perceive}),
        column("datalink", &C::datalink, WrittenBy{"sensors", perceive}),
        column("sent", &C::sent, WrittenBy{"sensors", act}),
        column("emission", &C::emission, WrittenBy{"sensors", act}, WrittenBy{"remote", act}),
        column("stores", &C::stores, WrittenBy{"stores", act}),
        column("decoys", &C::decoys, WrittenBy{"stores", act}),
        column("gun", &C::gun, WrittenBy{"gun", interact}),
        column("damage", &C::damage, WrittenBy{"damage", commit}),
        column("tasking", &C::tasking, WrittenBy{"pilot", orders}, WrittenBy{"pilot", decide})
            .seldom_used()};
  }
};

/// The table "missile": missiles in flight, players like any other.
struct MissileColumns : sim::Table<MissileColumns> {
  sim::Column<Kinematics> kinematics;
  sim::Column<MissileState> state;
  sim::Column<Emission> emission;

  static constexpr std::string_view table_name = "missile";
  static constexpr auto columns() {
    using C = MissileColumns;
    using sim::column, sim::WrittenBy;
    using enum sim::Phase;
    return Lines{
        column("kinematics", &C::kinematics, WrittenBy{"missile", move},
               WrittenBy{"remote missile", move}),
        column("state", &C::state, WrittenBy{"missile", perceive}, WrittenBy{"missile", decide},
               WrittenBy{"missile", move}, WrittenBy{"missile", interact}),
        column("emission", &C::emission, WrittenBy{"missile", act},
               WrittenBy{"remote missile", act})};
  }
};

/// The table "vehicle": what drives on the ground.
struct VehicleColumns : sim::Table<VehicleColumns> {
  sim::Column<Fit> fit;
  sim::Column<Kinematics> kinematics;
  sim::Column<Driving> driving;
  sim::Column<DriveCommand> command;
  sim::Column<Lookout> lookout;
  sim::Column<DatalinkState> datalink;
  sim::Column<DatalinkSent> sent;

  static constexpr std::string_view table_name = "vehicle";
  static constexpr auto columns() {
    using C = VehicleColumns;
    using sim::column, sim::WrittenBy;
    using enum sim::Phase;
    return Lines{column("fit", &C::fit),
                 column("kinematics", &C::kinematics, WrittenBy{"vehicle", move}),
                 column("driving", &C::driving, WrittenBy{"vehicle", move}),
                 column("command", &C::command, WrittenBy{"driver", decide}),
                 column("lookout", &C::lookout, WrittenBy{"vehicle", perceive}),
                 column("datalink", &C::datalink, WrittenBy{"vehicle", perceive}),
                 column("sent", &C::sent, WrittenBy{"vehicle", act})};
  }
};

}  // namespace eyrie::model
