// SPDX-License-Identifier: MIT
#include "campaign/design.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "core/draw.hpp"

namespace eyrie::campaign {
namespace {

/// Numbers in (0, 1), a multiple of 2^-32 and a half of that.
double inside(std::uint32_t bits) {
  return (bits + 0.5) * 0x1p-32;
}

/// Of a factor in a design. A purpose is a step, so that none shares its numbers with another.
enum class Purpose : std::uint64_t { place, order, shift };
Draw draw(const Design& design, std::size_t factor, Purpose purpose, std::size_t cell = 0) {
  return {design.seed, PlayerId{static_cast<std::uint32_t>(factor + 1)}, Stream::design,
          static_cast<std::uint64_t>(purpose), static_cast<std::uint32_t>(cell)};
}
std::uint32_t bits(Draw draw) {
  return static_cast<std::uint32_t>(draw.bits() >> 32);
}

std::vector<Cell> full_factorial(std::span<const Factor> factors) {
  std::vector<Cell> cells{Cell{}};
  for (const Factor& factor : factors) {
    std::vector<Cell> more;
    for (const Cell& cell : cells)
      for (const Level& level : factor.levels)
        (more.emplace_back(cell)).values.push_back(level.name);
    cells = std::move(more);
  }
  return cells;
}

std::vector<Cell> one_at_a_time(std::span<const Factor> factors) {
  std::vector<Cell> cells(1);
  for (const Factor& factor : factors)
    cells.front().values.push_back(factor.levels.front().name);
  for (std::size_t f = 0; f < factors.size(); ++f)
    for (std::size_t i = 1; i < factors[f].levels.size(); ++i)
      (cells.emplace_back(Cell(cells.front()))).values[f] = factors[f].levels[i].name;
  return cells;
}

/// Where the cells of a factor lie in (0, 1).
std::vector<double> places(const Design& design, std::size_t factor) {
  std::vector<double> all(*design.cells);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i-- > 1;) {  // Fisher and Yates
    const double u = inside(bits(draw(design, factor, Purpose::order, i)));
    std::swap(order[i], order[static_cast<std::size_t>(u * static_cast<double>(i + 1))]);
  }
  const std::uint32_t shift = bits(draw(design, factor, Purpose::shift));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double u = inside(bits(draw(design, factor, Purpose::place, i)));
    all[i] = design.kind == DesignKind::latin_hypercube
                 ? (static_cast<double>(order[i]) + u) / static_cast<double>(all.size())
             : design.kind == DesignKind::sobol
                 ? inside(sobol(static_cast<std::uint32_t>(i), factor) ^ shift)
                 : u;
  }
  return all;
}

bool has_levels_only(DesignKind kind) {
  return kind == DesignKind::full_factorial || kind == DesignKind::one_at_a_time;
}

/// Degree, inner coefficients of the primitive polynomial, and the first direction numbers.
struct Direction {
  unsigned degree, polynomial;
  std::array<std::uint32_t, 7> first;
};
constexpr std::array<Direction, kSobolDimensions - 1> kDirections{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

}  // namespace

std::optional<Diagnostic> problem_of(const Design& design, std::span<const Factor> factors) {
  const std::string_view kind = enum_name(design.kind);
  if (has_levels_only(design.kind)) {
    if (design.cells)
      return Diagnostic{{}, fmt::format("the levels say how many cells {} has, not 'cells'", kind)};
    double cells = 1;
    for (const Factor& f : factors) {
      if (f.distribution)
        return Diagnostic{f.where, fmt::format("{} needs levels: give {} some, as with !range, or "
                                               "choose latin_hypercube, sobol or random",
                                               kind, f.name)};
      cells *= static_cast<double>(f.levels.size());
    }
    if (design.kind == DesignKind::full_factorial && cells > Design::kMostCells)
      return Diagnostic{{},
                        fmt::format("{:.0f} combinations; at most {} cells are flown", cells,
                                    Design::kMostCells)};
    return std::nullopt;
  }
  if (!design.cells)
    return Diagnostic{{}, fmt::format("{} needs 'cells'", kind)};
  if (factors.empty())
    return Diagnostic{{}, fmt::format("{} needs factors", kind)};
  if (design.kind == DesignKind::sobol && factors.size() > kSobolDimensions)
    return Diagnostic{
        {},
        fmt::format("sobol takes at most {} factors, here are {}; choose latin_hypercube",
                    kSobolDimensions, factors.size())};
  return std::nullopt;
}

std::vector<Cell> cells_of(const Design& design, std::span<const Factor> factors) {
  if (design.kind == DesignKind::full_factorial)
    return full_factorial(factors);
  if (design.kind == DesignKind::one_at_a_time)
    return one_at_a_time(factors);
  std::vector<Cell> cells(*design.cells);
  for (std::size_t f = 0; f < factors.size(); ++f) {
    const std::vector<double> at = places(design, f);
    for (std::size_t i = 0; i < cells.size(); ++i)
      cells[i].values.push_back(factors[f].value_at(at[i]));
  }
  return cells;
}

std::uint32_t sobol(std::uint32_t i, std::size_t dimension) {
  // Bratley & Fox, ACM Trans. Math. Softw. 14 (1988) 88: direction numbers v, points by Gray code
  std::array<std::uint32_t, 32> v{};
  for (unsigned k = 0; k < v.size(); ++k) {
    if (dimension == 0) {
      v[k] = 1u << (31 - k);
      continue;
    }
    const auto& [degree, polynomial, first] = kDirections[dimension - 1];
    if (k < degree) {
      v[k] = first[k] << (31 - k);
      continue;
    }
    v[k] = v[k - degree] ^ (v[k - degree] >> degree);
    for (unsigned j = 1; j < degree; ++j)
      v[k] ^= (polynomial >> (degree - 1 - j) & 1u) * v[k - j];
  }
  std::uint32_t point = 0;
  for (std::uint32_t gray = i ^ (i >> 1); gray != 0; gray &= gray - 1)
    point ^= v[static_cast<unsigned>(std::countr_zero(gray))];
  return point;
}

}  // namespace eyrie::campaign
