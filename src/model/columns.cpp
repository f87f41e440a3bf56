// SPDX-License-Identifier: MIT
#include "model/columns.hpp"

namespace eyrie::model {

AircraftColumns AircraftColumns::define(sim::SchemaBuilder& builder, std::uint32_t capacity) {
  AircraftColumns c;
  c.table = builder.add_table("aircraft", capacity);
  const auto add = [&](auto& column, std::string_view name) {
    const auto key = [&]<class Row>(const sim::Column<Row>&) {
      return builder.add_column<Row>(c.table, name);
    };
    column = key(column);
  };
  add(c.fit, "fit");
  add(c.kinematics, "kinematics");
  add(c.flying, "flying");
  add(c.propulsion, "propulsion");
  add(c.command, "command");
  add(c.request, "request");
  add(c.radar, "radar");
  add(c.rwr, "rwr");
  add(c.threats, "threats");
  add(c.tracks, "tracks");
  add(c.datalink, "datalink");
  add(c.sent, "sent");
  add(c.emission, "emission");
  add(c.stores, "stores");
  add(c.gun, "gun");
  add(c.damage, "damage");
  return c;
}

MissileColumns MissileColumns::define(sim::SchemaBuilder& builder, std::uint32_t capacity) {
  MissileColumns c;
  c.table = builder.add_table("missile", capacity);
  c.kinematics = builder.add_column<Kinematics>(c.table, "kinematics");
  c.state = builder.add_column<MissileState>(c.table, "state");
  c.emission = builder.add_column<Emission>(c.table, "emission");
  return c;
}

VehicleColumns VehicleColumns::define(sim::SchemaBuilder& builder, std::uint32_t capacity) {
  VehicleColumns c;
  c.table = builder.add_table("vehicle", capacity);
  c.fit = builder.add_column<Fit>(c.table, "fit");
  c.kinematics = builder.add_column<Kinematics>(c.table, "kinematics");
  c.driving = builder.add_column<Driving>(c.table, "driving");
  c.command = builder.add_column<DriveCommand>(c.table, "command");
  c.lookout = builder.add_column<Lookout>(c.table, "lookout");
  c.datalink = builder.add_column<DatalinkState>(c.table, "datalink");
  c.sent = builder.add_column<DatalinkSent>(c.table, "sent");
  return c;
}

}  // namespace eyrie::model
