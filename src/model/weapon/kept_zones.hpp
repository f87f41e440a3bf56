// SPDX-License-Identifier: MIT
#pragma once
/// \file  Launch zones that need not be flown again: those of this process, those of data/zones,
/// and those that the program has flown before.
#include <deque>
#include <map>

#include "core/mutex.hpp"
#include "model/weapon/launch_zone.hpp"

namespace eyrie::model::weapon {

/// Where zones are kept between runs of a program, and who is told while one is flown. Each may be
/// empty.
struct ZoneStore {
  /// What save() was given under that key, or "".
  std::function<std::string(std::uint64_t key)> load;
  std::function<void(std::uint64_t key, std::string_view file)> save;
  std::function<void(const MissileType& type, double done)> progress;  ///< from 0 to 1
  unsigned workers = 1;                                                ///< that fly one zone
};

/// Each zone under every parameter that it depends on, bit by bit: what it gives has the bits of a
/// flown one. May be used from any thread, never inside a step.
class KeptZones {
 public:
  /// Of at most so many types, 100 kB each; then the oldest is forgotten.
  explicit KeptZones(std::size_t most = 256) : most_(most) {}

  void use(ZoneStore store);
  /// The zone of a type, flown now if it is not kept.
  [[nodiscard]] LaunchZone of(const MissileType& type);
  /// How many zones were flown so far.
  [[nodiscard]] std::size_t flown() const;

  /// The zones of some types as a file for take().
  [[nodiscard]] std::string encode(std::span<const MissileType> types);
  /// Keeps the zones of such files one behind the other, and gives how many there are: only those
  /// before the first that is damaged or of another version. When one is first asked for, it is
  /// believed only if some flights of the missile end now, in this program and on this machine, as
  /// they ended then.
  std::size_t take(std::string_view file);

 private:
  using Table = std::shared_ptr<const ZoneTable>;
  /// From a file, not yet believed.
  struct Offer {
    Table table;
    std::uint64_t trial = 0;  ///< how the flights ended
  };

  std::size_t most_;
  mutable Mutex mutex_;
  std::map<std::string, Table> tables_;
  std::deque<const std::string*> order_;  ///< keys of tables_, the oldest first
  std::map<std::string, Offer> offers_;
  std::size_t flown_ = 0;
  std::shared_ptr<const ZoneStore> store_ = std::make_shared<const ZoneStore>();
};

/// Those of this process: MissileType::prepare() asks here.
[[nodiscard]] KeptZones& kept_zones();

}  // namespace eyrie::model::weapon
