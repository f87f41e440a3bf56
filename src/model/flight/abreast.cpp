// SPDX-License-Identifier: MIT
#include "model/flight/abreast.hpp"

namespace eyrie::model::flight {

void fly(const Sky& sky, std::span<Flyer* const> flyers) {
  std::size_t i = 0;
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512vbmi2"))
    i = fly_by_avx512(sky, flyers);
  if (__builtin_cpu_supports("avx2"))
    i += fly_by_avx2(sky, flyers.subspan(i));
#endif
  for (; i < flyers.size(); ++i)
    fly_abreast<double>(sky, &flyers[i]);
}

void fly_laero(const Sky& sky, Flyer& flyer) {
  const Airframe& airframe = flyer.model->airframe();
  const Laero& laero = airframe.laero;
  const Command& command = *flyer.command;
  Kinematics& k = *flyer.kinematics;
  Flying& flying = *flyer.flying;
  const Air air = sky.environment.atmosphere.at(k.altitude);
  const Vec3 wind = sky.environment.wind.at(k.altitude);
  const double turn_limit =
      laero.turn_rate_limit(k.speed, std::max(command.load_factor, kLeastLoadFactor));
  Guidance wanted =
      guide(airframe.autopilot, k, command, flyer.routes,
            turn_radius(k.speed, turn_limit, laero.heading_time), flying, wind, flyer.time, sky.dt);
  if (wanted.climb)
    wanted.altitude += k.speed * math::sin(*wanted.climb) * laero.altitude_time;
  const auto most = static_cast<float>(1 / math::cos(laero.max_bank));
  flying.energy = {
      .available = most, .sustained = most, .corner_speed = static_cast<float>(k.speed)};
  laero.step(k, flying, wanted, turn_limit, *flyer.propulsion, air, wind, sky.dt);
  flyer.propulsion->flow = flyer.propulsion->fuel > 0 ? laero.fuel_flow : 0;
  carry_to(k, sky.reference.vertical_at(k.position));
  flyer.ran_dry = burn(*flyer.propulsion, sky.dt);
}

}  // namespace eyrie::model::flight
