// SPDX-License-Identifier: MIT
/// \file  `eyrie serve` without a scenario: the home page, what is flown from it, and back.
#include <gtest/gtest.h>

#include <csignal>

#include "support/live_viewer.hpp"
#include "support/served.hpp"

namespace eyrie::test {
namespace {

using Json = nlohmann::json;

/// What comes behind the head of an answer.
std::string body(const std::string& answer) {
  return answer.substr(std::min(answer.size(), answer.find("\r\n\r\n") + 4));
}

TEST(Home, ListsScenariosFliesOneAndThenItsRun) {
  Served home({"--rate", "max"});
  EXPECT_NE(home.ask("/").find("<title>Eyrie</title>"), std::string::npos);
  const Json scenarios = Json::parse(body(home.ask("/api/scenarios")));
  const auto sweep = std::find_if(scenarios.begin(), scenarios.end(),
                                  [](const Json& one) { return one["name"] == "sweep"; });
  ASSERT_NE(sweep, scenarios.end());
  EXPECT_EQ((*sweep)["help"], "four F-15s sweep the area of two MiG-29s, on sensors alone");
  ASSERT_EQ((*sweep)["players"].size(), 6u);
  EXPECT_EQ((*sweep)["players"][0][2], "blue");
  EXPECT_TRUE(Json::parse(body(home.ask("/api/schema"))).contains("properties"));
  EXPECT_EQ(body(home.ask("/api/runs")), "[]");

  // chosen by somebody who makes mistakes first
  LiveChannel channel(home.port);
  const auto said = [&](Json wish) {
    wish["do"] = "fly";
    channel.say(wish);
    return Json::parse(channel.next().data);
  };
  EXPECT_EQ(said({{"scenario", "/etc/passwd"}})["refused"], "there is no scenario '/etc/passwd'");
  const std::string wrong = said({{"scenario", "merge"}, {"sets", {"untill=1 min"}}})["refused"];
  EXPECT_NE(wrong.find("did you mean 'until'?"), wrong.npos) << wrong;
  for (const char* set : {"plugins=/etc/passwx", "plugins.0=/etc/passwd", "\"plugins\"=[x]"})
    EXPECT_EQ(said({{"scenario", "merge"}, {"sets", {set}}})["refused"],
              "it uses plug-ins, which browsers cannot")
        << set;
  EXPECT_EQ(said({{"scenario", "merge"}, {"seed", "-1"}})["refused"],
            "seed: expected digits of a number below 2^64, got '-1'");
  EXPECT_EQ(said({{"scenario", "merge"}, {"seed", "8"}, {"sets", {"until=20 s"}}})["flies"],
            "merge");

  ASSERT_TRUE(soon([&] { return home.ask("/api/scenarios").starts_with("HTTP/1.1 404 "); }));
  LiveViewer viewer(home.port);
  viewer.follow_to_the_end();
  EXPECT_EQ(viewer.world().step(), 1000u);
  EXPECT_EQ(viewer.world().seed(), 8u);
  ASSERT_TRUE(soon([&] { return home.ask("/home").starts_with("HTTP/1.1 200 "); }));
  ASSERT_TRUE(soon([&] {
    static_cast<void>(home.ask("/home"));
    return home.ask("/api/runs").starts_with("HTTP/1.1 200 ");
  }));

  const Json runs = Json::parse(body(home.ask("/api/runs")));
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0]["name"], "merge-8");
  EXPECT_EQ(runs[0]["seed"], "8");
  EXPECT_EQ(runs[0]["sets"], Json({"until=20 s"}));
  EXPECT_NE(home.ask("/debrief?run=merge-8").find("application/x-eyrie-run"), std::string::npos);
  EXPECT_NE(home.ask("/debrief?run=merge-8&run=merge-8").find("application/x-eyrie-run"),
            std::string::npos);
  std::filesystem::rename(home.folder / "runs/merge-8", home.folder / "runs/\u00fc & b");
  EXPECT_EQ(Json::parse(body(home.ask("/api/runs")))[0]["name"], "\u00fc & b");
  EXPECT_NE(home.ask("/debrief?run=%C3%BC%20%26%20b").find("application/x-eyrie-run"),
            std::string::npos);
  EXPECT_TRUE(home.ask("/debrief?run=nosuch").starts_with("HTTP/1.1 404 "));
  for (const char* bad : {"/debrief", "/debrief?run=", "/debrief?run=../runs/merge-8", "/debrief?r",
                          "/debrief?run=%2e%2e%2fruns%2fmerge-8", "/debrief?run=%00",
                          "/debrief?run=merge-8&run=merge-8&run=merge-8", "/api/else"})
    EXPECT_TRUE(home.ask(bad).starts_with("HTTP/1.1 404 ")) << bad;
}

TEST(Home, ThrowsOutWhoWantsSomethingElse) {
  Served home({});
  for (const char* bad : {"rubbish", "{}", R"({"do":"play"})", R"({"do":"fly","scenario":1})",
                          R"({"do":"fly","scenario":"merge","seed":1})",
                          R"({"do":"fly","scenario":"merge","sets":[1]})"}) {
    TcpClient client = join_live(home.port);
    static_cast<void>(client.read_to("\r\n\r\n"));
    client.send(ws_frame(bad) + std::string("\x88\x80\0\0\0\0", 6));
    EXPECT_NE(client.read_all().find("no wish to fly a scenario"), std::string::npos) << bad;
  }
}

TEST(Home, LeadsBackWhileTheRunIsStillWritten) {
  Served home({"--rate", "max"});
  LiveChannel channel(home.port);
  channel.say({{"do", "fly"}, {"scenario", "sweep"}});
  EXPECT_EQ(Json::parse(channel.next().data)["flies"], "sweep");
  ASSERT_TRUE(soon([&] { return home.ask("/api/scenarios").starts_with("HTTP/1.1 404 "); }));
  LiveChannel mission(home.port);
  static_cast<void>(mission.next());  // what was flown so far
  while (Json::parse(mission.next().data).value("outcome", "running") == "running") {
  }
  const std::string answer = home.ask("/home");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 ")) << answer;
}

/// Not when somebody has chosen a scenario.
TEST(Home, RefusesAtOnceWhatNoFlightCouldHave) {
  TempFolder folder;
  const Served other({});
  for (const std::string& wrong :
       {fmt::format("--tacview {}", other.port), std::string("--tacview 0 --tacview-password none"),
        std::string("--dis --dis-threshold 3kg"),
        std::string("--dis --dis-interface 203.0.113.7")}) {
    const Ran ran = run_line(folder, "timeout 10 \"$EYRIE\" serve --port 0 " + wrong);
    EXPECT_EQ(ran.code, 2) << wrong << "\n" << ran.err;
    EXPECT_TRUE(ran.err.starts_with("--")) << ran.err;
  }
  EXPECT_EQ(folder.everything(), std::vector<std::string>{});
  folder.write("runs", "");
  const Ran ran = run_line(folder, "timeout 10 \"$EYRIE\" serve --port 0");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err, "eyrie: cannot make 'runs/latest': Not a directory\n");
}

TEST(Home, TakesPartInAnExercise) {
  const std::string at = "239.30.12.86:30186";
  Served home({"--ours", "blue", "--dis", at, "--dis-station", "1.1.1"});
  Running red(home.folder, {"fly", "merge", "--ours", "red", "--dis", at, "--dis-station", "1.1.2",
                            "--until", "5 min", "--out", "red", "--no-debrief"});
  const Json fly{{"do", "fly"}, {"scenario", "merge"}, {"sets", {"until=5 s"}}};
  LiveChannel channel(home.port);
  channel.say(fly);
  EXPECT_EQ(Json::parse(channel.next().data)["flies"], "merge");
  ASSERT_TRUE(soon([&] { return home.ask("/api/scenarios").starts_with("HTTP/1.1 404 "); }));
  LiveViewer viewer(home.port);
  EXPECT_EQ(viewer.follow_to_the_end()["shared"], true);
  EXPECT_TRUE(viewer.scenario().remote);
  EXPECT_GE(viewer.orders(), 2u) << "what was heard of red";

  Served alone({});
  LiveChannel other(alone.port);
  other.say({{"do", "fly"}, {"scenario", "merge"}, {"sets", {"ours=[blue]"}}});
  EXPECT_EQ(Json::parse(other.next().data)["refused"],
            "some of its players are another program's, of whom 'eyrie serve --dis' hears");
}

}  // namespace
}  // namespace eyrie::test
