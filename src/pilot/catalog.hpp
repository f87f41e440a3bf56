// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every node that a pilot's tree may be made of. A new behavior is one name in catalog.cpp.
#include "pilot/trees.hpp"

namespace eyrie::pilot {

[[nodiscard]] Registry make_registry();

}  // namespace eyrie::pilot
