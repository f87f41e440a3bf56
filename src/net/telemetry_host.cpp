// SPDX-License-Identifier: MIT
#include "net/telemetry_host.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <deque>
#include <utility>
#include <vector>

#include "net/listener.hpp"
#include "net/telemetry.hpp"

namespace eyrie::net {
namespace {

/// Bytes that a client may send after its greeting: Tacview sends none.
constexpr std::size_t kMostHeard = 1 << 16;

struct Session {
  enum class State { greeting, waiting, joined, ended };

  explicit Session(tcp::socket connected)
      : socket(std::move(connected)), timer(socket.get_executor()) {}

  tcp::socket socket;
  asio::steady_timer timer;
  State state = State::greeting;
  std::array<char, 512> in{};
  std::string greeting;
  std::size_t heard = 0;
  std::deque<Text> out;
  std::size_t pending = 0;  ///< bytes of `out`
};
using SessionPtr = std::shared_ptr<Session>;

}  // namespace

// All of it but the constructor, `waiting` and the counters belongs to the listener's thread.
struct TelemetryHost::Network {
  explicit Network(TelemetryOptions asked) : options(std::move(asked)), listener(options.at) {
    listener.run([this](tcp::socket socket) { welcome(std::move(socket)); });
  }

  void welcome(tcp::socket socket) {
    if (sessions.size() >= options.connections) {
      // rather somebody who has not said who he is
      const auto silent = std::find_if(sessions.begin(), sessions.end(), [](const SessionPtr& s) {
        return s->state == Session::State::greeting;
      });
      if (silent == sessions.end()) {
        ++refused;
        return;
      }
      refuse(SessionPtr(*silent));
    }
    const auto session = std::make_shared<Session>(std::move(socket));
    sessions.push_back(session);
    error_code ignored;
    session->socket.set_option(tcp::no_delay(true), ignored);
    session->socket.set_option(asio::socket_base::keep_alive(true), ignored);
    session->timer.expires_after(options.greeting);
    session->timer.async_wait([this, session](error_code cancelled) {
      if (!cancelled && session->state == Session::State::greeting)
        refuse(session);
    });
    queue(session, std::make_shared<const std::string>(host_greeting(options.name)));
    listen(session);
  }

  void listen(const SessionPtr& session) {
    session->socket.async_read_some(
        asio::buffer(session->in), [this, session](error_code failed, std::size_t size) {
          if (session->state == Session::State::ended)
            return;
          if (failed)
            return session->state == Session::State::greeting ? refuse(session) : end(session);
          if (!hear(*session, {session->in.data(), size}))
            return refuse(session);
          listen(session);
        });
  }

  /// False if he does not talk as he should.
  bool hear(Session& session, std::string_view bytes) {
    if (session.state != Session::State::greeting)
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

  void queue(const SessionPtr& session, const Text& text) {
    if (text->empty())
      return;
    session->pending += text->size();
    if (session->pending > options.waiting) {
      ++dropped;
      return end(session);
    }
    session->out.push_back(text);
    if (session->out.size() == 1)
      write(session);
  }

  void write(const SessionPtr& session) {
    asio::async_write(session->socket, asio::buffer(*session->out.front()),
                      [this, session](error_code failed, std::size_t size) {
                        sent += size;
                        if (session->state == Session::State::ended)
                          return;
                        if (failed)
                          return end(session);
                        session->pending -= session->out.front()->size();
                        session->out.pop_front();
                        if (!session->out.empty())
                          write(session);
                        else if (closing)
                          end(session);
                      });
  }

  void hand_out(const Text& text, const Text& whole) {
    for (const SessionPtr& session : std::vector(sessions)) {
      if (session->state == Session::State::joined) {
        queue(session, text);
      } else if (session->state == Session::State::waiting && !whole->empty()) {
        session->state = Session::State::joined;
        --waiting;
        queue(session, whole);
      }
    }
  }

  void refuse(const SessionPtr& session) {
    ++refused;
    end(session);
  }

  void end(const SessionPtr& session) {
    waiting -= session->state == Session::State::waiting;
    session->state = Session::State::ended;
    session->timer.cancel();
    error_code ignored;
    if (!session->out.empty())  // at once, with what the system still holds for him
      session->socket.set_option(asio::socket_base::linger(true, 0), ignored);
    session->socket.close(ignored);
    sessions.erase(std::find(sessions.begin(), sessions.end(), session));
    if (closing && sessions.empty())
      listener.stop();
  }

  void begin_to_close(std::chrono::milliseconds wait) {
    closing = true;
    listener.close(wait);
    for (const SessionPtr& session : std::vector(sessions))
      if (session->state != Session::State::joined || session->out.empty())
        end(session);
    if (sessions.empty())
      listener.stop();
  }

  TelemetryOptions options;
  Listener listener;
  std::vector<SessionPtr> sessions;  ///< in the order in which they came
  bool closing = false;
  std::atomic<std::uint32_t> waiting = 0;  ///< clients that have got nothing yet
  std::atomic<std::uint64_t> joined = 0, refused = 0, dropped = 0, sent = 0;
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
          .refused = network_->refused,
          .dropped = network_->dropped,
          .bytes = network_->sent};
}

}  // namespace eyrie::net
