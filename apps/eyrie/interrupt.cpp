// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <signal.h>

#include <atomic>
#include <cerrno>

#include "disk/temporary.hpp"

namespace eyrie::app {
namespace {

std::atomic<int> noted = 0;

extern "C" void on_interrupt(int signal) {
  const int error = errno;
  int none = 0;
  // each output may reach its limit, one after the other
  if (!noted.compare_exchange_strong(none, signal) && signal != SIGXFSZ &&
      disk::remove_temporaries_now()) {
    ::signal(signal, SIG_DFL);
    ::raise(signal);
  }
  errno = error;
}

extern "C" void on_gone_reader(int) {}

void handle(int signal, void (*handler)(int)) {
  struct sigaction before {
  }, after{};
  ::sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN)
    return;
  after.sa_handler = handler;
  after.sa_flags = SA_RESTART;
  ::sigaction(signal, &after, nullptr);
}

}  // namespace

void listen_for_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXFSZ})
    handle(signal, on_interrupt);
  handle(SIGPIPE, on_gone_reader);
}
int interruption() {
  return noted;
}

}  // namespace eyrie::app
