// SPDX-License-Identifier: MIT
#include "campaign/engine.hpp"

#include <algorithm>

#include "campaign/in_order.hpp"
#include "core/diagnostics.hpp"
#include "core/hash.hpp"

namespace eyrie::campaign {
namespace {

/// The number of replicates after which a cell that has `n` is looked at next.
std::uint64_t next_look(const Spec& spec, std::uint64_t n) {
  if (!spec.stop)
    return spec.replicates;
  const Stopping& stop = *spec.stop;
  const std::uint64_t looks = n < stop.least ? 0 : (n - stop.least) / stop.every + 1;
  return std::min(stop.least + looks * stop.every, stop.most);
}

/// Whether a cell with `n` replicates needs no more.
bool enough(const Spec& spec, std::uint64_t cell, std::uint64_t n, const Estimator& estimator) {
  if (n >= most_of_part(spec, cell))
    return true;
  if (!spec.stop || n < spec.stop->least || (n - spec.stop->least) % spec.stop->every != 0)
    return false;
  const auto interval = estimator.estimate(spec.stop->confidence).interval;
  return interval && interval->width() <= spec.stop->width;
}

/// What is flown until the next look: of every cell that needs more, up to the same number, so that
/// it does not matter where an earlier process was interrupted.
std::vector<Batch> next_batches(const Spec& spec, std::span<const std::uint64_t> counts,
                                std::span<const Estimator> estimators) {
  std::vector<Batch> batches;
  std::uint64_t look = most_replicates(spec);
  for (std::size_t cell = 0; cell < counts.size(); ++cell)
    if (!enough(spec, cell, counts[cell], estimators[cell])) {
      batches.push_back({cell, counts[cell], 0});
      look = std::min(look, next_look(spec, counts[cell]));
    }
  std::erase_if(batches, [&](const Batch& batch) { return batch.first >= look; });
  for (Batch& batch : batches)
    batch = {batch.cell, spec.part.first(batch.cell) + batch.first * spec.part.of,
             std::min(look, most_of_part(spec, batch.cell)) - batch.first, spec.part.of};
  return batches;
}

bool within(const Budget& budget, const Store& store, std::uint64_t done) {
  return done < budget.replicates.value_or(done + 1) &&
         (!budget.time || store.seconds() < *budget.time);
}

/// Flies again what an earlier process flew.
void demand_the_same(const Result& before, Crew& crew) {
  const Batch batch{before.cell, before.replicate, 1};
  crew.fly({&batch, 1}, [&](Result&& now) {
    if (now.flown.outcome != scenario::Outcome::stopped && now.flown.hash != before.flown.hash)
      throw disk::Refused(
          "this program, or a plug-in, is another one than that which began the campaign: cell {}, "
          "replicate {} ends with the world {}, was {}",
          now.cell, now.replicate, hash_text(now.flown.hash), hash_text(before.flown.hash));
    return false;
  });
}

thread_local std::optional<std::pair<std::uint64_t, std::uint64_t>> in_the_air;

}  // namespace

std::shared_ptr<const scenario::Scenario> Scenarios::of(std::uint64_t cell) {
  std::shared_ptr<Loaded> loaded;
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find_if(last_, [&](const auto& l) { return l->cell == cell; });
    if (found == last_.end()) {
      last_.push_front(std::make_shared<Loaded>(cell));
      if (last_.size() > kept_)
        last_.pop_back();
    } else {
      last_.splice(last_.begin(), last_, found);
    }
    loaded = last_.front();
  }
  std::call_once(loaded->once, [&] {
    const std::lock_guard lock(loading_);
    loaded->scenario = load_(sets_of(spec_, cells_[cell]));
  });
  return loaded->scenario;
}

Result fly_replicate(const Spec& spec, Scenarios& scenarios, std::uint64_t cell,
                     std::uint64_t replicate, bool (*given_up)()) {
  Result result{.cell = cell, .replicate = replicate, .flown = {}};
  result.flown.seed = seed_of(spec, cell, replicate);
  in_the_air = {cell, replicate};
  const struct Landing {
    ~Landing() { in_the_air.reset(); }
  } landing;
  try {
    const auto scenario = scenarios.of(cell);
    const auto watching = watch(spec.measures, *scenario);
    result.flown = fly(scenario, result.flown.seed, watching.get(), {}, given_up);
    if (result.flown.fault.empty())
      result.values = watching->values(result.flown.outcome, result.flown.time);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    result.flown.outcome = scenario::Outcome::fault;
    result.flown.fault = e.what();
  }
  return result;
}

Plan::Plan(std::span<const Batch> batches) : batches_(batches) {
  for (const Batch& batch : batches)
    ends_.push_back(size() + batch.count);
}
Plan::Place Plan::operator[](std::uint64_t i) const {
  const auto b = static_cast<std::size_t>(std::ranges::upper_bound(ends_, i) - ends_.begin());
  const Batch& batch = batches_[b];
  return {batch.cell, batch.first + (i + batch.count - ends_[b]) * batch.step};
}

std::optional<std::pair<std::uint64_t, std::uint64_t>> flying_now() {
  return in_the_air;
}

void Threads::fly(std::span<const Batch> batches, const Take& take) {
  const Plan plan(batches);
  const auto work = [&](std::uint64_t i) {
    return fly_replicate(spec_, scenarios_, plan[i].cell, plan[i].replicate, given_up_);
  };
  in_order<Result>(plan.size(), workers_, work,
                   [&](std::uint64_t, Result&& result) { return take(std::move(result)); });
}

Ended run(const Spec& spec, std::span<const Cell> cells, Store& store, Crew& crew,
          const std::function<void(const Standing&)>& tell) {
  const Measure& measure = spec.measures.estimates[spec.stop ? spec.stop->measure : 0];
  std::vector<Estimator> estimators(cells.size(), Estimator(measure));
  std::uint64_t most = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
    most += most_of_part(spec, cell);
  Standing standing{.most = std::min(most, spec.budget.replicates.value_or(most))};
  std::optional<Result> earlier;
  store.each([&](const Result& result) {
    estimators[result.cell].add(result.values);
    ++standing.done;
    if (!earlier)
      earlier = result;
  });

  Ended ended = Ended::complete;
  const auto take = [&](Result&& result) {
    if (result.flown.outcome == scenario::Outcome::stopped) {
      ended = Ended::stopped;
      return false;
    }
    store.put(result);
    estimators[result.cell].add(result.values);
    ++standing.done;
    ++standing.now;
    standing.cell = result.cell;
    standing.last = &result;
    standing.estimate = &estimators[result.cell];
    tell(standing);
    if (!within(spec.budget, store, standing.done))
      ended = Ended::budget;
    return ended == Ended::complete;
  };
  while (ended == Ended::complete) {
    const auto batches = next_batches(spec, store.counts(), estimators);
    if (batches.empty())
      break;
    if (!within(spec.budget, store, standing.done))
      return Ended::budget;
    if (earlier)
      demand_the_same(*std::exchange(earlier, {}), crew);
    crew.fly(batches, take);
  }
  if (ended == Ended::budget && next_batches(spec, store.counts(), estimators).empty())
    ended = Ended::complete;  // with the last replicate that the budget allows
  store.flush();
  return ended;
}

}  // namespace eyrie::campaign
