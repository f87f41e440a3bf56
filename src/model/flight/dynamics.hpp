// SPDX-License-Identifier: MIT
#pragma once
/// \file  The two equations of motion.
#include <cstdint>

#include "core/enum_names.hpp"

namespace eyrie::model {

/// Which equations of motion an aircraft flies by.
enum class Dynamics : std::uint8_t {
  laero,       ///< rate limits only, as the paper's aircraft
  point_mass,  ///< lift, drag, thrust, weight and fuel
};

}  // namespace eyrie::model

template <>
struct eyrie::EnumNames<eyrie::model::Dynamics> {
  using E = eyrie::model::Dynamics;
  static constexpr std::array names{std::pair<std::string_view, E>{"laero", E::laero},
                                    std::pair<std::string_view, E>{"point_mass", E::point_mass}};
};
