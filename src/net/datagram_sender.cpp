// SPDX-License-Identifier: MIT
#include "net/datagram_sender.hpp"

#include <array>
#include <atomic>
#include <cstring>
#include <thread>
#include <vector>

#include "net/datagram_socket.hpp"

namespace eyrie::net {
namespace {

class Socket {
 public:
  explicit Socket(const DatagramOptions& options) {
    const in_addr to = ipv4_of(options.to.address);
    const bool group = IN_MULTICAST(ntohl(to.s_addr));
    socket_.set(SOL_SOCKET, SO_BROADCAST, 1);
    if (group || !options.interface.empty()) {
      const in_addr from = ipv4_of(options.interface.empty() ? "127.0.0.1" : options.interface);
      socket_.bind(from, 0);
      if (group) {
        socket_.set(IPPROTO_IP, IP_MULTICAST_IF, from);
        socket_.set(IPPROTO_IP, IP_MULTICAST_LOOP, 1);  // others on this machine hear it, too
      }
    }
    socket_.connect(to, options.to.port);
  }

  /// errno, or 0.
  [[nodiscard]] int send(std::span<const std::byte> bytes) const {
    for (;;) {
      if (::send(socket_.file(), bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0)
        return 0;
      // of an earlier one, that nobody listens there now: somebody may later
      if (errno != EINTR && errno != ECONNREFUSED)
        return errno;
    }
  }

 private:
  DatagramSocket socket_;
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
