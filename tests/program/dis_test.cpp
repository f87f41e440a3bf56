// SPDX-License-Identifier: MIT
/// \file  `fly --dis` as another simulation hears it: what is sent is what `export --to pcap`
/// writes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "dis/pdu.hpp"
#include "support/program.hpp"
#include "support/udp_listener.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

/// The datagrams of a capture file.
std::vector<std::string> payloads(const std::string& pcap) {
  std::vector<std::string> all;
  for (std::size_t at = 24; at < pcap.size();) {
    const std::size_t size = static_cast<unsigned char>(pcap.at(at + 8)) +
                             256u * static_cast<unsigned char>(pcap.at(at + 9));
    all.push_back(pcap.substr(at + 16 + 42, size - 42));
    at += 16 + size;
  }
  return all;
}

json flown(const TempFolder& folder, const std::string& out, std::vector<std::string> more) {
  std::vector<std::string> words{"fly",    "merge",        "--until", "10 s",
                                 "--json", "--no-debrief", "--out",   out};
  words.insert(words.end(), more.begin(), more.end());
  const Ran ran = run_program(folder, words);
  EXPECT_EQ(ran.code, 0) << ran.err;
  return json::parse(ran.out);
}

TEST(DisProgram, SendsWhatIsInTheCaptureOfTheRunAndChangesNothing) {
  const TempFolder folder;
  const UdpListener listener;
  const json with =
      flown(folder, "run", {"--real-time", "50", "--dis", std::to_string(listener.port())});
  const json without = flown(folder, "alone", {});
  EXPECT_EQ(with["hash"], without["hash"]);
  EXPECT_FALSE(without.contains("dis"));
  ASSERT_EQ(run_program(folder, {"export", "run", "--to", "pcap"}).code, 0);
  const auto wanted = payloads(read_text(folder / "run/run.pcap"));
  ASSERT_GE(wanted.size(), 20u);
  EXPECT_EQ(with["dis"]["sent"], wanted.size());
  EXPECT_EQ(with["dis"]["dropped"], 0);
  EXPECT_EQ(listener.waiting(), wanted);
}

TEST(DisProgram, ReachesAGroupAsAnotherStation) {
  const TempFolder folder;
  const UdpListener listener("239.30.12.79");
  const std::string to = "239.30.12.79:" + std::to_string(listener.port());
  flown(folder, "run", {"--real-time", "max", "--dis", to, "--dis-station", "9.8.7"});
  const std::string first = listener.next().value_or("");
  const dis::Decoded read = dis::decode(std::as_bytes(std::span(first.data(), first.size())));
  ASSERT_EQ(read.refusal, std::nullopt);
  EXPECT_EQ(read.packet.exercise, 9);
  EXPECT_EQ(std::get<dis::StartResume>(read.packet.pdu).from, (dis::EntityId{8, 7, 0}));
}

TEST(DisProgram, RefusesWhatIsNoPlaceToSendTo) {
  const TempFolder folder;
  for (const std::vector<std::string>& wrong :
       std::vector<std::vector<std::string>>{{"--dis", "::1"},
                                             {"--dis", "0"},
                                             {"--dis", "example.org"},
                                             {"--dis", "--dis-station", "1.1"},
                                             {"--dis-station", "1.1.1"},
                                             {"--dis", "--dis-interface", "203.0.113.7"},
                                             {"--dis", "--dis-interface", "lo"},
                                             {"--dis", "--dis-interface", "0.0.0.0"},
                                             {"--dis", "--seeds", "1..2"}}) {
    std::vector<std::string> words{"fly", "merge"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    const Ran ran = run_program(folder, words);
    EXPECT_EQ(ran.code, 2) << wrong[1] << "\n" << ran.err;
    EXPECT_NE(ran.err.find("dis"), std::string::npos) << ran.err;
  }
  const Ran any = run_program(folder, {"fly", "merge", "--dis=0.0.0.0:3001"});
  EXPECT_EQ(any.code, 2);
  EXPECT_TRUE(any.err.starts_with("eyrie: --dis: '0.0.0.0:3001' is where one listens")) << any.err;
  const Ran lo = run_program(folder, {"fly", "merge", "--dis", "--dis-interface", "lo"});
  EXPECT_NE(lo.err.find("'lo' is no IPv4 address of this machine"), std::string::npos) << lo.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "runs"));
}

/// It is to listen that fails, not to send.
TEST(DisProgram, SaysThatItCannotListen) {
  const TempFolder folder;
  const UdpListener other;
  const std::string at = "127.0.0.1:" + std::to_string(other.port());
  const Ran ran = run_program(folder, {"fly", "merge", "--ours", "blue", "--dis", at});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err, "--dis: cannot listen at " + at + ": Address already in use\n");
}

}  // namespace
}  // namespace eyrie::test
