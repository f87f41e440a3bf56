// SPDX-License-Identifier: MIT
/// \file  `eyrie serve SCENARIO`: several look at a mission, steer it and fly along bit by bit, and
/// whoever means harm gets nothing.
#include <gtest/gtest.h>

#include <csignal>
#include <regex>

#include "support/live_viewer.hpp"
#include "support/served.hpp"

namespace eyrie::test {
namespace {

using Json = nlohmann::json;

/// A mission that is served.
struct Mission : Served {
  using Served::Served;

  /// The run that it left flies again, on so many workers, to that hash.
  void expect_replay(const sim::World& world, const char* workers) const {
    const Ran again = run_program(folder, {"replay", "runs/latest", "--workers", workers});
    EXPECT_EQ(again.out, fmt::format("runs/latest/run.eyrie: the same, {} steps, world hash {}\n",
                                     world.step(), hash_text(world.hash())))
        << again.err;
  }
};

bool refused(const Json& message) {
  return message.contains("refused");
}

TEST(Live, SeveralFlyAlongAndSteerAndTheRunIsReplayed) {
  Mission mission({"sweep", "--paused", "--rate", "max", "--seed", "3"});
  LiveViewer first(mission.port);
  EXPECT_EQ(first.world().step(), 0u);
  first.say({{"do", "step"}, {"steps", 2000}});
  const Json made = first.follow_to(2000);
  EXPECT_EQ(made["step"], 2000);
  EXPECT_EQ(made["paused"], true);
  EXPECT_EQ(made["rate"], "max");
  EXPECT_EQ(made["viewers"], 1);
  EXPECT_EQ(made["outcome"], "running");

  // the second comes late, and everybody flies what either orders
  LiveViewer second(mission.port);
  EXPECT_EQ(second.world().step(), 2000u);
  second.say({{"do", "order"}, {"order", "tree"}, {"flight", "eagle"}, {"tree", "veteran_patrol"}});
  first.say({{"do", "order"}, {"order", "lose"}, {"player", "eagle4"}});
  second.say({{"do", "order"}, {"order", "lose"}, {"player", "eagel3"}});
  EXPECT_EQ(second.follow(refused)["refused"],
            "there is no player 'eagel3'; did you mean 'eagle3'?");
  // a third one joins between orders and their step
  LiveViewer third(mission.port);
  EXPECT_EQ(third.orders(), 0u);
  third.say({{"do", "step"}});
  for (LiveViewer* viewer : {&first, &second, &third}) {
    EXPECT_EQ(viewer->follow_to(2001)["step"], 2001);
    EXPECT_EQ(viewer->orders(), 5u);
  }
  EXPECT_FALSE(first.scenario().find(first.world(), *first.scenario().roster.find("eagle4")));
  first.say({{"do", "order"}, {"order", "lose"}, {"player", "eagle4"}});
  EXPECT_EQ(first.follow(refused)["refused"], "eagle4 is no longer there");
  // a flight is those of it who are left
  first.say({{"do", "order"}, {"order", "weapons"}, {"flight", "eagle"}, {"free", true}});

  // by the clock, and to the end as fast as it goes
  first.say({{"do", "rate"}, {"rate", 100}});
  first.say({{"do", "play"}});
  const Json paced = second.follow([](const Json& j) { return j.contains("pacing"); });
  EXPECT_GT(paced["pacing"]["frames"], 0);
  second.say({{"do", "pause"}});
  const Json held = first.follow([](const Json& j) { return j.value("paused", false); });
  EXPECT_EQ(held["rate"], 100.0);
  first.say({{"do", "rate"}, {"rate", "max"}});
  first.say({{"do", "play"}});
  for (LiveViewer* viewer : {&first, &second, &third}) {
    EXPECT_EQ(viewer->follow_to_the_end()["viewers"], 3);
    EXPECT_GE(viewer->hashes(), 2u);
    EXPECT_EQ(viewer->world().hash(), first.world().hash());
  }
  first.say({{"do", "play"}});
  EXPECT_EQ(first.follow(refused)["refused"], "the mission is over");
  LiveViewer after(mission.port);
  EXPECT_EQ(after.world().hash(), first.world().hash());
  EXPECT_EQ(after.orders(), 8u);

  mission.server->kill(SIGINT);
  const Ran ended = mission.server->wait();
  EXPECT_EQ(ended.code, 128 + SIGINT);
  EXPECT_NE(ended.err.find("4 viewers"), std::string::npos) << ended.err;
  mission.expect_replay(first.world(), "3");
}

TEST(Live, HandsBackWhatSomebodyFlewWhoLeaves) {
  Mission mission({"sweep", "--paused"});
  const Json take_over{{"do", "order"},  {"order", "manual"}, {"player", "eagle1"},
                       {"heading", 1.5}, {"altitude", 7000},  {"speed", 250}};
  LiveViewer stays(mission.port);
  {
    LiveViewer goes(mission.port);
    goes.say(take_over);
    goes.say({{"do", "step"}, {"steps", 50}});
    goes.follow_to(50);
    stays.say(take_over);
    EXPECT_EQ(stays.follow(refused)["refused"], "eagle1 is flown by somebody else");
    EXPECT_EQ(stays.orders(), 1u);
  }
  stays.follow([](const Json& j) { return j.value("viewers", 0) == 1; });
  stays.say({{"do", "step"}, {"steps", 50}});
  stays.follow_to(100);
  EXPECT_EQ(stays.orders(), 2u) << "handed back";
  stays.say(take_over);
  stays.say({{"do", "step"}, {"steps", 50}});
  stays.follow_to(150);
  EXPECT_EQ(stays.orders(), 3u);
  mission.server->kill(SIGINT);
  stays.follow_to_the_end();
  static_cast<void>(mission.server->wait());
  mission.expect_replay(stays.world(), "2");
}

TEST(Live, IsRecordedWhenItIsEndedEarly) {
  Mission mission({"merge", "--rate", "1"});
  LiveViewer viewer(mission.port);
  const std::uint64_t begun = viewer.world().step();
  viewer.follow_to(begun + 1);
  mission.server->kill(SIGINT);
  EXPECT_EQ(viewer.follow_to_the_end()["outcome"], "stopped");
  EXPECT_EQ(mission.server->wait().code, 128 + SIGINT);
  mission.expect_replay(viewer.world(), "2");
}

TEST(Live, WritesNothingIfNothingWasFlown) {
  Mission mission({"merge", "--paused"});
  mission.server->kill(SIGINT);
  const Ran ended = mission.server->wait();
  EXPECT_EQ(ended.code, 128 + SIGINT);
  EXPECT_NE(ended.err.find("eyrie: interrupted before the first step; nothing was flown\n"),
            std::string::npos)
      << ended.err;
  EXPECT_EQ(mission.folder.everything(), std::vector<std::string>{});
}

TEST(Live, GivesItsPage) {
  Mission mission({"merge", "--paused"});
  const std::string page = mission.ask("/");
  EXPECT_NE(page.find("connect-src 'self'\r\n"), page.npos);
  EXPECT_NE(page.find("application/x-eyrie-live"), page.npos);
  EXPECT_EQ(page.find("application/x-eyrie-run"), page.npos);
}

/// Bytes of memory that the program has.
std::size_t memory_of(pid_t process) {
  std::size_t all = 0, resident = 0;
  std::ifstream(fmt::format("/proc/{}/statm", process)) >> all >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

TEST(Live, OutlivesWhoeverMeansHarm) {
  Mission mission({"merge", "--rate", "1"});
  LiveViewer viewer(mission.port);
  const TcpClient never_reads = join_live(mission.port);
  const std::size_t before = memory_of(mission.server->id());
  std::vector<TcpClient> silent;
  for (int i = 0; i < 1000; ++i)
    silent.emplace_back(mission.port);
  const auto ended = [&](const std::string& bytes) {
    TcpClient bad = join_live(mission.port);
    static_cast<void>(bad.read_to("\r\n\r\n"));
    bad.send(bytes + std::string("\x88\x80\0\0\0\0", 6));  // and goes
    return bad.read_all();
  };
  const std::string whole = ws_frame(std::string(4097, 'x'));
  for (const std::string& bad :
       {ws_frame("x", '\x82', 1 << 30), ws_frame("x", '\x81', 1 << 30), whole})
    EXPECT_EQ(ended(bad).find("refused"), std::string::npos) << "ended without an answer";
  for (const auto& [bad, why] : std::vector<std::pair<std::string, std::string>>{
           {"rubbish", "no JSON object"},
           {"[1]", "no JSON object"},
           {std::string(4000, '['), "no JSON object"},
           {"{}", "do: play, pause, step, rate or order"},
           {R"({"do":"fly"})", "do: play, pause, step, rate or order"},
           {R"({"do":"step","steps":0})", "steps: a whole number from 1 to 5000"},
           {R"({"do":"rate","rate":1e9})", "rate: a number from 0.1 to 100, or \"max\""},
           {R"({"do":"play","and":1})", "more than is asked for"}}) {
    const std::string said = ended(ws_frame(bad));
    EXPECT_NE(said.find(why), said.npos) << bad << ": " << said.substr(0, 300);
  }
  std::string many;
  for (int i = 0; i < 1000; ++i)
    many += ws_frame(R"({"do":"order","order":"lose","player":"nobody"})");
  EXPECT_NE(ended(many).find("too many messages in a second"), std::string::npos);
  TcpClient other = join_live(mission.port, "Origin: http://evil.example\r\n");
  EXPECT_TRUE(other.read_all().starts_with("HTTP/1.1 403 "));
  EXPECT_LT(memory_of(mission.server->id()), before + (std::size_t{24} << 20));
  mission.server->kill(SIGINT);
  EXPECT_EQ(viewer.follow_to_the_end()["outcome"], "stopped");
  const Ran ran = mission.server->wait();
  std::smatch refused;
  ASSERT_TRUE(std::regex_search(ran.err, refused, std::regex(R"((\d+) refused\n)"))) << ran.err;
  EXPECT_GE(std::stoi(refused[1]), 900 + 13);
  mission.expect_replay(viewer.world(), "1");
}

TEST(Live, AsksOthersForAToken) {
  Mission mission({"merge", "--paused", "--address", "0.0.0.0"});
  TcpClient without = join_live(mission.port);
  EXPECT_TRUE(without.read_all().starts_with("HTTP/1.1 403 "));
  const std::string cookie = "Cookie: eyrie_" + std::to_string(mission.port) + "=";
  TcpClient wrong = join_live(mission.port, cookie + std::string(32, '0') + "\r\n");
  EXPECT_TRUE(wrong.read_all().starts_with("HTTP/1.1 403 "));
  const std::string token = mission.address.substr(mission.address.find("?token=") + 7);
  TcpClient with = join_live(mission.port, cookie + token + "\r\n");
  EXPECT_TRUE(with.read_to("\r\n\r\n").starts_with("HTTP/1.1 101 "));
}

TEST(Live, SaysWhatIsWrong) {
  const TempFolder folder;
  const auto said = [&](const std::vector<std::string>& words) {
    const Ran ran = run_program(folder, words);
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(folder.everything(), std::vector<std::string>{});
    return ran.err;
  };
  EXPECT_EQ(said({"serve", "sweeep"}),
            "eyrie: there is no scenario 'sweeep'; did you mean 'sweep'?\n");
  EXPECT_NE(said({"serve", "sweep", "--rate", "1000"}).find("--rate"), std::string::npos);
  EXPECT_NE(said({"serve", ".", "--paused"}).find("is a run, which was flown already"),
            std::string::npos);
}

}  // namespace
}  // namespace eyrie::test
