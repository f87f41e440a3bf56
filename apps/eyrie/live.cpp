// SPDX-License-Identifier: MIT
#include "live.hpp"

#include <chrono>
#include <system_error>
#include <thread>

#include "command.hpp"
#include "disk/file_system.hpp"
#include "disk/sink.hpp"
#include "say.hpp"

namespace eyrie::app {
namespace {

/// The first line of a file.
std::string password_in(const std::string& file) {
  if (file.empty())
    return {};
  const disk::FileRead read = disk::read_file(file, 4096);
  if (!read.problem.empty())
    refuse("--tacview-password: {}: {}", file, read.problem);
  std::string line = read.bytes.substr(0, read.bytes.find_first_of("\r\n"));
  if (line.empty())
    refuse("--tacview-password: {}: its first line, which is the password, is empty", file);
  return line;
}

}  // namespace

std::unique_ptr<net::TelemetryHost> host_tacview(const FlyOptions& options,
                                                 const std::string& name) {
  if (options.tacview.empty())
    return {};
  const net::Endpoint at =
      net::endpoint_of(options.tacview, kTacviewStandard).value_or(kTacviewStandard);
  const std::string password = password_in(options.tacview_password);
  try {
    auto host = std::make_unique<net::TelemetryHost>(
        net::TelemetryOptions{.at = at, .name = "Eyrie: " + name, .password = password});
    complain("eyrie: Tacview finds this flight at {}\n", host->at().text());
    if (!at.loopback() && password.empty())
      complain("eyrie: so does anybody else there; --tacview-password FILE asks for a password\n");
    return host;
  } catch (const std::system_error& error) {
    refuse("--tacview: cannot listen at {}: {}", at.text(), disk::words_of(error.code().value()));
  }
}

std::unique_ptr<Broadcast> broadcast_dis(const FlyOptions& options,
                                         const scenario::Scenario& scenario) {
  if (options.dis.empty())
    return {};
  const net::Endpoint to = net::endpoint_of(options.dis, kDisStandard).value_or(kDisStandard);
  try {
    auto made = std::make_unique<Broadcast>(
        scenario, net::DatagramOptions{.to = to, .interface = options.dis_interface},
        dis::station_of(options.dis_station).value_or(dis::Station{}));
    complain("eyrie: tells other simulations by DIS at {}\n", to.text());
    return made;
  } catch (const std::system_error& error) {
    refuse(
        "--dis: cannot send to {}{}: {}", to.text(),
        options.dis_interface.empty() ? "" : fmt::format(" from {}", quote(options.dis_interface)),
        disk::words_of(error.code().value()));
  }
}

void tell_nameless(const dis::Announcer& announcer) {
  if (const std::size_t count = announcer.nameless())
    complain("eyrie: DIS has no numbers beyond 65534: {} players and missiles are left out\n",
             count);
}

void wait_for_tacview(const net::TelemetryHost& host) {
  while (host.counts().joined == 0) {
    if (interrupted())
      throw disk::Failed("interrupted before anybody joined; nothing was flown");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace eyrie::app
