// SPDX-License-Identifier: MIT
#pragma once
/// \file  Hashes of a run along the way: recorded, packed, and compared by a replay.
#include "core/bytes.hpp"
#include "sim/difference.hpp"
#include "sim/system.hpp"
#include "sim/world.hpp"

namespace eyrie::sim {

/// A world on the way of a run.
struct Mark {
  std::uint64_t step = 0;  ///< World::step()
  std::uint64_t hash = 0;  ///< World::hash()
  Digest digest{};
  friend bool operator==(const Mark&, const Mark&) = default;
};

/// Folds lie 0.1 s apart.
[[nodiscard]] constexpr std::uint64_t steps_per_fold(std::uint32_t steps_per_second) {
  return steps_per_second < 10 ? 1 : steps_per_second / 10;
}
/// Whether there is a mark at a step: each second of the first hour, then every ten seconds. (And
/// one at the beginning and the end.)
[[nodiscard]] constexpr bool is_mark(std::uint64_t step, std::uint32_t steps_per_second) {
  return step % steps_per_second == 0 && (step <= std::uint64_t{3600} * steps_per_second ||
                                          step % (std::uint64_t{10} * steps_per_second) == 0);
}

/// A trail in spans: one for the start and one from each mark to the next. A span is the number of
/// its steps, a 16-bit fold of the hash per 0.1 s, and the mark at its end: 64 bits of hash, and 16
/// bits of digest for each row and for each field that is not as it was at the mark before. (Six of
/// seven are; which ones seldom changes, so that is told as a change too.) Integers are
/// little-endian, those that are mostly small in LEB128.
class TrailPacker {
 public:
  explicit TrailPacker(std::uint32_t steps_per_second)
      : period_(steps_per_fold(steps_per_second)) {}

  /// Whether a World::step() after the first is to have a fold.
  [[nodiscard]] bool is_fold(std::uint64_t step) const { return step % period_ == 0; }
  void fold(std::uint16_t fold) { folds_.push_back(fold); }
  /// Ends the span.
  void mark(const Mark& mark);

  /// All spans since the last take().
  [[nodiscard]] const std::string& bytes() const { return out_; }
  [[nodiscard]] std::string take();

 private:
  void put_fields(const std::vector<std::uint16_t>& fields);
  void put_rows(const std::vector<Digest::Row>& rows);

  std::uint64_t period_;
  std::vector<std::uint16_t> folds_;
  Mark last_;
  std::vector<std::uint32_t> changed_, now_, others_;  ///< indices of fields
  std::string out_;
};

/// Reads what a TrailPacker wrote, span by span. Its work and memory are bounded by the number of
/// the bytes, whatever they are. They must outlive it.
class TrailUnpacker {
 public:
  TrailUnpacker(std::string_view bytes, std::uint32_t steps_per_second)
      : left_(bytes), period_(steps_per_fold(steps_per_second)) {}

  /// The next span; false at the end of the bytes, and where they are none of a TrailPacker.
  bool next();
  /// No bytes were wrong so far.
  [[nodiscard]] bool ok() const { return ok_; }
  /// The mark at the end of the span.
  [[nodiscard]] const Mark& mark() const { return mark_; }
  /// Whether the span has a fold for a World::step(), and which.
  [[nodiscard]] bool has_fold(std::uint64_t step) const {
    return step > begin_ && step <= mark_.step && step % period_ == 0;
  }
  [[nodiscard]] std::uint16_t fold(std::uint64_t step) const;

 private:
  bool read_span();
  bool read_fields();
  bool read_rows();

  ByteReader left_;
  std::string_view folds_;
  std::uint64_t period_, begin_ = 0;  ///< step of the mark before
  bool ok_ = true, any_ = false;
  Mark mark_;
  std::vector<std::uint32_t> changed_, now_, others_;
};

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
  /// Without digests it is as without_digests() makes it.
  explicit TrailRecorder(bool digests = true) : digests_(digests) {}

  void begin(const World& world, double dt) override;
  void observe(const World& world, const StepInfo& info, std::span<const Event> events) override;
  void finish(const World& world) override;

  [[nodiscard]] HashTrail trail() const {
    return {steps_per_second_, packer_.bytes(), mark_.step, mark_.hash};
  }
  /// The same up to the world that was observed last, as if the run ended there.
  [[nodiscard]] HashTrail trail_to(const World& world) const;
  [[nodiscard]] std::uint32_t steps_per_second() const { return steps_per_second_; }
  /// World::step() at the last mark.
  [[nodiscard]] std::uint64_t last_step() const { return mark_.step; }
  /// Whole spans that were not taken yet, for who writes them while the run is being flown.
  [[nodiscard]] const std::string& spans() const { return packer_.bytes(); }
  [[nodiscard]] std::string take() { return packer_.take(); }

 private:
  void mark(const World& world, std::uint64_t hash);

  bool digests_;
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
