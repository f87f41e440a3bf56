// SPDX-License-Identifier: MIT
#include "net/datagrams.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
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

void aim(const DatagramSocket& socket, const DatagramOptions& options) {
  const in_addr to = ipv4_of(options.to.address);
  const bool group = IN_MULTICAST(ntohl(to.s_addr));
  socket.set(SOL_SOCKET, SO_BROADCAST, 1);
  if (group || !options.interface.empty()) {
    const in_addr from = ipv4_of(options.interface.empty() ? "127.0.0.1" : options.interface);
    socket.bind(from, 0);
    if (group) {
      socket.set(IPPROTO_IP, IP_MULTICAST_IF, from);
      socket.set(IPPROTO_IP, IP_MULTICAST_LOOP, 1);  // others on this machine hear it, too
    }
  }
  socket.connect(to, options.to.port);
}

/// errno, or 0.
int send_to_aim(const DatagramSocket& socket, std::span<const std::byte> bytes) {
  for (;;) {
    if (::send(socket.file(), bytes.data(), bytes.size(), MSG_NOSIGNAL) >= 0)
      return 0;
    // of an earlier one, that nobody listens there now: somebody may later
    if (errno != EINTR && errno != ECONNREFUSED)
      return errno;
  }
}

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
struct DatagramSender::Line {
  struct Slot {
    std::array<std::byte, kLongest> bytes;
    std::size_t size = 0;
  };

  explicit Line(const DatagramOptions& options) : slots(options.slots) {
    aim(socket, options);
    thread = std::thread([this] { run(); });
  }

  void run() {
    for (;;) {
      const std::uint32_t heard = calls.load(std::memory_order_acquire);
      const bool last = closing.load(std::memory_order_acquire);
      for (; taken != put.load(std::memory_order_acquire); ++taken) {
        const Slot& slot = slots[taken % slots.size()];
        const int error = send_to_aim(socket, std::span(slot.bytes).first(slot.size));
        if (error == 0) {
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

  DatagramSocket socket;
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
