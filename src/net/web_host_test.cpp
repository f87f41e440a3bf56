// SPDX-License-Identifier: MIT
#include "net/web_host.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <vector>

#include "support/soon.hpp"
#include "support/tcp_client.hpp"

namespace eyrie::net {
namespace {

using std::chrono::milliseconds;
using test::soon;
using test::TcpClient;

struct Site {
  WebHost host;

  explicit Site(WebOptions options = {}) : host(with_pages(std::move(options))) {}
  static WebOptions with_pages(WebOptions options) {
    options.pages["/"] = {"text/html", "<p>hello"};
    options.pages["/long"] = {"text/plain", std::string(3 << 20, 'x')};
    return options;
  }
  [[nodiscard]] std::uint16_t port() const { return host.at().port; }
  [[nodiscard]] std::string name() const { return host.at().text(); }

  /// The answer to a request without a body; `more`: header lines.
  [[nodiscard]] std::string ask(const std::string& first, const std::string& more = "",
                                std::string host_name = "") const {
    TcpClient client(port());
    client.send(request(first, more, std::move(host_name)));
    return client.read_all();
  }
  [[nodiscard]] std::string request(const std::string& first, const std::string& more = "",
                                    std::string host_name = "") const {
    if (host_name.empty())
      host_name = name();
    return fmt::format("{} HTTP/1.1\r\nHost: {}\r\n{}\r\n", first, host_name, more);
  }
  /// A viewer at /live.
  [[nodiscard]] TcpClient join(const std::string& more = "", int window = 0) const {
    TcpClient client(port(), window);
    client.send(request("GET /live",
                        "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
                            more));
    return client;
  }
};

std::string first_line(const std::string& answer) {
  return answer.substr(0, answer.find("\r\n"));
}

TEST(WebHost, GivesItsPages) {
  Site site;
  const std::string answer = site.ask("GET /");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n<p>hello")) << answer;
  for (const char* head :
       {"Content-Type: text/html\r\n", "Content-Length: 8\r\n", "Cache-Control: no-store\r\n",
        "X-Content-Type-Options: nosniff\r\n", "frame-ancestors 'none'"})
    EXPECT_NE(answer.find(head), answer.npos) << head;
  EXPECT_TRUE(site.ask("GET /?at=8:20").ends_with("<p>hello"));
  const std::string head = site.ask("HEAD /");
  EXPECT_NE(head.find("Content-Length: 8\r\n"), head.npos);
  EXPECT_TRUE(head.ends_with("\r\n\r\n"));
  EXPECT_GT(site.ask("GET /long").size(), std::size_t{3} << 20);
  EXPECT_EQ(site.host.counts().pages, 4u);
  EXPECT_EQ(site.host.counts().refused, 0u);
}

TEST(WebHost, AnswersNothingElse) {
  Site site;
  EXPECT_EQ(first_line(site.ask("GET /else")), "HTTP/1.1 404 Not Found");
  EXPECT_EQ(first_line(site.ask("GET /../etc/passwd")), "HTTP/1.1 404 Not Found");
  EXPECT_EQ(first_line(site.ask("DELETE /")), "HTTP/1.1 405 Method Not Allowed");
  EXPECT_EQ(first_line(site.ask("GET /live")), "HTTP/1.1 404 Not Found") << "which is no page";
  EXPECT_EQ(site.ask("POST /", "Content-Length: 1000000000\r\n"), "") << "a body";
  EXPECT_EQ(site.ask("GET /" + std::string(20'000, 'x')), "");
  EXPECT_EQ(site.ask("GET /", "X: " + std::string(20'000, 'x') + "\r\n"), "");
  EXPECT_EQ(site.ask("nonsense"), "");
  EXPECT_TRUE(soon([&] { return site.host.counts().refused == 8; })) << site.host.counts().refused;
  EXPECT_EQ(site.host.counts().pages, 0u);
}

TEST(WebHost, IsForNoOtherSite) {
  Site site;
  const std::string port = fmt::format(":{}", site.port());
  // a name of somebody else that leads here
  EXPECT_EQ(first_line(site.ask("GET /", "", "evil.example" + port)),
            "HTTP/1.1 421 Misdirected Request");
  EXPECT_EQ(first_line(site.ask("GET /", "", "localhost" + port)), "HTTP/1.1 200 OK");
  for (const std::string& origin : {std::string("http://evil.example"), std::string("null"),
                                    "https://" + site.name(), std::string("http://127.0.0.1")}) {
    EXPECT_EQ(first_line(site.ask("GET /", "Origin: " + origin + "\r\n")),
              "HTTP/1.1 403 Forbidden");
    TcpClient client = site.join("Origin: " + origin + "\r\n");
    EXPECT_EQ(first_line(client.read_all()), "HTTP/1.1 403 Forbidden") << origin;
  }
  TcpClient own = site.join("Origin: http://" + site.name() + "\r\n");
  EXPECT_EQ(first_line(own.read_to("\r\n\r\n")), "HTTP/1.1 101 Switching Protocols");
  EXPECT_TRUE(soon([&] { return site.host.counts().viewers == 1; }));
}

TEST(WebHost, AsksForItsToken) {
  Site site({.token = "f00d"});
  EXPECT_EQ(first_line(site.ask("GET /")), "HTTP/1.1 403 Forbidden");
  for (const char* wrong : {"/?token=", "/?token=f00", "/?token=f00dd", "/?token=F00D"})
    EXPECT_EQ(first_line(site.ask(std::string("GET ") + wrong)), "HTTP/1.1 403 Forbidden") << wrong;
  for (const char* wrong : {"eyrie=", "eyrie=f00e", "xeyrie=f00d", "other=f00d"})
    EXPECT_EQ(first_line(site.ask("GET /", std::string("Cookie: ") + wrong + "\r\n")),
              "HTTP/1.1 403 Forbidden")
        << wrong;
  EXPECT_EQ(first_line(site.join().read_all()), "HTTP/1.1 403 Forbidden");
  const std::string answer = site.ask("GET /?token=f00d");
  EXPECT_EQ(first_line(answer), "HTTP/1.1 303 See Other");
  EXPECT_NE(answer.find("Location: /\r\n"), answer.npos) << "the address has it no longer";
  EXPECT_NE(answer.find("Set-Cookie: eyrie=f00d; HttpOnly; SameSite=Strict; Path=/\r\n"),
            answer.npos);
  EXPECT_TRUE(site.ask("GET /", "Cookie: a=b; eyrie=f00d\r\n", "any.name").ends_with("<p>hello"));
  TcpClient viewer = site.join("Cookie: eyrie=f00d\r\n");
  EXPECT_EQ(first_line(viewer.read_to("\r\n\r\n")), "HTTP/1.1 101 Switching Protocols");
}

TEST(WebHost, TellsEverybodyWhoIsLive) {
  Site site;
  std::vector<TcpClient> viewers;
  for (int i = 0; i < 3; ++i) {
    viewers.push_back(site.join());
    const std::string answer = viewers.back().read_to("\r\n\r\n");
    // the example of RFC 6455, section 1.3
    EXPECT_NE(answer.find("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"), answer.npos);
  }
  ASSERT_TRUE(soon([&] { return site.host.counts().viewers == 3; }));
  site.host.send("step 1");
  site.host.send("step 2");
  for (TcpClient& viewer : viewers)  // text, not masked
    EXPECT_EQ(viewer.read_to("step 2"), "\x81\x06step 1\x81\x06step 2");
}

/// A frame as a client sends it, masked with zeros; `size` may be a lie.
std::string frame(char opcode, std::uint64_t size, const std::string& data) {
  std::string bytes{opcode, '\xff'};
  for (int shift = 56; shift >= 0; shift -= 8)
    bytes += static_cast<char>(size >> shift & 0xFF);
  return bytes + std::string(4, '\0') + data;
}

TEST(WebHost, EndsWithWhoeverTalksOrLiesAboutIt) {
  Site site;
  std::uint64_t refused = 0;
  for (const std::string& bad :
       {frame('\x82', 1 << 30, "x"), frame('\x82', ~std::uint64_t{0}, "x"),
        frame('\x81', 5, "hello"), frame('\x8f', 1, "x"), std::string("\x81\x05hello"),
        frame('\x01', 70'000, std::string(70'000, 'x'))}) {
    TcpClient viewer = site.join();
    static_cast<void>(viewer.read_to("\r\n\r\n"));
    viewer.send(bad);
    static_cast<void>(viewer.read_all());
    ++refused;
    EXPECT_TRUE(soon([&] { return site.host.counts().refused == refused; })) << refused;
  }
  EXPECT_TRUE(site.ask("GET /").ends_with("<p>hello"));
}

TEST(WebHost, DropsAViewerWhoIsTooSlow) {
  Site site({.waiting = 1 << 20});
  TcpClient slow = site.join("", 4096);
  static_cast<void>(slow.read_to("\r\n\r\n"));
  TcpClient quick = site.join();
  static_cast<void>(quick.read_to("\r\n\r\n"));
  ASSERT_TRUE(soon([&] { return site.host.counts().viewers == 2; }));
  for (int i = 0; i < 400 && site.host.counts().dropped == 0; ++i) {
    site.host.send(std::string(50'000, 'x') + "\n");
    static_cast<void>(quick.read_to("\n"));
  }
  EXPECT_EQ(site.host.counts().dropped, 1u);
  site.host.send("end");
  EXPECT_NE(quick.read_to("end").find("end"), std::string::npos);
}

TEST(WebHost, OutlivesManyWhoSayNothing) {
  Site site({.connections = 16, .patience = milliseconds(300)});
  TcpClient viewer = site.join();
  static_cast<void>(viewer.read_to("\r\n\r\n"));
  std::vector<TcpClient> many;
  for (int i = 0; i < 500; ++i)
    many.emplace_back(site.port());
  EXPECT_TRUE(site.ask("GET /").ends_with("<p>hello")) << "silence holds no place";
  EXPECT_TRUE(soon([&] { return site.host.counts().refused >= 500; }))
      << site.host.counts().refused;
  ASSERT_TRUE(soon([&] { return site.host.counts().viewers == 1; }));
  site.host.send("still here");
  EXPECT_EQ(viewer.read_to("here"), "\x81\x0astill here");
}

}  // namespace
}  // namespace eyrie::net
