// SPDX-License-Identifier: MIT
#include "pilot/pilot_system.hpp"

template class eyrie::team::AgentSystem<eyrie::pilot::Piloting>;
