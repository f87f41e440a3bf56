// SPDX-License-Identifier: MIT
#pragma once
/// \file  What `fly --tacview` adds: a host that Tacview connects to.
#include <memory>

#include "commands.hpp"
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

}  // namespace eyrie::app
