// SPDX-License-Identifier: MIT
// Exponentials and logarithms. Where one double does not hold enough, a value is the sum of two.
#include "core/math.hpp"

namespace eyrie::math {
namespace {

// ln 2 in two parts, the first short enough for an exact product with any exponent
constexpr double kLn2High = 0x1.62e42feep-1, kLn2Low = 0x1.a39ef35793c76p-33;

/// An unevaluated sum; `low` is below the last bit of `high`.
struct Pair {
  double high, low;
};

/// a + b without error, for |a| >= |b| (Dekker 1971).
constexpr Pair exact_sum(double a, double b) {
  const double sum = a + b;
  return {sum, (a - sum) + b};
}

struct Split {
  double high, low;
};
/// The leading 26 bits and the rest.
constexpr Split split(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x) & ~((std::uint64_t{1} << 27) - 1);
  const double high = std::bit_cast<double>(bits);
  return {high, x - high};
}

/// a * b without error but for the last of 106 bits (Dekker 1971).
constexpr Pair exact_product(double a, double b) {
  const Split sa = split(a), sb = split(b);
  const double product = a * b;
  const double error =
      ((sa.high * sb.high - product) + sa.high * sb.low + sa.low * sb.high) + sa.low * sb.low;
  return {product, error};
}

constexpr Pair product(const Pair& a, const Pair& b) {
  const Pair p = exact_product(a.high, b.high);
  return exact_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/// e^(r + tail) for |r| <= 0.35.
template <class Real>
Real exp_near_zero(const Real& r, const Real& tail) {
  // e^r = 1 + r + r^2 / 2 + r^3 q(r): minimax, 2^-60
  const Real z = r * r;
  const Real q =
      detail::horner(z, 0x1.5555555555558p-3, 0x1.111111110fb5cp-7, 0x1.a01a01ae88341p-13,
                     0x1.71ddfafcdb3e7p-19, 0x1.af5b05a3614a3p-26) +
      r * detail::horner(z, 0x1.5555555555535p-5, 0x1.6c16c16c267e8p-10, 0x1.a01a014f420acp-16,
                         0x1.27e59ce11af88p-22, 0x1.1e443954217eep-29);
  const Real one = 1 + r, rest = (1 - one) + r;
  return one + (rest + (tail + tail * r + z * (0.5 + r * q)));
}

/// e^(r + tail) 2^n for |r| <= 0.35.
double scaled_exp(double r, double tail, std::int64_t n) {
  const double value = exp_near_zero(r, tail);
  // times 2^n; in two steps where that alone is no normal number
  const auto power = [](std::int64_t e) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
  };
  if (n >= -1022 && n <= 1023)
    return value * power(n);
  const std::int64_t half = n / 2;
  return value * power(half) * power(n - half);
}

/// x + low = r + tail + n ln 2, |x| <= 750.
template <class Real>
struct Reduced {
  Real r, tail, n;

  Reduced(const Real& x, const Real& low) {
    const Real shifted = x * 0x1.71547652b82fep+0 + detail::kRounder;
    n = shifted - detail::kRounder;
    const Real a = x - n * kLn2High;
    const Real b = n * kLn2Low;
    const Real near = a - b;
    const Real rest = ((a - near) - b) + low;
    r = near + rest;
    tail = (near - r) + rest;
  }
};

/// e^(x + low), |x| <= 750.
double exp_of(double x, double low) {
  const Reduced<double> e(x, low);
  return scaled_exp(e.r, e.tail, static_cast<std::int64_t>(e.n));
}

/// x = m 2^k with m in [sqrt(1/2), sqrt(2)), for finite x > 0.
struct Scaled {
  double m, k;
};
Scaled scaled(double x) {
  double below = 0;
  if (x < 0x1p-1022) {
    x *= 0x1p54;
    below = 54;
  }
  constexpr std::uint64_t kRootHalf = 0x3fe6a09e667f3bcd;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::int64_t k = static_cast<std::int64_t>(bits - kRootHalf) >> 52;
  return {std::bit_cast<double>(bits - (static_cast<std::uint64_t>(k) << 52)),
          static_cast<double>(k) - below};
}

/// Whether x has a logarithm that is a number; if not, what C says it is.
bool ordinary(double x) {
  return x > 0 && x < kInfinity;
}
double log_special(double x) {
  return x == 0 ? -kInfinity : x > 0 ? kInfinity : kNaN;
}

/// One piece of the range of m: a factor of few bits that brings m close to 1, and its logarithm.
struct LogCell {
  double factor;
  double high, low;  ///< -log(factor); high is a multiple of 2^-42, so that adding k ln 2 is exact
};
constexpr int kCells = 128;  // per unit of m; m is in the cell around round(m kCells) / kCells
constexpr int kFirstCell = 90, kLastCell = 182;

/// -log(n / 2048) to 2^-100, for s = (n - 2048) / (n + 2048) by the series
/// -2 atanh(s) = -2 s (1 + s^2 / 3 + s^4 / 5 ...). Evaluated by the compiler only.
constexpr Pair minus_log(int n) {
  const auto ratio = [](double a, double b) -> Pair {
    const double quotient = a / b;
    const Pair back = exact_product(quotient, b);
    return {quotient, ((a - back.high) - back.low) / b};
  };
  const Pair s = ratio(n - 2048, n + 2048);
  const Pair square = product(s, s);
  Pair sum{0, 0};
  for (int odd = 41; odd >= 1; odd -= 2) {
    const Pair term = ratio(1, odd);
    const Pair rest = product(sum, square);
    const Pair both = exact_sum(term.high, rest.high);
    sum = exact_sum(both.high, both.low + (term.low + rest.low));
  }
  const Pair half = product(s, sum);
  return {-2 * half.high, -2 * half.low};
}

constexpr auto kLogCells = [] {
  std::array<LogCell, kLastCell - kFirstCell + 1> cells{};
  for (int i = kFirstCell; i <= kLastCell; ++i) {
    const int n = (2048 * kCells + i / 2) / i;
    const Pair value = minus_log(n);
    const double high =
        static_cast<double>(static_cast<std::int64_t>(value.high * 0x1p42)) * 0x1p-42;
    cells[i - kFirstCell] = {n / 2048.0, high, (value.high - high) + value.low};
  }
  return cells;
}();

/// k ln 2 + log(m) to about 2^-66 of itself.
Pair log_pair(const Scaled& x) {
  const LogCell& cell = kLogCells[static_cast<int>(x.m * kCells + 0.5) - kFirstCell];

  // m factor = 1 + r, |r| < 2^-7, in two exact parts, the first of at most 26 bits
  constexpr std::uint64_t kHalf = std::uint64_t{1} << 30;
  const auto bits = (std::bit_cast<std::uint64_t>(x.m) + kHalf) & ~(2 * kHalf - 1);
  const double m_high = std::bit_cast<double>(bits);
  const double r_high = m_high * cell.factor - 1;
  const double r_low = (x.m - m_high) * cell.factor;
  const Pair r = exact_sum(r_high, r_low);

  // log(1 + r) = r - r^2 / 2 + r^3 p(r): minimax, 2^-68
  const double half_square = 0.5 * r_high * r_high;
  const double zz = r.high * r.high;
  const double p =
      detail::horner(zz, 0x1.555555555556bp-2, 0x1.999999931a722p-3, 0x1.2496acf2d81bcp-3) +
      r.high *
          detail::horner(zz, -0x1.000000000002dp-2, -0x1.5555554c0f67ap-3, -0x1.0004d19f9f9aep-3);
  const double rest = zz * r.high * p - r_low * (r_high + 0.5 * r_low);

  const Pair a = exact_sum(x.k * kLn2High + cell.high, r.high);
  const Pair b = exact_sum(a.high, -half_square);
  return exact_sum(b.high, a.low + b.low + (r.low + (x.k * kLn2Low + cell.low) + rest));
}

}  // namespace

double exp(double x) {
  if (!(std::fabs(x) <= 750))
    return std::isnan(x) ? kNaN : x > 0 ? kInfinity : 0;
  return exp_of(x, 0);
}

std::array<double, 2> exp(double x, double y) {
  if (!(std::fabs(x) <= 700 && std::fabs(y) <= 700))
    return {exp(x), exp(y)};
  using Both = Lanes<2>;
  const Reduced<Both> e(Both(Both::Vector{x, y}), 0);
  const Both value = exp_near_zero(e.r, e.tail);
  const auto times_power = [&](std::size_t i) {
    const auto n = static_cast<std::int64_t>(lane(e.n, i));
    return lane(value, i) * std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
  };
  return {times_power(0), times_power(1)};
}

double exp2(double x) {
  if (!(std::fabs(x) <= 1100))
    return std::isnan(x) ? kNaN : x > 0 ? kInfinity : 0;
  const double n = (x + detail::kRounder) - detail::kRounder;
  const Pair r = product({x - n, 0}, {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56});
  return scaled_exp(r.high, r.low, static_cast<std::int64_t>(n));
}

double log(double x) {
  return ordinary(x) ? log_pair(scaled(x)).high : log_special(x);
}

double log2(double x) {
  if (!ordinary(x))
    return log_special(x);
  const auto [m, k] = scaled(x);
  const Pair fraction = product(log_pair({m, 0}), {0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56});
  const Pair sum = exact_sum(k, fraction.high);
  return k == 0 ? fraction.high : sum.high + (sum.low + fraction.low);
}

double log10(double x) {
  if (!ordinary(x))
    return log_special(x);
  return product(log_pair(scaled(x)), {0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57}).high;
}

double pow(double x, double y) {
  if (y == 0 || x == 1)
    return 1;
  if (std::isnan(x) || std::isnan(y) || x < 0)
    return kNaN;
  const bool huge = (x > 1) == (y > 0);  // if y is infinite, or x is 0 or infinite
  if (x == 0 || std::isinf(x) || std::isinf(y))
    return huge ? kInfinity : 0;
  const Pair log_x = log_pair(scaled(x));
  const double estimate = y * log_x.high;
  if (!(std::fabs(estimate) <= 750))
    return huge ? kInfinity : 0;
  const Pair exponent = exact_product(y, log_x.high);
  return exp_of(exponent.high, exponent.low + y * log_x.low);
}

}  // namespace eyrie::math
