// SPDX-License-Identifier: MIT
#pragma once
/// \file  From a thread of the network to the one that steps, which never waits for it.
#include <atomic>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace eyrie::live {

template <class T>
class Mailbox {
 public:
  /// Items that may wait.
  explicit Mailbox(std::size_t most) : most_(most) {}

  /// False if too many wait already; what `must` come does all the same.
  bool put(T item, bool must = false) {
    const std::lock_guard lock(mutex_);
    if (items_.size() >= most_ && !must)
      return false;
    items_.push_back(std::move(item));
    waiting_ = true;
    return true;
  }
  [[nodiscard]] bool waiting() const { return waiting_; }
  /// Everything that waits; nothing if the other thread is at it now: then it comes the next time.
  [[nodiscard]] std::vector<T> take() {
    std::vector<T> taken;
    if (const std::unique_lock lock(mutex_, std::try_to_lock); lock) {
      taken.swap(items_);
      waiting_ = false;
    }
    return taken;
  }

 private:
  std::mutex mutex_;
  std::vector<T> items_;
  std::size_t most_;
  std::atomic<bool> waiting_ = false;
};

}  // namespace eyrie::live
