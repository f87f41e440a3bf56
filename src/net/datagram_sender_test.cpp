// SPDX-License-Identifier: MIT
#include "net/datagrams.hpp"

#include <gtest/gtest.h>

#include <system_error>

#include "support/udp_listener.hpp"

namespace eyrie::net {
namespace {

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

TEST(DatagramSender, ReachesOneEverybodyAndAGroup) {
  for (const char* address : {"127.0.0.1", "127.255.255.255", "239.30.12.78"}) {
    const bool group = std::string(address).starts_with("239");
    const test::UdpListener listener(group ? address : "");
    DatagramSender sender({.to = {address, listener.port()}});
    sender.send(bytes_of("first"));
    sender.send(bytes_of(std::string(DatagramSender::kLongest, 'x')));
    sender.close();
    EXPECT_EQ(listener.next(), "first") << address;
    EXPECT_EQ(listener.next().value_or("").size(), DatagramSender::kLongest);
    EXPECT_EQ(sender.counts().sent, 2u);
    EXPECT_EQ(sender.counts().bytes, 5 + DatagramSender::kLongest);
    EXPECT_EQ(sender.counts().dropped + sender.counts().failed, 0u);
  }
}

TEST(DatagramSender, DropsAndCountsWhatHasNoRoom) {
  const test::UdpListener listener;
  DatagramSender sender({.to = {"127.0.0.1", listener.port()}, .slots = 4});
  sender.send(bytes_of(std::string(DatagramSender::kLongest + 1, 'x')));
  for (int i = 0; i < 100'000; ++i)
    sender.send(bytes_of(std::to_string(i)));
  sender.close();
  const auto counts = sender.counts();
  EXPECT_EQ(counts.sent + counts.dropped + counts.failed, 100'001u);
  EXPECT_GE(counts.dropped, 1u);
  EXPECT_GE(counts.sent, 4u);
  int before = -1;
  for (const std::string& heard : listener.waiting()) {
    EXPECT_GT(std::stoi(heard), before) << "in their order, whole";
    before = std::stoi(heard);
  }
  EXPECT_GE(before, 0);
}

TEST(DatagramSender, DoesNotMindThatNobodyListens) {
  std::uint16_t free_port = 0;
  { free_port = test::UdpListener().port(); }
  DatagramSender sender({.to = {"127.0.0.1", free_port}});
  for (int i = 0; i < 100; ++i)
    sender.send(bytes_of("hello"));
  sender.close();
  sender.close();
  EXPECT_EQ(sender.counts().sent, 100u);
  EXPECT_EQ(sender.counts().failed, 0u);
}

TEST(DatagramSender, RefusesAnAddressThatIsNotHere) {
  EXPECT_THROW(DatagramSender({.to = {"::1", 3000}}), std::system_error);
  EXPECT_THROW(DatagramSender({.to = {"239.1.2.3", 3000}, .interface = "203.0.113.7"}),
               std::system_error);
}

}  // namespace
}  // namespace eyrie::net
