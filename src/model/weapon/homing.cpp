// SPDX-License-Identifier: MIT
#include "model/weapon/homing.hpp"

#include "model/weapon/flyout.hpp"

namespace eyrie::model::weapon {

TargetScene TargetScene::of(const sim::World& world, const AircraftColumns& columns,
                            const Library& library, double time) {
  return {.ids = world.ids(columns.table),
          .kinematics = world.rows(columns.kinematics),
          .fit = world.rows(columns.fit),
          .propulsion = world.rows(columns.propulsion),
          .decoys = world.rows(columns.decoys),
          .emission = world.rows(columns.emission),
          .library = library,
          .time = time};
}

double TargetScene::signature(SeekerKind kind, std::size_t row, const Vec3& direction) const {
  const AircraftType& type = library.aircraft[fit[row].type];
  const double cos_aspect = -dot(nose_of(kinematics[row], library.environment.wind), direction);
  if (kind == SeekerKind::radar)
    return radar_cross_section(type.signature, cos_aspect);
  return radiant_intensity(type.infrared, cos_aspect, propulsion[row].throttle);
}

std::optional<TargetScene::Towed> TargetScene::towed(std::size_t row) const {
  if (decoys.empty() || decoys[row].towed == 0)
    return std::nullopt;
  const Dispenser& dispenser = library.dispensers[*library.aircraft[fit[row].type].index.dispenser];
  const Vec3 moves = through_air(kinematics[row], library.environment.wind);
  const auto offset = towed_at(dispenser, decoys[row], moves, time);
  return offset ? std::optional(Towed{*offset, dispenser.towed_section}) : std::nullopt;
}

namespace {

/// dB: the first side lobe of a round antenna whose field falls off to its edge with the square of
/// the radius is 24.6 dB below its middle (Skolnik, Introduction to Radar Systems; not seen).
constexpr double kSideLobes = 24.6;

/// What the jammer of aircraft `row` puts into a seeker that points at it, over the receiver's own
/// noise; nothing in one of its own side.
double jamming_of(const SeekerType& seeker, const SeekerView& view, const TargetScene& scene,
                  std::size_t row) {
  const Emission& emission = scene.emission[row];
  if (emission.jamming <= 0 || (view.side != Side::none && emission.side == view.side))
    return 0;
  return jamming_to_noise(emission.jamming, seeker.field_of_view,
                          norm2(scene.kinematics[row].position - view.position));
}

/// Noise of all jammers in a seeker that points along `direction`, over the receiver's own.
double jamming_along(const SeekerType& seeker, const SeekerView& view, const TargetScene& scene,
                     const Vec3& direction) {
  double noise = 0;
  for (std::size_t row = 0; row < scene.emission.size(); ++row)
    if (const double loud = jamming_of(seeker, view, scene, row); loud > 0) {
      const Vec3 apart = scene.kinematics[row].position - view.position;
      noise += loud * off_beam(seeker.field_of_view, kSideLobes,
                               dot(normalized(apart, direction), direction));
    }
  return noise;
}

}  // namespace

std::optional<Detected> look_at(const SeekerType& seeker, const SeekerView& view,
                                const TargetScene& scene, std::uint32_t row) {
  const Kinematics& target = scene.kinematics[row];
  const Vec3 apart = target.position - view.position;
  LineOfSight los = line_of_sight(apart, target.velocity - view.velocity);
  double signature = scene.signature(seeker.kind, row, los.direction);
  const bool radar = seeker.kind == SeekerKind::radar;
  if (const auto tow = radar ? scene.towed(row) : std::nullopt) {
    const TwoEchoes both = seen_together(seeker, apart, tow->offset, tow->section, signature);
    los = line_of_sight(apart + both.shift, target.velocity - view.velocity);
    signature = both.signature;
  }
  Detected seen{.row = row, .id = scene.ids[row], .los = los};
  const bool jams = radar && scene.library.jammers.size() != 0;
  // range goes with the fourth root of echo over noise
  if (jams)
    signature /= 1 + jamming_along(seeker, view, scene, los.direction);
  if (visible(seeker, view, los, target.velocity, signature)) {
    seen.reach = acquisition_range(seeker, signature);
    return seen;
  }
  // a jammer shines as far as one likes, and has no notch
  seen.on_jam = jams && jamming_of(seeker, view, scene, row) > kStrobe &&
                visible(seeker, view, los, 1e6 * los.direction, 1e12);
  return seen.on_jam ? std::optional(seen) : std::nullopt;
}

std::optional<Detected> search(const SeekerType& seeker, const SeekerView& view,
                               const TargetScene& scene, const SearchVolume& volume) {
  const double range2 = seeker.greatest_range * seeker.greatest_range;
  const double edge = math::cos(seeker.field_of_view / 2);
  std::optional<Detected> best;
  double least = 0;
  for (std::uint32_t row = 0; row < scene.ids.size(); ++row) {
    // cheap tests first: most players are nowhere near the field of view
    const Vec3 apart = scene.kinematics[row].position - view.position;
    const double distance2 = norm2(apart);
    const double along = dot(apart, volume.direction);
    if (distance2 > range2 || along <= 0 || along * along < edge * edge * distance2 ||
        scene.ids[row] == volume.except)
      continue;
    const double off = volume.place ? norm2(scene.kinematics[row].position - *volume.place)
                                    : distance2 / (along * along);
    if (best && off >= least)
      continue;
    if (const auto seen = look_at(seeker, view, scene, row)) {
      best = seen;
      least = off;
    }
  }
  return best;
}

namespace {

SeekerView view_of(const Kinematics& k, const Wind& wind, Side side) {
  return {.position = k.position,
          .velocity = k.velocity,
          .axis = nose_of(k, wind),
          .down = k.down,
          .altitude = k.altitude,
          .side = side};
}

/// A radar searches where it believes the target, an infrared seeker along its last line of sight.
SearchVolume search_volume(const MissileType& type, const Kinematics& k, double time,
                           const MissileState& state) {
  if (type.seeker.kind == SeekerKind::infrared)
    return {.direction = sight_at(state, time)};
  const Vec3 place = believed_position(state, time);
  return {.direction = normalized(place - k.position, state.sight), .place = place};
}

/// What the gates of a radar seeker rest on: the echo of aircraft `row`, or, if that is stronger or
/// alone in them, the false one of its jammer. They are where range and closing speed are believed.
struct InGates {
  std::optional<Detected> seen;
  bool pulled_off = false;  ///< somebody pulls, or has pulled: what is not seen is not at hand
};
InGates in_gates(const SeekerType& seeker, const SeekerView& view, const TargetScene& scene,
                 std::uint32_t row, double time, const MissileState& state) {
  InGates result{.seen = look_at(seeker, view, scene, row)};
  const auto& index = scene.library.aircraft[scene.fit[row].type].index.jammer;
  if (seeker.kind != SeekerKind::radar || !index || !scene.library.jammers[*index].pull_off ||
      (view.side != Side::none && scene.fit[row].side == view.side) ||
      (result.seen && result.seen->on_jam))
    return result;
  result.pulled_off = true;
  const PullOff& pull = *scene.library.jammers[*index].pull_off;
  const double believed = norm(believed_position(state, time) - view.position);
  const auto inside = [&](const LineOfSight& los) {
    return std::fabs(los.range - believed) <= seeker.range_gate / 2 &&
           std::fabs(los.closing - state.closing_speed) <= seeker.doppler_gate / 2;
  };
  if (result.seen && !inside(result.seen->los))
    result.seen = std::nullopt;
  const auto phase = pull.phase(time);
  if (!phase)
    return result;
  const Kinematics& target = scene.kinematics[row];
  const FalseEcho off = pull.at(*phase);
  LineOfSight los = line_of_sight(target.position - view.position, target.velocity - view.velocity);
  los.range += off.range;
  los.closing -= off.speed;
  const double section = pull.section() / (1 + jamming_along(seeker, view, scene, los.direction));
  if (inside(los) &&
      (!result.seen || pull.section() > scene.signature(SeekerKind::radar, row, los.direction)) &&
      visible(seeker, view, los, target.velocity + off.speed * los.direction, section))
    result.seen = Detected{
        .row = row, .id = scene.ids[row], .los = los, .reach = acquisition_range(seeker, section)};
  return result;
}

/// One look at what is seen. Range and closing speed of a jammer stay what was believed of it.
SeekerLook measured(const SeekerType& seeker, const SeekerView& view, const Detected& seen,
                    double time, Draw noise, MissileState& state) {
  SeekerLook look =
      measure(seeker, view, seen.los, seen.reach, time - state.sight_time, state.glint, noise);
  if (seen.on_jam) {
    const LineOfSight believed = line_of_sight(believed_position(state, time) - view.position,
                                               state.target_velocity - view.velocity);
    look.range = believed.range;
    look.closing = std::max(believed.closing, 0.0);
  }
  return look;
}

}  // namespace

Vec3 believed_position(const MissileState& state, double time) {
  return state.target_position + (time - state.target_time) * state.target_velocity;
}

bool switch_on(const MissileType& type, const Kinematics& k, double time, MissileState& state) {
  if (state.active != 0 || time - state.launch_time < type.guidance.separation_time)
    return false;
  const double range2 = norm2(believed_position(state, time) - k.position);
  if (range2 > type.seeker.activation_range * type.seeker.activation_range)
    return false;
  state.active = 1;
  state.sight_time = time;
  return true;
}

std::optional<Detected> look(const MissileType& type, const Kinematics& k, double time,
                             const TargetScene& scene, Draw noise, MissileState& state) {
  const SeekerType& seeker = type.seeker;
  const SeekerView view = view_of(k, scene.library.environment.wind, state.side);

  // whom it rests on already
  if (state.locked != 0) {
    const auto row = std::lower_bound(scene.ids.begin(), scene.ids.end(), state.seen);
    if (row != scene.ids.end() && *row == state.seen) {
      const InGates gates = in_gates(
          seeker, view, scene, static_cast<std::uint32_t>(row - scene.ids.begin()), time, state);
      if (gates.seen)
        follow(seeker, view, measured(seeker, view, *gates.seen, time, noise, state), time, state);
      state.locked = gates.seen ? 1 : 0;
      if (gates.seen || gates.pulled_off)
        return std::nullopt;
    }
    state.locked = 0;
  }

  // somebody new, or the old one again
  const auto seen = search(seeker, view, scene, search_volume(type, k, time, state));
  if (!seen)
    return std::nullopt;
  const Vec3 expected_rate = seeker.kind == SeekerKind::infrared
                                 ? state.sight_rate
                                 : line_of_sight(believed_position(state, time) - k.position,
                                                 state.target_velocity - k.velocity)
                                       .rate;
  const SeekerLook first = measured(seeker, view, *seen, time, noise, state);
  start_following(state, first, expected_rate, time);
  follow(seeker, view, first, time, state);
  state.locked = 1;
  if (state.seen == seen->id)
    return std::nullopt;
  state.seen = seen->id;
  return seen;
}

DecoyLook look_at_decoys(const MissileType& type, const Kinematics& k, double time,
                         const TargetScene& scene, std::uint64_t seed, PlayerId self, Draw noise,
                         MissileState& state) {
  const SeekerType& seeker = type.seeker;
  if (state.locked == 0 || scene.decoys.empty())
    return DecoyLook::none;
  const auto found = std::lower_bound(scene.ids.begin(), scene.ids.end(), state.seen);
  if (found == scene.ids.end() || *found != state.seen) {
    state.locked = state.decoy == 0 ? state.locked : std::uint8_t{0};
    state.decoy = 0;
    return DecoyLook::none;
  }
  const auto row = static_cast<std::size_t>(found - scene.ids.begin());
  const auto& dispenser = scene.library.aircraft[scene.fit[row].type].index.dispenser;
  if (!dispenser)
    return DecoyLook::none;
  const Dispenser& model = scene.library.dispensers[*dispenser];
  const auto& thrown = scene.decoys[row].thrown;
  const Kinematics& target = scene.kinematics[row];
  const Vec3 wind = air_at(target, scene.library.environment.wind);
  const SeekerView view = view_of(k, scene.library.environment.wind, state.side);
  const auto los_of = [&](const DecoyNow& now) {
    return line_of_sight(now.position - k.position, now.velocity - k.velocity);
  };

  DecoyLook result = DecoyLook::rests;
  if (state.decoy == 0) {
    const Dispense kind = seeker.kind == SeekerKind::radar ? Dispense::chaff : Dispense::flares;
    const Vec3 apart = target.position - k.position;
    const double range = norm(apart);
    const Vec3 line = apart / std::max(range, 1.0);
    for (std::size_t i = 0; i < thrown.size() && state.decoy == 0; ++i) {
      if (thrown[i].kind != kind)
        continue;
      const auto now = decoy_at(model, thrown[i], target.down, wind, time);
      if (!now ||
          !merged(seeker, {.line = line,
                           .range = range,
                           .offset = now->position - target.position,
                           .slip = now->velocity - target.velocity,
                           .acceleration = now->acceleration}) ||
          !visible(seeker, view, los_of(*now), now->velocity, now->signature))
        continue;
      Draw fate(seed, self, Stream::decoy, thrown[i].step, state.seen.value);
      if (fate.uniform() <
          seduction(seeker, now->signature, scene.signature(seeker.kind, row, line))) {
        state.decoy = static_cast<std::uint8_t>(i + 1);
        state.decoy_step = thrown[i].step;
        result = DecoyLook::fell;
      }
    }
    if (state.decoy == 0)
      return DecoyLook::none;
  }
  const Decoy& decoy = thrown[state.decoy - 1U];
  const auto now = decoy_at(model, decoy, target.down, wind, time);
  if (decoy.step != state.decoy_step || !now ||
      !visible(seeker, view, los_of(*now), now->velocity, now->signature)) {
    state.decoy = state.locked = 0;
    return DecoyLook::none;
  }
  const SeekerLook look =
      measure(seeker, view, los_of(*now), acquisition_range(seeker, now->signature),
              time - state.sight_time, state.glint, noise);
  follow(seeker, view, look, time, state);
  return result;
}

void hear(const Track& track, MissileState& state) {
  if (state.locked != 0 || track.time <= state.target_time)
    return;
  state.target_position = track.position;
  state.target_velocity = track.velocity;
  state.target_time = track.time;
}

Vec3 guide(const MissileType& type, const Kinematics& k, double time, const MissileState& state) {
  const MissileGuidance& guidance = type.guidance;
  if (time - state.launch_time < guidance.separation_time)
    return {};
  if (state.locked != 0 || type.seeker.kind == SeekerKind::infrared) {
    const LineOfSight los{.direction = sight_at(state, time),
                          .rate = state.sight_rate,
                          .closing = state.closing_speed};
    return steer(guidance, los, k.velocity, k.down);
  }
  const Vec3 apart = believed_position(state, time) - k.position;
  const Vec3 aim = guidance.loft ? lofted(*guidance.loft, apart, k.down, k.altitude) : apart;
  return steer(guidance, line_of_sight(aim, state.target_velocity - k.velocity), k.velocity,
               k.down);
}

}  // namespace eyrie::model::weapon
