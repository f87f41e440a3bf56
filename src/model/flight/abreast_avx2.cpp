// SPDX-License-Identifier: MIT
// CMake compiles this file, and no other, for processors with AVX2; without FMA, which rounds once
// where others round twice. Every function here must be a template of lanes or inlined: the linker
// could give a copy of any other one, with AVX2 in it, to the rest of the program.
// tests/lanes looks.
#include "model/flight/abreast.hpp"

std::size_t eyrie::model::flight::fly_by_avx2([[maybe_unused]] const Sky& sky,
                                              [[maybe_unused]] std::span<Flyer* const> all) {
#ifdef __AVX2__
  const std::size_t flown = fly_full<math::Lanes<4>>(sky, all);
  return flown + fly_full<math::Lanes<2>>(sky, all.subspan(flown));
#else
  return 0;
#endif
}
