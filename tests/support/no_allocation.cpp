// SPDX-License-Identifier: MIT
#include "support/no_allocation.hpp"

namespace eyrie {
}
