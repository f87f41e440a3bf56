// SPDX-License-Identifier: MIT
#pragma once
/// \file  The hashes of a run as bytes: packed while it is flown, unpacked while it is flown again.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/digest.hpp"

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
  template <class T>
  T number();
  std::uint64_t varint();
  bool read_span();
  bool read_fields();
  bool read_rows();

  std::string_view left_, folds_;
  std::uint64_t period_, begin_ = 0;  ///< step of the mark before
  bool ok_ = true, any_ = false;
  Mark mark_;
  std::vector<std::uint32_t> changed_, now_, others_;
};

}  // namespace eyrie::sim
