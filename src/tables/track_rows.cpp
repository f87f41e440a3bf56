// SPDX-License-Identifier: MIT
#include "tables/track_rows.hpp"

#include "core/angle.hpp"
#include "record/names.hpp"

namespace eyrie::tables {
namespace {

TrackRow row_of(double time, const Reference& reference, const model::Kinematics& k,
                const scenario::Gauges& gauges) {
  const Geodetic place = reference.to_geodetic(k.position);
  return {time,
          k.position.x,
          k.position.y,
          place.altitude,
          degrees(place.latitude),
          degrees(place.longitude),
          heading_degrees(k.heading, 100),
          degrees(k.pitch),
          degrees(k.roll),
          k.speed,
          gauges.mach.value_or(math::kNaN),
          gauges.load_factor.value_or(math::kNaN),
          gauges.fuel.value_or(math::kNaN)};
}

}  // namespace

void each_track(const scenario::Scenario& scenario, const sim::World& world,
                const TrackRates& rates,
                const std::function<void(PlayerId, const TrackRow&)>& use) {
  const double dt = scenario.simulation->dt();
  const double time = static_cast<double>(world.step()) * dt;
  const Reference& reference = scenario.library->reference;
  if (world.step() % record::steps_in(rates.players, dt) == 0)
    scenario.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
      use(id, row_of(time, reference, fleet.motion(world, row), fleet.gauges(world, row)));
    });
  if (world.step() % record::steps_in(rates.missiles, dt) == 0)
    for (std::size_t i = 0; i < world.rows(scenario.missiles.table); ++i)
      use(world.ids(scenario.missiles.table)[i],
          row_of(time, reference, world.rows(scenario.missiles.kinematics)[i], {}));
}

}  // namespace eyrie::tables
