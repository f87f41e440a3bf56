// SPDX-License-Identifier: MIT
#include "model/weapon/target_scene.hpp"

#include "core/math.hpp"

namespace eyrie::model::weapon {

TargetScene TargetScene::of(const sim::World& world, const AircraftColumns& columns,
                            const Library& library) {
  return {.ids = world.ids(columns.table),
          .kinematics = world.rows(columns.kinematics),
          .fit = world.rows(columns.fit),
          .propulsion = world.rows(columns.propulsion),
          .library = library};
}

double TargetScene::signature(SeekerKind kind, std::size_t row, const Vec3& direction) const {
  const AircraftType& type = library.aircraft[fit[row].type];
  const Vec3 nose = normalized(kinematics[row].velocity, kinematics[row].north);
  const double cos_aspect = -dot(nose, direction);
  if (kind == SeekerKind::radar)
    return radar_cross_section(type.signature, cos_aspect);
  return radiant_intensity(type.infrared, cos_aspect, propulsion[row].throttle);
}

std::optional<Detected> look_at(const SeekerType& seeker, const SeekerView& view,
                                const TargetScene& scene, std::uint32_t row) {
  const Kinematics& target = scene.kinematics[row];
  const LineOfSight los =
      line_of_sight(target.position - view.position, target.velocity - view.velocity);
  const double signature = scene.signature(seeker.kind, row, los.direction);
  if (!visible(seeker, view, los, target.velocity, signature))
    return std::nullopt;
  return Detected{.row = row, .id = scene.ids[row], .los = los};
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

}  // namespace eyrie::model::weapon
