// SPDX-License-Identifier: MIT
#pragma once
/// \file  Everything that a driver's tree may be made of.
#include "driver/trees.hpp"

namespace eyrie::driver {

/// The standard nodes and all behaviors and conditions of drivers.
[[nodiscard]] Registry make_registry();

}  // namespace eyrie::driver
