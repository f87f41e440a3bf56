// SPDX-License-Identifier: MIT
#pragma once
/// \file  Arithmetic on several doubles side by side. A function that is written for a type `Real`
/// runs on one double or on Lanes, and every lane has the bits that one double would have: lanes
/// are + - * / and sqrt of IEEE 754, and what depends on a comparison is selected, never branched.
/// `select`, `max`, `min` and `clamp` compare as those of C++ do, with NaN and signed zeros too.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace eyrie::math {

/// Vectors of the compiler.
template <std::size_t N>
struct LaneTypes {
  using Reals [[gnu::vector_size(8 * N)]] = double;
  using Mask [[gnu::vector_size(8 * N)]] = std::int64_t;
  using Whole [[gnu::vector_size(4 * N)]] = std::int32_t;
  using Bits [[gnu::vector_size(8 * N)]] = std::uint64_t;
};

/// What a comparison of lanes says of each.
template <std::size_t N>
struct LaneMask {
  typename LaneTypes<N>::Mask bits;

  friend LaneMask operator&(LaneMask a, LaneMask b) { return {a.bits & b.bits}; }
  friend LaneMask operator|(LaneMask a, LaneMask b) { return {a.bits | b.bits}; }
  friend LaneMask operator!(LaneMask a) { return {~a.bits}; }
};

template <std::size_t N>
struct Lanes {
  using Vector = typename LaneTypes<N>::Reals;
  Vector v;

  Lanes() = default;
  explicit Lanes(Vector vector) : v(vector) {}
  Lanes(double same) {  // NOLINT: a number is a number in every lane
    for (std::size_t i = 0; i < N; ++i)
      v[i] = same;
  }

  friend Lanes operator+(Lanes a, Lanes b) { return Lanes{a.v + b.v}; }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes{a.v - b.v}; }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes{a.v * b.v}; }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes{a.v / b.v}; }
  friend Lanes operator-(Lanes a) { return Lanes{-a.v}; }
  Lanes& operator+=(Lanes b) { return *this = *this + b; }
  friend LaneMask<N> operator<(Lanes a, Lanes b) { return {a.v < b.v}; }
  friend LaneMask<N> operator>(Lanes a, Lanes b) { return {a.v > b.v}; }
  friend LaneMask<N> operator<=(Lanes a, Lanes b) { return {a.v <= b.v}; }
  friend LaneMask<N> operator>=(Lanes a, Lanes b) { return {a.v >= b.v}; }
};

/// The bits of a Real, as whole numbers.
template <class Real>
struct BitsAs {
  using Type = std::uint64_t;
};
template <std::size_t N>
struct BitsAs<Lanes<N>> {
  using Type = typename LaneTypes<N>::Bits;
};
template <class Real>
using BitsOf = typename BitsAs<Real>::Type;

/// How many doubles a Real is.
template <class Real>
inline constexpr std::size_t kLanes = sizeof(Real) / sizeof(double);
template <class Real>
using MaskOf = decltype(std::declval<Real>() < std::declval<Real>());

inline double lane(double x, std::size_t) {
  return x;
}
inline std::uint64_t lane(std::uint64_t x, std::size_t) {
  return x;
}
template <std::size_t N>
double lane(const Lanes<N>& x, std::size_t i) {
  return x.v[i];
}
template <class Bits>
requires(sizeof(Bits) > sizeof(double)) std::uint64_t lane(const Bits& x, std::size_t i) {
  return x[i];
}

/// The value of each lane, asked one after the other: of(0), of(1), ...
template <class Real, class Of>
Real each_lane(Of of) {
  if constexpr (std::is_same_v<Real, double>) {
    return of(std::size_t{0});
  } else {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return Real(typename Real::Vector{of(I)...});
    }
    (std::make_index_sequence<kLanes<Real>>{});
  }
}

namespace detail {

/// Of two vectors in each four lanes the numbers of these indices: 0 to 3 are those of the first.
template <std::size_t... kOf, class Vector>
Vector shuffled(const Vector& a, const Vector& b) {
  constexpr std::size_t kCount = sizeof(Vector) / sizeof(double);
  constexpr auto index = [](std::size_t lane) {
    const std::size_t of = std::array{kOf...}[lane % 4];
    return of % 4 + of / 4 * kCount + lane / 4 * 4;
  };
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return __builtin_shufflevector(a, b, index(I)...);
  }
  (std::make_index_sequence<kCount>{});
}

/// Row by row becomes column by column, and back, in each four lanes.
template <class Vector>
void transpose(const Vector& a, const Vector& b, const Vector& c, const Vector& d, auto put) {
  const Vector ab_even = shuffled<0, 4, 2, 6>(a, b), ab_odd = shuffled<1, 5, 3, 7>(a, b);
  const Vector cd_even = shuffled<0, 4, 2, 6>(c, d), cd_odd = shuffled<1, 5, 3, 7>(c, d);
  put(0, shuffled<0, 1, 4, 5>(ab_even, cd_even));
  put(1, shuffled<0, 1, 4, 5>(ab_odd, cd_odd));
  put(2, shuffled<2, 3, 6, 7>(ab_even, cd_even));
  put(3, shuffled<2, 3, 6, 7>(ab_odd, cd_odd));
}

/// Lanes by fours.
template <std::size_t N>
using Fours = std::array<typename Lanes<4>::Vector, N / 4>;

/// Calls use(first) for each four of so many numbers; the last four may overlap those before.
template <std::size_t kNumbers>
void each_four(auto use) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (use(std::min(4 * I, kNumbers - 4)), ...);
  }
  (std::make_index_sequence<(kNumbers + 3) / 4>{});
}

}  // namespace detail

/// A row of doubles of each lane as one row of Reals with the same members.
template <class To, class Row, std::size_t kCount>
To to_lanes(const std::array<Row*, kCount>& rows) {
  constexpr std::size_t kNumbers = sizeof(Row) / sizeof(double);
  static_assert(sizeof(To) == kCount * sizeof(Row));
  if constexpr (kCount == 1) {
    return std::bit_cast<To>(*rows[0]);
  } else {
    using Vector = typename Lanes<kCount>::Vector;
    To to;
    Vector* const all = reinterpret_cast<Vector*>(&to);
    const auto numbers = [&](auto i) { return reinterpret_cast<const double*>(rows[i]); };
    if constexpr (kCount >= 4 && kNumbers >= 4)
      detail::each_four<kNumbers>([&](std::size_t first) {
        const auto rows_of = [&](std::size_t i) {
          detail::Fours<kCount> fours;
          for (std::size_t n = 0; n < fours.size(); ++n)
            std::memcpy(&fours[n], numbers(4 * n + i) + first, sizeof fours[n]);
          return std::bit_cast<Vector>(fours);
        };
        detail::transpose(rows_of(0), rows_of(1), rows_of(2), rows_of(3),
                          [&](std::size_t i, const Vector& column) { all[first + i] = column; });
      });
    else
      for (std::size_t n = 0; n < kNumbers; ++n)
        all[n] = each_lane<Lanes<kCount>>([&](std::size_t i) { return numbers(i)[n]; }).v;
    return to;
  }
}
/// And back.
template <class From, class Row, std::size_t kCount>
void from_lanes(const From& from, const std::array<Row*, kCount>& rows) {
  constexpr std::size_t kNumbers = sizeof(Row) / sizeof(double);
  static_assert(sizeof(From) == kCount * sizeof(Row));
  if constexpr (kCount == 1) {
    *rows[0] = std::bit_cast<Row>(from);
  } else {
    using Vector = typename Lanes<kCount>::Vector;
    const Vector* const all = reinterpret_cast<const Vector*>(&from);
    const auto numbers = [&](auto i) { return reinterpret_cast<double*>(rows[i]); };
    if constexpr (kCount >= 4 && kNumbers >= 4)
      detail::each_four<kNumbers>([&](std::size_t first) {
        detail::transpose(all[first], all[first + 1], all[first + 2], all[first + 3],
                          [&](std::size_t i, const Vector& rows_of) {
                            const auto fours = std::bit_cast<detail::Fours<kCount>>(rows_of);
                            for (std::size_t n = 0; n < fours.size(); ++n)
                              std::memcpy(numbers(4 * n + i) + first, &fours[n], sizeof fours[n]);
                          });
      });
    else
      for (std::size_t i = 0; i < kCount; ++i)
        for (std::size_t n = 0; n < kNumbers; ++n)
          numbers(i)[n] = all[n][i];
  }
}

/// of(0), of(1), ...
template <std::size_t kCount, class Of>
auto each_of(Of of) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{of(I)...};
  }
  (std::make_index_sequence<kCount>{});
}

/// Whether a condition holds in one lane.
inline bool holds(bool condition, std::size_t) {
  return condition;
}
template <std::size_t N>
bool holds(const LaneMask<N>& mask, std::size_t i) {
  return mask.bits[i] != 0;
}
/// 1 where the condition holds, else 0.
inline std::uint64_t ones(bool condition) {
  return condition;
}
template <std::size_t N>
BitsOf<Lanes<N>> ones(const LaneMask<N>& mask) {
  return std::bit_cast<BitsOf<Lanes<N>>>(mask.bits) & 1;
}
/// A whole number below 2^52.
template <class Real>
Real whole(const BitsOf<Real>& number) {
  return std::bit_cast<Real>(number | std::bit_cast<std::uint64_t>(0x1p52)) - 0x1p52;
}
/// The whole number at or below x, for x in [0, 2^31); 0 where x is not a number.
inline std::uint64_t whole_part(double x) {
  return static_cast<std::uint64_t>(x > 0 ? static_cast<std::int32_t>(x) : 0);
}
template <std::size_t N>
BitsOf<Lanes<N>> whole_part(const Lanes<N>& x) {
  const auto numbers = x.v > 0 ? x.v : typename Lanes<N>::Vector{};
  return __builtin_convertvector(__builtin_convertvector(numbers, typename LaneTypes<N>::Whole),
                                 BitsOf<Lanes<N>>);
}
/// 1 where x has a minus, else 0.
inline std::uint64_t sign_bit(double x) {
  return std::signbit(x);
}
template <std::size_t N>
BitsOf<Lanes<N>> sign_bit(const Lanes<N>& x) {
  return std::bit_cast<BitsOf<Lanes<N>>>(x) >> 63;
}

/// One bit per lane, the lowest of the first.
template <std::size_t N>
int bits_of(const LaneMask<N>& mask) {
#if defined(__SSE2__)
  if constexpr (N == 2)
    return _mm_movemask_pd(std::bit_cast<__m128d>(mask.bits));
#endif
#if defined(__AVX__)
  if constexpr (N == 4)
    return _mm256_movemask_pd(std::bit_cast<__m256d>(mask.bits));
#endif
#if defined(__AVX512DQ__)
  if constexpr (N == 8)
    return _mm512_movepi64_mask(std::bit_cast<__m512i>(mask.bits));
#endif
  int bits = 0;
  for (std::size_t i = 0; i < N; ++i)
    bits |= holds(mask, i) << i;
  return bits;
}
inline bool any(bool condition) {
  return condition;
}
template <std::size_t N>
bool any(const LaneMask<N>& mask) {
  return bits_of(mask) != 0;
}
inline bool all(bool condition) {
  return condition;
}
template <std::size_t N>
bool all(const LaneMask<N>& mask) {
  return bits_of(mask) == (1 << N) - 1;
}

/// a where the condition holds, else b.
inline double select(bool condition, double a, double b) {
  return condition ? a : b;
}
template <std::size_t N>
Lanes<N> select(const LaneMask<N>& mask, const std::type_identity_t<Lanes<N>>& a,
                const std::type_identity_t<Lanes<N>>& b) {
  return Lanes<N>{mask.bits ? a.v : b.v};
}

template <class Real>
Real max(const Real& a, const std::type_identity_t<Real>& b) {
  return select(a < b, b, a);
}
template <class Real>
Real min(const Real& a, const std::type_identity_t<Real>& b) {
  return select(b < a, b, a);
}
template <class Real>
Real clamp(const Real& x, const std::type_identity_t<Real>& low,
           const std::type_identity_t<Real>& high) {
  return max(min(x, high), low);
}

inline double sqrt(double x) {
  return std::sqrt(x);
}
template <std::size_t N>
Lanes<N> sqrt(const Lanes<N>& x) {
#if defined(__SSE2__)
  if constexpr (N == 2)
    return Lanes<N>{_mm_sqrt_pd(x.v)};
#endif
#if defined(__AVX__)
  if constexpr (N == 4)
    return Lanes<N>{_mm256_sqrt_pd(x.v)};
#endif
#if defined(__AVX512F__)
  if constexpr (N == 8)  // GCC 12 warns of what is not initialised in _mm512_sqrt_pd
    return Lanes<N>{_mm512_maskz_sqrt_pd(0xff, x.v)};
#endif
  return each_lane<Lanes<N>>([&](std::size_t i) { return std::sqrt(x.v[i]); });
}

template <std::size_t N>
Lanes<N> ceil(const Lanes<N>& x) {
#if defined(__AVX__)
  if constexpr (N == 4)
    return Lanes<N>{_mm256_ceil_pd(x.v)};
#endif
#if defined(__AVX512F__)
  if constexpr (N == 8)
    return Lanes<N>{_mm512_maskz_roundscale_pd(0xff, x.v, _MM_FROUND_CEIL)};
#endif
  return each_lane<Lanes<N>>([&](std::size_t i) { return std::ceil(x.v[i]); });
}

inline constexpr std::uint64_t kSign = std::uint64_t{1} << 63;

inline double abs(double x) {
  return std::fabs(x);
}
template <std::size_t N>
Lanes<N> abs(const Lanes<N>& x) {
  return std::bit_cast<Lanes<N>>(std::bit_cast<BitsOf<Lanes<N>>>(x) & ~kSign);
}

inline double copysign(double size, double sign) {
  return std::copysign(size, sign);
}
template <std::size_t N>
Lanes<N> copysign(const Lanes<N>& size, const Lanes<N>& sign) {
  return std::bit_cast<Lanes<N>>((std::bit_cast<BitsOf<Lanes<N>>>(size) & ~kSign) |
                                 (std::bit_cast<BitsOf<Lanes<N>>>(sign) & kSign));
}

}  // namespace eyrie::math
