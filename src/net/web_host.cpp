// SPDX-License-Identifier: MIT
#include "net/web_host.hpp"

#include <algorithm>
#include <utility>
// boost 1.74 takes std::exchange without its header
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "net/listener.hpp"

namespace eyrie::net {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

constexpr std::uint32_t kLongestHead = 8 << 10;
/// Places beside those for `connections`, for who asks meanwhile and is told that it is full.
constexpr std::size_t kAnteroom = 8;
/// For who goes on talking when he is answered: closing at once would take the answer from him.
constexpr std::chrono::seconds kLastWords{1};

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
}

/// What somebody is told whose request could not be read; nothing if he has gone, or never asked.
std::optional<http::status> status_of(error_code failed) {
  if (failed == http::error::header_limit || failed == http::error::buffer_overflow)
    return http::status::request_header_fields_too_large;
  if (failed == http::error::body_limit)
    return http::status::payload_too_large;
  const bool bad = failed.category() == http::make_error_code(http::error::bad_value).category() &&
                   failed != http::error::end_of_stream;
  return bad ? std::optional(http::status::bad_request) : std::nullopt;
}

/// Whether both are the same; how long that takes does not tell where they differ.
bool same_secret(std::string_view a, std::string_view b) {
  if (a.size() != b.size())
    return false;
  unsigned differ = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    differ |= static_cast<unsigned char>(a[i] ^ b[i]);
  return differ == 0;
}

/// Ends at once when a viewer breaks the protocol: Beast's own would read on until he ends it.
struct Stream : beast::tcp_stream {
  using beast::tcp_stream::tcp_stream;
};
template <class Handler>
void async_teardown(beast::role_type, Stream& stream, Handler&& handler) {
  stream.close();
  asio::post(stream.get_executor(),
             beast::bind_front_handler(std::forward<Handler>(handler), error_code()));
}

struct Visitor : Guest {
  enum class State { asking, answered, heard_out, live, leaving };
  using Clock = std::chrono::steady_clock;
  using Request = http::request_parser<http::empty_body>;
  using Response = http::response<http::span_body<const char>>;

  Visitor(tcp::socket connected, std::chrono::milliseconds patience)
      : stream(std::move(connected)) {
    stream.expires_after(patience);
    request.header_limit(kLongestHead);
  }
  [[nodiscard]] bool silent() const { return state == State::asking || state == State::heard_out; }
  template <class Handler>
  void write(const Text& text, Handler handler) {
    socket->binary(text == greeting);
    socket->async_write(asio::buffer(*text), std::move(handler));
  }
  void close() {
    Stream& lowest = socket ? socket->next_layer() : stream;
    error_code ignored;
    if (!out.empty())
      lowest.socket().set_option(asio::socket_base::linger(true, 0), ignored);
    lowest.close();
  }
  /// Whether he may say one more thing now, of so many in a second.
  [[nodiscard]] bool may_talk(double most) {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> since = now - talked;
    talked = now;
    allowance = std::min(most, allowance + most * since.count()) - 1;
    return allowance >= 0;
  }

  State state = State::asking;
  Clock::time_point came = Clock::now();
  ViewerId id = 0;  ///< once he is live
  Stream stream;
  std::optional<websocket::stream<Stream>> socket;  ///< instead, once it is live
  beast::flat_buffer in{kLongestHead};
  Request request;
  Response response;
  std::shared_ptr<const WebPage> page;
  Text greeting;
  double allowance = 0;  ///< messages
  Clock::time_point talked{};
};
using VisitorPtr = std::shared_ptr<Visitor>;

}  // namespace

// All of it but the constructor and the counters belongs to the listener's thread.
struct WebHost::Network {
  explicit Network(WebOptions asked) : options(std::move(asked)), listener(options.at) {
    guests.on_end = [this](const Visitor& visitor) {
      if (visitor.id && options.channel.left)
        options.channel.left(visitor.id);
    };
    listener.run([this](tcp::socket socket) { welcome(std::move(socket)); });
  }

  void welcome(tcp::socket socket) {
    const auto visitor = std::make_shared<Visitor>(std::move(socket), options.patience);
    if (!guests.admit(visitor))
      return;
    http::async_read_header(visitor->stream, visitor->in, visitor->request,
                            [this, visitor](error_code failed, std::size_t) {
                              if (visitor->gone)
                                return;
                              if (const auto status = status_of(failed))
                                return say(visitor, *status, view(http::obsolete_reason(*status)));
                              if (failed)
                                return guests.refuse(visitor);
                              answer(visitor);
                            });
  }

  void answer(const VisitorPtr& visitor) {
    const auto all = guests.all();
    if (std::ranges::count_if(all, [](const auto& one) { return !one->silent(); }) >=
        static_cast<std::ptrdiff_t>(options.connections)) {
      // who takes his page slowly, or not at all, gives his place to who comes
      const auto slow = std::ranges::find_if(all, [&](const auto& one) {
        return one->state == Visitor::State::answered &&
               Visitor::Clock::now() - one->came > options.patience;
      });
      if (slow == all.end())
        return say(visitor, http::status::service_unavailable,
                   "too many look on; come again later");
      guests.refuse(*slow);
    }
    if (!visitor->request.is_done())
      return say(visitor, http::status::payload_too_large, "a request has no body here");
    const auto& request = visitor->request.get();
    const std::string_view target = view(request.target());
    const std::string_view path = target.substr(0, target.find('?'));
    const std::string_view host = view(request[http::field::host]);
    if (!is_own_name(host))
      return say(visitor, http::status::misdirected_request, "ask by another name");
    if (!options.token.empty()) {
      // also of one who has the cookie: the token does not stay in his address bar
      if (has_token(target))
        return let_in(visitor);
      if (!knows_token(view(request[http::field::cookie])))
        return say(visitor, http::status::forbidden, "ask with the address that eyrie printed");
    }
    const std::string_view origin = view(request[http::field::origin]);
    if (!origin.empty() && origin != "http://" + std::string(host))
      return say(visitor, http::status::forbidden, "this is for no other site");
    // a picture or a link of another site sends no origin; newer browsers say this of it
    const std::string_view from = view(request["Sec-Fetch-Site"]);
    if (path != "/" && !from.empty() && from != "same-origin" && from != "none")
      return say(visitor, http::status::forbidden, "this is for no other site");
    if (path == "/live" && websocket::is_upgrade(request))
      return join(visitor);
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return say(visitor, http::status::method_not_allowed, "only GET and HEAD");
    if (const auto page = options.pages.find(path); page != options.pages.end())
      visitor->page = {std::shared_ptr<void>(), &page->second};
    else if (auto made = options.made ? options.made(target) : std::nullopt)
      visitor->page = std::make_shared<WebPage>(std::move(*made));
    if (!visitor->page)
      return say(visitor, http::status::not_found, "there is no such page");
    ++pages;
    send(visitor, http::int_to_status(visitor->page->status));
  }

  /// A page of another site may give its own name this machine's address: it asks by that name.
  [[nodiscard]] bool is_own_name(std::string_view host) const {
    if (!options.token.empty())
      return true;
    if (options.at.port == 80 && (host == options.at.address || host == "localhost" ||
                                  host == "127.0.0.1" || host == "[::1]"))
      return true;
    const std::string port = ":" + std::to_string(options.at.port);
    return host == options.at.text() || host == "localhost" + port || host == "127.0.0.1" + port ||
           host == "[::1]" + port;
  }

  /// Browsers send a cookie to all ports of a machine: a server at another port has its own.
  [[nodiscard]] std::string cookie() const {
    return "eyrie_" + std::to_string(options.at.port) + "=";
  }

  [[nodiscard]] bool has_token(std::string_view target) const {
    const std::size_t asked = target.find("?token=");
    return asked != target.npos && same_secret(target.substr(asked + 7), options.token);
  }

  /// Lax: a browser that followed a link of another site here does not send a strict one on.
  void let_in(const VisitorPtr& visitor) {
    visitor->response.set(http::field::set_cookie,
                          cookie() + options.token + "; HttpOnly; SameSite=Lax; Path=/");
    visitor->response.set(http::field::location, "/");
    say(visitor, http::status::see_other, "");
  }

  [[nodiscard]] bool knows_token(std::string_view cookies) const {
    const std::string name = cookie();
    while (!cookies.empty()) {
      const std::string_view one = cookies.substr(0, cookies.find(';'));
      cookies.remove_prefix(std::min(cookies.size(), one.size() + 1));
      if (cookies.starts_with(' '))
        cookies.remove_prefix(1);
      if (one.starts_with(name) && same_secret(one.substr(name.size()), options.token))
        return true;
    }
    return false;
  }

  void say(const VisitorPtr& visitor, http::status status, std::string_view words) {
    guests.refused += status != http::status::see_other;
    visitor->page =
        std::make_shared<WebPage>(WebPage{"text/plain; charset=utf-8", std::string(words)});
    send(visitor, status);
  }

  /// His page.
  void send(const VisitorPtr& visitor, http::status status) {
    const std::string& body = visitor->page->body;
    visitor->state = Visitor::State::answered;
    Visitor::Response& response = visitor->response;
    response.result(status);
    response.version(11);
    response.keep_alive(false);
    response.set(http::field::content_type, visitor->page->type);
    response.set(http::field::cache_control, "no-store");
    response.set("Referrer-Policy", "no-referrer");
    response.set("Content-Security-Policy", "frame-ancestors 'none'; connect-src 'self'");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Cross-Origin-Resource-Policy", "same-origin");
    response.content_length(body.size());
    if (visitor->request.get().method() != http::verb::head)
      response.body() = {body.data(), body.size()};
    visitor->stream.expires_after(6 * options.patience);
    http::async_write(visitor->stream, response, [this, visitor](error_code, std::size_t) {
      if (visitor->gone)
        return;
      error_code ignored;
      visitor->stream.socket().shutdown(tcp::socket::shutdown_send, ignored);
      visitor->stream.expires_after(kLastWords);
      visitor->request.is_done() ? guests.end(visitor) : hear_out(visitor);
    });
  }

  /// Of who still talks; what he says is thrown away, and he holds no place.
  void hear_out(const VisitorPtr& visitor) {
    visitor->state = Visitor::State::heard_out;
    visitor->in.clear();
    visitor->stream.async_read_some(visitor->in.prepare(kLongestHead),
                                    [this, visitor](error_code failed, std::size_t) {
                                      if (!visitor->gone)
                                        failed ? guests.end(visitor) : hear_out(visitor);
                                    });
  }

  void join(const VisitorPtr& visitor) {
    visitor->state = Visitor::State::answered;
    visitor->stream.expires_never();
    auto& socket = visitor->socket.emplace(std::move(visitor->stream));
    auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
    timeout.handshake_timeout = options.patience;
    socket.set_option(timeout);
    socket.read_message_max(options.message);
    socket.auto_fragment(false);
    socket.async_accept(visitor->request.get(), [this, visitor](error_code failed) {
      if (visitor->gone)
        return;
      if (failed)
        return guests.refuse(visitor);
      visitor->state = Visitor::State::live;
      visitor->id = ++viewers;
      visitor->allowance = options.messages;
      visitor->talked = Visitor::Clock::now();
      if (options.channel.joined)
        options.channel.joined(visitor->id);
      listen(visitor);
    });
  }

  void listen(const VisitorPtr& visitor) {
    visitor->in.clear();
    visitor->socket->async_read(visitor->in, [this, visitor](error_code failed, std::size_t) {
      if (visitor->gone)
        return;
      if (failed) {
        const bool left = failed == websocket::error::closed || failed == asio::error::eof ||
                          failed == asio::error::connection_reset;
        return left ? guests.end(visitor) : guests.refuse(visitor);
      }
      const std::string wrong = hear(*visitor);
      wrong.empty() ? listen(visitor) : show_out(visitor, wrong);
    });
  }

  /// What is wrong with what a viewer said.
  std::string hear(Visitor& visitor) {
    if (!options.channel.said)
      return "there is nothing to say here";
    if (!visitor.socket->got_text())
      return "say it in text";
    if (!visitor.may_talk(options.messages))
      return "too many messages in a second";
    const auto bytes = visitor.in.cdata();
    return options.channel.said(visitor.id, {static_cast<const char*>(bytes.data()), bytes.size()});
  }

  /// Tells him why; he has as long as for a request to take it.
  void show_out(const VisitorPtr& visitor, const std::string& why) {
    ++guests.refused;
    visitor->state = Visitor::State::leaving;
    visitor->socket->async_close({websocket::close_code::policy_error, why},
                                 [this, visitor](error_code) { guests.end(visitor); });
  }

  [[nodiscard]] VisitorPtr viewer(ViewerId who) const {
    for (const VisitorPtr& visitor : guests.all())
      if (visitor->id == who && visitor->state == Visitor::State::live)
        return visitor;
    return {};
  }

  WebOptions options;
  Listener listener;
  Guests<Visitor> guests{options.connections + kAnteroom, options.waiting};
  std::atomic<std::uint64_t> pages = 0, viewers = 0;
};

WebHost::WebHost(WebOptions options) : network_(std::make_unique<Network>(std::move(options))) {}

WebHost::~WebHost() {
  asio::post(network_->listener.io, [network = network_.get()] { network->listener.stop(); });
  network_->listener.join();
}

const Endpoint& WebHost::at() const {
  return network_->options.at;
}

void WebHost::greet(ViewerId who, std::shared_ptr<const std::string> bytes) {
  asio::post(network_->listener.io, [network = network_.get(), who, bytes = std::move(bytes)] {
    const VisitorPtr visitor = network->viewer(who);
    if (!visitor)
      return;
    visitor->greeting = bytes;
    visitor->room = bytes->size();  // that it is long says nothing of how fast he is
    network->guests.send(visitor, bytes);
  });
}

void WebHost::send(std::string message) {
  asio::post(network_->listener.io,
             [network = network_.get(), text = std::make_shared<std::string>(std::move(message))] {
               for (const VisitorPtr& visitor : network->guests.all())
                 if (visitor->greeting && visitor->state == Visitor::State::live)
                   network->guests.send(visitor, text);
             });
}

void WebHost::send(ViewerId who, std::string message) {
  asio::post(network_->listener.io, [network = network_.get(), who,
                                     text = std::make_shared<std::string>(std::move(message))] {
    if (const VisitorPtr visitor = network->viewer(who))
      network->guests.send(visitor, text);
  });
}

WebHost::Counts WebHost::counts() const {
  return {.pages = network_->pages,
          .viewers = network_->viewers,
          .refused = network_->guests.refused,
          .dropped = network_->guests.dropped,
          .bytes = network_->guests.sent};
}

}  // namespace eyrie::net
