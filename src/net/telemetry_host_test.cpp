// SPDX-License-Identifier: MIT
#include "net/telemetry_host.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <system_error>

#include "support/soon.hpp"
#include "support/tcp_client.hpp"

namespace eyrie::net {
namespace {

using std::chrono::milliseconds;
using test::join_telemetry;
using test::soon;
using test::TcpClient;

struct Served {
  TelemetryHost host;

  explicit Served(TelemetryOptions options = {}) : host(std::move(options)) {}
  [[nodiscard]] std::uint16_t port() const { return host.at().port; }
  [[nodiscard]] bool has_joined(std::uint64_t clients) {
    return soon([&] { return host.counts().joined >= clients; });
  }
};

TEST(TelemetryHost, GivesEverybodyTheSameAndLateOnesWhatIsThere) {
  Served s;
  TcpClient first = join_telemetry(s.port());
  ASSERT_TRUE(s.has_joined(1));
  EXPECT_TRUE(s.host.wanted());
  s.host.send("begin\n", "begin\n");
  EXPECT_TRUE(soon([&] { return !s.host.wanted(); }));
  s.host.send("one\n", "");
  TcpClient late = join_telemetry(s.port());
  ASSERT_TRUE(s.has_joined(2));
  s.host.send("two\n", "");  // which was made before anybody knew of the second
  s.host.send("three\n", "whole\n");
  s.host.send("four\n", "");
  s.host.close(milliseconds(20'000));
  EXPECT_EQ(first.read_all(), "begin\none\ntwo\nthree\nfour\n");
  EXPECT_EQ(late.read_all(), "whole\nfour\n");
  EXPECT_EQ(s.host.counts().joined, 2u);
  EXPECT_EQ(s.host.counts().refused + s.host.counts().dropped, 0u);
}

TEST(TelemetryHost, ClosesWithoutWaitingForWhoeverDoesNotRead) {
  Served s;
  TcpClient lazy = join_telemetry(s.port(), "0", 4096);
  ASSERT_TRUE(s.has_joined(1));
  s.host.send("", std::string(6 << 20, 'x'));
  s.host.close(milliseconds(50));
  s.host.send("nobody hears it", "");
  s.host.close(milliseconds(50));
}

TEST(TelemetryHost, DropsWhoIsTooSlowAndKeepsTheOthers) {
  Served s({.waiting = 1 << 20});
  TcpClient slow = join_telemetry(s.port(), "0", 4096);
  TcpClient quick = join_telemetry(s.port());
  ASSERT_TRUE(s.has_joined(2));
  s.host.send("", "#0\n");
  const std::string line(50'000, 'x');
  std::uint64_t sent = 3;
  std::string got = quick.read_to("#0\n");
  for (int i = 0; i < 400 && s.host.counts().dropped == 0; ++i) {
    s.host.send(line + "\n", "");
    sent += line.size() + 1;
    got += quick.read_to("\n");  // who reads is not dropped, however much it is
  }
  EXPECT_EQ(s.host.counts().dropped, 1u) << sent;
  s.host.send("end\n", "");
  s.host.close(milliseconds(20'000));
  EXPECT_EQ(got.size() + quick.read_all().size(), sent + 4);
}

TEST(TelemetryHost, AsksForThePassword) {
  Served s({.password = "geheim"});
  for (const char* wrong : {"0", "", "1234"})
    EXPECT_EQ(join_telemetry(s.port(), wrong).read_all(), "");
  EXPECT_TRUE(soon([&] { return s.host.counts().refused == 3; }));
  TcpClient knows = join_telemetry(s.port(), password_hash("geheim"));
  ASSERT_TRUE(s.has_joined(1));
  s.host.send("", "secret");
  s.host.close(milliseconds(20'000));
  EXPECT_EQ(knows.read_all(), "secret");
}

TEST(TelemetryHost, RefusesWhoTalksOtherwiseOrNotAtAll) {
  Served s({.greeting = milliseconds(300)});
  TcpClient browser(s.port()), half(s.port()), silent(s.port()), gone(s.port()), endless(s.port());
  browser.send(std::string("GET / HTTP/1.1\r\n\r\n\0", 19));
  half.send("XtraLib.Stream.0\nTacview");
  { const TcpClient ends = std::move(gone); }
  const std::string megabyte(1 << 20, 'x');
  std::size_t sent = 0;
  for (int i = 0; i < 1024; ++i) {  // a gigabyte, if anybody took it
    const std::size_t taken = endless.send(megabyte);
    sent += taken;
    if (taken < megabyte.size())
      break;
  }
  EXPECT_LT(sent, std::size_t{32} << 20);
  for (TcpClient* refused : {&browser, &half, &silent})
    EXPECT_TRUE(refused->read_all().starts_with(test::kTacviewProtocols));
  EXPECT_TRUE(soon([&] { return s.host.counts().refused == 5; })) << s.host.counts().refused;
  EXPECT_EQ(s.host.counts().joined, 0u);
}

TEST(TelemetryHost, RefusesAClientThatTalksOnAndOn) {
  Served s;
  TcpClient client = join_telemetry(s.port());
  ASSERT_TRUE(s.has_joined(1));
  const std::string megabyte(1 << 20, 'x');
  for (int i = 0; i < 64 && client.send(megabyte) == megabyte.size(); ++i) {
  }
  EXPECT_TRUE(soon([&] { return s.host.counts().refused == 1; }));
  EXPECT_TRUE(soon([&] { return !s.host.wanted(); })) << "and it is not waited for";
}

/// Bytes in memory.
std::size_t resident() {
  std::size_t size = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> size >> pages;
  return pages * 4096;
}

TEST(TelemetryHost, OutlivesAThousandConnections) {
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = std::min<rlim_t>(files.rlim_max, 4096);
  setrlimit(RLIMIT_NOFILE, &files);
  if (files.rlim_cur < 1100)
    GTEST_SKIP() << "this system has no thousand files for a process";
  Served s({.connections = 16});
  TcpClient first = join_telemetry(s.port());
  ASSERT_TRUE(s.has_joined(1));
  const std::size_t before = resident();
  std::vector<TcpClient> many;
  for (int i = 0; i < 1000; ++i)
    many.emplace_back(s.port());
  EXPECT_TRUE(soon([&] { return s.host.counts().refused >= 985; })) << s.host.counts().refused;
#ifdef EYRIE_SANITIZED  // which keeps for a while what was freed
  constexpr std::size_t kRoom = 256 << 20;
#else
  constexpr std::size_t kRoom = 8 << 20;
#endif
  EXPECT_LT(resident(), before + kRoom);
  TcpClient honest = join_telemetry(s.port());
  ASSERT_TRUE(s.has_joined(2)) << "silence holds no place";
  s.host.send("", "still here");
  s.host.close(milliseconds(20'000));
  EXPECT_EQ(first.read_all(), "still here");
  EXPECT_EQ(honest.read_all(), "still here");
}

TEST(TelemetryHost, IgnoresWhoLeavesInTheMiddleOfALine) {
  Served s;
  {
    TcpClient leaves = join_telemetry(s.port());
    ASSERT_TRUE(s.has_joined(1));
    s.host.send("", std::string(1 << 20, 'x'));
    static_cast<void>(leaves.read_to("xxx"));
  }
  TcpClient stays = join_telemetry(s.port());
  ASSERT_TRUE(s.has_joined(2));
  s.host.send("x\n", "all\n");
  s.host.close(milliseconds(20'000));
  EXPECT_EQ(stays.read_all(), "all\n");
  EXPECT_EQ(s.host.counts().dropped, 0u);
}

TEST(TelemetryHost, SaysWhyItCannotListen) {
  Served s;
  try {
    const TelemetryHost second({.at = s.host.at()});
    FAIL() << "two hosts at one port";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::address_in_use);
  }
}

}  // namespace
}  // namespace eyrie::net
