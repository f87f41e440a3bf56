// SPDX-License-Identifier: MIT
#include "faults/allocation.hpp"

#include <signal.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {
std::atomic<std::uint64_t> count{0}, moment{0};
std::atomic<int> signal_then{0};
}  // namespace

namespace eyrie::test {

std::uint64_t allocations() {
  return count;
}
void at_allocation(std::uint64_t n, int signal) {
  signal_then = signal;
  moment = n ? count + n : 0;
}

}  // namespace eyrie::test

// The array and nothrow forms of the library call these. Not inlined: the compiler would compare
// malloc with delete and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (++count == moment) {
    if (const int signal = signal_then)
      ::raise(signal);
    else
      throw std::bad_alloc();
  }
  if (void* const memory = std::malloc(size > 0 ? size : 1))
    return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  if (++count == moment && !signal_then)
    throw std::bad_alloc();
  void* memory = nullptr;
  if (::posix_memalign(&memory, static_cast<std::size_t>(alignment), size > 0 ? size : 1) == 0)
    return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
