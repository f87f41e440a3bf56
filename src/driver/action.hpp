// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a driver wants. An empty field is "no opinion".
#include <cstdint>
#include <optional>
#include <tuple>

#include "core/enum_names.hpp"
#include "ubf/action_traits.hpp"

namespace eyrie::driver {

/// What the driver calls out while doing it: told as an event when it changes.
enum class Call : std::uint32_t { none, scatter };
constexpr auto names_of(Call) {
  return names_from_zero<Call>("none", "scatter");
}

/// The recommendation of one behavior, or of a whole tree. A field that is empty at the root leaves
/// heading and speed as they are.
struct Action {
  std::optional<double> heading;  ///< rad, true
  std::optional<double> speed;    ///< m/s; 0 stands
  std::optional<Call> call;       ///< ends
};

}  // namespace eyrie::driver

template <>
struct eyrie::ubf::ActionTraits<eyrie::driver::Action> {
  using A = driver::Action;
  static constexpr auto fields =
      std::tuple{field<blend::Angle>("heading", &A::heading, "rad", {-1e4, 1e4}),
                 field<blend::Mean>("speed", &A::speed, "m/s", {-10e3, 10e3}),
                 field<blend::Strongest>("call", &A::call)};
};
