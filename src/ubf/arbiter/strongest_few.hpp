// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "ubf/behavior.hpp"

namespace eyrie::ubf {

/// The few strongest of many proposals, in the order in which they came; of equal votes the
/// earlier. On the stack, for one tick.
template <class Action, std::size_t Most>
class StrongestFew {
 public:
  /// At most `few` of them, which is at least 1 and at most Most.
  explicit StrongestFew(std::size_t few) : few_(few) {}
  StrongestFew(const StrongestFew&) = delete;
  StrongestFew& operator=(const StrongestFew&) = delete;

  /// Where the next proposal goes, before add() says that it counts.
  [[nodiscard]] Proposal<Action>& spare() { return kept_[size_].scratch->get(); }
  /// Keeps the proposal in spare() unless there are enough that are at least as strong.
  void add(NodeIndex child, Status status) {
    kept_[size_].child = child;
    kept_[size_].status = status;
    if (size_ < few_) {
      ++size_;
      return;
    }
    // the weakest goes, the latest of equals, and its place is the spare one from now on
    std::size_t weakest = size_;
    for (std::size_t i = size_; i-- > 0;)
      if (proposal(i).vote < proposal(weakest).vote)
        weakest = i;
    const Kept gone = kept_[weakest];
    for (std::size_t i = weakest; i < size_; ++i)
      kept_[i] = kept_[i + 1];
    kept_[size_] = gone;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Proposal<Action>& proposal(std::size_t i) const {
    return kept_[i].scratch->get();
  }
  [[nodiscard]] Status status(std::size_t i) const { return kept_[i].status; }
  [[nodiscard]] bool contains(NodeIndex child) const {
    for (std::size_t i = 0; i < size_; ++i)
      if (kept_[i].child == child)
        return true;
    return false;
  }

 private:
  struct Kept {
    Scratch<Action>* scratch = nullptr;
    NodeIndex child = kNone;
    Status status = Status::failure;
  };
  [[nodiscard]] std::array<Kept, Most + 1> places() {
    std::array<Kept, Most + 1> all;
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].scratch = &scratch_[i];
    return all;
  }

  std::array<Scratch<Action>, Most + 1> scratch_;
  std::array<Kept, Most + 1> kept_ = places();  ///< those behind the first size_ are spare
  std::size_t few_, size_ = 0;
};

}  // namespace eyrie::ubf
