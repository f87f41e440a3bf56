// SPDX-License-Identifier: MIT
#pragma once
/// \file  What hosts of this layer share: a thread with everything that the network does, and a
/// socket that takes connections. To be included by .cpp files alone: it brings Boost.Asio.
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

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

}  // namespace eyrie::net
