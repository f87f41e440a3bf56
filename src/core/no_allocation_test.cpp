// SPDX-License-Identifier: MIT
#include "support/no_allocation.hpp"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <string>
#include <thread>
#include <vector>

namespace eyrie {
namespace {

struct alignas(128) Aligned {
  char bytes[128];
};

/// Out of the optimiser's sight.
template <class T>
void keep(T& value) {
  asm volatile("" : : "r"(&value) : "memory");
}

void make_a_vector() {
  std::vector<int> numbers(100);
  keep(numbers);
}

TEST(NoAllocation, CountsInThisBuild) {
  EXPECT_TRUE(NoAllocation::counts());
}

TEST(NoAllocation, StaysSilentWhenNothingIsAllocated) {
  NoAllocation guard;
  int numbers[100] = {};
  keep(numbers);
  EXPECT_EQ(guard.count(), 0u);
}

TEST(NoAllocation, FailsTheTestWhenSomethingIs) {
  EXPECT_NONFATAL_FAILURE(
      {
        NoAllocation guard;
        make_a_vector();
      },
      "used 2 times");
}

TEST(NoAllocation, SeesEveryFormOfNewAndDelete) {
  const auto uses = [](auto make) {
    NoAllocation guard;
    make();
    guard.dismiss();
    return guard.count();
  };
  EXPECT_EQ(uses([] { ::operator delete(::operator new(8)); }), 2u);
  EXPECT_EQ(uses([] { ::operator delete[](::operator new[](8)); }), 2u);
  EXPECT_EQ(uses([] { ::operator delete(::operator new(8, std::nothrow), std::nothrow); }), 2u);
  EXPECT_EQ(uses([] {
              auto aligned = std::make_unique<Aligned>();
              keep(aligned);
            }),
            2u);
  EXPECT_EQ(uses([] {
              auto aligned = std::make_unique<Aligned[]>(3);
              keep(aligned);
            }),
            2u);
  EXPECT_EQ(uses([] {
              std::string text(100, 'x');
              keep(text);
            }),
            2u);
}

TEST(NoAllocation, SeesAFreeAlone) {
  EXPECT_NONFATAL_FAILURE(
      {
        static std::unique_ptr<int> inner;
        inner = std::make_unique<int>(2);
        NoAllocation guard;
        inner.reset();
      },
      "used 1 times");
}

TEST(NoAllocation, CountsOtherThreadsOnlyInProcessScope) {
  NoAllocation own(NoAllocation::Scope::thread), all(NoAllocation::Scope::process);
  own.dismiss();
  all.dismiss();
  std::thread other(make_a_vector);
  const std::uint64_t by_this_thread = own.count();
  other.join();
  EXPECT_GE(all.count(), by_this_thread + 2);
}

}  // namespace
}  // namespace eyrie
