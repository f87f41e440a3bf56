// SPDX-License-Identifier: MIT
#include "model/weapon/kept_zones.hpp"

#include "core/bytes.hpp"
#include "core/hash.hpp"
#include "model/weapon/engagement.hpp"

namespace eyrie::model::weapon {
namespace {

constexpr std::string_view kMagic = "Eyrie launch zones 3\n";
/// One range of all cells behind the other: so they are a quarter smaller when they are packed.
constexpr std::array kRanges{&ZoneTable::Cell::r_max, &ZoneTable::Cell::r_tr,
                             &ZoneTable::Cell::r_ne, &ZoneTable::Cell::r_min};

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

/// One zone as bytes: what it is, how much follows, and a checksum of all that.
std::string section(std::string_view key, std::uint64_t trial, const ZoneTable& table) {
  std::string file(kMagic);
  const std::size_t cells = table.cells.size() * sizeof(ZoneTable::Cell);
  put_number<std::uint64_t>(file, 2 * sizeof trial + key.size() + cells);
  put_number<std::uint64_t>(file, key.size());
  file += key;
  put_number(file, trial);
  for (const auto range : kRanges)
    for (const ZoneTable::Cell& cell : table.cells)
      put_number(file, cell.*range);
  put_number(file, checksum(file));
  return file;
}

/// Takes the first one off a file: what it holds, or nothing if it is not whole.
std::optional<std::string_view> next_section(std::string_view& file) {
  if (!file.starts_with(kMagic))
    return std::nullopt;
  ByteReader reader(file.substr(kMagic.size()));
  const std::string_view body = reader.text();
  const auto sum = reader.number<std::uint64_t>();
  const std::size_t whole = kMagic.size() + sizeof(std::uint64_t) + body.size();
  if (!reader.ok() || checksum(file.substr(0, whole)) != sum)
    return std::nullopt;
  file.remove_prefix(whole + sizeof sum);
  return body;
}

}  // namespace

void KeptZones::use(ZoneStore store) {
  auto shared = std::make_shared<const ZoneStore>(std::move(store));
  const std::lock_guard lock(mutex_);
  store_ = std::move(shared);
}

LaunchZone KeptZones::of(const MissileType& type) {
  const std::string key = key_of(type);
  Offer offer;
  std::shared_ptr<const ZoneStore> store;
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = tables_.find(key); known != tables_.end())
      return {type, known->second};
    if (const auto offered = offers_.find(key); offered != offers_.end())
      offer = offered->second;
    store = store_;
  }

  // from a file or from the store, if it is believed; flown otherwise
  const std::uint64_t trial = trial_flights(type);
  if (offer.trial != trial && store->load) {
    KeptZones stored;
    stored.take(store->load(checksum(key)));
    offer = stored.offers_[key];
  }
  Table table = offer.trial == trial ? offer.table : nullptr;
  const bool flown = !table;
  if (flown) {
    table = std::make_shared<const ZoneTable>(fly_zone(type, store->workers, [&](double done) {
      if (store->progress)
        store->progress(type, done);
    }));
    if (store->save)
      store->save(checksum(key), section(key, trial, *table));
  }

  const std::lock_guard lock(mutex_);
  flown_ += flown ? 1 : 0;
  const auto [place, fresh] = tables_.emplace(key, std::move(table));
  if (fresh)
    order_.push_back(&place->first);
  const LaunchZone zone(type, place->second);
  if (order_.size() > most_) {
    tables_.erase(tables_.find(*order_.front()));
    order_.pop_front();
  }
  return zone;
}

std::size_t KeptZones::flown() const {
  const std::lock_guard lock(mutex_);
  return flown_;
}

std::string KeptZones::encode(std::span<const MissileType> types) {
  std::string file;
  for (const MissileType& type : types)
    file += section(key_of(type), trial_flights(type), *of(type).table());
  return file;
}

std::size_t KeptZones::take(std::string_view file) {
  std::map<std::string, Offer> offers;
  while (const auto body = next_section(file)) {
    ByteReader reader(*body);
    std::string key(reader.text());
    const auto trial = reader.number<std::uint64_t>();
    ZoneTable table;
    for (const auto range : kRanges)
      for (ZoneTable::Cell& cell : table.cells)
        cell.*range = reader.number<std::uint16_t>();
    if (!reader.ok() || !reader.at_end())
      break;
    offers[std::move(key)] = {std::make_shared<const ZoneTable>(std::move(table)), trial};
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
