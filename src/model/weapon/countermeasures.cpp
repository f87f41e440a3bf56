// SPDX-License-Identifier: MIT
#include "model/weapon/countermeasures.hpp"

#include "model/jamming.hpp"

namespace eyrie::model::weapon {
Decoys loaded(const Dispenser& dispenser) {
  Decoys decoys;
  decoys.chaff = dispenser.chaff;
  decoys.flares = dispenser.flares;
  decoys.towed = dispenser.towed;
  return decoys;
}

std::optional<DecoyNow> decoy_at(const Dispenser& d, const Decoy& decoy, const Vec3& down,
                                 const Vec3& wind, double time) {
  const bool chaff = decoy.kind == Dispense::chaff;
  const double age = time - decoy.time;
  if (decoy.kind == Dispense::none || age <= 0 || age > (chaff ? d.chaff_life : d.flare_life))
    return std::nullopt;
  const double slowing = chaff ? d.chaff_slowing : d.flare_slowing;
  const double left = math::exp(-age / slowing);
  const Vec3 through_air = decoy.velocity - wind;
  DecoyNow now{.position = decoy.position + age * wind + slowing * (1 - left) * through_air,
               .velocity = wind + left * through_air,
               .acceleration = -left / slowing * through_air};
  if (chaff) {
    now.signature = d.chaff_section * (1 - math::exp(-age / d.chaff_bloom));
    return now;
  }
  // the same drag against its weight: it ends at a terminal speed of g times the time constant
  now.position += kGravity * slowing * (age - slowing * (1 - left)) * down;
  now.velocity += kGravity * slowing * (1 - left) * down;
  now.acceleration += kGravity * left * down;
  now.signature = d.flare_intensity * (1 - math::exp(-age / d.flare_rise));
  return now;
}

Dispense throw_out(const Dispenser& dispenser, Dispense wanted, const Vec3& position,
                   const Vec3& velocity, double time, std::uint64_t step, Decoys& decoys) {
  constexpr double kSlack = 1e-4;
  if (wanted == Dispense::none || time + kSlack < decoys.ready_time)
    return Dispense::none;
  unsigned thrown = 0;
  const auto put = [&](Dispense kind, std::uint16_t& left) {
    const auto bit = static_cast<unsigned>(kind);
    if ((static_cast<unsigned>(wanted) & bit) == 0 || left == 0)
      return;
    --left;
    decoys.thrown[decoys.next] = {
        .position = position, .velocity = velocity, .time = time, .step = step, .kind = kind};
    decoys.next = static_cast<std::uint16_t>((decoys.next + 1) % kMaxDecoys);
    thrown |= bit;
  };
  put(Dispense::chaff, decoys.chaff);
  put(Dispense::flares, decoys.flares);
  if (thrown != 0)
    decoys.ready_time = time + dispenser.interval;
  return static_cast<Dispense>(thrown);
}

bool merged(const SeekerType& seeker, const Apart& apart) {
  if (seeker.kind == SeekerKind::radar)
    return std::fabs(dot(apart.offset, apart.line)) <= seeker.range_gate / 2 &&
           std::fabs(dot(apart.slip, apart.line)) <= seeker.doppler_gate / 2 &&
           std::fabs(dot(apart.acceleration, apart.line)) <= kTurnInGate;
  const Vec3 aside = apart.offset - dot(apart.offset, apart.line) * apart.line;
  const double edge = seeker.field_of_view / 2 * apart.range;
  return norm2(aside) <= edge * edge;
}

double seduction(const SeekerType& seeker, double decoy, double aircraft) {
  if (decoy <= 0)
    return 0;
  return (1 - seeker.decoy_rejection) * decoy / (decoy + std::max(aircraft, 0.0));
}

std::optional<Vec3> towed_at(const Dispenser& dispenser, const Decoys& decoys, const Vec3& velocity,
                             double time) {
  if (decoys.towed == 0 || time < decoys.tow_time)
    return std::nullopt;
  return -dispenser.tow_length * normalized(velocity, {});
}

TwoEchoes seen_together(const SeekerType& seeker, const Vec3& apart, const Vec3& offset,
                        double decoy, double aircraft) {
  const double range = norm(apart);
  const Vec3 line = apart / std::max(range, 1.0);
  const double along = dot(offset, line);
  const double beam = seeker.field_of_view * range;
  if (std::fabs(along) <= seeker.range_gate / 2 && norm2(offset - along * line) <= beam * beam) {
    const double both = decoy + aircraft;
    return {.shift = (both > 0 ? decoy / both : 0) * offset, .signature = both};
  }
  return decoy > aircraft ? TwoEchoes{offset, decoy} : TwoEchoes{{}, aircraft};
}

}  // namespace eyrie::model::weapon
