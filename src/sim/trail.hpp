// SPDX-License-Identifier: MIT
#pragma once
/// \file  The hashes of a run: recorded once, checked by a replay.
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "sim/difference.hpp"
#include "sim/packed_trail.hpp"
#include "sim/system.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// What a run looked like on its way. Data only; the run file writes it.
struct HashTrail {
  std::uint32_t steps_per_second = 1;
  std::string spans{};          ///< of a TrailPacker
  std::uint64_t last_step = 0;  ///< World::step() and World::hash() at the last mark
  std::uint64_t last_hash = 0;
  friend bool operator==(const HashTrail&, const HashTrail&) = default;
};

/// Reads packed spans to their end. Nothing if there are none, or they are not those of a trail.
[[nodiscard]] std::optional<HashTrail> trail_of(std::string spans, std::uint32_t steps_per_second);

/// The same with hashes alone, a twentieth of the bytes: it tells that and when worlds part, not in
/// which field.
[[nodiscard]] HashTrail without_digests(const HashTrail& trail);

/// Records a trail: at the beginning a mark, every 0.1 s a fold, every second (after an hour: every
/// ten) and at the end a mark. Hashing runs at some 10 GB/s.
class TrailRecorder final : public Observer {
 public:
  void begin(const World& world, double dt) override;
  void observe(const World& world, const StepInfo& info, std::span<const Event> events) override;
  void finish(const World& world) override;

  [[nodiscard]] HashTrail trail() const {
    return {steps_per_second_, packer_.bytes(), mark_.step, mark_.hash};
  }
  [[nodiscard]] std::uint32_t steps_per_second() const { return steps_per_second_; }
  /// World::step() at the last mark.
  [[nodiscard]] std::uint64_t last_step() const { return mark_.step; }
  /// Whole spans that were not taken yet, for who writes them while the run is being flown.
  [[nodiscard]] const std::string& spans() const { return packer_.bytes(); }
  [[nodiscard]] std::string take() { return packer_.take(); }

 private:
  void mark(const World& world, std::uint64_t hash);

  std::uint32_t steps_per_second_ = 1;
  TrailPacker packer_{1};
  Mark mark_;
};

/// Where a replay left the recorded run.
struct Departure {
  /// The first World::step() known to be wrong. The last one known to be right is `last_good`, or
  /// none if the start was wrong already; the two lie 0.1 s apart.
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
  explicit TrailChecker(const HashTrail& expected);
  explicit TrailChecker(HashTrail&&) = delete;

  void begin(const World& world, double dt) override;
  void observe(const World& world, const StepInfo& info, std::span<const Event> events) override;
  void finish(const World& world) override;

  /// Nothing as long as all hashes agree.
  [[nodiscard]] const std::optional<Departure>& departure() const { return departure_; }
  /// Nothing more will be learnt: the replay may stop here.
  [[nodiscard]] bool done() const { return departure_ && over_; }

 private:
  void check(const World& world);
  void check_mark(const World& world, std::uint64_t hash);
  void depart(std::uint64_t step, std::string reason);

  const HashTrail& expected_;
  TrailUnpacker span_;
  bool more_ = false;  ///< `span_` has not been flown to its end
  std::optional<std::uint64_t> last_good_;
  std::optional<Departure> departure_;
  bool over_ = false;
};

}  // namespace eyrie::sim
