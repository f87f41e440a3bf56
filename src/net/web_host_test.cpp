// SPDX-License-Identifier: MIT
#include "net/web_host.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
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

/// What viewers did, as the thread of the network tells it.
struct Heard {
  std::mutex mutex;
  std::vector<std::string> all;

  [[nodiscard]] Channel channel() {
    return {.joined = [this](ViewerId who) { add(fmt::format("{} joined", who)); },
            .said = [this](ViewerId who, std::string_view text) -> std::string {
              add(fmt::format("{} said {}", who, text));
              return text == "rubbish" ? "that is rubbish" : "";
            },
            .left = [this](ViewerId who) { add(fmt::format("{} left", who)); }};
  }
  void add(std::string what) {
    const std::lock_guard lock(mutex);
    all.push_back(std::move(what));
  }
  [[nodiscard]] std::vector<std::string> so_far() {
    const std::lock_guard lock(mutex);
    return all;
  }
  [[nodiscard]] bool comes_to(const std::vector<std::string>& expected) {
    return soon([&] { return so_far() == expected; });
  }
};

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
  EXPECT_EQ(site.host.counts().refused, 4u);
  EXPECT_EQ(site.host.counts().pages, 0u);
}

TEST(WebHost, SaysWhatIsWrongWithARequest) {
  Site site;
  std::uint64_t refused = 0;
  const auto said = [&](const std::string& bytes, bool ends = false) {
    TcpClient client(site.port());
    client.send(bytes);
    if (ends)
      client.end();
    ++refused;
    return first_line(client.read_all());
  };
  const std::string tls("\x16\x03\x01\x02\x00\x01\x00\x01", 8), x(100'000, 'x');
  for (const std::string& bad :
       {tls, site.request("nonsense"), std::string("\r\n\r\n\r\n"), site.request("GET  /"),
        site.request("GET /", "a b: c\r\n"), std::string("GET / HTTP/9.9\r\n\r\n"),
        site.request("GET /", "Content-Length: -1\r\n"),
        site.request("GET /", "Content-Length: 1\r\nContent-Length: 2\r\n")})
    EXPECT_EQ(said(bad), "HTTP/1.1 400 Bad Request") << bad;
  for (const std::string more :
       {"Content-Length: 1", "Content-Length: 1000000000", "Transfer-Encoding: chunked",
        "Expect: 100-continue\r\nContent-Length: 9"})
    EXPECT_EQ(said(site.request("POST /", more + "\r\n")), "HTTP/1.1 413 Payload Too Large");
  EXPECT_EQ(said(site.request("GET /", "Content-Length: 100000\r\n") + x),
            "HTTP/1.1 413 Payload Too Large");
  for (const std::string& longer : {site.request("GET /" + x), site.request("GET /", "X: " + x)})
    EXPECT_EQ(said(longer), "HTTP/1.1 431 Request Header Fields Too Large");
  EXPECT_EQ(said("GET / HTTP/1.1\r\nHost:", true), "HTTP/1.1 400 Bad Request") << "and no more";
  EXPECT_EQ(said("", true), "");
  EXPECT_TRUE(soon([&] { return site.host.counts().refused == refused; }));
}

TEST(WebHost, EndsWithWhoeverNeverFinishes) {
  Site site({.connections = 1, .patience = milliseconds(200)});
  std::vector<TcpClient> many;
  for (const char* bytes : {"", "G", "GET / HTTP/1.1\r\nHost: x\r\n"})
    many.emplace_back(site.port()).send(bytes);
  for (TcpClient& one : many)
    EXPECT_EQ(one.read_all(), "");
  // who was answered, and goes on sending what he announced, holds no place
  TcpClient talks(site.port());
  talks.send(site.request("POST /", "Content-Length: 1000000000\r\n"));
  EXPECT_EQ(first_line(talks.read_to("\r\n")), "HTTP/1.1 413 Payload Too Large");
  EXPECT_EQ(first_line(site.ask("GET /")), "HTTP/1.1 200 OK");
  EXPECT_TRUE(soon([&] { return talks.send(std::string(1000, 'x')) < 1000; }));
}

TEST(WebHost, SaysWhenItIsFull) {
  Heard heard;
  Site site({.connections = 3, .channel = heard.channel()});
  std::vector<TcpClient> viewers;
  for (int i = 0; i < 3; ++i)
    static_cast<void>(viewers.emplace_back(site.join()).read_to("\r\n\r\n"));
  EXPECT_EQ(first_line(site.join().read_all()), "HTTP/1.1 503 Service Unavailable");
  EXPECT_EQ(first_line(site.ask("GET /")), "HTTP/1.1 503 Service Unavailable");
  viewers.pop_back();
  ASSERT_TRUE(soon([&] { return heard.so_far().back() == "3 left"; }));
  EXPECT_EQ(first_line(site.ask("GET /")), "HTTP/1.1 200 OK");
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
  // a picture or a link there, which sends no origin
  for (const char* from : {"cross-site", "same-site"})
    EXPECT_EQ(first_line(site.ask("GET /long", fmt::format("Sec-Fetch-Site: {}\r\n", from))),
              "HTTP/1.1 403 Forbidden");
  EXPECT_EQ(first_line(site.ask("GET /", "Sec-Fetch-Site: cross-site\r\n")), "HTTP/1.1 200 OK");
  EXPECT_EQ(first_line(site.ask("GET /long", "Sec-Fetch-Site: same-origin\r\n")),
            "HTTP/1.1 200 OK");
  TcpClient own = site.join("Origin: http://" + site.name() + "\r\n");
  EXPECT_EQ(first_line(own.read_to("\r\n\r\n")), "HTTP/1.1 101 Switching Protocols");
  EXPECT_TRUE(soon([&] { return site.host.counts().viewers == 1; }));
}

TEST(WebHost, AsksForItsToken) {
  Site site({.token = "f00d"});
  EXPECT_EQ(first_line(site.ask("GET /")), "HTTP/1.1 403 Forbidden");
  for (const char* wrong : {"/?token=", "/?token=f00", "/?token=f00dd", "/?token=F00D"})
    EXPECT_EQ(first_line(site.ask(std::string("GET ") + wrong)), "HTTP/1.1 403 Forbidden") << wrong;
  const std::string cookie = fmt::format("eyrie_{}=", site.port());
  for (const std::string& wrong :
       {cookie, cookie + "f00e", "x" + cookie + "f00d", std::string("eyrie=f00d"),
        fmt::format("eyrie_{}=f00d", site.port() + 1), std::string("other=f00d")})
    EXPECT_EQ(first_line(site.ask("GET /", "Cookie: " + wrong + "\r\n")), "HTTP/1.1 403 Forbidden")
        << wrong;
  EXPECT_EQ(first_line(site.join().read_all()), "HTTP/1.1 403 Forbidden");
  const std::string known = "Cookie: a=b; " + cookie + "f00d\r\n";
  for (const std::string& more :
       {std::string(), known, std::string("Sec-Fetch-Site: cross-site\r\n")}) {
    const std::string answer = site.ask("GET /?token=f00d", more);
    EXPECT_EQ(first_line(answer), "HTTP/1.1 303 See Other") << more;
    EXPECT_NE(answer.find("Location: /\r\n"), answer.npos) << "the address has it no longer";
    const std::string set = "Set-Cookie: " + cookie + "f00d; HttpOnly; SameSite=Lax; Path=/\r\n";
    EXPECT_NE(answer.find(set), answer.npos) << answer;
  }
  EXPECT_TRUE(site.ask("GET /", known, "any.name").ends_with("<p>hello"));
  EXPECT_TRUE(site.ask("GET /?token=old", known).ends_with("<p>hello"));
  TcpClient viewer = site.join(known);
  EXPECT_EQ(first_line(viewer.read_to("\r\n\r\n")), "HTTP/1.1 101 Switching Protocols");
}

TEST(WebHost, LeavesTheCookieOfAnotherPortAlone) {
  Site one({.token = "f00d"}), other({.token = "beef"});
  const std::string both =
      fmt::format("Cookie: eyrie_{}=f00d; eyrie_{}=beef\r\n", one.port(), other.port());
  EXPECT_TRUE(one.ask("GET /", both).ends_with("<p>hello"));
  EXPECT_TRUE(other.ask("GET /", both).ends_with("<p>hello"));
}

TEST(WebHost, MakesPagesThatAreAskedFor) {
  Site site({.made = [](std::string_view target) -> std::optional<WebPage> {
    if (!target.starts_with("/made"))
      return {};
    return WebPage{"text/plain", "of " + std::string(target)};
  }});
  EXPECT_TRUE(site.ask("GET /").ends_with("<p>hello"));
  EXPECT_TRUE(site.ask("GET /made?x=1").ends_with("\r\n\r\nof /made?x=1"));
  EXPECT_EQ(first_line(site.ask("GET /else")), "HTTP/1.1 404 Not Found");
  EXPECT_EQ(site.host.counts().pages, 2u);
}

/// A text as a client sends it, masked with zeros.
std::string text_frame(const std::string& text) {
  return "\x81" + std::string(1, static_cast<char>(0x80 | text.size())) + std::string(4, '\0') +
         text;
}

TEST(WebHost, TellsEverybodyWhoWasGreeted) {
  Heard heard;
  Site site({.channel = heard.channel()});
  std::vector<TcpClient> viewers;
  for (int i = 0; i < 3; ++i) {
    viewers.push_back(site.join());
    const std::string answer = viewers.back().read_to("\r\n\r\n");
    // the example of RFC 6455, section 1.3
    EXPECT_NE(answer.find("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo=\r\n"), answer.npos);
    ASSERT_TRUE(soon([&] { return site.host.counts().viewers == viewers.size(); }));
  }
  EXPECT_TRUE(heard.comes_to({"1 joined", "2 joined", "3 joined"}));
  site.host.send("step 1");
  site.host.greet(3, std::make_shared<std::string>("so far"));
  site.host.greet(1, std::make_shared<std::string>("so far"));
  site.host.send("step 2");
  site.host.send(1, "no");
  site.host.send(2, "no");
  site.host.send(4, "no");
  // binary, then text, none masked
  EXPECT_EQ(viewers[0].read_to("no"), "\x82\x06so far\x81\x06step 2\x81\x02no");
  EXPECT_EQ(viewers[1].read_to("no"), "\x81\x02no");
  EXPECT_EQ(viewers[2].read_to("step 2"), "\x82\x06so far\x81\x06step 2");
  EXPECT_TRUE(soon([&] { return site.host.counts().bytes == 12 + 12 + 4; }));
}

TEST(WebHost, HearsViewers) {
  Heard heard;
  Site site({.channel = heard.channel()});
  {
    TcpClient viewer = site.join();
    static_cast<void>(viewer.read_to("\r\n\r\n"));
    viewer.send(text_frame("more"));
    viewer.send(text_frame("most"));
    EXPECT_TRUE(heard.comes_to({"1 joined", "1 said more", "1 said most"}));
  }
  EXPECT_TRUE(heard.comes_to({"1 joined", "1 said more", "1 said most", "1 left"}));
  EXPECT_EQ(site.host.counts().refused, 0u);
}

TEST(WebHost, ShowsOutWhoTalksRubbishOrTooMuchAndSaysWhy) {
  Heard heard;
  Site site({.channel = heard.channel(), .messages = 5});
  const auto ended_by = [&](const std::string& bytes) {
    TcpClient viewer = site.join();
    static_cast<void>(viewer.read_to("\r\n\r\n"));
    viewer.send(bytes);
    const std::string said = viewer.read_to(".");
    return said.size() < 4 ? said : said.substr(4);
  };
  // 1008, policy violation
  EXPECT_EQ(ended_by(text_frame("rubbish") + std::string("\x88\x80\0\0\0\0", 6)),
            "that is rubbish");
  std::string many;
  for (int i = 0; i < 50; ++i)
    many += text_frame("x");
  EXPECT_EQ(ended_by(many + std::string("\x88\x80\0\0\0\0", 6)), "too many messages in a second");
  std::string binary = text_frame("x");
  binary[0] = '\x82';
  EXPECT_EQ(ended_by(binary + std::string("\x88\x80\0\0\0\0", 6)), "say it in text");
  EXPECT_EQ(site.host.counts().refused, 3u);
  EXPECT_TRUE(soon([&] { return heard.so_far().back() == "3 left"; }));
  const auto all = heard.so_far();
  EXPECT_EQ(std::count(all.begin(), all.end(), "2 said x"), 5);
}

TEST(WebHost, DoesNotWaitForSomebodyWhoIsShownOut) {
  Heard heard;
  Site site({.channel = heard.channel(), .patience = milliseconds(200)});
  TcpClient viewer = site.join();
  static_cast<void>(viewer.read_to("\r\n\r\n"));
  viewer.send(text_frame("rubbish"));
  EXPECT_TRUE(heard.comes_to({"1 joined", "1 said rubbish", "1 left"}));
  EXPECT_TRUE(site.ask("GET /").ends_with("<p>hello"));
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
        frame('\x01', 5'000, std::string(5'000, 'x'))}) {
    TcpClient viewer = site.join();
    static_cast<void>(viewer.read_to("\r\n\r\n"));
    viewer.send(bad);
    static_cast<void>(viewer.read_all());
    ++refused;
    EXPECT_TRUE(soon([&] { return site.host.counts().refused == refused; })) << refused;
  }
  EXPECT_TRUE(site.ask("GET /").ends_with("<p>hello"));
}

TEST(WebHost, GreetsWithMoreThanMayWait) {
  Site site({.waiting = 1 << 20});
  TcpClient viewer = site.join();
  static_cast<void>(viewer.read_to("\r\n\r\n"));
  ASSERT_TRUE(soon([&] { return site.host.counts().viewers == 1; }));
  site.host.greet(1, std::make_shared<std::string>(std::string(8 << 20, 'x') + "here"));
  site.host.send("and more");
  EXPECT_NE(viewer.read_to("and more").find("xhere"), std::string::npos);
  EXPECT_EQ(site.host.counts().dropped, 0u);
}

TEST(WebHost, DropsAViewerWhoIsTooSlow) {
  Site site({.waiting = 1 << 20});
  TcpClient slow = site.join("", 4096);
  static_cast<void>(slow.read_to("\r\n\r\n"));
  TcpClient quick = site.join();
  static_cast<void>(quick.read_to("\r\n\r\n"));
  ASSERT_TRUE(soon([&] { return site.host.counts().viewers == 2; }));
  for (const ViewerId who : {1, 2})
    site.host.greet(who, std::make_shared<std::string>("hello"));
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
  site.host.send(1, "still here");
  EXPECT_EQ(viewer.read_to("here"), "\x81\x0astill here");
}

}  // namespace
}  // namespace eyrie::net
