// SPDX-License-Identifier: MIT
#pragma once
/// \file  What somebody who looks at a mission says, as JSON:
///
///   {"do": "play"}   {"do": "pause"}   {"do": "step", "steps": 1}   {"do": "rate", "rate": 4}
///   {"do": "order", ...}               see scenario/operator_orders.hpp
#include "net/web_host.hpp"
#include "scenario/operator_orders.hpp"

namespace eyrie::live {

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

}  // namespace eyrie::live
