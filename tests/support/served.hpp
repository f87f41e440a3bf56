// SPDX-License-Identifier: MIT
#pragma once
/// \file  `eyrie serve` while it runs, and what it answers.
#include <fmt/format.h>

#include <optional>
#include <regex>

#include "support/program.hpp"
#include "support/soon.hpp"
#include "support/tcp_client.hpp"

namespace eyrie::test {

struct Served {
  TempFolder folder;
  std::optional<Running> server;
  std::uint16_t port = 0;
  std::string address;  ///< as it was printed

  /// `words` behind `serve`; `before`: what the program does in the folder first.
  explicit Served(std::vector<std::string> words, const std::vector<std::string>& before = {}) {
    if (!before.empty())
      if (const Ran ran = run_program(folder, before); ran.code != 0)
        throw std::runtime_error(ran.err);
    words.insert(words.begin(), "serve");
    words.insert(words.end(), {"--port", "0"});
    server.emplace(folder, words);
    std::smatch found;
    static const std::regex kAt(R"((http://[^ ]*:(\d+)/[^ ]*) shows it)");
    std::string said;
    if (!soon([&] { return std::regex_search(said = server->err(), found, kAt); }))
      throw std::runtime_error("says no address: " + said);
    address = found[1];
    port = static_cast<std::uint16_t>(std::stoi(found[2]));
  }
  /// The answer to a request of a page.
  [[nodiscard]] std::string ask(const std::string& path) const {
    try {
      TcpClient client(port);
      client.send(fmt::format("GET {} HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", path, port));
      return client.read_all();
    } catch (const std::runtime_error&) {  // between two hosts
      return "";
    }
  }
};

}  // namespace eyrie::test
