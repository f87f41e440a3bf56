// SPDX-License-Identifier: MIT
#pragma once
/// \file  How sure shares are: of so many, so many.
#include <cstdint>

namespace eyrie::stats {

struct Interval {
  double low = 0, high = 1;
  [[nodiscard]] double width() const { return high - low; }
};

/// So many of so many.
struct Share {
  std::uint64_t count = 0, n = 0;
  [[nodiscard]] double value() const {
    return n ? static_cast<double>(count) / static_cast<double>(n) : 0;
  }
};

/// Wilson's score interval (Journal of the American Statistical Association 22 (1927) 209): covers
/// the truth as often as it says in the mean over truths. [0, 1] of nothing.
[[nodiscard]] Interval wilson(const Share& share, double confidence = 0.95);
/// Of what a share is more than another, independent one (Newcombe, Statistics in Medicine 17
/// (1998) 873, method 10): from -1 to 1.
[[nodiscard]] Interval newcombe(const Share& one, const Share& other, double confidence = 0.95);

/// The same of two shares of the same pairs (Newcombe, Statistics in Medicine 17 (1998) 2635,
/// method 10): `both` have it, or only the first, or only the second, of `n`.
[[nodiscard]] Interval newcombe_paired(std::uint64_t both, std::uint64_t only_one,
                                       std::uint64_t only_other, std::uint64_t n,
                                       double confidence = 0.95);

/// McNemar's exact test of two shares of the same pairs (Psychometrika 12 (1947) 153): how likely
/// pairs that differ are split as unevenly as this if both shares are the same. In `only_one` pairs
/// the first alone has it, in `only_other` the second. 1 if none differs.
[[nodiscard]] double mcnemar(std::uint64_t only_one, std::uint64_t only_other);

}  // namespace eyrie::stats
