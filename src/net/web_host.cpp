// SPDX-License-Identifier: MIT
#include "net/web_host.hpp"

#include <algorithm>
#include <atomic>
#include <utility>
// boost 1.74 takes std::exchange without its header
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <optional>
#include <vector>

#include "net/listener.hpp"

namespace eyrie::net {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;

constexpr std::uint32_t kLongestHead = 8 << 10;
constexpr std::string_view kCookie = "eyrie=";

std::string_view view(beast::string_view text) {
  return {text.data(), text.size()};
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

struct Visitor {
  enum class State { asking, answered, live, ended };
  using Request = http::request_parser<http::empty_body>;
  using Response = http::response<http::span_body<const char>>;

  Visitor(tcp::socket connected, std::chrono::milliseconds patience)
      : stream(std::move(connected)) {
    stream.expires_after(patience);
    request.header_limit(kLongestHead);
  }
  void close() {
    Stream& lowest = socket ? socket->next_layer() : stream;
    error_code ignored;
    if (!out.empty())
      lowest.socket().set_option(asio::socket_base::linger(true, 0), ignored);
    lowest.close();
  }

  State state = State::asking;
  Stream stream;
  std::optional<websocket::stream<Stream>> socket;  ///< instead, once it is live
  beast::flat_buffer in{kLongestHead};
  Request request;
  Response response;
  std::string said;  ///< the body of a response that is no page
  std::deque<Text> out;
  std::size_t pending = 0;  ///< bytes of `out`
};
using VisitorPtr = std::shared_ptr<Visitor>;

}  // namespace

// All of it but the constructor and the counters belongs to the listener's thread.
struct WebHost::Network {
  explicit Network(WebOptions asked) : options(std::move(asked)), listener(options.at) {
    listener.run([this](tcp::socket socket) { welcome(std::move(socket)); });
  }

  void welcome(tcp::socket socket) {
    if (visitors.size() >= options.connections) {
      const auto silent = std::find_if(visitors.begin(), visitors.end(), [](const VisitorPtr& s) {
        return s->state == Visitor::State::asking;
      });
      if (silent == visitors.end()) {
        ++refused;
        return;
      }
      refuse(VisitorPtr(*silent));
    }
    const auto visitor = std::make_shared<Visitor>(std::move(socket), options.patience);
    visitors.push_back(visitor);
    http::async_read(visitor->stream, visitor->in, visitor->request,
                     [this, visitor](error_code failed, std::size_t) {
                       if (visitor->state == Visitor::State::ended)
                         return;
                       if (failed)
                         return refuse(visitor);
                       answer(visitor);
                     });
  }

  void answer(const VisitorPtr& visitor) {
    const auto& request = visitor->request.get();
    const std::string_view target = view(request.target());
    const std::string_view path = target.substr(0, target.find('?'));
    const std::string_view host = view(request[http::field::host]);
    if (!is_own_name(host))
      return say(visitor, http::status::misdirected_request, "ask by another name");
    if (!options.token.empty() && !knows_token(view(request[http::field::cookie]))) {
      const std::size_t asked = target.find("?token=");
      if (asked == target.npos || !same_secret(target.substr(asked + 7), options.token))
        return say(visitor, http::status::forbidden, "ask with the address that eyrie printed");
      visitor->response.set(http::field::set_cookie, std::string(kCookie) + options.token +
                                                         "; HttpOnly; SameSite=Strict; Path=/");
      visitor->response.set(http::field::location, "/");
      return say(visitor, http::status::see_other, "");
    }
    const std::string_view origin = view(request[http::field::origin]);
    if (!origin.empty() && origin != "http://" + std::string(host))
      return say(visitor, http::status::forbidden, "this is for no other site");
    if (path == "/live" && websocket::is_upgrade(request))
      return join(visitor);
    if (request.method() != http::verb::get && request.method() != http::verb::head)
      return say(visitor, http::status::method_not_allowed, "only GET and HEAD");
    const auto page = options.pages.find(path);
    if (page == options.pages.end())
      return say(visitor, http::status::not_found, "there is no such page");
    ++pages;
    send_page(visitor, http::status::ok, page->second.type, page->second.body);
  }

  /// A page of another site may give its own name this machine's address: it asks by that name.
  [[nodiscard]] bool is_own_name(std::string_view host) const {
    if (!options.token.empty())
      return true;
    const std::string port = ":" + std::to_string(options.at.port);
    return host == options.at.text() || host == "localhost" + port || host == "127.0.0.1" + port ||
           host == "[::1]" + port;
  }

  [[nodiscard]] bool knows_token(std::string_view cookies) const {
    while (!cookies.empty()) {
      const std::string_view one = cookies.substr(0, cookies.find(';'));
      cookies.remove_prefix(std::min(cookies.size(), one.size() + 1));
      if (cookies.starts_with(' '))
        cookies.remove_prefix(1);
      if (one.starts_with(kCookie) && same_secret(one.substr(kCookie.size()), options.token))
        return true;
    }
    return false;
  }

  void say(const VisitorPtr& visitor, http::status status, std::string_view words) {
    refused += status != http::status::see_other;
    visitor->said = words;
    send_page(visitor, status, "text/plain; charset=utf-8", visitor->said);
  }

  void send_page(const VisitorPtr& visitor, http::status status, const std::string& type,
                 const std::string& body) {
    visitor->state = Visitor::State::answered;
    Visitor::Response& response = visitor->response;
    response.result(status);
    response.version(11);
    response.keep_alive(false);
    response.set(http::field::content_type, type);
    response.set(http::field::cache_control, "no-store");
    response.set("Referrer-Policy", "no-referrer");
    response.set("Content-Security-Policy", "frame-ancestors 'none'");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("Cross-Origin-Resource-Policy", "same-origin");
    response.content_length(body.size());
    if (visitor->request.get().method() != http::verb::head)
      response.body() = {body.data(), body.size()};
    visitor->stream.expires_after(6 * options.patience);
    http::async_write(visitor->stream, response, [this, visitor](error_code, std::size_t) {
      if (visitor->state == Visitor::State::ended)
        return;
      error_code ignored;
      visitor->stream.socket().shutdown(tcp::socket::shutdown_send, ignored);
      end(visitor);
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
    socket.text(true);
    socket.async_accept(visitor->request.get(), [this, visitor](error_code failed) {
      if (visitor->state == Visitor::State::ended)
        return;
      if (failed)
        return refuse(visitor);
      visitor->state = Visitor::State::live;
      ++viewers;
      listen(visitor);
    });
  }

  /// Nobody has anything to say so far: a message ends it, as a frame that is too long does.
  void listen(const VisitorPtr& visitor) {
    visitor->in.clear();
    visitor->socket->async_read(visitor->in, [this, visitor](error_code failed, std::size_t) {
      if (visitor->state == Visitor::State::ended)
        return;
      const bool left = failed == websocket::error::closed || failed == asio::error::eof ||
                        failed == asio::error::connection_reset;
      left ? end(visitor) : refuse(visitor);
    });
  }

  void hand_out(const Text& message) {
    for (const VisitorPtr& visitor : std::vector(visitors)) {
      if (visitor->state != Visitor::State::live)
        continue;
      visitor->pending += message->size();
      if (visitor->pending > options.waiting) {
        ++dropped;
        end(visitor);
        continue;
      }
      visitor->out.push_back(message);
      if (visitor->out.size() == 1)
        write(visitor);
    }
  }

  void write(const VisitorPtr& visitor) {
    visitor->socket->async_write(asio::buffer(*visitor->out.front()),
                                 [this, visitor](error_code failed, std::size_t) {
                                   if (visitor->state == Visitor::State::ended)
                                     return;
                                   if (failed)
                                     return end(visitor);
                                   visitor->pending -= visitor->out.front()->size();
                                   visitor->out.pop_front();
                                   if (!visitor->out.empty())
                                     write(visitor);
                                 });
  }

  void refuse(const VisitorPtr& visitor) {
    ++refused;
    end(visitor);
  }

  void end(const VisitorPtr& visitor) {
    visitor->state = Visitor::State::ended;
    visitor->close();
    visitors.erase(std::find(visitors.begin(), visitors.end(), visitor));
  }

  WebOptions options;
  Listener listener;
  std::vector<VisitorPtr> visitors;  ///< in the order in which they came
  std::atomic<std::uint64_t> pages = 0, viewers = 0, refused = 0, dropped = 0;
};

WebHost::WebHost(WebOptions options) : network_(std::make_unique<Network>(std::move(options))) {}

WebHost::~WebHost() {
  asio::post(network_->listener.io, [network = network_.get()] { network->listener.stop(); });
  network_->listener.join();
}

const Endpoint& WebHost::at() const {
  return network_->options.at;
}

void WebHost::send(std::string message) {
  asio::post(network_->listener.io,
             [network = network_.get(), text = std::make_shared<std::string>(std::move(message))] {
               network->hand_out(text);
             });
}

WebHost::Counts WebHost::counts() const {
  return {.pages = network_->pages,
          .viewers = network_->viewers,
          .refused = network_->refused,
          .dropped = network_->dropped};
}

}  // namespace eyrie::net
