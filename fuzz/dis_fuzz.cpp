// SPDX-License-Identifier: MIT
/// \file  Any bytes as a datagram of DIS: it is read to its end or refused, never beyond it; and
/// what was read is written as it is read again. A mission that hears it flies on.
#include "dis/others.hpp"
#include "dis/pdu.hpp"
#include "fuzz/demand.hpp"
#include "fuzz/shipped.hpp"

namespace {

using eyrie::fuzz::demand;

const std::shared_ptr<const eyrie::scenario::Scenario>& shared() {
  static const auto scenario = eyrie::fuzz::shipped("merge", {"ours=[blue]"});
  return scenario;
}

/// It flies on, whatever it hears.
void hear(std::span<const std::byte> datagram) {
  using namespace eyrie;
  constexpr double kNow = 1'767'268'800;
  scenario::Mission mission(shared(), 1);
  dis::Others others(*shared(), {.application = 9});
  for (int i = 0; i < 3; ++i) {
    others.hear(datagram, kNow + i);
    for (const sim::Order& order : others.orders(mission.run().world(), kNow + i))
      demand(mission.run().submit(order).empty());
    for (int step = 0; step < 3; ++step)
      static_cast<void>(mission.step());
  }
  demand(!mission.run().fault());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace eyrie;
  std::span<const std::byte> rest(reinterpret_cast<const std::byte*>(data), size);
  hear(rest);
  while (!rest.empty()) {
    const dis::Decoded read = dis::decode(rest);
    demand(read.length <= rest.size());
    if (!read.refusal) {
      const auto bytes = dis::encode(read.packet);
      const dis::Decoded again = dis::decode(bytes);
      demand(!again.refusal && again.length == bytes.size());
      demand(dis::encode(again.packet) == bytes);
    }
    if (read.length == 0)
      break;
    rest = rest.subspan(read.length);
  }
  return 0;
}
