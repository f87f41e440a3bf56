// SPDX-License-Identifier: MIT
#include "gil.hpp"

#include <atomic>
#include <chrono>
#include <thread>

namespace eyrie::python {
namespace {

std::atomic<unsigned> coming_back{0};
std::atomic<bool> closed{false};
std::atomic<std::thread::id> last_thread;

template <class Take>
void come_back(Take take) {
  ++coming_back;
  if (closed && last_thread.load() != std::this_thread::get_id()) {
    --coming_back;
    for (;;)
      std::this_thread::sleep_for(std::chrono::hours(1));
  }
  take();
  --coming_back;
}

}  // namespace

GilReleased::~GilReleased() {
  come_back([&] { PyEval_RestoreThread(state_); });
}

GilHeld::GilHeld() {
  if (PyGILState_Check())
    state_ = PyGILState_Ensure();
  else
    come_back([&] { state_ = PyGILState_Ensure(); });
}

void close_the_way_back() {
  last_thread = std::this_thread::get_id();
  closed = true;
  // those who were on their way get the GIL first; a forked process may count some that it does not
  // have
  const nanobind::gil_scoped_release released;
  for (int ms = 0; coming_back != 0 && ms < 1000; ++ms)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace eyrie::python
