// SPDX-License-Identifier: MIT
#include "model/weapon/kept_zones.hpp"

#include <cstring>

#include "core/hash.hpp"
#include "model/weapon/engagement.hpp"

namespace eyrie::model::weapon {
namespace {

constexpr std::string_view kMagic = "Eyrie launch zones 1\n";

/// Everything that a table depends on but the code that flies.
std::string key_of(const MissileType& type) {
  return parameter_bits(type) + zone_search_bits();
}

std::uint64_t checksum(std::string_view bytes) {
  return hash_bytes(std::as_bytes(std::span<const char>(bytes)));
}

/// How some flights end, high and low, near and far, to the last bit: other code, or a machine that
/// reckons otherwise, shows here.
std::uint64_t trial_flights(const MissileType& type) {
  const Atmosphere atmosphere;
  std::string ends;
  for (const double altitude : {300.0, 5000.0, 11500.0, 15000.0})
    for (const double aspect : {0.0, radians(70), kPi})
      for (const double range : {3e3, 20e3}) {
        const Engagement launch{.situation = {.shooter_altitude = altitude,
                                              .target_altitude = 500 + 0.8 * altitude,
                                              .shooter_speed = 250,
                                              .target_speed = 280,
                                              .aspect = aspect,
                                              .off_boresight = altitude < 10e3 ? 0 : radians(50)},
                                .range = range,
                                .escape = aspect == 0    ? Escape::none
                                          : range > 10e3 ? Escape::dive
                                                         : Escape::beam};
        const EngagementResult end = engage(type, atmosphere, launch);
        append_bits(ends, std::array{end.miss, end.time, end.speed, end.greatest_speed,
                                     end.greatest_lift, end.greatest_altitude});
      }
  return checksum(ends);
}

/// Takes pieces off the front of a file; one that is not whole is not there.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <class T>
  std::optional<T> value() {
    const auto bytes = piece(sizeof(T));
    if (!bytes)
      return std::nullopt;
    T result;
    std::memcpy(&result, bytes->data(), sizeof result);
    return result;
  }
  std::optional<std::string_view> piece(std::uint64_t size) {
    if (size > left_.size())
      return std::nullopt;
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }
  [[nodiscard]] bool at_end() const { return left_.empty(); }

 private:
  std::string_view left_;
};

}  // namespace

LaunchZone KeptZones::of(const MissileType& type) {
  std::string key = key_of(type);
  if (const Table known = find(key))
    return {type, known};
  const std::optional<Offer> offer = offered(key);
  const bool believed = offer && offer->trial == trial_flights(type);
  return {type, keep(std::move(key), believed ? offer->table : fly(type))};
}

std::size_t KeptZones::flown() const {
  const std::lock_guard lock(mutex_);
  return flown_;
}

KeptZones::Table KeptZones::find(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto there = tables_.find(key);
  return there == tables_.end() ? nullptr : there->second;
}

std::optional<KeptZones::Offer> KeptZones::offered(const std::string& key) const {
  const std::lock_guard lock(mutex_);
  const auto there = offers_.find(key);
  return there == offers_.end() ? std::nullopt : std::optional(there->second);
}

KeptZones::Table KeptZones::fly(const MissileType& type) {
  Table table = std::make_shared<const ZoneTable>(fly_zone(type));
  const std::lock_guard lock(mutex_);
  ++flown_;
  return table;
}

KeptZones::Table KeptZones::keep(std::string key, Table table) {
  const std::lock_guard lock(mutex_);
  const auto [place, fresh] = tables_.emplace(std::move(key), std::move(table));
  if (fresh)
    order_.push_back(&place->first);
  Table kept = place->second;
  if (order_.size() > kMost) {
    tables_.erase(tables_.find(*order_.front()));
    order_.pop_front();
  }
  return kept;
}

std::string KeptZones::encode(std::span<const MissileType> types) {
  std::string file(kMagic);
  const auto add = [&](const auto& value) {
    file.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (const MissileType& type : types) {
    const std::string key = key_of(type);
    add(std::uint64_t{key.size()});
    file += key;
    add(trial_flights(type));
    add(*of(type).table());
  }
  add(checksum(file));
  return file;
}

std::size_t KeptZones::take(std::string_view file) {
  if (!file.starts_with(kMagic) || file.size() < kMagic.size() + sizeof(std::uint64_t))
    return 0;
  const std::string_view body = file.substr(0, file.size() - sizeof(std::uint64_t));
  if (Reader(file.substr(body.size())).value<std::uint64_t>() != checksum(body))
    return 0;
  std::map<std::string, Offer> offers;
  Reader reader(body.substr(kMagic.size()));
  while (!reader.at_end()) {
    const auto size = reader.value<std::uint64_t>();
    const auto key = size ? reader.piece(*size) : std::nullopt;
    const auto trial = reader.value<std::uint64_t>();
    const auto table = reader.value<ZoneTable>();
    if (!key || !table)
      return 0;
    offers[std::string(*key)] = {std::make_shared<const ZoneTable>(*table), *trial};
  }
  const std::size_t count = offers.size();
  const std::lock_guard lock(mutex_);
  offers_.merge(offers);
  return count;
}

KeptZones& kept_zones() {
  static KeptZones zones;
  return zones;
}

}  // namespace eyrie::model::weapon
