// SPDX-License-Identifier: MIT
#include "net/precedence.hpp"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>

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
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    news_.notify_one();
    thread_.join();
  }

  /// By the thread that is looked after.
  void sleep_until(Clock::time_point until) {
    std::unique_lock lock(mutex_);
    where_ = sched_getcpu();
    expected_ = until;
    news_.notify_one();
    if (wake_.wait_until(lock, until, [&] { return expected_ != until; })) {
      ++moves_;
      sched_setaffinity(whom_, sizeof all_, &all_);  // anywhere again
    }
    expected_ = kNever;
  }
  [[nodiscard]] std::uint64_t moves() const { return moves_; }

 private:
  static constexpr Clock::time_point kNever{};

  void look() {
    if (!run_before_others(true))
      return;
    std::unique_lock lock(mutex_);
    for (int avoided = -1; !ended_;) {
      const Clock::time_point expected = expected_;
      if (expected == kNever) {
        news_.wait(lock);
      } else if (const int where = where_; where != avoided) {
        lock.unlock();
        stay_away_from(where);
        avoided = where;
        lock.lock();
      } else if (!news_.wait_until(lock, expected + grace_,
                                   [&] { return ended_ || expected_ != expected; })) {
        move_here();
      }
    }
  }

  /// Where the other one sleeps nobody may be able to wake.
  void stay_away_from(int where) const {
    cpu_set_t others = all_;
    CPU_CLR(static_cast<unsigned>(where), &others);
    sched_setaffinity(0, sizeof others, &others);
  }

  /// Also one that is awake and waits for its processor goes over at once.
  void move_here() {
    cpu_set_t here;
    CPU_ZERO(&here);
    CPU_SET(static_cast<unsigned>(sched_getcpu()), &here);
    sched_setaffinity(whom_, sizeof here, &here);
    expected_ = kNever;
    wake_.notify_one();
  }

  const Clock::duration grace_;
  const pid_t whom_;
  const cpu_set_t all_;
  std::mutex mutex_;
  std::condition_variable wake_, news_;  ///< of the one that is looked after, and of this one
  Clock::time_point expected_ = kNever;  ///< to wake
  int where_ = -1;                       ///< the processor it sleeps at
  bool ended_ = false;
  std::uint64_t moves_ = 0;  ///< by the thread that is looked after
  std::thread thread_;
};

Precedence::Precedence(Clock::duration grace) : grace_(grace) {}

Precedence::~Precedence() {
  ask(false);
}

void Precedence::ask(bool wanted) {
  if (wanted == asked_)
    return;
  asked_ = wanted;
  const bool done = run_before_others(wanted);
  if (!wanted)
    return;
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
