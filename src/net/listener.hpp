// SPDX-License-Identifier: MIT
#pragma once
/// \file  What hosts of this layer share: a thread with everything that the network does, a socket
/// that takes connections, whom a host has let in, and what waits for each of them. To be included
/// by .cpp files alone: it brings Boost.Asio.
#include <algorithm>
#include <atomic>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "net/endpoint.hpp"

namespace eyrie::net {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
/// For any number of clients.
using Text = std::shared_ptr<const std::string>;

class Listener {
 public:
  using Welcome = std::function<void(tcp::socket)>;

  /// Listens; a port of 0 becomes the one that was free. Throws std::system_error if it cannot.
  explicit Listener(Endpoint& at);

  /// From now on the thread runs what is posted to `io`, and `welcome` for each connection.
  void run(Welcome welcome);
  /// By the thread: nobody is welcome any more, and after `wait` it ends.
  void close(std::chrono::milliseconds wait);
  /// By the thread: it ends.
  void stop() { io.stop(); }
  /// Until it has ended.
  void join();
  [[nodiscard]] bool running() const { return thread_.joinable(); }

  asio::io_context io{1};

 private:
  void accept();

  asio::executor_work_guard<asio::io_context::executor_type> work_{io.get_executor()};
  tcp::acceptor acceptor_{io};
  asio::steady_timer timer_{io};
  Welcome welcome_;
  std::thread thread_;
};

struct Guest {
  bool gone = false;
  std::deque<Text> out;
  std::size_t pending = 0;  ///< bytes of `out`
  std::size_t room = 0;     ///< bytes more than others that may wait for him
};

/// One host's; all of it but the counters belongs to the listener's thread. `Kind` is a Guest with
///   bool silent()                      whether he has not said yet who he is
///   void close()                       at once, with what the system still holds for him if
///                                      something waits
///   void write(const Text&, handler)   calls handler(error_code, size_t)
template <class Kind>
class Guests {
 public:
  using Ptr = std::shared_ptr<Kind>;

  /// At most so many at a time, and so many bytes that wait for one of them.
  Guests(std::size_t most, std::size_t waiting) : most_(most), waiting_(waiting) {}

  /// Lets him in if there is room for one more, or one who is silent can be shown out.
  bool admit(const Ptr& guest) {
    if (all_.size() >= most_) {
      const auto silent = std::ranges::find_if(all_, [](const Ptr& one) { return one->silent(); });
      if (silent == all_.end()) {
        ++refused;
        return false;
      }
      refuse(Ptr(*silent));
    }
    all_.push_back(guest);
    return true;
  }
  void refuse(const Ptr& guest) {
    if (guest->gone)
      return;
    ++refused;
    end(guest);
  }
  void end(const Ptr& guest) {
    if (guest->gone)
      return;
    guest->gone = true;
    guest->close();
    all_.erase(std::ranges::find(all_, guest));
    if (on_end)
      on_end(*guest);
  }

  /// He gets it after what waits already. A guest who is too slow is dropped.
  void send(const Ptr& guest, const Text& text) {
    if (guest->gone || text->empty())
      return;
    guest->pending += text->size();
    if (guest->pending > waiting_ + guest->room) {
      ++dropped;
      return end(guest);
    }
    guest->out.push_back(text);
    if (guest->out.size() == 1)
      write(guest);
  }

  [[nodiscard]] bool empty() const { return all_.empty(); }
  /// In the order in which they came; a copy, so that each of them may end.
  [[nodiscard]] std::vector<Ptr> all() const { return all_; }

  std::function<void(Kind&)> on_end;           ///< one of them has gone
  std::function<void(const Ptr&)> on_drained;  ///< nothing waits for him any more
  std::atomic<std::uint64_t> refused = 0, dropped = 0, sent = 0;  ///< guests, guests, bytes

 private:
  void write(const Ptr& guest) {
    guest->write(guest->out.front(), [this, guest](error_code failed, std::size_t size) {
      sent += size;
      if (guest->gone)
        return;
      if (failed)
        return end(guest);
      guest->pending -= guest->out.front()->size();
      guest->out.pop_front();
      if (!guest->out.empty())
        write(guest);
      else if (on_drained)
        on_drained(guest);
    });
  }

  std::size_t most_, waiting_;
  std::vector<Ptr> all_;
};

}  // namespace eyrie::net
