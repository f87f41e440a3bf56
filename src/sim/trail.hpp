// SPDX-License-Identifier: MIT
#pragma once
/// \file  The hashes of a run: recorded once, checked by a replay.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/difference.hpp"
#include "sim/digest.hpp"
#include "sim/system.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// What a run looked like on its way. Data only; the run file writes it.
struct HashTrail {
  struct Mark {
    std::uint64_t step = 0;  ///< World::step() when it was taken
    std::uint64_t hash = 0;  ///< World::hash()
    Digest digest{};
    friend bool operator==(const Mark&, const Mark&) = default;
  };

  std::uint64_t first_step = 0;      ///< World::step() at the beginning
  std::uint32_t steps_per_mark = 0;  ///< marks lie one simulated second apart
  /// 32 bits of the hash after each step; empty when only marks were recorded.
  std::vector<std::uint32_t> folds{};
  std::vector<Mark> marks{};  ///< at the beginning, every simulated second and at the end
  friend bool operator==(const HashTrail&, const HashTrail&) = default;
};

/// Whether to hash the world after every step (a replay then names the very step that went wrong)
/// or only once per simulated second. Hashing runs at some 10 GB/s.
enum class TrailDetail : std::uint8_t { every_step, marks_only };

/// Records a HashTrail.
class TrailRecorder final : public Observer {
 public:
  explicit TrailRecorder(TrailDetail detail = TrailDetail::every_step) : detail_(detail) {}

  void begin(const World& world, double dt) override;
  void observe(const World& world, const StepInfo& info, std::span<const Event> events) override;
  void finish(const World& world) override;

  [[nodiscard]] const HashTrail& trail() const { return trail_; }

 private:
  void mark(const World& world, std::uint64_t hash);

  TrailDetail detail_;
  HashTrail trail_;
};

/// Where a replay left the recorded run.
struct Departure {
  /// The first World::step() known to be wrong. The last one known to be right is `last_good`, or
  /// none if the start was wrong already; with a fold per step the two are neighbors.
  std::uint64_t step = 0;
  std::optional<std::uint64_t> last_good{};
  /// From the first digest at or after `step`; nothing if the run has not come to one, or ended.
  std::optional<Difference> where{};
  std::string reason{};  ///< one line for people; names `where` once it is known
};

/// Flies along and compares with a recorded trail; `expected` must outlive it. Left is recorded,
/// right is the replay.
class TrailChecker final : public Observer {
 public:
  explicit TrailChecker(const HashTrail& expected) : expected_(expected) {}

  void begin(const World& world, double dt) override;
  void observe(const World& world, const StepInfo& info, std::span<const Event> events) override;
  void finish(const World& world) override;

  /// Nothing as long as all hashes agree.
  [[nodiscard]] const std::optional<Departure>& departure() const { return departure_; }
  /// Nothing more will be learnt: the replay may stop here.
  [[nodiscard]] bool done() const { return departure_ && (departure_->where || finished_); }

 private:
  void check_mark(const World& world);
  void depart(std::uint64_t step, std::string reason);

  const HashTrail& expected_;
  std::size_t next_mark_ = 0;
  std::optional<std::uint64_t> last_good_;
  std::optional<Departure> departure_;
  bool finished_ = false;
};

}  // namespace eyrie::sim
