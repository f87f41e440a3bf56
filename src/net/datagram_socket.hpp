// SPDX-License-Identifier: MIT
#pragma once
/// \file  What who sends datagrams and who receives them share. To be included by .cpp files alone.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace eyrie::net {

inline void must(bool good) {
  if (!good)
    throw std::system_error(errno, std::system_category());
}

inline in_addr ipv4_of(const std::string& text) {
  in_addr address{};
  errno = EAFNOSUPPORT;
  must(::inet_pton(AF_INET, text.c_str(), &address) == 1);
  return address;
}

/// A socket of IPv4 for datagrams; throws std::system_error.
class DatagramSocket {
 public:
  DatagramSocket() : file_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) { must(file_ >= 0); }
  ~DatagramSocket() { ::close(file_); }
  DatagramSocket(const DatagramSocket&) = delete;
  DatagramSocket& operator=(const DatagramSocket&) = delete;

  [[nodiscard]] int file() const { return file_; }
  void set(int level, int option, const auto& value) const {
    must(::setsockopt(file_, level, option, &value, sizeof value) == 0);
  }
  void bind(in_addr address, std::uint16_t port) const {
    const sockaddr_in at = place(address, port);
    must(::bind(file_, reinterpret_cast<const sockaddr*>(&at), sizeof at) == 0);
  }
  void connect(in_addr address, std::uint16_t port) const {
    const sockaddr_in to = place(address, port);
    must(::connect(file_, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0);
  }

 private:
  static sockaddr_in place(in_addr address, std::uint16_t port) {
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_port = htons(port);
    at.sin_addr = address;
    return at;
  }
  int file_;
};

}  // namespace eyrie::net
