// SPDX-License-Identifier: MIT
#pragma once
/// \file  What `--tacview` and `--dis` add to a flight: a host that Tacview connects to, and
/// packets for other simulations.
#include <memory>

#include "commands.hpp"
#include "dis/announcer.hpp"
#include "net/datagrams.hpp"
#include "net/telemetry_host.hpp"
#include "scenario/mission.hpp"

namespace eyrie::app {

/// Where Tacview looks if it is told nothing else.
inline const net::Endpoint kTacviewStandard{.address = "127.0.0.1", .port = 42674};

/// Listens, and says where. Null if the options ask for none; refuses what they ask for and cannot
/// be had.
[[nodiscard]] std::unique_ptr<net::TelemetryHost> host_tacview(const FlyOptions& options,
                                                               const std::string& name);
/// Until a client has joined. Throws disk::Failed if it was interrupted before.
void wait_for_tacview(const net::TelemetryHost& host);

/// Where DIS is sent if nothing else is said.
inline const net::Endpoint kDisStandard{.address = "127.0.0.1", .port = dis::kPort};

/// A station of an exercise, and its sockets.
struct DisLink {
  dis::Station station;
  std::unique_ptr<net::DatagramSender> sender;
  std::unique_ptr<net::DatagramReceiver> receiver;  ///< null: nobody is listened to
};

/// Sends packets of a flight as it is flown; and, where other programs fly some of its players,
/// hears theirs.
class Broadcast {
 public:
  Broadcast(const scenario::Scenario& scenario, DisLink link, double rate, bool obeys);

  /// Between two steps: what was heard, as orders for the next one.
  [[nodiscard]] std::vector<sim::Order> listen(scenario::Mission& mission);
  /// Somebody whom we obey has stopped us, until he says go on.
  [[nodiscard]] bool frozen() const { return frozen_; }
  void close();

  struct Counts {
    net::DatagramSender::Counts sent;
    std::optional<net::DatagramReceiver::Counts> came;
    dis::HeardCounts heard;
    std::uint64_t asked = 0;   ///< starts and stops
    std::uint64_t obeyed = 0;  ///< of these
  };
  /// After close().
  [[nodiscard]] Counts counts() const;
  [[nodiscard]] const dis::Announcer& announcer() const { return announcer_; }
  [[nodiscard]] dis::Announcer& announcer() { return announcer_; }

 private:
  void send(const dis::Packet& packet);

  DisLink link_;
  dis::Others others_;
  dis::Announcer announcer_;
  bool obeys_, timed_, frozen_ = false;
  double held_ = 0;  ///< s since 1970, when it was said last that we stand still
  std::uint64_t asked_ = 0, obeyed_ = 0;
};
/// Says where to. Null if the options ask for none; refuses what they ask for and cannot be had.
[[nodiscard]] std::unique_ptr<Broadcast> broadcast_dis(const FlyOptions& options,
                                                       const scenario::Scenario& scenario);

/// Refuses what both of the above would, before there is a flight.
void demand_others(const FlyOptions& options);

/// Says how many were not told of by DIS, if any.
void tell_nameless(const dis::Announcer& announcer);

}  // namespace eyrie::app
