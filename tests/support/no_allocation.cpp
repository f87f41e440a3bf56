// SPDX-License-Identifier: MIT
#include "support/no_allocation.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define EYRIE_MALLOC_HOOKS 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define EYRIE_MALLOC_HOOKS 1
#endif
#endif

namespace {

std::atomic<std::uint64_t> process_count{0};
thread_local std::uint64_t thread_count = 0;

void count_one() {
  ++thread_count;
  process_count.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

#if defined(EYRIE_MALLOC_HOOKS)

// of <sanitizer/allocator_interface.h>, which GCC 12 does not install
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void*,
                                                                             std::size_t),
                                                         void (*free_hook)(const volatile void*));

namespace {

void on_malloc(const volatile void*, std::size_t) {
  count_one();
}
void on_free(const volatile void*) {
  count_one();
}

[[maybe_unused]] const bool hooked =
    __sanitizer_install_malloc_and_free_hooks(on_malloc, on_free) != 0;

}  // namespace

#else

// The array and nothrow forms of the library call these. Not inlined: the compiler would compare
// malloc with delete and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  count_one();
  if (void* const memory = std::malloc(size > 0 ? size : 1))
    return memory;
  throw std::bad_alloc();
}

[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  count_one();
  const std::size_t unit = static_cast<std::size_t>(alignment);
  if (void* const memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit))
    return memory;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* memory) noexcept {
  if (memory != nullptr)
    count_one();
  std::free(memory);
}

void operator delete(void* memory, std::align_val_t) noexcept {
  ::operator delete(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  ::operator delete(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  ::operator delete(memory);
}

#endif

namespace eyrie {
namespace {

std::uint64_t current(NoAllocation::Scope scope) {
  return scope == NoAllocation::Scope::thread ? thread_count
                                              : process_count.load(std::memory_order_relaxed);
}

bool try_out() {
  const std::uint64_t thread_before = thread_count, process_before = process_count.load();
  ::operator delete(::operator new(1));  // called by name, so that it cannot be optimised away
  const bool seen = thread_count >= thread_before + 2 && process_count.load() >= process_before + 2;
  if (!seen)
    std::fputs("NoAllocation cannot count in this build: what it guards is not checked\n", stderr);
  return seen;
}

}  // namespace

bool NoAllocation::counts() {
  static const bool seen = try_out();
  return seen;
}

NoAllocation::NoAllocation(Scope scope) : scope_(scope) {
  static_cast<void>(counts());
  before_ = current(scope_);
}

NoAllocation::~NoAllocation() {
  if (const std::uint64_t n = count(); armed_ && n > 0)
    ADD_FAILURE() << "the heap was used " << n << " times where nothing may be allocated";
}

std::uint64_t NoAllocation::count() const {
  return current(scope_) - before_;
}

}  // namespace eyrie
