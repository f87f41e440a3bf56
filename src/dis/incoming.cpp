// SPDX-License-Identifier: MIT
#include "dis/incoming.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace eyrie::dis {
namespace {

constexpr double kHour = 3600;       // s
constexpr double kForgotten = 60;    // s without a word
constexpr double kLongestWay = 2;    // s that one takes; a clock that is farther off is another one
constexpr double kSameClock = 0.02;  // s that clocks of the world are apart
constexpr std::size_t kRemembered = 256;  // shots of an application
constexpr std::size_t kWaiting = 65536;   // PDUs between two steps

/// s that a is behind b, within half an hour.
double behind(double a, double b) {
  const double apart = b - a;
  return apart - kHour * std::floor(apart / kHour + 0.5);
}
double seconds_of(std::uint32_t stamp) {
  return static_cast<double>(stamp >> 1) * (kHour / 2147483648.0);
}

EntityId sender_of(const Pdu& pdu) {
  return std::visit(
      [](const auto& p) {
        using P = std::decay_t<decltype(p)>;
        if constexpr (std::is_same_v<P, EntityState>)
          return p.id;
        else if constexpr (std::is_same_v<P, Fire> || std::is_same_v<P, Detonation>)
          return EntityId{p.event.site, p.event.application, 0};
        else if constexpr (std::is_same_v<P, Emission>)
          return p.emitter;
        else
          return p.from;
      },
      pdu);
}

auto silent_until(double now) {
  return [now](const auto& one) { return now - one.heard > kForgotten; };
}

template <class... T>
bool finite(const T&... values) {
  const auto good = [](const auto& v) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(v)>>)
      return std::isfinite(v);
    else if constexpr (std::is_same_v<std::decay_t<decltype(v)>, Vec3>)
      return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    else
      return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  };
  return (good(values) && ...);
}

}  // namespace

std::optional<Station> station_of(std::string_view text) {
  Station station;
  const char *at = text.data(), *const end = at + text.size();
  bool good = true;
  const auto take = [&](auto& number, std::uint16_t most, bool last) {
    if (!good)
      return;
    const auto [next, failed] = std::from_chars(at, end, number);
    good = failed == std::errc{} && number > 0 && number <= most &&
           (last ? next == end : next != end && *next == '.');
    at = next + (last ? 0 : 1);
  };
  take(station.exercise, 255, false);
  take(station.site, 65534, false);
  take(station.application, 65534, true);
  return good ? std::optional(station) : std::nullopt;
}

std::string_view words_of(Unused why) {
  static constexpr std::array<std::string_view, 11> kWords{
      "shorter than they say",
      "of another version",
      "of a kind that is not read",
      "malformed",
      "of another exercise",
      "of our own number",
      "that came twice",
      "overtaken by newer ones",
      "that cannot be",
      "of more entities than fit",
      "of entities without a place in the scenario"};
  return kWords[static_cast<std::size_t>(why)];
}

void Incoming::hear(std::span<const std::byte> datagram, double came) {
  ++counts.datagrams;
  while (!datagram.empty()) {
    Decoded read = decode(datagram);
    // who speaks of another exercise may speak another version
    if (read.refusal && read.refusal != Unused::truncated &&
        read.packet.exercise != station_.exercise)
      ++counts[Unused::exercise];
    else if (read.refusal)
      ++counts[*read.refusal];
    else if (const auto why = check(read.packet, came))
      ++counts[*why];
    else if (received_.size() < kWaiting) {
      const EntityId from = sender_of(read.packet.pdu);
      Application& application = applications_[{from.site, from.application}];
      received_.push_back(
          {std::move(read.packet.pdu), valid_at(application, read.packet.timestamp, came)});
    } else {
      ++counts[Unused::crowded];
    }
    if (read.length == 0)
      return;
    datagram = datagram.subspan(read.length);
  }
}

std::optional<Unused> Incoming::check(const Packet& packet, double came) {
  const EntityId from = sender_of(packet.pdu);
  if (packet.exercise != station_.exercise)
    return Unused::exercise;
  if (from.site == station_.site && from.application == station_.application)
    return Unused::own;
  const auto key = std::pair(from.site, from.application);
  if (!applications_.contains(key) &&
      !has_room(applications_, applications_tidied_, came, silent_until(came)))
    return Unused::crowded;
  Application& application = applications_[key];
  application.heard = came;
  return std::visit(
      [&](const auto& p) -> std::optional<Unused> {
        using P = std::decay_t<decltype(p)>;
        if constexpr (std::is_same_v<P, EntityState>) {
          if (!finite(p.velocity, p.location, p.orientation, p.acceleration, p.spin))
            return Unused::implausible;
          return newest(p.id, p.kType, packet.timestamp, came);
        } else if constexpr (std::is_same_v<P, Emission>) {
          return newest(p.emitter, p.kType, packet.timestamp, came);
        } else if constexpr (std::is_same_v<P, Fire>) {
          return finite(p.location, p.velocity, p.range)
                     ? once(application, p.kType, p.event.number, came)
                     : Unused::implausible;
        } else if constexpr (std::is_same_v<P, Detonation>) {
          return finite(p.location, p.velocity, p.place)
                     ? once(application, p.kType, p.event.number, came)
                     : Unused::implausible;
        } else if constexpr (requires { p.request; } && !std::is_same_v<P, Data>) {
          return once(application, p.kType, p.request ^ packet.timestamp, came);
        } else {
          return std::nullopt;
        }
      },
      packet.pdu);
}

std::optional<Unused> Incoming::newest(const EntityId& who, std::uint8_t type, std::uint32_t stamp,
                                       double came) {
  if (!entities_.contains(who) && !has_room(entities_, entities_tidied_, came, silent_until(came)))
    return Unused::crowded;
  Stamps& stamps = entities_[who];
  stamps.heard = came;
  const auto [known, fresh] = stamps.last.emplace(type, stamp);
  if (fresh)
    return std::nullopt;
  const double older = behind(seconds_of(stamp), seconds_of(known->second));
  if (older == 0)
    return Unused::twice;
  if (older > 0 && older < kLongAgo)
    return Unused::late;
  known->second = stamp;
  return std::nullopt;
}

std::optional<Unused> Incoming::once(Application& application, std::uint8_t type,
                                     std::uint32_t number, double came) {
  const auto key = std::pair(type, number);
  const auto [known, fresh] = application.told.emplace(key, came);
  if (!fresh)
    return came - std::exchange(known->second, came) < kLongAgo ? std::optional(Unused::twice)
                                                                : std::nullopt;
  if (application.order.size() < kRemembered) {
    application.order.push_back(key);
  } else {
    application.told.erase(std::exchange(application.order[application.next], key));
    application.next = (application.next + 1) % kRemembered;
  }
  return std::nullopt;
}

double Incoming::valid_at(Application& application, std::uint32_t stamp, double came) {
  const bool absolute = (stamp & 1) != 0;
  const double rate = absolute ? 1 : rate_;
  const double ago = behind(seconds_of(stamp), std::fmod(rate * came, kHour));
  if (absolute && ago > -kSameClock && ago < kLongestWay) {
    counts.latency.add(std::max(ago, 0.0));
    return came - std::max(ago, 0.0);
  }
  // its own clock: that packet was the quickest which is the least behind
  const double later = behind(application.nearest, ago);
  if (!application.known || later < 0 || later > rate * kLongestWay) {
    application.known = true;
    application.nearest = ago;
    return came;
  }
  return came - later / rate;
}

}  // namespace eyrie::dis
