// SPDX-License-Identifier: MIT
#pragma once
/// \file  Boost's distributions, reckoned in double. As they come they reckon in long double, which
/// has other digits on another CPU, and some that valgrind does not know.
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace eyrie::stats {

using InDouble = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Binomial = boost::math::binomial_distribution<double, InDouble>;
using Normal = boost::math::normal_distribution<double, InDouble>;
using StudentsT = boost::math::students_t_distribution<double, InDouble>;

}  // namespace eyrie::stats
