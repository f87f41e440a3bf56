// SPDX-License-Identifier: MIT
#include "net/telemetry_host.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "core/text.hpp"
#include "net/listener.hpp"

namespace eyrie::net {
namespace {

constexpr std::string_view kProtocols = "XtraLib.Stream.0\nTacview.RealTimeTelemetry.0\n";

std::string utf16le(std::string_view text) {
  std::string out;
  const auto put = [&](std::uint32_t unit) {
    out += static_cast<char>(unit & 0xFF);
    out += static_cast<char>(unit >> 8);
  };
  while (!text.empty()) {
    const Utf8 next = first_character(text);
    const std::uint32_t point = next.length ? static_cast<std::uint32_t>(next.point) : 0xFFFD;
    if (point < 0x10000) {
      put(point);
    } else {
      put(0xD800 + ((point - 0x10000) >> 10));
      put(0xDC00 + ((point - 0x10000) & 0x3FF));
    }
    text.remove_prefix(std::max<std::size_t>(next.length, 1));
  }
  return out;
}

/// Bytes that a client may send after its greeting: Tacview sends none.
constexpr std::size_t kMostHeard = 1 << 16;

struct Session : Guest {
  enum class State { greeting, waiting, joined };

  explicit Session(tcp::socket connected)
      : socket(std::move(connected)), timer(socket.get_executor()) {}
  [[nodiscard]] bool silent() const { return state == State::greeting; }
  template <class Handler>
  void write(const Text& text, Handler handler) {
    asio::async_write(socket, asio::buffer(*text), std::move(handler));
  }
  void close() {
    timer.cancel();
    error_code ignored;
    if (!out.empty())
      socket.set_option(asio::socket_base::linger(true, 0), ignored);
    socket.close(ignored);
  }

  tcp::socket socket;
  asio::steady_timer timer;
  State state = State::greeting;
  std::array<char, 512> in{};
  std::string greeting;
  std::size_t heard = 0;
};
using SessionPtr = std::shared_ptr<Session>;

}  // namespace

// All of it but the constructor, `waiting` and the counters belongs to the listener's thread.
struct TelemetryHost::Network {
  explicit Network(TelemetryOptions asked) : options(std::move(asked)), listener(options.at) {
    guests.on_end = [this](const Session& session) {
      waiting -= session.state == Session::State::waiting;
      if (closing && guests.empty())
        listener.stop();
    };
    guests.on_drained = [this](const SessionPtr& session) {
      if (closing)
        guests.end(session);
    };
    listener.run([this](tcp::socket socket) { welcome(std::move(socket)); });
  }

  void welcome(tcp::socket socket) {
    const auto session = std::make_shared<Session>(std::move(socket));
    if (!guests.admit(session))
      return;
    error_code ignored;
    session->socket.set_option(tcp::no_delay(true), ignored);
    session->socket.set_option(asio::socket_base::keep_alive(true), ignored);
    session->timer.expires_after(options.greeting);
    session->timer.async_wait([this, session](error_code cancelled) {
      if (!cancelled && session->silent())
        guests.refuse(session);
    });
    guests.send(session, std::make_shared<const std::string>(host_greeting(options.name)));
    listen(session);
  }

  void listen(const SessionPtr& session) {
    session->socket.async_read_some(
        asio::buffer(session->in), [this, session](error_code failed, std::size_t size) {
          if (session->gone)
            return;
          if (failed)
            return session->silent() ? guests.refuse(session) : guests.end(session);
          if (!hear(*session, {session->in.data(), size}))
            return guests.refuse(session);
          listen(session);
        });
  }

  /// False if he does not talk as he should.
  bool hear(Session& session, std::string_view bytes) {
    if (!session.silent())
      return (session.heard += bytes.size()) <= kMostHeard;
    session.greeting += bytes;
    const std::size_t zero = session.greeting.find('\0');
    if (zero == std::string::npos)
      return session.greeting.size() < kLongestGreeting;
    const auto said = client_greeting(std::string_view(session.greeting).substr(0, zero));
    if (!said || !is_hash_of(said->hash, options.password))
      return false;
    session.timer.cancel();
    session.state = Session::State::waiting;
    ++joined;
    ++waiting;
    return true;
  }

  void hand_out(const Text& text, const Text& whole) {
    for (const SessionPtr& session : guests.all()) {
      if (session->state == Session::State::joined) {
        guests.send(session, text);
      } else if (session->state == Session::State::waiting && !whole->empty()) {
        session->state = Session::State::joined;
        --waiting;
        guests.send(session, whole);
      }
    }
  }

  void begin_to_close(std::chrono::milliseconds wait) {
    closing = true;
    listener.close(wait);
    for (const SessionPtr& session : guests.all())
      if (session->state != Session::State::joined || session->out.empty())
        guests.end(session);
    if (guests.empty())
      listener.stop();
  }

  TelemetryOptions options;
  Listener listener;
  Guests<Session> guests{options.connections, options.waiting};
  bool closing = false;
  std::atomic<std::uint32_t> waiting = 0;  ///< clients that have got nothing yet
  std::atomic<std::uint64_t> joined = 0;
};

TelemetryHost::TelemetryHost(TelemetryOptions options)
    : network_(std::make_unique<Network>(std::move(options))) {}

TelemetryHost::~TelemetryHost() {
  close({});
}

const Endpoint& TelemetryHost::at() const {
  return network_->options.at;
}

bool TelemetryHost::wanted() const {
  return network_->waiting > 0;
}

void TelemetryHost::send(std::string_view text, std::string whole) {
  asio::post(network_->listener.io,
             [network = network_.get(), text = std::make_shared<std::string>(text),
              whole = std::make_shared<std::string>(std::move(whole))] {
               network->hand_out(text, whole);
             });
}

void TelemetryHost::close(std::chrono::milliseconds wait) {
  if (!network_->listener.running())
    return;
  asio::post(network_->listener.io,
             [network = network_.get(), wait] { network->begin_to_close(wait); });
  network_->listener.join();
}

TelemetryHost::Counts TelemetryHost::counts() const {
  return {.joined = network_->joined,
          .refused = network_->guests.refused,
          .dropped = network_->guests.dropped,
          .bytes = network_->guests.sent};
}

std::uint64_t crc64_we(std::string_view bytes) {
  std::uint64_t crc = ~std::uint64_t{0};
  for (const char byte : bytes) {
    crc ^= std::uint64_t{static_cast<unsigned char>(byte)} << 56;
    for (int bit = 0; bit < 8; ++bit)
      crc = crc >> 63 ? (crc << 1) ^ 0x42F0E1EBA9EA3693 : crc << 1;
  }
  return ~crc;
}

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = ~std::uint32_t{0};
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = crc & 1 ? (crc >> 1) ^ 0xEDB88320 : crc >> 1;
  }
  return ~crc;
}

std::string host_greeting(std::string_view name) {
  return fmt::format("{}{}\n{}", kProtocols, name, '\0');
}

std::optional<ClientGreeting> client_greeting(std::string_view text) {
  if (!text.starts_with(kProtocols))
    return {};
  text.remove_prefix(kProtocols.size());
  const std::size_t end = text.find('\n');
  if (end == text.npos)
    return {};
  std::string_view hash = text.substr(end + 1);
  if (hash.ends_with('\n'))
    hash.remove_suffix(1);
  if (hash.find('\n') != hash.npos)
    return {};
  return ClientGreeting{std::string(text.substr(0, end)), std::string(hash)};
}

std::string password_hash(std::string_view password) {
  return password.empty() ? "0" : fmt::format("{:x}", crc64_we(utf16le(password)));
}

bool is_hash_of(std::string_view hash, std::string_view password) {
  return password.empty() || hash == password_hash(password) ||
         hash == fmt::format("{:x}", crc32(utf16le(password)));
}

}  // namespace eyrie::net
