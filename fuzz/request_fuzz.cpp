// SPDX-License-Identifier: MIT
/// \file  Any bytes as what somebody who looks at a mission says: it is a request, is refused in
/// words, or he is shown out with a reason that fits into a frame. A mission that obeys flies on.
#include "fuzz/demand.hpp"
#include "fuzz/shipped.hpp"
#include "live/exercise.hpp"

namespace {

using eyrie::fuzz::demand;

const std::shared_ptr<const eyrie::scenario::Scenario>& shared() {
  static const auto scenario = eyrie::fuzz::shipped("sweep", {});
  return scenario;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace eyrie;
  const live::Said said =
      live::request_of(*shared(), 1, {reinterpret_cast<const char*>(data), size});
  demand(said.garbage.size() <= 120);
  const auto& [kind, orders, problem] = said.request.order;
  demand(orders.empty() || (said.garbage.empty() && problem.empty()));
  demand(said.request.steps >= 1 && said.request.steps <= live::kMostSteps);
  if (orders.empty())
    return 0;
  scenario::Mission mission(shared(), 1);
  for (const sim::Order& order : orders) {
    demand(shared()->find(mission.run().world(), order.player).has_value());
    demand(mission.run().submit(order).empty());
  }
  for (int step = 0; step < 10; ++step)
    static_cast<void>(mission.step());
  demand(!mission.run().fault());
  return 0;
}
