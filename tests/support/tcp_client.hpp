// SPDX-License-Identifier: MIT
#pragma once
/// \file  A client by plain sockets, which shares nothing with our hosts. Whatever it waits for
/// ends after 300 seconds.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace eyrie::test {

class TcpClient {
 public:
  /// Of 127.0.0.1. `window`: bytes that the system takes before they are read; 0: as it likes.
  explicit TcpClient(std::uint16_t port, int window = 0)
      : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (window)
      ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &window, sizeof window);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (socket_ < 0 || ::connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof to) != 0)
      throw std::runtime_error("cannot connect");
  }
  TcpClient(TcpClient&& other) noexcept
      : socket_(std::exchange(other.socket_, -1)), held_(std::move(other.held_)) {}
  TcpClient& operator=(TcpClient&&) = delete;
  ~TcpClient() {
    if (socket_ >= 0)
      ::close(socket_);
  }

  /// The bytes that were taken: fewer if the other end has closed, or takes no more.
  std::size_t send(std::string_view text) {
    std::size_t sent = 0;
    while (sent < text.size()) {
      if (!ready(POLLOUT))
        break;
      const ssize_t n = ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (n <= 0)
        break;
      sent += static_cast<std::size_t>(n);
    }
    return sent;
  }
  /// Sends no more, and goes on reading.
  void end() { ::shutdown(socket_, SHUT_WR); }
  /// Up to and with `end`; what came by then, if the other end closes before.
  [[nodiscard]] std::string read_to(std::string_view end) {
    for (;;) {
      if (const auto at = held_.find(end); !end.empty() && at != held_.npos)
        return taken(at + end.size());
      if (!receive())
        return std::exchange(held_, {});
    }
  }
  /// So many bytes; fewer if the other end closes before.
  [[nodiscard]] std::string read(std::size_t size) {
    while (held_.size() < size && receive()) {
    }
    return taken(std::min(size, held_.size()));
  }
  /// Until the other end closes.
  [[nodiscard]] std::string read_all() { return read_to({}); }

 private:
  [[nodiscard]] std::string taken(std::size_t size) {
    std::string text = held_.substr(0, size);
    held_.erase(0, size);
    return text;
  }
  bool receive() {
    if (!ready(POLLIN))
      throw std::runtime_error("nothing comes; so far: " + held_.substr(0, 200));
    char part[1 << 16];
    const ssize_t n = ::recv(socket_, part, sizeof part, 0);
    if (n > 0)
      held_.append(part, static_cast<std::size_t>(n));
    return n > 0;
  }
  [[nodiscard]] bool ready(short what) const {
    pollfd one{.fd = socket_, .events = what, .revents = 0};
    return ::poll(&one, 1, 300'000) == 1;
  }
  int socket_;
  std::string held_;
};

inline constexpr std::string_view kTacviewProtocols =
    "XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\n";

/// A client that has said what Tacview says; `hash`: of its password.
[[nodiscard]] inline TcpClient join_telemetry(std::uint16_t port, std::string_view hash = "0",
                                              int window = 0) {
  TcpClient client(port, window);
  const std::string greeting = client.read_to(std::string_view("\0", 1));
  if (!greeting.starts_with(kTacviewProtocols) || !greeting.ends_with(std::string_view("\n\0", 2)))
    throw std::runtime_error("no host of telemetry: " + greeting);
  client.send(std::string(kTacviewProtocols) + "Test\n" + std::string(hash) + '\0');
  return client;
}

}  // namespace eyrie::test
