// SPDX-License-Identifier: MIT
#include "core/executor.hpp"

#include <fmt/format.h>

#include <atomic>
#include <condition_variable>
#include <latch>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "core/assert.hpp"

namespace eyrie {
namespace {

constexpr unsigned kMostWorkers = 256;
// The phases of one step follow each other within microseconds, and what workers share out of a
// tenth of a millisecond differs by tens of them; falling asleep and waking up costs more than
// that. 50 to 80 us on current x86-64.
constexpr int kSpins = 2048;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}

/// A thread that waits here spins first if the machine has a core to spare, then sleeps.
class Doorbell {
 public:
  template <class Ready>
  void wait(bool spin, Ready ready) {
    for (int i = 0; spin && i < kSpins; ++i) {
      if (ready())
        return;
      pause();
    }
    std::unique_lock lock(mutex_);
    sleepers_.fetch_add(1);
    condition_.wait(lock, ready);
    sleepers_.fetch_sub(1);
  }

  /// To be called after the store that makes a waiter ready. That store, `sleepers_` and what
  /// ready() reads are sequentially consistent: either we see the sleeper or the sleeper sees the
  /// store.
  void ring() {
    if (sleepers_.load() == 0)
      return;
    { const std::lock_guard lock(mutex_); }
    condition_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  std::atomic<int> sleepers_{0};
};

}  // namespace

struct Executor::Pool {
  explicit Pool(unsigned helpers)
      : spin(helpers < std::thread::hardware_concurrency()), started(helpers) {
    threads.reserve(helpers);
    try {
      for (unsigned i = 0; i < helpers; ++i)
        threads.emplace_back([this] { help(); });
    } catch (const std::system_error& e) {
      end();  // those that did start
      throw std::system_error(e.code(), fmt::format("{} threads cannot be started", helpers + 1));
    }
    started.wait();  // what a thread allocates to start is not left for the first call
  }

  ~Pool() { end(); }

  void end() {
    stop.store(true);
    work_bell.ring();
  }

  void help() {
    started.count_down();
    for (;;) {
      work_bell.wait(spin, [this] { return unclaimed.load() > 0 || stop.load(); });
      if (stop.load())
        return;
      work();
    }
  }

  /// Takes chunks until none is left. `job` may be read only between a claim and its completion:
  /// that is when it cannot change.
  void work() {
    for (;;) {
      std::size_t left = unclaimed.load();
      do {
        if (left == 0)
          return;
      } while (!unclaimed.compare_exchange_weak(left, left - 1));
      const std::size_t chunk = chunk_count(job.rows) - left;
      const std::size_t begin = chunk * kChunk;
      job.call(job.context, chunk, begin, std::min(job.rows, begin + kChunk));
      if (unfinished.fetch_sub(1) == 1)
        done_bell.ring();
    }
  }

  Job job{};
  bool spin;
  std::latch started;
  alignas(64) std::atomic<std::size_t> unclaimed{0};
  alignas(64) std::atomic<std::size_t> unfinished{0};
  alignas(64) std::atomic<bool> stop{false};
  std::atomic_flag in_use;
  Doorbell work_bell, done_bell;
  std::vector<std::jthread> threads;  // last: joined before anything they use is gone
};

Executor::Executor(unsigned workers) {
  EYRIE_THROW_UNLESS(workers >= 1 && workers <= kMostWorkers, "an executor has 1 to 256 workers");
  if (workers > 1)
    pool_ = std::make_unique<Pool>(workers - 1);
}

Executor::~Executor() = default;

unsigned Executor::workers() const {
  return pool_ ? static_cast<unsigned>(pool_->threads.size()) + 1 : 1;
}

void Executor::run(const Job& job) const {
  Pool& pool = *pool_;
  EYRIE_DEMAND(!pool.in_use.test_and_set(), "one for_chunks at a time");
  pool.job = job;
  pool.unfinished.store(chunk_count(job.rows));
  pool.unclaimed.store(chunk_count(job.rows));
  pool.work_bell.ring();
  pool.work();
  pool.done_bell.wait(pool.spin, [&pool] { return pool.unfinished.load() == 0; });
  pool.in_use.clear();
}

}  // namespace eyrie
