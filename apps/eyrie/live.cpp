// SPDX-License-Identifier: MIT
#include "live.hpp"

#include <chrono>
#include <system_error>
#include <thread>

#include "command.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
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

/// s since 1970.
double seconds_of(std::chrono::system_clock::time_point time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

/// "2 m", "5 deg" or both, with a comma between.
dis::Thresholds thresholds_of(const std::string& text) {
  std::optional<double> position, turn;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string one = text.substr(at, end - at);
    const Parsed length = parse_quantity(one, Dimension::length);
    const Parsed angle = parse_quantity(one, Dimension::angle);
    const bool far = length && length.value > 0 && length.value <= 10e3;
    if (!far && !(angle && angle.value > 0 && angle.value <= kPi))
      refuse(
          "--dis-threshold: {} is no distance up to 10 km and no angle up to 180 deg, such as "
          "'2 m, 5 deg'",
          quote(one));
    std::optional<double>& threshold = far ? position : turn;
    if (threshold)
      refuse("--dis-threshold: {} has two {}", quote(text), far ? "distances" : "angles");
    threshold = far ? length.value : angle.value;
    at = end + 1;
  }
  const dis::Thresholds standard;
  return {.position = position.value_or(standard.position), .angle = turn.value_or(standard.angle)};
}

/// What makes a host or a socket makes it; or it is refused, and what cannot be done is said.
auto demand(std::string_view option, const std::string& what, auto make) {
  try {
    return make();
  } catch (const std::system_error& error) {
    refuse("{}: cannot {}: {}", option, what, disk::words_of(error.code().value()));
  }
}

net::Endpoint dis_place(const FlyOptions& options) {
  return net::endpoint_of(options.dis, kDisStandard).value_or(kDisStandard);
}

DisLink link_dis(const FlyOptions& options, bool listens) {
  const net::Endpoint at = dis_place(options);
  DisLink link{.station = dis::station_of(options.dis_station).value_or(dis::Station{})};
  link.station.thresholds = thresholds_of(options.dis_threshold);
  const std::string from =
      options.dis_interface.empty() ? "" : fmt::format(" from {}", quote(options.dis_interface));
  link.sender = demand("--dis", fmt::format("send to {}{}", at.text(), from), [&] {
    return std::make_unique<net::DatagramSender>(
        net::DatagramOptions{.to = at, .interface = options.dis_interface});
  });
  if (listens)
    link.receiver = demand("--dis", "listen at " + at.text(), [&] {
      return std::make_unique<net::DatagramReceiver>(
          net::ReceiverOptions{.at = at, .interface = options.dis_interface});
    });
  return link;
}

std::unique_ptr<net::TelemetryHost> listen_for_tacview(const FlyOptions& options,
                                                       const std::string& name) {
  if (options.tacview.empty())
    return {};
  const net::Endpoint at =
      net::endpoint_of(options.tacview, kTacviewStandard).value_or(kTacviewStandard);
  const std::string password = password_in(options.tacview_password);
  return demand("--tacview", "listen at " + at.text(), [&] {
    return std::make_unique<net::TelemetryHost>(
        net::TelemetryOptions{.at = at, .name = "Eyrie: " + name, .password = password});
  });
}

}  // namespace

Broadcast::Broadcast(const scenario::Scenario& scenario, DisLink link, double rate, bool obeys)
    : link_(std::move(link)),
      others_(scenario, link_.station, rate),
      announcer_(
          scenario, link_.station, [this](double, const dis::Packet& packet) { send(packet); },
          scenario.remote ? &others_ : nullptr),
      obeys_(obeys),
      timed_(scenario.remote && rate == 1) {}

void Broadcast::send(const dis::Packet& packet) {
  if (!timed_)
    return link_.sender->send(dis::encode(packet));
  // others reckon from when it was so, if their clock is that of the world, too
  dis::Packet stamped = packet;
  stamped.timestamp =
      dis::timestamp_at(std::fmod(seconds_of(std::chrono::system_clock::now()), 3600)) | 1;
  link_.sender->send(dis::encode(stamped));
}

std::vector<sim::Order> Broadcast::listen(scenario::Mission& mission) {
  if (!link_.receiver)
    return {};
  link_.receiver->drain([this](std::span<const std::byte> bytes, auto came) {
    others_.hear(bytes, seconds_of(came));
  });
  const double now = seconds_of(std::chrono::system_clock::now());
  std::vector<sim::Order> orders = others_.orders(mission.run().world(), now);
  for (const dis::Others::Asked& asked : others_.asked()) {
    ++asked_;
    obeyed_ += obeys_ ? 1 : 0;
    if (obeys_)
      frozen_ = asked.stop && !asked.over;
    if (obeys_ && asked.over)
      mission.stop();
    // UID 69 and 70
    const std::uint16_t kStart = 3, kStop = 4, kAble = 1, kUnable = 2;
    send({.exercise = link_.station.exercise,
          .timestamp = dis::timestamp_at(mission.run().time()),
          .pdu = dis::Acknowledge{.from = link_.station.entity(0),
                                  .to = asked.from,
                                  .what = asked.stop ? kStop : kStart,
                                  .response = obeys_ ? kAble : kUnable,
                                  .request = asked.request}});
  }
  if (frozen_) {
    others_.hold(now);
    if (now - held_ > link_.station.thresholds.heartbeat) {
      held_ = now;
      announcer_.hold();
    }
  }
  return orders;
}

void Broadcast::close() {
  link_.sender->close();
  if (link_.receiver)
    link_.receiver->close();
}

Broadcast::Counts Broadcast::counts() const {
  return {.sent = link_.sender->counts(),
          .came = link_.receiver ? std::optional(link_.receiver->counts()) : std::nullopt,
          .heard = others_.counts(),
          .asked = asked_,
          .obeyed = obeyed_};
}

std::unique_ptr<net::TelemetryHost> host_tacview(const FlyOptions& options,
                                                 const std::string& name) {
  auto host = listen_for_tacview(options, name);
  if (!host)
    return {};
  complain("eyrie: Tacview finds this flight at {}\n", host->at().text());
  if (!host->at().loopback() && options.tacview_password.empty())
    complain("eyrie: so does anybody else there; --tacview-password FILE asks for a password\n");
  return host;
}

std::unique_ptr<Broadcast> broadcast_dis(const FlyOptions& options,
                                         const scenario::Scenario& scenario) {
  if (options.dis.empty()) {
    if (scenario.remote)
      complain(
          "eyrie: some of its players are another program's: without --dis nobody hears of "
          "them, and they never appear\n");
    return {};
  }
  const bool listens = scenario.remote || options.dis_obey;
  auto made = std::make_unique<Broadcast>(scenario, link_dis(options, listens),
                                          options.real_time.value_or(1), options.dis_obey);
  complain("eyrie: tells other simulations by DIS at {}{}\n", dis_place(options).text(),
           listens ? ", and listens there" : "");
  return made;
}

void demand_others(const FlyOptions& options) {
  static_cast<void>(listen_for_tacview(options, ""));
  if (!options.dis.empty())
    static_cast<void>(link_dis(options, !options.ours.empty() || options.dis_obey));
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
