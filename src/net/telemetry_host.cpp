// SPDX-License-Identifier: MIT
#include "net/telemetry_host.hpp"

#include <array>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <utility>

#include "net/guests.hpp"
#include "net/telemetry.hpp"

namespace eyrie::net {
namespace {

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

}  // namespace eyrie::net
