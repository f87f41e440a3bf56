// SPDX-License-Identifier: MIT
/// \file  Any bytes as a datagram of DIS: it is read to its end or refused, never beyond it; and
/// what was read is written as it is read again.
#include <cstdlib>

#include "dis/pdu.hpp"

namespace {

void demand(bool condition) {
  if (!condition)
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace eyrie;
  std::span<const std::byte> rest(reinterpret_cast<const std::byte*>(data), size);
  while (!rest.empty()) {
    const dis::Decoded read = dis::decode(rest);
    demand(read.length <= rest.size());
    if (read.refusal == dis::Refusal::none) {
      const auto bytes = dis::encode(read.packet);
      const dis::Decoded again = dis::decode(bytes);
      demand(again.refusal == dis::Refusal::none && again.length == bytes.size());
      demand(dis::encode(again.packet) == bytes);
    }
    if (read.length == 0)
      break;
    rest = rest.subspan(read.length);
  }
  return 0;
}
