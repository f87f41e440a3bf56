// SPDX-License-Identifier: MIT
/// \file  `eyrie serve`: a browser gets the debrief page, and nobody else anything.
#include <gtest/gtest.h>

#include <csignal>
#include <regex>

#include "support/program.hpp"
#include "support/soon.hpp"
#include "support/tcp_client.hpp"

namespace eyrie::test {
namespace {

/// A run that is served.
struct Served {
  TempFolder folder;
  std::optional<Running> server;
  std::uint16_t port = 0;
  std::string address;  ///< as it was printed

  explicit Served(std::vector<std::string> more = {}) {
    const Ran flown = run_program(folder, {"fly", "merge", "--until", "10 s", "--out", "run"});
    if (flown.code != 0)
      throw std::runtime_error(flown.err);
    std::vector<std::string> words{"serve", "run", "--port", "0"};
    words.insert(words.end(), more.begin(), more.end());
    server.emplace(folder, words);
    std::smatch found;
    static const std::regex kAt(R"((http://[^ ]*:(\d+)/[^ ]*) shows it)");
    std::string said;
    if (!soon([&] { return std::regex_search(said = server->err(), found, kAt); }))
      throw std::runtime_error("says no address: " + said);
    address = found[1];
    port = static_cast<std::uint16_t>(std::stoi(found[2]));
  }
  [[nodiscard]] std::string ask(const std::string& path) const {
    TcpClient client(port);
    client.send("GET " + path + " HTTP/1.1\r\nHost: localhost:" + std::to_string(port) +
                "\r\n\r\n");
    return client.read_all();
  }
};

TEST(Serve, GivesTheDebriefPageUntilItIsEnded) {
  Served site;
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

TEST(Serve, AsksOthersForAToken) {
  Served site({"--address", "0.0.0.0"});
  const std::size_t token = site.address.find("?token=");
  ASSERT_NE(token, std::string::npos) << site.address;
  EXPECT_EQ(site.address.size() - token, 7u + 32);
  EXPECT_TRUE(site.ask("/").starts_with("HTTP/1.1 403 "));
  EXPECT_TRUE(site.ask("/" + site.address.substr(token)).starts_with("HTTP/1.1 303 "));
  Served other({"--address", "0.0.0.0"});
  EXPECT_TRUE(other.ask("/" + site.address.substr(token)).starts_with("HTTP/1.1 403 "));
}

TEST(Serve, SaysWhatIsWrong) {
  Served site;
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
}

}  // namespace
}  // namespace eyrie::test
