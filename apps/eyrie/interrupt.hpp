// SPDX-License-Identifier: MIT
#pragma once

namespace eyrie::app {

/// From now on the first Ctrl-C is noted and the second one ends the program.
void listen_for_interrupts();
[[nodiscard]] bool interrupted();

}  // namespace eyrie::app
