// SPDX-License-Identifier: MIT
#pragma once
/// \file  What `fly --tacview` and `fly --dis` add: a host that Tacview connects to, and packets
/// for other simulations.
#include <memory>

#include "commands.hpp"
#include "dis/announcer.hpp"
#include "net/datagram_sender.hpp"
#include "net/telemetry_host.hpp"

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

/// Sends packets of a flight as it is flown.
struct Broadcast {
  net::DatagramSender sender;
  dis::Announcer announcer;

  Broadcast(const scenario::Scenario& scenario, const net::DatagramOptions& options,
            const dis::Station& station)
      : sender(options), announcer(scenario, station, [this](double, const dis::Packet& packet) {
          sender.send(dis::encode(packet));
        }) {}
};
/// Says where to. Null if the options ask for none; refuses what they ask for and cannot be had.
[[nodiscard]] std::unique_ptr<Broadcast> broadcast_dis(const FlyOptions& options,
                                                       const scenario::Scenario& scenario);

/// Says how many were not told of by DIS, if any.
void tell_nameless(const dis::Announcer& announcer);

}  // namespace eyrie::app
