// SPDX-License-Identifier: MIT
#pragma once
/// \file  Hears datagrams by a plain socket, which shares nothing with who sends them.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace eyrie::test {

class UdpListener {
 public:
  /// On a free port of this machine; `group`: also what is sent to that address through loopback.
  explicit UdpListener(const std::string& group = "")
      : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    const int room = 4 << 20;  // as much of it as the system gives
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_ANY);
    socklen_t size = sizeof at;
    if (socket_ < 0 || ::bind(socket_, reinterpret_cast<sockaddr*>(&at), size) != 0 ||
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&at), &size) != 0)
      throw std::runtime_error("cannot listen");
    port_ = ntohs(at.sin_port);
    if (group.empty())
      return;
    ip_mreq join{};
    join.imr_multiaddr.s_addr = ::inet_addr(group.c_str());
    join.imr_interface.s_addr = htonl(INADDR_LOOPBACK);
    if (::setsockopt(socket_, IPPROTO_IP, IP_ADD_MEMBERSHIP, &join, sizeof join) != 0)
      throw std::runtime_error("cannot join " + group);
  }
  ~UdpListener() { ::close(socket_); }
  UdpListener(const UdpListener&) = delete;
  UdpListener& operator=(const UdpListener&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// The next datagram; nothing if none comes for so long.
  [[nodiscard]] std::optional<std::string> next(int milliseconds = 20'000) const {
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, milliseconds) != 1)
      return {};
    std::string bytes(65536, '\0');
    const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), 0);
    bytes.resize(got < 0 ? 0 : static_cast<std::size_t>(got));
    return bytes;
  }
  /// Those that have come already.
  [[nodiscard]] std::vector<std::string> waiting() const {
    std::vector<std::string> all;
    while (auto one = next(0))
      all.push_back(std::move(*one));
    return all;
  }

 private:
  int socket_;
  std::uint16_t port_ = 0;
};

}  // namespace eyrie::test
