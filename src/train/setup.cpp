// SPDX-License-Identifier: MIT
/// \file  From a task to environments: who learns, what an action is, against whom.
#include <algorithm>
#include <bit>
#include <fstream>
#include <limits>

#include "core/hash.hpp"
#include "train/slot.hpp"
#include "train/vector_env.hpp"

namespace eyrie::train {
namespace {

/// Bytes that this program can still take: what the machine has left, at most what the group of
/// processes that it is in may have; infinity where neither is told.
double memory_left() {
  double left = std::numeric_limits<double>::infinity();
  std::ifstream machine("/proc/meminfo");
  for (std::string word; machine >> word;)
    if (double kB = 0; word == "MemAvailable:" && machine >> kB)
      left = kB * 1024;
  if (double most = 0; std::ifstream("/sys/fs/cgroup/memory.max") >> most)
    left = std::min(left, most);
  return left;
}

/// Refuses what would make the system end the program on the way.
void check_memory(std::size_t envs, double bytes) {
  if (const double left = memory_left(); bytes > left)
    refuse("{} environments need {:.1f} GB, and {:.1f} GB are left", envs, bytes / 1e9, left / 1e9);
}

}  // namespace

Results::Results(const Shape& s)
    : observations(s.envs * s.agents * s.observation),
      masks(s.envs * s.agents * s.action),
      alive(s.envs * s.agents),
      rewards(alive.size()),
      terminated(alive.size()),
      truncated(alive.size()),
      over(s.envs),
      last_observations(observations.size()),
      last_masks(masks.size()) {}

VectorEnv::VectorEnv(TaskSpec task, scenario::Source source, const Options& options)
    : task_(std::move(task)),
      options_(options),
      scenario_(scenario::load({task_.scenario, task_.sets}, std::move(source))),
      observation_(task_.observation, {"observation", 1, 1}) {
  constexpr std::size_t kMostEnvs = 1'000'000;  // of some 50 kB each
  if (options_.envs == 0 || options_.envs > kMostEnvs)
    refuse("{} environments: there can be 1 to {}", options_.envs, kMostEnvs);
  if (options_.workers == 0 || options_.workers > 256)
    refuse("{} workers: there can be 1 to 256", options_.workers);
  if (task_.controls.empty() == !task_.votes)
    refuse("a task has controls or votes, one of them");
  if (!task_.votes)
    controls_ = pilot::Controls(task_.controls, {"controls", 1, 1});
  for (const Reward& r : task_.rewards) {
    constexpr double kMostWeight = 1e9;  // rewards are single precision
    if (!(std::fabs(r.weight) <= kMostWeight))
      refuse("reward {}: its weight {} is outside [-1e9, 1e9]", enum_name(r.term), r.weight);
    if ((r.low != 0 || r.high != 0) && !has_range(r.term))
      refuse("reward {} has no range", enum_name(r.term));
    if (!(r.low <= r.high) || !std::isfinite(r.high - r.low) ||
        (r.term == Term::closing && !(r.high > 0)))
      refuse("reward {}: {} to {} is no range", enum_name(r.term), r.low, r.high);
    if (r.high == 0 &&
        (r.term == Term::closeness || r.term == Term::low || r.term == Term::formation))
      refuse("reward {} needs a range: it is 1 up to its low end, 0 from its high end on",
             enum_name(r.term));
  }
  for (const pilot::Control& control : controls_.items())
    action_names_.emplace_back(control.info().name);
  read_learners();
  read_opponents();
  const double dt = scenario_->simulation->dt();
  period_ = sim::period_steps(scenario_->spec.rates.decisions, dt).steps;
  // by then everybody has perceived something
  for (lead_ = period_; !sim::due(lead_, learners_.front().id, period_);)
    ++lead_;
  seconds_ = period_ * dt;
  shape_ = {options_.envs, learners_.size(), observation_.size(), action_names_.size()};

  const auto decisions =
      static_cast<std::size_t>(scenario_->spec.until / seconds_ + 2) * learners_.size();
  room_ = scenario_->orders.size() + choices_.size() +
          decisions * (task_.votes ? action_names_.size() : 1);
  constexpr std::size_t kArrays = 3, kSlack = 1024;  // last ones and copies too; of the heap
  const std::size_t world =
      scenario_->simulation->schema().bytes() + sizeof(Slot) + kSlack +
      shape_.agents *
          (sizeof(Slot::Agent) + kArrays * sizeof(float) * (shape_.observation + shape_.action));
  const std::size_t episodes =
      std::min(options_.envs, options_.keep_episodes) * 2 * room_ * sizeof(sim::Order);
  check_memory(options_.envs, static_cast<double>(options_.envs) * static_cast<double>(world) +
                                  static_cast<double>(episodes));
  results_ = std::make_shared<Results>(shape_);
  for (std::size_t env = 0; env < options_.envs; ++env)
    slots_.emplace_back(*scenario_, learners_.size(), task_.votes ? action_names_.size() : 0,
                        env < options_.keep_episodes ? room_ : 0);
  const std::size_t lanes = std::min<std::size_t>(options_.envs, options_.workers);
  const std::size_t at_once = scenario_->orders.size() + choices_.size() +
                              learners_.size() * std::max<std::size_t>(1, action_names_.size());
  for (std::size_t i = 0; i < lanes; ++i)
    lanes_.push_back(std::make_unique<Lane>(*scenario_, at_once));
  executor_ = std::make_unique<Executor>(options_.workers);
  reset(options_.seed);
  hash_ = hash_of_task();
}

VectorEnv::~VectorEnv() = default;
VectorEnv::VectorEnv(VectorEnv&&) noexcept = default;
VectorEnv& VectorEnv::operator=(VectorEnv&&) noexcept = default;

std::uint64_t VectorEnv::hash_of_task() const {
  Hasher hash;
  const auto add = [&](std::string_view text) {
    hash.word(text.size());
    hash.bytes(text.data(), text.size());
  };
  const auto add_all = [&](const auto& texts) {
    hash.word(texts.size());
    for (const auto& text : texts)
      add(text);
  };
  for (const auto& [name, text] : scenario_->files) {
    add(name);
    add(text);
  }
  add_all(task_.sets);
  add_all(task_.learners);
  add_all(action_names_);
  for (const Opponent& opponent : task_.opponents) {
    add(opponent.player);
    add_all(opponent.trees);
  }
  hash.word(controls_.hash());
  hash.word(task_.votes ? std::bit_cast<std::uint64_t>(task_.votes->most) : 0);
  return hash.value();
}

void VectorEnv::read_learners() {
  if (task_.learners.empty())
    refuse("nobody learns: name a learner");
  for (const std::string& name : task_.learners) {
    const auto id = scenario_->roster.find(name);
    if (!id)
      refuse("learner: {}", scenario_->roster.unknown(name));
    const auto row = scenario_->start->row(scenario_->aircraft.table, *id);
    if (!row || scenario_->roster.find(*id)->remote)
      refuse("learner {} is no aircraft of this program", quote(name));
    for (const Learner& other : learners_)
      if (other.id == *id)
        refuse("learner {} is named twice", quote(name));
    const std::uint16_t tree = scenario_->start->rows(scenario_->pilots.agent)[*row].tree;
    if (tree == pilot::kNoTree)
      refuse(
          "learner {} has no tree: what is asked of it goes through its tree, if "
          "only one of navigate",
          quote(name));
    Learner learner{.id = *id, .nodes = {}};
    if (task_.votes) {
      const pilot::Tree& flown = (*scenario_->trees)[tree];
      const std::vector<std::string> paths = flown.paths();
      const auto arbiter = flown.find(task_.votes->arbiter);
      if (!arbiter)
        refuse("votes: tree {} of {} has no node {}{}", quote(flown.name()), name,
               quote(task_.votes->arbiter), nearest_or_all(task_.votes->arbiter, paths));
      std::vector<std::string> voters;
      for (const auto& child : flown.node(*arbiter).children()) {
        learner.nodes.push_back(static_cast<std::uint16_t>(child->index() + 1));
        voters.push_back(paths[child->index()]);
      }
      if (voters.empty() || voters.size() > model::Tasking::kVotes)
        refuse("votes: {} has {} children, there can be 1 to {}", quote(task_.votes->arbiter),
               voters.size(), model::Tasking::kVotes);
      if (!(task_.votes->most > 0 && task_.votes->most <= 1000))
        refuse("votes: {} is outside (0, 1000]", task_.votes->most);
      if (learners_.empty())
        action_names_ = voters;
      else if (action_names_ != voters)
        refuse("votes: {} and {} fly by trees with other children there", task_.learners.front(),
               name);
    }
    learners_.push_back(std::move(learner));
  }
}

void VectorEnv::read_opponents() {
  for (const Opponent& opponent : task_.opponents) {
    const auto id = scenario_->roster.find(opponent.player);
    if (!id)
      refuse("opponent: {}", scenario_->roster.unknown(opponent.player));
    if (scenario_->roster.find(*id)->fleet != 0)
      refuse("opponent: {} is no aircraft", quote(opponent.player));
    for (const Learner& learner : learners_)
      if (learner.id == *id)
        refuse("opponent: {} learns", quote(opponent.player));
    if (opponent.trees.empty())
      refuse("opponent {}: name a tree", quote(opponent.player));
    Choice choice{.player = *id, .trees = {}};
    for (const std::string& name : opponent.trees) {
      const auto tree = scenario_->trees->find(name);
      if (!tree)
        refuse("opponent {}: there is no tree {}{}", quote(opponent.player), quote(name),
               nearest_or_all(name, listed(*scenario_->trees, &pilot::Tree::name)));
      choice.trees.push_back(*tree);
    }
    choices_.push_back(std::move(choice));
  }
}

}  // namespace eyrie::train
