// SPDX-License-Identifier: MIT
#pragma once
/// \file  Flies a campaign: what is flown next, by whom, and when it is enough. The results depend
/// on the campaign alone, not on who flies, how often it was interrupted, or when.
#include <list>
#include <mutex>

#include "campaign/measure.hpp"
#include "campaign/store.hpp"

namespace eyrie::campaign {

/// The replicates first, first + step, ... of a cell, `count` of them.
struct Batch {
  std::uint64_t cell = 0, first = 0, count = 0, step = 1;
};

/// Batches one behind the other.
class Plan {
 public:
  explicit Plan(std::span<const Batch> batches);
  [[nodiscard]] std::uint64_t size() const { return ends_.empty() ? 0 : ends_.back(); }
  struct Place {
    std::uint64_t cell, replicate;
  };
  [[nodiscard]] Place operator[](std::uint64_t i) const;

 private:
  std::span<const Batch> batches_;
  std::vector<std::uint64_t> ends_;  ///< of each batch, in all
};

/// Whoever flies: threads of this process, or other processes.
class Crew {
 public:
  using Take = std::function<bool(Result&&)>;
  virtual ~Crew() = default;
  /// Gives every result to `take`, in the calling thread and in order, until that is false.
  virtual void fly(std::span<const Batch> batches, const Take& take) = 0;
};

/// The scenarios of the cells that were asked for last, each loaded once. For any thread.
class Scenarios {
 public:
  Scenarios(const Spec& spec, std::span<const Cell> cells, Load load, std::size_t kept)
      : spec_(spec), cells_(cells), load_(std::move(load)), kept_(kept) {}
  [[nodiscard]] std::shared_ptr<const scenario::Scenario> of(std::uint64_t cell);

 private:
  struct Loaded {
    std::uint64_t cell;
    std::once_flag once{};
    std::shared_ptr<const scenario::Scenario> scenario{};
  };
  const Spec& spec_;
  std::span<const Cell> cells_;
  Load load_;
  std::size_t kept_;
  std::mutex mutex_;
  std::mutex loading_;  ///< what a plug-in does when it is added need not be safe for threads
  std::list<std::shared_ptr<Loaded>> last_;  ///< the last one first
};

/// Flies one. What it throws becomes its fault; the lack of memory is none of it. `given_up`, if
/// any, ends it as Outcome::stopped.
[[nodiscard]] Result fly_replicate(const Spec& spec, Scenarios& scenarios, std::uint64_t cell,
                                   std::uint64_t replicate, bool (*given_up)() = nullptr);

/// The cell and replicate that this thread flies now, for the last words of a plug-in that ends
/// the program.
[[nodiscard]] std::optional<std::pair<std::uint64_t, std::uint64_t>> flying_now();

/// Threads of this process.
class Threads final : public Crew {
 public:
  Threads(const Spec& spec, std::span<const Cell> cells, Load load, unsigned workers,
          bool (*given_up)() = nullptr)
      : spec_(spec),
        scenarios_(spec, cells, std::move(load), workers + 1),
        workers_(workers),
        given_up_(given_up) {}
  void fly(std::span<const Batch> batches, const Take& take) override;

 private:
  const Spec& spec_;
  Scenarios scenarios_;
  unsigned workers_;
  bool (*given_up_)();
};

/// How far a campaign is.
struct Standing {
  std::uint64_t done = 0;               ///< replicates, of all sessions
  std::uint64_t most = 0;               ///< replicates there can be
  std::uint64_t now = 0;                ///< replicates of this session
  std::uint64_t cell = 0;               ///< of the last one
  const Result* last = nullptr;         ///< that one, which is in the store
  const Estimator* estimate = nullptr;  ///< of the first measure, or that of the rule, in that cell
};

enum class Ended : std::uint8_t { complete, stopped, budget };
constexpr auto names_of(Ended) {
  return names_from_zero<Ended>("complete", "interrupted", "at the end of its budget");
}

/// Flies what is missing in the store, and tells of every result. What was taken up before is flown
/// again once first: throws disk::Refused if this program gives another result. A measure's
/// interval is looked at after fixed numbers of replicates only.
Ended run(const Spec& spec, std::span<const Cell> cells, Store& store, Crew& crew,
          const std::function<void(const Standing&)>& tell);

}  // namespace eyrie::campaign
