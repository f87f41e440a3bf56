// SPDX-License-Identifier: MIT
#pragma once
/// \file  Work that is done in any order, on any thread, and taken in order.
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace eyrie::campaign {

/// Calls `R work(i)` once for each i in [0, n), on so many threads, each of which takes the next i
/// when it is free; and `bool take(i, R&&)` in the calling thread in the order of i. So what is
/// taken depends neither on the number of workers nor on who is faster. At most kAhead results per
/// worker wait to be taken. An exception of work(i) arrives at the caller in the place of take(i).
/// After that, or false from take, no more work begins; what has begun is finished and dropped. One
/// worker is the calling thread itself.
template <class R, class Work, class Take>
void in_order(std::uint64_t n, unsigned workers, Work work, Take take) {
  if (workers <= 1 || n <= 1) {
    for (std::uint64_t i = 0; i < n && take(i, R(work(i))); ++i) {
    }
    return;
  }
  constexpr std::uint64_t kAhead = 64;
  struct Slot {
    std::optional<R> result;
    std::exception_ptr thrown;
  };
  std::mutex mutex;
  std::condition_variable room, done;
  std::vector<Slot> slots(kAhead * workers);  // that of i is i % size
  std::uint64_t begun = 0, taken = 0, end = n;

  const auto help = [&] {
    for (std::unique_lock lock(mutex);;) {
      room.wait(lock, [&] { return begun >= end || begun < taken + slots.size(); });
      if (begun >= end)
        return;
      const std::uint64_t i = begun++;
      lock.unlock();
      Slot mine;
      try {
        mine.result.emplace(work(i));
      } catch (...) {
        mine.thrown = std::current_exception();
      }
      lock.lock();
      slots[i % slots.size()] = std::move(mine);
      if (i == taken)
        done.notify_one();
    }
  };
  std::vector<std::jthread> helpers;
  const struct Ending {  // before they are joined
    std::mutex& mutex;
    std::condition_variable& room;
    std::uint64_t& end;
    ~Ending() {
      const std::lock_guard lock(mutex);
      end = 0;
      room.notify_all();
    }
  } ending{mutex, room, end};
  for (unsigned w = 0; w < workers && w < n; ++w)
    helpers.emplace_back(help);

  for (std::uint64_t i = 0; i < n; ++i) {
    std::unique_lock lock(mutex);
    Slot& slot = slots[i % slots.size()];
    done.wait(lock, [&] { return slot.result || slot.thrown; });
    Slot next = std::exchange(slot, {});
    lock.unlock();
    if (next.thrown)
      std::rethrow_exception(next.thrown);
    if (!take(i, std::move(*next.result)))
      return;
    lock.lock();
    taken = i + 1;
    room.notify_all();
  }
}

}  // namespace eyrie::campaign
