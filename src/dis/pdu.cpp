// SPDX-License-Identifier: MIT
#include "dis/pdu.hpp"

namespace eyrie::dis {
namespace {

constexpr std::size_t kHeader = 12;

/// 6.2.66
struct Header {
  std::uint8_t version = 0, exercise = 0, type = 0, family = 0;
  std::uint32_t timestamp = 0;
  std::uint16_t length = 0;
  std::uint8_t status = 0;
  static void fields(auto& wire, auto& r) {
    wire(r.version, r.exercise, r.type, r.family, r.timestamp, r.length, r.status);
    wire.zeros(1);
  }
};

/// An empty PDU of that type; false if it is none of ours.
template <std::size_t I = 0>
bool make(std::uint8_t type, Pdu& pdu) {
  if constexpr (I == std::variant_size_v<Pdu>) {
    return false;
  } else if (std::variant_alternative_t<I, Pdu>::kType == type) {
    pdu.emplace<I>();
    return true;
  } else {
    return make<I + 1>(type, pdu);
  }
}

}  // namespace

std::vector<std::byte> encode(const Packet& packet) {
  Writer body;
  Header header{.version = packet.version,
                .exercise = packet.exercise,
                .timestamp = packet.timestamp,
                .status = packet.status};
  std::visit(
      [&](const auto& pdu) {
        body(pdu);
        header.type = pdu.kType;
        header.family = pdu.kFamily;
      },
      packet.pdu);
  header.length = static_cast<std::uint16_t>(kHeader + body.size());
  Writer whole;
  whole(header);
  auto bytes = whole.take();
  const auto rest = body.take();
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return bytes;
}

Decoded decode(std::span<const std::byte> bytes) {
  Decoded result;
  Header header;
  Reader head(bytes);
  head(header);
  const auto refused = [&](Unused why) {
    result.refusal = why;
    return result;
  };
  if (head.failed() || header.length < kHeader || header.length > bytes.size())
    return refused(Unused::truncated);
  result.length = header.length;
  result.packet.version = header.version;
  result.packet.exercise = header.exercise;
  result.packet.timestamp = header.timestamp;
  result.packet.status = header.status;
  if (header.version != 6 && header.version != 7)
    return refused(Unused::version);
  if (!make(header.type, result.packet.pdu))
    return refused(Unused::kind);
  Reader body(bytes.subspan(kHeader, header.length - kHeader));
  std::visit([&](auto& pdu) { body(pdu); }, result.packet.pdu);
  if (body.failed() || kHeader + body.size() != header.length)
    return refused(Unused::malformed);
  return result;
}

}  // namespace eyrie::dis
