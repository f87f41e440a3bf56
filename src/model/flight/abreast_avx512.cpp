// SPDX-License-Identifier: MIT
// As abreast_avx2.cpp, for processors with AVX-512.
#include "model/flight/abreast.hpp"

std::size_t eyrie::model::flight::fly_by_avx512([[maybe_unused]] const Sky& sky,
                                                [[maybe_unused]] std::span<Flyer* const> all) {
#ifdef __AVX512DQ__
  return fly_full<math::Lanes<8>>(sky, all);
#else
  return 0;
#endif
}
