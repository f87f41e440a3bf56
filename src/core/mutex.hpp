// SPDX-License-Identifier: MIT
#pragma once
#include <mutex>

namespace eyrie {

#ifdef __wasm__
/// The module has one thread, and its library no mutex.
struct Mutex {
  void lock() {}
  void unlock() {}
};
#else
using Mutex = std::mutex;
#endif

}  // namespace eyrie
