// SPDX-License-Identifier: MIT
#pragma once

namespace eyrie::app {

/// From now on the first signal that asks the program to end (Ctrl-C, a closed terminal, a file at
/// its limit) is noted, and what is being made is brought to its end. A second one ends the program
/// at once, without anything that is half written. Signals that were ignored stay so, as under
/// nohup. A reader who has gone is seen when something is written for him.
void listen_for_interrupts();
/// The signal that was noted; 0: none.
[[nodiscard]] int interruption();
[[nodiscard]] inline bool interrupted() {
  return interruption() != 0;
}

}  // namespace eyrie::app
