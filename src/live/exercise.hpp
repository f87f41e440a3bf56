// SPDX-License-Identifier: MIT
#pragma once
/// \file  A mission that browsers look at and steer while it is flown. Each of them has the engine
/// and flies along: it gets what has been flown so far as a run file, then steps that it may fly,
/// with the orders for them, and hashes to compare with (docs/live.md has the messages).
#include "live/mailbox.hpp"
#include "net/precedence.hpp"
#include "net/web_host.hpp"
#include "record/run_file.hpp"
#include "scenario/mission.hpp"
#include "scenario/operator_orders.hpp"
#include "sim/trail.hpp"

namespace eyrie::live {

// What somebody who looks at a mission says, as JSON:
//
//   {"do": "play"}   {"do": "pause"}   {"do": "step", "steps": 1}   {"do": "rate", "rate": 4}
//   {"do": "order", ...}               see scenario/operator_orders.hpp

inline constexpr std::uint64_t kMostSteps = 5000;  ///< of one request
inline constexpr double kSlowest = 0.1, kFastest = 100;

struct Request {
  enum class What { joined, left, play, pause, step, rate, order };
  net::ViewerId who = 0;
  What what = What::joined;
  std::uint64_t steps = 1;
  double rate = 1;  ///< seconds of the mission in one of the clock; 0: as fast as it goes
  scenario::OperatorOrders order = {};  ///< for no step yet
};

struct Said {
  Request request;
  std::string garbage;  ///< why it is no request at all; else ""
};

/// On any thread.
[[nodiscard]] Said request_of(const scenario::Scenario& scenario, net::ViewerId who,
                              std::string_view text);

/// What other programs tell of players whom they fly.
struct Heard {
  std::vector<sim::Order> orders;  ///< for the next step
  bool frozen = false;             ///< one of them holds the mission
};
/// Asked before each step, and while there is none.
using Outside = std::function<Heard()>;

struct ExerciseOptions {
  double rate = 1;  ///< seconds of the mission in one of the clock; 0: as fast as it goes
  bool paused = false;
  Outside outside = {};  ///< they do not wait: once it goes, viewers change no rate, and no pause
  std::function<void()> ended = {};  ///< called when it is over, before viewers hear of it
};

class Exercise {
 public:
  using Enough = std::function<bool()>;

  /// `run`: what is known of the mission before it is flown. The mission must outlive it, and not
  /// have begun. Listens; throws std::system_error if it cannot.
  Exercise(scenario::Mission& mission, record::RunFile run, net::WebOptions web,
           const ExerciseOptions& options);

  /// Steps until the mission is over, or `enough` ends it.
  void fly(const Enough& enough);
  /// Goes on telling how it ended, until it is `enough`.
  void stay(const Enough& enough);

  [[nodiscard]] const net::WebHost& host() const { return host_; }
  [[nodiscard]] const net::Pacing& pacing() const { return pacing_; }
  [[nodiscard]] const net::Precedence& precedence() const { return precedence_; }

 private:
  [[nodiscard]] net::WebOptions with_channel(net::WebOptions web);
  std::string hear(net::ViewerId who, std::string_view text);

  void attend();
  void keep_time();
  bool listen();
  void carry_out(Request& request);
  void steer(const Request& request);
  void order(Request& request);
  void hand_back(net::ViewerId who);
  /// Gives why it cannot be; "" if it is given.
  [[nodiscard]] std::string give(std::span<const sim::Order> orders);
  void refuse(net::ViewerId who, const std::string& words);
  [[nodiscard]] std::string problem(Request& request) const;

  void wait(net::Clock::time_point until, const Enough& enough);
  void tell_when_due();
  void tell(net::Clock::time_point now);
  void tell_pacing();
  void greet();
  [[nodiscard]] std::shared_ptr<const std::string> so_far() const;
  [[nodiscard]] std::size_t not_flown() const;

  scenario::Mission& mission_;
  record::RunFile run_;
  sim::TrailRecorder trail_{false};
  net::Pacing pacing_;
  net::Precedence precedence_;  ///< of the thread that flies
  double rate_;
  Outside outside_;
  std::function<void()> ended_;
  bool paused_, over_ = false, frozen_ = false;
  std::uint64_t single_ = 0;  ///< steps to be made although it is paused

  std::vector<sim::Order> fresh_;  ///< not told yet
  std::uint64_t given_ = 0;        ///< orders of viewers
  std::size_t waiting_ = 0;        ///< of these, not told yet
  std::map<PlayerId, net::ViewerId> held_;
  std::uint64_t viewers_ = 0;
  std::vector<net::ViewerId> joining_;

  bool changed_ = true;  ///< something that is worth telling, besides steps
  std::uint64_t told_step_ = 0;
  net::Clock::time_point told_{}, hashed_{}, paced_{};

  Mailbox<Request> mail_;
  net::WebHost host_;  ///< last: its thread uses the others
};

}  // namespace eyrie::live
