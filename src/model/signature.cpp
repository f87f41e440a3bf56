// SPDX-License-Identifier: MIT
#include "model/signature.hpp"

namespace eyrie::model {

double silhouette(const Signature& s, const Axes& target, const Vec3& unit) {
  const double front = s.area_front * dot(unit, target.forward);
  const double side = s.area_side * dot(unit, target.right);
  const double top = s.area_top * dot(unit, target.down);
  return std::sqrt(front * front + side * side + top * top);
}

}  // namespace eyrie::model
