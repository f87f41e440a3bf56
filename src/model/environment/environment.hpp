// SPDX-License-Identifier: MIT
#pragma once
/// \file  What surrounds everybody: the air and its wind.
#include <string_view>
#include <tuple>
#include <vector>

#include "core/describe.hpp"
#include "model/environment/atmosphere.hpp"
#include "model/environment/wind.hpp"

namespace eyrie::model {

/// What a scenario says about the environment.
struct EnvironmentSpec {
  static constexpr std::string_view type_name = "environment";
  static constexpr std::string_view help = "the standard atmosphere, with a steady wind if wanted";
  static constexpr auto params() {
    return std::tuple{
        param("wind", &EnvironmentSpec::wind, "layers of wind from low to high; none: calm air")};
  }

  std::vector<WindLayer> wind;
};

/// The environment of a run. Immutable and shared.
struct Environment {
  Environment() = default;
  /// std::logic_error if Wind::problem(spec.wind).
  explicit Environment(const EnvironmentSpec& spec) : wind(spec.wind) {}

  Atmosphere atmosphere;
  Wind wind;
};

}  // namespace eyrie::model
