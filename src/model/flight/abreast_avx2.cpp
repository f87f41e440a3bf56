// SPDX-License-Identifier: MIT
// CMake compiles this file, and no other, for processors with AVX2; without FMA, which rounds once
// where others round twice. Every function here must be a template of lanes or inlined: the linker
// could give a copy of any other one, with AVX2 in it, to the rest of the program.
// tests/lanes looks.
#include "model/flight/abreast.hpp"

namespace eyrie::model::flight {
namespace {

template <class Real>
void fly_lanes(const Sky& sky, Flyer* const* flyers) {
  bool alike = true;
  for (std::size_t i = 1; i < math::kLanes<Real>; ++i)
    alike &= flyers[i]->model == flyers[0]->model;
  alike ? fly_abreast<Real, true>(sky, flyers) : fly_abreast<Real, false>(sky, flyers);
}

}  // namespace

std::size_t fly_in_lanes([[maybe_unused]] const Sky& sky,
                         [[maybe_unused]] std::span<Flyer* const> all) {
  std::size_t next = 0;
#ifdef __AVX2__
  for (; next + 4 <= all.size(); next += 4)
    fly_lanes<math::Lanes<4>>(sky, &all[next]);
  for (; next + 2 <= all.size(); next += 2)
    fly_lanes<math::Lanes<2>>(sky, &all[next]);
#endif
  return next;
}

}  // namespace eyrie::model::flight
