// SPDX-License-Identifier: MIT
#include "net/datagram_receiver.hpp"

#include <poll.h>

#include <array>
#include <atomic>
#include <thread>
#include <vector>

#include "net/datagram_socket.hpp"

namespace eyrie::net {
namespace {

constexpr int kLook = 50;  // ms between two looks whether it is over

std::uint16_t listen(const DatagramSocket& socket, const ReceiverOptions& options) {
  const in_addr at = ipv4_of(options.at.address);
  const std::uint32_t number = ntohl(at.s_addr);
  const bool group = IN_MULTICAST(number);
  socket.set(SOL_SOCKET, SO_REUSEADDR, 1);  // others on this machine hear the same
  const int room = 4 << 20;                 // as much of it as the system gives
  static_cast<void>(::setsockopt(socket.file(), SOL_SOCKET, SO_RCVBUF, &room, sizeof room));
  in_addr any{};
  any.s_addr = htonl(INADDR_ANY);
  socket.bind(group || number >> 24 == 127 ? at : any, options.at.port);
  if (group) {
    ip_mreq join{};
    join.imr_multiaddr = at;
    join.imr_interface = ipv4_of(options.interface.empty() ? "127.0.0.1" : options.interface);
    socket.set(IPPROTO_IP, IP_ADD_MEMBERSHIP, join);
  }
  sockaddr_in bound{};
  socklen_t size = sizeof bound;
  must(::getsockname(socket.file(), reinterpret_cast<sockaddr*>(&bound), &size) == 0);
  return ntohs(bound.sin_port);
}

}  // namespace

/// A ring of datagrams: one thread puts them in, one takes them out.
struct DatagramReceiver::Line {
  struct Slot {
    std::array<std::byte, kLongest> bytes;
    std::size_t size = 0;
    WallClock::time_point came;
  };

  explicit Line(const ReceiverOptions& options)
      : port(listen(socket, options)), slots(options.slots) {
    thread = std::thread([this] { run(); });
  }

  void run() {
    pollfd waiting{socket.file(), POLLIN, 0};
    std::array<std::byte, kLongest> over;  // what there is no room for
    while (!closing.load(std::memory_order_acquire)) {
      if (::poll(&waiting, 1, kLook) != 1)
        continue;
      const std::uint64_t place = put.load(std::memory_order_relaxed);
      const bool room = place - taken.load(std::memory_order_acquire) < slots.size();
      Slot& slot = slots[place % slots.size()];
      const ssize_t size =
          ::recv(socket.file(), room ? slot.bytes.data() : over.data(), kLongest, MSG_TRUNC);
      if (size < 0)
        continue;
      ++counts.received;
      counts.bytes += static_cast<std::size_t>(size);
      if (static_cast<std::size_t>(size) > kLongest) {
        ++counts.too_long;
      } else if (!room) {
        ++counts.dropped;
      } else {
        slot.size = static_cast<std::size_t>(size);
        slot.came = WallClock::now();
        put.store(place + 1, std::memory_order_release);
      }
    }
  }

  DatagramSocket socket;
  std::uint16_t port;
  std::vector<Slot> slots;
  std::atomic<std::uint64_t> put = 0, taken = 0;
  std::atomic<bool> closing = false;
  Counts counts;  ///< of the thread
  std::thread thread;
};

DatagramReceiver::DatagramReceiver(const ReceiverOptions& options)
    : line_(std::make_unique<Line>(options)) {}

DatagramReceiver::~DatagramReceiver() {
  close();
}

std::uint16_t DatagramReceiver::port() const {
  return line_->port;
}

void DatagramReceiver::drain(const Use& use) {
  Line& line = *line_;
  std::uint64_t taken = line.taken.load(std::memory_order_relaxed);
  // what comes meanwhile waits: who sends without end holds nobody up
  const std::uint64_t put = line.put.load(std::memory_order_acquire);
  while (taken != put) {
    const Line::Slot& slot = line.slots[taken % line.slots.size()];
    use(std::span(slot.bytes).first(slot.size), slot.came);
    line.taken.store(++taken, std::memory_order_release);
  }
}

void DatagramReceiver::close() {
  if (!line_->thread.joinable())
    return;
  line_->closing.store(true, std::memory_order_release);
  line_->thread.join();
}

DatagramReceiver::Counts DatagramReceiver::counts() const {
  return line_->counts;
}

}  // namespace eyrie::net
