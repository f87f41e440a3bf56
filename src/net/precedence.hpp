// SPDX-License-Identifier: MIT
#pragma once
/// \file  A thread that keeps the clock although others want the machine.
#include <functional>
#include <memory>

#include "net/pacing.hpp"

namespace eyrie::net {

/// Lets the thread that made it run before all others of the machine (SCHED_FIFO) while it waits
/// for the clock, where the system permits that: root does, and RLIMIT_RTPRIO (`ulimit -r`).
/// Threads that it starts do not inherit it. Who falls behind should not ask for it: he never
/// waits.
///
/// A processor whose kernel works for somebody else, or whose host does, gives way to nobody, for
/// tens of milliseconds. So a second thread looks from another processor whether the first one woke
/// in time, and has it woken there if not.
class Precedence {
 public:
  /// `grace`: how late the thread may be before it is moved.
  explicit Precedence(Clock::duration grace = std::chrono::milliseconds(1));
  Precedence(const Precedence&) = delete;
  Precedence& operator=(const Precedence&) = delete;
  ~Precedence();
  /// Asks the system only when it is another answer than before.
  void ask(bool wanted);
  /// Whether it was permitted when it was wanted last.
  [[nodiscard]] bool permitted() const { return permitted_; }
  /// Sleeps until `due`, or soon after `enough` says so.
  void sleep_until(Clock::time_point due, const std::function<bool()>& enough);
  /// How often the thread was woken on another processor.
  [[nodiscard]] std::uint64_t moves() const;

 private:
  class Lookout;
  Clock::duration grace_;
  std::unique_ptr<Lookout> lookout_;  ///< where there is precedence, and another processor
  bool asked_ = false, permitted_ = false;
};

}  // namespace eyrie::net
