// SPDX-License-Identifier: MIT
/// \file  `eyrie serve`: a browser gets the debrief page, and nobody else anything.
#include <gtest/gtest.h>

#include <csignal>

#include "support/served.hpp"

namespace eyrie::test {
namespace {

/// A run that is served.
struct ServedRun : Served {
  explicit ServedRun(std::vector<std::string> more = {})
      : Served(with_run(std::move(more)), {"fly", "merge", "--until", "10 s", "--out", "run"}) {}
  static std::vector<std::string> with_run(std::vector<std::string> words) {
    words.insert(words.begin(), "run");
    return words;
  }
};

TEST(Serve, GivesTheDebriefPageUntilItIsEnded) {
  ServedRun site;
  EXPECT_EQ(site.address, "http://127.0.0.1:" + std::to_string(site.port) + "/");
  const std::string answer = site.ask("/");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer.substr(0, 200);
  EXPECT_TRUE(answer.substr(answer.find("\r\n\r\n") + 4) ==
              read_text(site.folder / "run/debrief.html"));
  site.server->kill(SIGTERM);
  const Ran ran = site.server->wait();
  EXPECT_EQ(ran.code, 128 + SIGTERM);
  EXPECT_TRUE(ran.err.ends_with("eyrie: 1 page sent, 0 refused\n")) << ran.err;
}

TEST(Serve, DoesNotBeginWithAHomePageThatLeadsNowhere) {
  const TempFolder folder;
  const Ran ran = run_program(folder, {"serve", "--port", "0"}, {.viewer = "/none"});
  EXPECT_EQ(ran.code, 1);
  EXPECT_TRUE(ran.err.starts_with("eyrie: the debrief page is not built")) << ran.err;
}

TEST(Serve, AsksOthersForAToken) {
  ServedRun site({"--address", "0.0.0.0"});
  const std::size_t token = site.address.find("?token=");
  ASSERT_NE(token, std::string::npos) << site.address;
  EXPECT_EQ(site.address.size() - token, 7u + 32);
  EXPECT_TRUE(site.ask("/").starts_with("HTTP/1.1 403 "));
  EXPECT_TRUE(site.ask("/" + site.address.substr(token)).starts_with("HTTP/1.1 303 "));
  ServedRun other({"--address", "0.0.0.0"});
  EXPECT_TRUE(other.ask("/" + site.address.substr(token)).starts_with("HTTP/1.1 403 "));
}

TEST(Serve, SaysWhatIsWrong) {
  ServedRun site;
  const std::string port = std::to_string(site.port);
  const Ran taken = run_program(site.folder, {"serve", "run", "--port", port});
  EXPECT_EQ(taken.code, 2);
  EXPECT_EQ(taken.err, "cannot listen at 127.0.0.1:" + port + ": Address already in use\n");
  const Ran name = run_program(site.folder, {"serve", "run", "--address", "example.org"});
  EXPECT_EQ(name.code, 2);
  EXPECT_EQ(name.err,
            "eyrie: --address: 'example.org' is no address such as 0.0.0.0\neyrie serve "
            "--help says more\n");
  EXPECT_EQ(run_program(site.folder, {"serve", "nowhere"}).code, 2);
  const Ran all = run_program(site.folder, {"serve", "run", "--address", "255.255.255.255"});
  EXPECT_EQ(all.code, 2);
  EXPECT_EQ(all.err, "cannot listen at 255.255.255.255:8042: Cannot assign requested address\n");
  const Ran two = run_program(site.folder, {"serve", "sweep", "sweep"});
  EXPECT_EQ(two.code, 2);
  EXPECT_EQ(two.err,
            "eyrie: serve has no use for 'sweep': it flies one scenario, or compares two runs\n");
  const Ran twice = run_program(site.folder, {"serve", "nowhere", "nowhere"});
  EXPECT_EQ(twice.code, 2);
  EXPECT_EQ(twice.err, "nowhere: there is no such file\n");
}

}  // namespace
}  // namespace eyrie::test
