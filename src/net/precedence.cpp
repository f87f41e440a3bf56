// SPDX-License-Identifier: MIT
#include "net/precedence.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace eyrie::net {
namespace {

using std::chrono::milliseconds;

/// Of the calling thread.
bool run_before_others(bool wanted) {
  // a low one of the 99: threads of the kernel and of sound come first
  const sched_param priority{.sched_priority = wanted ? 10 : 0};
  const int policy = (wanted ? SCHED_FIFO : SCHED_OTHER) | SCHED_RESET_ON_FORK;
  return sched_setscheduler(0, policy, &priority) == 0;
}

}  // namespace

/// Looks after the thread that made it.
class Precedence::Lookout {
 public:
  Lookout(Clock::duration grace, const cpu_set_t& all)
      : grace_(grace), whom_(::gettid()), all_(all), thread_([this] { look(); }) {}
  ~Lookout() {
    ended_ = true;
    thread_.join();
    let_go();
  }

  /// By the thread that is looked after.
  void sleep_until(Clock::time_point until) {
    {
      std::unique_lock lock(mutex_);
      where_ = sched_getcpu();
      expected_ = until;
      wake_.wait_until(lock, until, [&] { return expected_ != until; });
      expected_ = kNever;
    }
    let_go();
  }
  /// It may run on any processor again.
  void let_go() {
    const std::lock_guard lock(mutex_);
    if (std::exchange(moved_, false))
      sched_setaffinity(whom_, sizeof all_, &all_);
  }
  [[nodiscard]] std::uint64_t moves() const {
    const std::lock_guard lock(mutex_);
    return moves_;
  }

 private:
  static constexpr Clock::time_point kNever{};
  static constexpr milliseconds kNap{5};

  void look() {
    if (!run_before_others(true))
      return;
    for (int avoided = -1; !ended_;) {
      Clock::time_point expected;
      int where;
      {
        const std::lock_guard lock(mutex_);
        expected = expected_;
        where = where_;
      }
      // where the other one sleeps nobody may be able to wake
      if (where != avoided && where >= 0) {
        cpu_set_t others = all_;
        CPU_CLR(static_cast<unsigned>(where), &others);
        sched_setaffinity(0, sizeof others, &others);
        avoided = where;
      }
      const auto nap = Clock::now() + kNap;
      std::this_thread::sleep_until(expected == kNever ? nap : std::min(expected + grace_, nap));
      if (expected != kNever && Clock::now() >= expected + grace_)
        move(expected);
    }
  }

  void move(Clock::time_point expected) {
    {
      const std::lock_guard lock(mutex_);
      if (expected_ != expected)
        return;  // it woke
      cpu_set_t here;
      CPU_ZERO(&here);
      CPU_SET(static_cast<unsigned>(sched_getcpu()), &here);
      // also one that is awake and waits for its processor goes over at once
      sched_setaffinity(whom_, sizeof here, &here);
      moved_ = true;
      expected_ = kNever;
      ++moves_;
    }
    wake_.notify_one();
  }

  const Clock::duration grace_;
  const pid_t whom_;
  const cpu_set_t all_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  Clock::time_point expected_ = kNever;  ///< to wake
  int where_ = -1;                       ///< the processor it sleeps at
  bool moved_ = false;
  std::uint64_t moves_ = 0;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

Precedence::Precedence(Clock::duration grace) : grace_(grace) {}

Precedence::~Precedence() {
  lookout_.reset();
  ask(false);
}

void Precedence::ask(bool wanted) {
  if (wanted == asked_)
    return;
  asked_ = wanted;
  const bool done = run_before_others(wanted);
  if (!wanted) {
    if (lookout_)
      lookout_->let_go();
    return;
  }
  permitted_ = done;
  cpu_set_t all;
  if (permitted_ && !lookout_ && sched_getaffinity(0, sizeof all, &all) == 0 && CPU_COUNT(&all) > 1)
    lookout_ = std::make_unique<Lookout>(grace_, all);
}

void Precedence::sleep_until(Clock::time_point due, const std::function<bool()>& enough) {
  constexpr milliseconds kPiece(50);
  for (auto now = Clock::now(); now < due && !enough(); now = Clock::now()) {
    const Clock::time_point until = std::min(due, now + kPiece);
    if (asked_ && lookout_)
      lookout_->sleep_until(until);
    else
      std::this_thread::sleep_until(until);
  }
}

std::uint64_t Precedence::moves() const {
  return lookout_ ? lookout_->moves() : 0;
}

}  // namespace eyrie::net
