// SPDX-License-Identifier: MIT
#pragma once
/// \file  Pages for browsers (HTTP), and a channel to those who look at them (WebSocket, at /live).
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "net/endpoint.hpp"

namespace eyrie::net {

struct WebPage {
  std::string type;  ///< "text/html; charset=utf-8"
  std::string body;
};

struct WebOptions {
  Endpoint at;
  /// What a browser has to know: /?token=... gives it a cookie. Empty: nothing, and then the host
  /// is asked by the names of this machine alone.
  std::string token;
  std::map<std::string, WebPage, std::less<>> pages;  ///< by their path, such as "/"
  std::size_t connections = 64;                       ///< at a time
  std::size_t message = 64 << 10;                     ///< bytes, the longest that a viewer may send
  std::size_t waiting = 8 << 20;                      ///< bytes, for one viewer
  std::chrono::milliseconds patience{10'000};  ///< for a request; six times as long to take a page
};

/// A thread of its own has all sockets. No page of another site reaches it: it answers who asks by
/// its own name, from a page of its own, with its token if there is one. A viewer who is too slow
/// is dropped.
class WebHost {
 public:
  /// Listens. Throws std::system_error if it cannot.
  explicit WebHost(WebOptions options);
  ~WebHost();
  WebHost(const WebHost&) = delete;
  WebHost& operator=(const WebHost&) = delete;

  /// With the port that was free, if any would do.
  [[nodiscard]] const Endpoint& at() const;
  /// A message for everybody at /live.
  void send(std::string message);

  /// So far.
  struct Counts {
    std::uint64_t pages = 0;    ///< sent
    std::uint64_t viewers = 0;  ///< who joined /live
    std::uint64_t refused = 0;  ///< requests and connections
    std::uint64_t dropped = 0;  ///< viewers who were too slow
  };
  [[nodiscard]] Counts counts() const;

 private:
  struct Network;
  std::unique_ptr<Network> network_;
};

}  // namespace eyrie::net
