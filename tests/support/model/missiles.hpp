// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: the missiles of data/, without their launch zones, and the air they fly
/// in.
#include "core/vec.hpp"
#include "model/environment.hpp"
#include "model/weapon/missile.hpp"
#include "support/data_file.hpp"

namespace eyrie::model::test {

inline const Atmosphere kAtmosphere;
inline constexpr Vec3 kDown{0, 0, 1};

inline const weapon::MissileType& medium_range() {
  static const auto type = eyrie::test::load<weapon::MissileType>("data/missiles/aim120.yaml");
  return type;
}
inline const weapon::MissileType& short_range() {
  static const auto type = eyrie::test::load<weapon::MissileType>("data/missiles/aim9.yaml");
  return type;
}

}  // namespace eyrie::model::test
