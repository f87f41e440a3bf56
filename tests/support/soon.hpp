// SPDX-License-Identifier: MIT
#pragma once
/// \file  Waiting for what another thread or process does.
#include <chrono>
#include <thread>

namespace eyrie::test {

/// Whether it comes true within 300 seconds: programs that are watched by a sanitizer are slow.
template <class F>
[[nodiscard]] bool soon(F&& true_now) {
  for (int i = 0; i < 60'000; ++i) {
    if (true_now())
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace eyrie::test
