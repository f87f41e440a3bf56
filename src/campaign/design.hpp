// SPDX-License-Identifier: MIT
#pragma once
/// \file  Which combinations of the values of all factors are flown.
#include <span>

#include "campaign/factor.hpp"
#include "core/describe.hpp"

namespace eyrie::campaign {

/// One combination.
struct Cell {
  std::vector<std::string> values;  ///< by factor: Factor::value_at()
  bool operator==(const Cell&) const = default;
};

enum class DesignKind : std::uint8_t {
  full_factorial,   ///< every combination of all levels; the last factor changes fastest
  one_at_a_time,    ///< all first levels, then each other level alone
  latin_hypercube,  ///< n cells; each factor has one in each of n strata of equal probability
                    ///< (McKay, Beckman & Conover, Technometrics 21 (1979) 239)
  sobol,            ///< n points of Sobol's sequence, shifted digit by digit at random
  random,           ///< n cells, each factor by itself
};
constexpr auto names_of(DesignKind) {
  return names_from_zero<DesignKind>("full_factorial", "one_at_a_time", "latin_hypercube", "sobol",
                                     "random");
}

struct Design {
  static constexpr std::string_view type_name = "design";
  static constexpr std::string_view help = "which combinations of the factors are flown";
  static constexpr std::size_t kMostCells = 100'000;
  static constexpr auto params() {
    return Lines{
        param("kind", &Design::kind, "how they are chosen").required(),
        param("cells", &Design::cells, range(1, kMostCells), "how many, if levels do not say it"),
        param("seed", &Design::seed, "of the draws")};
  }
  DesignKind kind = DesignKind::full_factorial;
  std::optional<std::uint32_t> cells;
  std::uint64_t seed = 1;
};

/// Why these factors have no such design, in words, and where the factor stands if it is one.
[[nodiscard]] std::optional<Diagnostic> problem_of(const Design& design,
                                                   std::span<const Factor> factors);
/// In the order in which they are numbered. Without factors it is one, with no values. The design
/// must have no problem.
[[nodiscard]] std::vector<Cell> cells_of(const Design& design, std::span<const Factor> factors);

inline constexpr std::size_t kSobolDimensions = 21;
/// Point number `i`, from 0, in a dimension, from 0, over 2^32: unshifted, with the direction
/// numbers new-joe-kuo-6.21201 (Joe & Kuo, SIAM J. Sci. Comput. 30 (2008) 2635).
[[nodiscard]] std::uint32_t sobol(std::uint32_t i, std::size_t dimension);

}  // namespace eyrie::campaign
