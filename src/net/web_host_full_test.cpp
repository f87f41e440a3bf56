// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "net/web_host.hpp"
#include "support/soon.hpp"
#include "support/tcp_client.hpp"

namespace eyrie::net {
namespace {

using test::TcpClient;

TEST(WebHost, GivesThePlaceOfWhoDoesNotTakeHisPageToWhoComes) {
  WebOptions options{.connections = 1, .patience = std::chrono::milliseconds(1000)};
  options.pages["/"] = {"text/plain", "hello"};
  options.pages["/long"] = {"text/plain", std::string(64 << 20, 'x')};
  const WebHost host(std::move(options));
  const auto request = [&](const std::string& path) {
    return "GET " + path + " HTTP/1.1\r\nHost: " + host.at().text() + "\r\n\r\n";
  };
  TcpClient idle(host.at().port, 4096);
  idle.send(request("/long"));
  static_cast<void>(idle.read_to("\r\n\r\n"));
  std::uint64_t full = 0;
  EXPECT_TRUE(test::soon([&] {
    TcpClient next(host.at().port);
    next.send(request("/"));
    const std::string answer = next.read_all();
    full += answer.starts_with("HTTP/1.1 503");
    return answer.ends_with("hello");
  }));
  EXPECT_GT(full, 0u) << "he has a moment to take it";
  EXPECT_EQ(host.counts().refused, full + 1) << "and no more";
}

}  // namespace
}  // namespace eyrie::net
