// SPDX-License-Identifier: MIT
#include "net/datagram_sender.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <thread>
#include <vector>

namespace eyrie::net {
namespace {

void must(bool good) {
  if (!good)
    throw std::system_error(errno, std::system_category());
}

in_addr ipv4_of(const std::string& text) {
  in_addr address{};
  errno = EAFNOSUPPORT;
  must(::inet_pton(AF_INET, text.c_str(), &address) == 1);
  return address;
}

class Socket {
 public:
  explicit Socket(const DatagramOptions& options)
      : file_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    must(file_ >= 0);
    try {
      open(options);
    } catch (...) {
      ::close(file_);
      throw;
    }
  }
  ~Socket() { ::close(file_); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  /// errno, or 0.
  [[nodiscard]] int send(std::span<const std::byte> bytes) const {
    for (;;) {
      if (::send(file_, bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0)
        return 0;
      // of an earlier one, that nobody listens there now: somebody may later
      if (errno != EINTR && errno != ECONNREFUSED)
        return errno;
    }
  }

 private:
  void set(int level, int option, const auto& value) const {
    must(::setsockopt(file_, level, option, &value, sizeof value) == 0);
  }
  void open(const DatagramOptions& options) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(options.to.port);
    to.sin_addr = ipv4_of(options.to.address);
    const bool group = IN_MULTICAST(ntohl(to.sin_addr.s_addr));
    set(SOL_SOCKET, SO_BROADCAST, 1);
    if (group || !options.interface.empty()) {
      sockaddr_in from{};
      from.sin_family = AF_INET;
      from.sin_addr = ipv4_of(options.interface.empty() ? "127.0.0.1" : options.interface);
      must(::bind(file_, reinterpret_cast<const sockaddr*>(&from), sizeof from) == 0);
      if (group) {
        set(IPPROTO_IP, IP_MULTICAST_IF, from.sin_addr);
        set(IPPROTO_IP, IP_MULTICAST_LOOP, 1);  // others on this machine hear it, too
      }
    }
    must(::connect(file_, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0);
  }

  int file_;
};

}  // namespace

/// A ring of datagrams: one thread puts them in, one takes them out.
struct DatagramSender::Line {
  struct Slot {
    std::array<std::byte, kLongest> bytes;
    std::size_t size = 0;
  };

  explicit Line(const DatagramOptions& options) : socket(options), slots(options.slots) {
    thread = std::thread([this] { run(); });
  }

  void run() {
    for (;;) {
      const std::uint32_t heard = calls.load(std::memory_order_acquire);
      const bool last = closing.load(std::memory_order_acquire);
      for (; taken != put.load(std::memory_order_acquire); ++taken) {
        const Slot& slot = slots[taken % slots.size()];
        if (const int error = socket.send(std::span(slot.bytes).first(slot.size)); error == 0) {
          ++counts.sent;
          counts.bytes += slot.size;
        } else if (counts.failed++ == 0) {
          counts.error = error;
        }
      }
      if (last)
        return;
      calls.wait(heard, std::memory_order_acquire);
    }
  }
  void call() {
    calls.fetch_add(1, std::memory_order_release);
    calls.notify_one();
  }

  Socket socket;
  std::vector<Slot> slots;
  std::atomic<std::uint64_t> put = 0, taken = 0;
  std::atomic<std::uint32_t> calls = 0;
  std::atomic<bool> closing = false;
  std::uint64_t dropped = 0;  ///< of who sends
  Counts counts;              ///< of the thread
  std::thread thread;
};

DatagramSender::DatagramSender(const DatagramOptions& options)
    : line_(std::make_unique<Line>(options)) {}

DatagramSender::~DatagramSender() {
  close();
}

void DatagramSender::send(std::span<const std::byte> bytes) {
  Line& line = *line_;
  const std::uint64_t put = line.put.load(std::memory_order_relaxed);
  if (bytes.size() > kLongest ||
      put - line.taken.load(std::memory_order_acquire) == line.slots.size()) {
    ++line.dropped;
    return;
  }
  Line::Slot& slot = line.slots[put % line.slots.size()];
  std::memcpy(slot.bytes.data(), bytes.data(), bytes.size());
  slot.size = bytes.size();
  line.put.store(put + 1, std::memory_order_release);
  line.call();
}

void DatagramSender::close() {
  if (!line_->thread.joinable())
    return;
  line_->closing.store(true, std::memory_order_release);
  line_->call();
  line_->thread.join();
}

DatagramSender::Counts DatagramSender::counts() const {
  Counts counts = line_->counts;
  counts.dropped = line_->dropped;
  return counts;
}

}  // namespace eyrie::net
