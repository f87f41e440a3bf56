// SPDX-License-Identifier: MIT
#pragma once
/// \file  Pages for browsers (HTTP), and a channel to those who look at them (WebSocket, at /live).
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "net/endpoint.hpp"

namespace eyrie::net {

struct WebPage {
  std::string type;  ///< "text/html; charset=utf-8"
  std::string body;
  unsigned status = 200;  ///< of HTTP
};

/// Somebody at /live. A number is never used twice.
using ViewerId = std::uint64_t;

/// What is done with viewers, by the thread of the network: it must not wait.
struct Channel {
  std::function<void(ViewerId)> joined;
  /// Gives why he is shown out, in at most 120 bytes; "" if he may stay.
  std::function<std::string(ViewerId, std::string_view text)> said;
  std::function<void(ViewerId)> left;  ///< of who has joined
};

struct WebOptions {
  Endpoint at;
  /// What a browser has to know: /?token=... gives it a cookie. Empty: nothing, and then the host
  /// is asked by the names of this machine alone.
  std::string token;
  std::map<std::string, WebPage, std::less<>> pages;  ///< by their path, such as "/"
  /// Another page, made when it is asked for, by the thread of the network; nothing: there is none.
  std::function<std::optional<WebPage>(std::string_view target)> made;
  std::size_t connections = 64;                ///< at a time
  Channel channel;                             ///< none: a viewer who talks is shown out
  std::size_t message = 4096;                  ///< bytes, the longest that a viewer may send
  double messages = 60;                        ///< that he may send in a second, and at once
  std::size_t waiting = 8 << 20;               ///< bytes, for one viewer
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

  /// With the port that was free, if any would do.
  [[nodiscard]] const Endpoint& at() const;
  /// The first thing that a viewer gets, in binary; to be sent once. From then on he gets what is
  /// for everybody.
  void greet(ViewerId who, std::shared_ptr<const std::string> bytes);
  /// A message for everybody who was greeted, or for one viewer.
  void send(std::string message);
  void send(ViewerId who, std::string message);

  /// So far.
  struct Counts {
    std::uint64_t pages = 0;    ///< sent
    std::uint64_t viewers = 0;  ///< who joined /live
    std::uint64_t refused = 0;  ///< requests and connections
    std::uint64_t dropped = 0;  ///< viewers who were too slow
    std::uint64_t bytes = 0;    ///< sent to viewers
  };
  [[nodiscard]] Counts counts() const;

 private:
  struct Network;
  std::unique_ptr<Network> network_;
};

}  // namespace eyrie::net
