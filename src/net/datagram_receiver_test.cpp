// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "net/datagrams.hpp"
#include "support/soon.hpp"

namespace eyrie::net {
namespace {

std::span<const std::byte> text_bytes(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

std::vector<std::string> drained(DatagramReceiver& receiver) {
  std::vector<std::string> all;
  receiver.drain([&](std::span<const std::byte> bytes, auto) {
    all.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  });
  return all;
}

TEST(DatagramReceiver, HearsWhatIsSentToItToEverybodyAndToAGroup) {
  for (const char* address : {"127.0.0.1", "127.255.255.255", "239.30.12.81"}) {
    DatagramReceiver receiver({.at = {address, 0}});
    DatagramSender sender({.to = {address, receiver.port()}});
    sender.send(text_bytes("first"));
    sender.send(text_bytes("second"));
    std::vector<std::string> heard;
    EXPECT_TRUE(test::soon([&] {
      for (std::string& one : drained(receiver))
        heard.push_back(std::move(one));
      return heard.size() == 2;
    })) << address;
    EXPECT_EQ(heard, (std::vector<std::string>{"first", "second"})) << address;
    receiver.close();
    EXPECT_EQ(receiver.counts().received, 2u);
    EXPECT_EQ(receiver.counts().bytes, 11u);
  }
}

TEST(DatagramReceiver, IsSharedByAllWhoListenToAGroupOfThisMachine) {
  DatagramReceiver first({.at = {"239.30.12.82", 0}});
  DatagramReceiver second({.at = {"239.30.12.82", first.port()}});
  DatagramSender sender({.to = {"239.30.12.82", first.port()}});
  sender.send(text_bytes("all"));
  EXPECT_TRUE(test::soon([&] { return !drained(first).empty(); }));
  EXPECT_TRUE(test::soon([&] { return !drained(second).empty(); }));
}

TEST(DatagramReceiver, CountsWhatHasNoRoom) {
  DatagramReceiver receiver({.at = {"127.0.0.1", 0}, .slots = 4});
  DatagramSender sender({.to = {"127.0.0.1", receiver.port()}});
  for (int i = 0; i < 9; ++i)
    sender.send(text_bytes(std::to_string(i)));
  sender.close();
  // nobody drains: the ring stays full, and what more comes is counted
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  receiver.close();
  const auto counts = receiver.counts();
  EXPECT_EQ(counts.received, 9u);
  EXPECT_EQ(counts.dropped, 5u);
  EXPECT_EQ(drained(receiver).size(), 4u);
}

TEST(DatagramReceiver, SaysWhereItCannotListen) {
  EXPECT_THROW(DatagramReceiver({.at = {"example.org", 3000}}), std::system_error);
  EXPECT_THROW(DatagramReceiver({.at = {"239.30.12.81", 0}, .interface = "203.0.113.7"}),
               std::system_error);
}

}  // namespace
}  // namespace eyrie::net
