// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <atomic>
#include <csignal>

namespace eyrie::app {
namespace {

std::atomic<bool> noted = false;

extern "C" void on_interrupt(int) {
  noted = true;
  std::signal(SIGINT, SIG_DFL);  // the second time it ends at once
}

}  // namespace

void listen_for_interrupts() {
  std::signal(SIGINT, on_interrupt);
}
bool interrupted() {
  return noted;
}

}  // namespace eyrie::app
