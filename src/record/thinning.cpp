// SPDX-License-Identifier: MIT
#include "record/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/angle.hpp"

namespace eyrie::record {
namespace {

/// Of the line from `a` to `b` at the time of `p`, in tolerances.
double error(const Pose& a, const Pose& p, const Pose& b, const Tolerance& tolerance) {
  const double part = (p.time - a.time) / (b.time - a.time);
  const double off = norm(a.position + part * (b.position - a.position) - p.position);
  const auto turned = [&](double Pose::*angle) {
    return std::fabs(wrap_pi(a.*angle + part * wrap_pi(b.*angle - a.*angle) - p.*angle));
  };
  return std::max(off / tolerance.position,
                  std::max({turned(&Pose::roll), turned(&Pose::pitch), turned(&Pose::heading)}) /
                      tolerance.attitude);
}

/// Whether all between two poses lie near the line.
bool fits(std::span<const Pose> poses, std::size_t from, std::size_t to,
          const Tolerance& tolerance) {
  for (std::size_t i = from + 1; i < to; ++i)
    if (error(poses[from], poses[i], poses[to], tolerance) > 1)
      return false;
  return true;
}

}  // namespace

void thin(std::span<const Pose> poses, std::vector<bool>& kept, const Tolerance& tolerance) {
  std::size_t from = 0;
  for (std::size_t to = 1; to < poses.size(); ++to) {
    if (!fits(poses, from, to, tolerance))
      kept[to - 1] = true;
    if (kept[to - 1])
      from = to - 1;
  }
}

}  // namespace eyrie::record
