// SPDX-License-Identifier: MIT
#pragma once

/// \file The elementary functions that a step may use. They are made of + - * / sqrt and bit
/// operations only, so they give the same bits on every IEEE 754 machine, which libm does not:
/// glibc picks other code on a processor without FMA.

namespace eyrie::math {

struct SinCos {
  double sin, cos;
};

[[nodiscard]] SinCos sin_cos(double x);
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
[[nodiscard]] double tan(double x);
[[nodiscard]] double asin(double x);
[[nodiscard]] double acos(double x);
[[nodiscard]] double atan(double x);
[[nodiscard]] double atan2(double y, double x);
[[nodiscard]] double exp(double x);
[[nodiscard]] double exp2(double x);
[[nodiscard]] double log(double x);
[[nodiscard]] double log2(double x);
[[nodiscard]] double log10(double x);
[[nodiscard]] double pow(double x, double y);
[[nodiscard]] double cbrt(double x);

}  // namespace eyrie::math
