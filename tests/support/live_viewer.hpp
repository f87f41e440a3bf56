// SPDX-License-Identifier: MIT
#pragma once
/// \file  Somebody who looks at a mission that is served: takes the run file, flies along by the
/// same engine and compares every hash.
#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/hash.hpp"
#include "debrief/recorded.hpp"
#include "sim/trail.hpp"
#include "support/tcp_client.hpp"

namespace eyrie::test {

/// A frame as a client sends it, masked with zeros. `announced`: a size that may be a lie.
[[nodiscard]] inline std::string ws_frame(const std::string& data, char opcode = '\x81',
                                          std::optional<std::uint64_t> announced = {}) {
  const std::uint64_t size = announced.value_or(data.size());
  const int more = size < 126 ? 0 : size < 65'536 ? 2 : 8;  // bytes of the size; fewer are refused
  std::string bytes{opcode, static_cast<char>(0x80 | (more == 0 ? size : more == 2 ? 126 : 127))};
  for (int shift = 8 * more; shift > 0; shift -= 8)
    bytes += static_cast<char>(size >> (shift - 8) & 0xFF);
  return bytes + std::string(4, '\0') + data;
}

/// At /live, if he is let in. `more`: header lines.
[[nodiscard]] inline TcpClient join_live(std::uint16_t port, const std::string& more = "") {
  TcpClient client(port);
  client.send(fmt::format(
      "GET /live HTTP/1.1\r\nHost: localhost:{}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n{}\r\n",
      port, more));
  return client;
}

/// The messages of a mission.
class LiveChannel {
 public:
  using Json = nlohmann::json;
  struct Message {
    bool binary = false;
    std::string data;
  };

  explicit LiveChannel(std::uint16_t port) : client_(join_live(port)) {
    if (!client_.read_to("\r\n\r\n").starts_with("HTTP/1.1 101 "))
      throw std::runtime_error("was not let in");
  }
  void say(const Json& message) { client_.send(ws_frame(message.dump())); }
  [[nodiscard]] Message next() {
    const std::uint64_t opcode = number(1);
    std::uint64_t size = number(1);
    if (size >= 126)
      size = number(size == 126 ? 2 : 8);
    std::string data = client_.read(size);
    if (data.size() < size || opcode == 0x88)
      throw std::runtime_error("was shown out: " + data);
    return {opcode == 0x82, std::move(data)};
  }

 private:
  std::uint64_t number(std::size_t size) {
    std::uint64_t value = 0;
    for (const char byte : client_.read(size))
      value = value << 8 | static_cast<unsigned char>(byte);
    return value;
  }
  TcpClient client_;
};

class LiveViewer {
 public:
  using Json = nlohmann::json;

  /// Joins, and flies what has been flown.
  explicit LiveViewer(std::uint16_t port) : channel_(port) {
    while (!run_)
      next();
  }

  void say(const Json& message) { channel_.say(message); }
  /// Flies along up to a message of which that is true, and gives it.
  Json follow(const std::function<bool(const Json&)>& enough) {
    for (;;)
      if (Json message = next(); enough(message))
        return message;
  }
  Json follow_to(std::uint64_t step) {
    return follow([&](const Json& j) { return j.value("step", std::uint64_t{0}) >= step; });
  }
  Json follow_to_the_end() {
    return follow([&](const Json& j) { return j.value("outcome", "running") != "running"; });
  }

  [[nodiscard]] const sim::World& world() const { return run_->world(); }
  [[nodiscard]] const scenario::Scenario& scenario() const { return *recorded_.scenario; }
  [[nodiscard]] std::size_t orders() const { return run_->orders().size(); }
  /// That were compared, besides those of the run file.
  [[nodiscard]] std::size_t hashes() const { return hashes_; }

 private:
  Json next() {
    const LiveChannel::Message got = channel_.next();
    if (got.binary)
      return take(got.data);
    Json message = Json::parse(got.data);
    if (message.contains("step") && run_)
      fly(message);
    return message;
  }

  Json take(const std::string& bytes) {
    if (run_)
      throw std::runtime_error("a second run file");
    record::Decoded decoded = record::decode(bytes);
    if (!decoded.error.empty())
      throw std::runtime_error(decoded.error);
    debrief::Opened opened = debrief::open(std::move(decoded.run), "live", {}, "test");
    if (!opened.recorded)
      throw std::runtime_error(opened.problems.front());
    recorded_ = std::move(*opened.recorded);
    run_.emplace(scenario().simulation, scenario().world(recorded_.run.seed),
                 sim::RunOptions{.workers = 2});
    for (const sim::Order& order : recorded_.run.orders)
      submit(order);
    checker_.emplace(recorded_.run.trail);
    run_->attach(*checker_);
    while (world().step() < recorded_.last_step())
      run_->step();
    if (checker_->departure())
      throw std::runtime_error("the run file: " + checker_->departure()->reason);
    checker_->finish(world());
    return {};
  }

  void fly(const Json& message) {
    for (const std::string text : message.value("orders", Json::array())) {
      sim::Order order;
      const std::string bytes = from_base64(text);
      if (bytes.size() != sizeof order)
        throw std::runtime_error("an order of another size");
      std::memcpy(static_cast<void*>(&order), bytes.data(), sizeof order);
      submit(order);
    }
    while (world().step() < message["step"])
      run_->step();
    if (world().step() != message["step"])
      throw std::runtime_error("steps backwards");
    if (!message.contains("hash"))
      return;
    ++hashes_;
    if (message["hash"] != hash_text(world().hash()))
      throw std::runtime_error(fmt::format("another hash after {} steps", world().step()));
  }
  void submit(const sim::Order& order) {
    if (const std::string problem = run_->submit(order); !problem.empty())
      throw std::runtime_error(problem);
  }
  [[nodiscard]] static std::string from_base64(const std::string& text) {
    static const std::string kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char digit : text) {
      held = held << 6 | static_cast<std::uint32_t>(kDigits.find(digit));
      if ((bits += 6) >= 8)
        bytes += static_cast<char>(held >> (bits -= 8));
    }
    return bytes;
  }

  LiveChannel channel_;
  debrief::Recorded recorded_;
  std::optional<sim::Run> run_;
  std::optional<sim::TrailChecker> checker_;
  std::size_t hashes_ = 0;
};

}  // namespace eyrie::test
