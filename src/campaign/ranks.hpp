// SPDX-License-Identifier: MIT
#pragma once
/// \file  A crew of several processes: rank 0 hands out replicates, keeps the results in order, and
/// flies as the others do.
#include <condition_variable>
#include <deque>
#include <thread>

#include "campaign/engine.hpp"
#include "campaign/link.hpp"

namespace eyrie::campaign {

/// A replicate to be flown, and its place in what is taken.
struct Job {
  std::uint64_t round = 0, index = 0, cell = 0, replicate = 0;
};
/// What came of it: a result, or why there is none.
struct Done {
  Job job;
  Result result;
  std::exception_ptr thrown;
};

/// The threads of one process. They fly what is put into it.
class Pool {
 public:
  using Work = std::function<Result(std::uint64_t cell, std::uint64_t replicate)>;
  Pool(unsigned workers, Work work);
  /// Finishes what has been begun, and begins no more.
  ~Pool();

  [[nodiscard]] unsigned workers() const { return static_cast<unsigned>(threads_.size()); }
  void put(const Job& job);
  [[nodiscard]] std::optional<Done> take();

 private:
  void help();

  Work work_;
  std::mutex mutex_;
  std::condition_variable some_;
  std::deque<Job> jobs_;
  std::deque<Done> done_;
  bool ending_ = false;
  std::vector<std::jthread> threads_;
};

/// Flies for rank 0 until that is done. `origin` is a hash of what is flown.
void serve(Link& link, Pool& pool, std::uint64_t origin);

/// Tells rank 0 why this one cannot fly.
void fail(Link& link, std::string_view words);

/// Rank 0 of the link with its own pool and all others.
class Ranks final : public Crew {
 public:
  Ranks(Link& link, Pool& pool, std::uint64_t origin);

  /// Throws what its own work throws; std::runtime_error if that of another rank throws, and if one
  /// cannot fly or has another origin.
  void fly(std::span<const Batch> batches, const Take& take) override;

 private:
  struct Rank {
    std::uint64_t workers = 0;  ///< 0: it has not said
    std::uint64_t given = 0;    ///< jobs that it has
  };
  void listen();
  void keep(std::size_t rank, Done&& done);

  Link& link_;
  Pool& pool_;
  std::uint64_t origin_;
  std::vector<Rank> ranks_;
  std::uint64_t round_ = 0;
  std::map<std::uint64_t, Done> waiting_;  ///< by index
};

}  // namespace eyrie::campaign
