// SPDX-License-Identifier: MIT
#include "net/listener.hpp"

#include <system_error>

namespace eyrie::net {
namespace {

void check(const error_code& failed) {
  if (failed)
    throw std::system_error(failed.value(), std::system_category());
}

}  // namespace

Listener::Listener(Endpoint& at) {
  const tcp::endpoint endpoint(asio::ip::make_address(at.address), at.port);
  // the system takes those, and nobody could connect to them
  if (endpoint.address().is_multicast() || at.address == "255.255.255.255")
    throw std::system_error(std::make_error_code(std::errc::address_not_available));
  error_code failed;
  check(acceptor_.open(endpoint.protocol(), failed));
  check(acceptor_.set_option(tcp::acceptor::reuse_address(true), failed));
  check(acceptor_.bind(endpoint, failed));
  check(acceptor_.listen(asio::socket_base::max_listen_connections, failed));
  at.port = acceptor_.local_endpoint().port();
}

void Listener::run(Welcome welcome) {
  welcome_ = std::move(welcome);
  accept();
  thread_ = std::thread([this] { io.run(); });
}

void Listener::accept() {
  acceptor_.async_accept([this](error_code failed, tcp::socket socket) {
    if (!acceptor_.is_open())
      return;
    if (!failed) {
      welcome_(std::move(socket));
      return accept();
    }
    // no more files for now, or a client that has gone already
    timer_.expires_after(std::chrono::milliseconds(100));
    timer_.async_wait([this](error_code) {
      if (acceptor_.is_open())
        accept();
    });
  });
}

void Listener::close(std::chrono::milliseconds wait) {
  error_code ignored;
  acceptor_.close(ignored);
  timer_.expires_after(wait);
  timer_.async_wait([this](error_code) { io.stop(); });
}

void Listener::join() {
  thread_.join();
}

}  // namespace eyrie::net
