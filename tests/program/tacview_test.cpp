// SPDX-License-Identifier: MIT
/// \file  `fly --tacview` as Tacview sees it: what comes over the socket is the recording.
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>

#include "net/telemetry_host.hpp"
#include "support/acmi_reader.hpp"
#include "support/program.hpp"
#include "support/soon.hpp"
#include "support/tcp_client.hpp"

namespace eyrie::test {
namespace {

using nlohmann::json;

/// A flight of the merge that is being flown.
struct Live {
  TempFolder folder;
  Running flight;
  std::uint16_t port = 0;

  explicit Live(std::vector<std::string> more)
      : flight(folder, [&] {
          std::vector<std::string> words{"fly",   "merge",  "--tacview", "0",   "--until",
                                         "100 s", "--json", "--out",     "run", "--no-debrief"};
          words.insert(words.end(), more.begin(), more.end());
          return words;
        }()) {
    std::smatch found;
    static const std::regex kAt(R"(at 127\.0\.0\.1:(\d+)\n)");
    std::string said;
    if (!soon([&] { return std::regex_search(said = flight.err(), found, kAt); }))
      throw std::runtime_error("says no port: " + said);
    port = static_cast<std::uint16_t>(std::stoi(found[1]));
  }
  [[nodiscard]] std::string recording() const { return read_text(folder / "run/flight.acmi"); }
};

TEST(Tacview, StreamsTheRecordingByteForByte) {
  Live live({"--real-time", "max", "--tacview-wait"});
  TcpClient client = join_telemetry(live.port);
  const std::string stream = client.read_all();
  const Ran ran = live.flight.wait();
  ASSERT_EQ(ran.code, 0) << ran.err;
  EXPECT_GT(stream.size(), 10'000u);
  EXPECT_TRUE(stream == live.recording());
  const json counts = json::parse(ran.out)["tacview"];
  EXPECT_EQ(counts["clients"], 1);
  EXPECT_EQ(counts["refused"], 0);
  EXPECT_GT(counts["bytes"].get<std::size_t>(), stream.size()) << "and the greeting";
}

TEST(Tacview, GivesALateOneAllThatIsThere) {
  Live live({"--real-time", "20", "--tacview-wait"});  // five seconds
  TcpClient first = join_telemetry(live.port);
  static_cast<void>(first.read_to("#10.00\n"));
  TcpClient late = join_telemetry(live.port);
  const Acmi stream(late.read_all());
  static_cast<void>(first.read_all());
  const Ran ran = live.flight.wait();
  ASSERT_EQ(ran.code, 0) << ran.err;
  const Acmi file(live.recording());
  EXPECT_EQ(stream.globals, file.globals);
  EXPECT_GE(stream.frames.front(), 10);
  EXPECT_LT(stream.frames.front(), 100);
  for (const auto& [id, object] : stream.objects) {
    EXPECT_EQ(object.last("Name"), file.objects.at(id).last("Name"));
    EXPECT_EQ(object.samples.back().fields, file.objects.at(id).samples.back().fields);
  }
  EXPECT_EQ(stream.frames.back(), file.frames.back());
  EXPECT_TRUE(json::parse(ran.out).contains("real_time"));
}

TEST(Tacview, FliesByTheClockUnlessToldOtherwise) {
  Live live({});
  live.flight.kill(SIGTERM);
  const Ran ran = live.flight.wait();
  EXPECT_EQ(ran.code, 128 + SIGTERM);
  const json j = json::parse(ran.out);
  EXPECT_EQ(j["real_time"]["frame_s"], 0.02);
  EXPECT_EQ(run_program(live.folder, {"replay", "run"}).code, 0);
}

TEST(Tacview, AsksForThePasswordInAFile) {
  TempFolder secret;
  const std::string file = secret.write("password", "geheim\n");
  Live live({"--real-time", "max", "--tacview-wait", "--tacview-password", file});
  EXPECT_EQ(join_telemetry(live.port, "0").read_all(), "");
  TcpClient knows = join_telemetry(live.port, net::password_hash("geheim"));
  const std::string stream = knows.read_all();
  const Ran ran = live.flight.wait();
  EXPECT_TRUE(stream == live.recording());
  EXPECT_EQ(json::parse(ran.out)["tacview"]["refused"], 1);
}

TEST(Tacview, FliesOnWhateverItsClientsDo) {
  Live live({"--real-time", "50", "--tacview-wait"});
  {
    TcpClient leaves = join_telemetry(live.port);
    static_cast<void>(leaves.read_to("FileVersion"));
    TcpClient browser(live.port);
    browser.send("GET / HTTP/1.1\r\n\r\n" + std::string(5000, 'x'));
  }
  const Ran ran = live.flight.wait();
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json j = json::parse(ran.out);
  EXPECT_EQ(j["sim_time_s"], 100);
  EXPECT_EQ(j["tacview"]["refused"], 1);
  const json alone = json::parse(
      run_program(live.folder, {"fly", "merge", "--until", "100 s", "--json", "--no-debrief"}).out);
  EXPECT_EQ(j["hash"], alone["hash"]);
}

TEST(Tacview, MayBeGivenUpBeforeAnybodyJoins) {
  Live live({"--tacview-wait"});
  live.flight.kill(SIGTERM);
  const Ran ran = live.flight.wait();
  EXPECT_EQ(ran.code, 128 + SIGTERM);
  EXPECT_NE(ran.err.find("eyrie: interrupted before anybody joined; nothing was flown\n"),
            std::string::npos);
  EXPECT_EQ(live.folder.everything(), std::vector<std::string>{});
}

TEST(Tacview, SaysWhatIsWrongBeforeAnythingIsFlown) {
  const Live other({"--tacview-wait"});
  const std::string taken = std::to_string(other.port);
  TempFolder folder;
  folder.write("empty", "\n");
  struct Case {
    std::vector<std::string> words;
    std::string answer;
  };
  for (const Case& wrong : {
           Case{{"--tacview", taken},
                "--tacview: cannot listen at 127.0.0.1:" + taken + ": Address already in use\n"},
           {{"--tacview=203.0.113.7"},
            "--tacview: cannot listen at 203.0.113.7:42674: Cannot assign requested address\n"},
           {{"--tacview=239.1.2.3"},
            "--tacview: cannot listen at 239.1.2.3:42674: Cannot assign requested address\n"},
           {{"--tacview=0", "--tacview-password", "nowhere"},
            "--tacview-password: nowhere: there is no such file\n"},
           {{"--tacview=0", "--tacview-password", "empty"},
            "--tacview-password: empty: its first line, which is the password, is empty\n"},
           {{"--tacview=example.org"},
            "eyrie: --tacview: 'example.org' is no port or address such as 42674, 0.0.0.0 or "
            "192.168.1.5:42674\neyrie fly --help says more\n"},
           {{"--tacview-wait"},
            "eyrie: --tacview-wait requires --tacview\neyrie fly --help says more\n"},
       }) {
    std::vector<std::string> words{"fly", "merge", "--out", "run"};
    words.insert(words.end(), wrong.words.begin(), wrong.words.end());
    const Ran ran = run_program(folder, words);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, wrong.answer);
    EXPECT_EQ(folder.everything(), std::vector<std::string>{"empty"});
  }
}

}  // namespace
}  // namespace eyrie::test
