// SPDX-License-Identifier: MIT
/// \file  Environments for learners: many worlds of one task, stepped at once.
#include <unistd.h>

#include "common.hpp"
#include "core/enum_names.hpp"
#include "core/hash.hpp"
#include "pilot/policy/policy_file.hpp"
#include "train/vector_env.hpp"

namespace eyrie::python {
namespace {

/// Everything of an environment that changes.
struct Saved {
  std::shared_ptr<const train::VectorEnv::Snapshot> snapshot;
};

/// One native environment with what it writes into, which outlives it.
class VectorEnv {
 public:
  VectorEnv(train::TaskSpec task, scenario::Source source, const train::Options& options)
      : env_(new train::VectorEnv(std::move(task), std::move(source), options)),
        shape_(env_->shape()),
        results_(env_->results()) {}
  /// Threads do not live on in a child of fork(): nobody may wait for them there.
  ~VectorEnv() {
    if (is_forked())
      static_cast<void>(env_.release());
  }
  VectorEnv(const VectorEnv&) = delete;
  VectorEnv& operator=(const VectorEnv&) = delete;

  void reset(std::uint64_t seed) {
    const InUse used = use();
    const GilReleased released;
    env_->reset(seed);
  }
  void step(const nb::ndarray<const float, nb::ndim<3>, nb::c_contig, nb::device::cpu>& actions) {
    if (actions.shape(0) != shape_.envs || actions.shape(1) != shape_.agents ||
        actions.shape(2) != shape_.action)
      refuse("actions: shape ({}, {}, {}) is not ({}, {}, {})", actions.shape(0), actions.shape(1),
             actions.shape(2), shape_.envs, shape_.agents, shape_.action);
    const InUse used = use();
    const std::span<const float> numbers(actions.data(), actions.size());
    const GilReleased released;
    env_->step(numbers);
  }
  /// Ends its threads and frees its worlds; the arrays stay.
  void close() {
    if (is_forked()) {
      static_cast<void>(env_.release());
    } else if (env_) {
      const InUse used = use();
      env_.reset();
    }
  }
  [[nodiscard]] Saved save() const {
    const InUse used = use();
    return {env_->save()};
  }
  void restore(const Saved& saved) {
    const InUse used = use();
    env_->restore(*saved.snapshot);
  }
  /// The run of the episode in a world, so far or that ended last.
  [[nodiscard]] Recorded episode(std::size_t world, bool last) const {
    const InUse used = use();
    const GilReleased released;
    debrief::Opened opened =
        debrief::open(env_->episode(world, last), "episode", {}, version_text());
    if (!opened.recorded)
      throw std::runtime_error(fmt::format("{}", fmt::join(opened.problems, "\n")));
    return {std::move(*opened.recorded)};
  }

  /// Properties of what reset() and step() write, which keep the environment: by world, by world
  /// and learner, or by world, learner and number.
  static void add_arrays(nb::class_<VectorEnv>& c) {
    const auto add = [&]<class T>(const char* name, std::vector<T> train::Results::*values,
                                  std::size_t dimensions, const char* help) {
      c.def_prop_ro(
          name,
          [=](nb::handle_t<VectorEnv> self) {
            const auto& env = nb::cast<const VectorEnv&>(self);
            const auto& [envs, agents, observation, action] = env.shape_;
            const auto& all = *env.results_.*values;
            const std::array shape{envs, agents, all.size() / (envs * agents)};
            return nb::ndarray<nb::numpy, const T>(all.data(), dimensions, shape.data(), self);
          },
          help);
    };
    using train::Results;
    add("observations", &Results::observations, 3, "(worlds, learners, numbers)");
    add("last_observations", &Results::last_observations, 3,
        "As observations, of the episodes that are over; else 0.");
    add("rewards", &Results::rewards, 2, "(worlds, learners)");
    add("alive", &Results::alive, 2, "(worlds, learners), 0 or 1");
    add("terminated", &Results::terminated, 2, "(worlds, learners), 0 or 1");
    add("truncated", &Results::truncated, 2, "(worlds, learners), 0 or 1");
    add("over", &Results::over, 1, "(worlds,): 1 if the episode was.");
    add("masks", &Results::masks, 3,
        "(worlds, learners, actions): 1 where the action can do anything now.");
    add("last_masks", &Results::last_masks, 3, "As masks, of the episodes that are over; else 0.");
  }
  [[nodiscard]] const train::VectorEnv& env() const {
    demand_open();
    return *env_;
  }

 private:
  /// While it lives nobody else may use the environment.
  [[nodiscard]] InUse use() const {
    demand_open();
    if (is_forked())
      raise("Error",
            "an environment of several threads does not live on in a forked process: make it "
            "there");
    return {in_use_, "this environment is being stepped by another thread"};
  }

  void demand_open() const {
    if (!env_)
      raise("Error", "this environment is closed");
  }
  [[nodiscard]] bool is_forked() const {
    return env_ && env_->options().workers > 1 && process_ != ::getpid();
  }

  std::unique_ptr<train::VectorEnv> env_;
  pid_t process_ = ::getpid();  ///< in which its threads are
  train::Shape shape_;
  std::shared_ptr<const train::Results> results_;
  mutable bool in_use_ = false;
};

/// "blue.flights.viper.players.viper1.privileged=true" of every learner.
std::vector<std::string> privileges(const train::VectorEnv& env) {
  std::vector<std::string> sets;
  const scenario::Roster& roster = env.scenario().roster;
  for (const std::string& name : env.task().learners) {
    const auto& player = *roster.find(*roster.find(name));
    sets.push_back(fmt::format("{}.flights.{}.players.{}.privileged=true",
                               scenario::side_name(player.side), roster.flights[player.flight].name,
                               name));
  }
  return sets;
}

using Opponents = std::map<std::string, std::vector<std::string>>;
/// Weight, and the range or nothing.
using Rewards = std::map<std::string, std::pair<double, std::optional<std::pair<double, double>>>>;

/// Other weights of the task's terms, and terms that it does not have; a weight of 0 takes one
/// away.
void change(std::vector<train::Reward>& rewards, const Rewards& changes) {
  static constexpr auto kNames = enum_names<train::Term>();
  for (const auto& [name, change] : changes) {
    const auto term = enum_named<train::Term>(name);
    if (!term)
      refuse("rewards: there is no term {}{}", quote(name), nearest_or_all(name, kNames));
    auto found = std::find_if(rewards.begin(), rewards.end(),
                              [&](const train::Reward& r) { return r.term == *term; });
    if (found == rewards.end())
      found = rewards.insert(found, {.term = *term});
    found->weight = change.first;
    if (change.second)
      std::tie(found->low, found->high) = *change.second;
  }
  std::erase_if(rewards, [](const train::Reward& r) { return r.weight == 0; });
}

/// The words of a policy's file that say what it sees and commands.
std::map<std::string, std::string> policy_words(const train::VectorEnv& env) {
  std::map<std::string, std::string> words{
      {"eyrie_policy", std::string(pilot::PolicyFile::kVersion)},
      {"observation", env.observation().text()},
      {"observation_hash", hash_text(env.observation().hash())}};
  if (!env.task().votes) {
    words["controls"] = env.controls().text();
    words["controls_hash"] = hash_text(env.controls().hash());
  } else {
    words["votes"] = enum_name(pilot::Votes::linear);
  }
  return words;
}

std::unique_ptr<VectorEnv> make(const std::string& name, const std::vector<std::string>& sets,
                                const Opponents& opponents, const Rewards& rewards,
                                std::size_t envs, unsigned workers, bool privileged,
                                const std::string& home, const std::vector<std::string>& allowed) {
  const GilReleased released;
  train::TaskSpec spec = train::task(name);
  spec.scenario = scenario::Source::kOwn + spec.scenario;  // below home, wherever we are
  spec.sets.insert(spec.sets.end(), sets.begin(), sets.end());
  if (!opponents.empty())
    spec.opponents.clear();
  for (const auto& [player, trees] : opponents)
    spec.opponents.push_back({player, trees});
  change(spec.rewards, rewards);
  if (privileged) {
    const train::VectorEnv plain(spec, scenario::Source::disk(home, allowed), {});
    for (std::string& set : privileges(plain))
      spec.sets.push_back(std::move(set));
  }
  return std::make_unique<VectorEnv>(std::move(spec), scenario::Source::disk(home, allowed),
                                     train::Options{.envs = envs, .workers = workers});
}

}  // namespace

void add_env(nb::module_& m) {
  using nb::arg;
  m.def(
      "tasks",
      [] {
        std::map<std::string, std::string> all;
        for (const train::TaskSpec& task : train::tasks())
          all.emplace(task.name, task.help);
        return all;
      },
      "The tasks that come with Eyrie: name -> what it is.");
  m.def(
      "task_learners", [](const std::string& name) { return train::task(name).learners; },
      arg("task"), "Who learns in a task.");
  m.def("vector_env", &make, arg("task"), arg("sets"), arg("opponents"), arg("rewards"),
        arg("envs"), arg("workers"), arg("privileged"), arg("home"), arg("allowed"),
        "Many worlds of a task.");
  nb::class_<Saved>(m, "SavedEnv", "Everything of an environment that changes.");
  nb::class_<VectorEnv> envs(m, "VectorEnv", "Many worlds of one task, stepped at once.");
  VectorEnv::add_arrays(envs);
  envs.def("reset", &VectorEnv::reset, arg("seed"), "Begins an episode in every world.")
      .def("step", &VectorEnv::step, arg("actions"),
           "One decision of everybody: (worlds, learners, actions) numbers in [-1, 1].")
      .def("close", &VectorEnv::close, "Ends its threads and frees its worlds.")
      .def("save", &VectorEnv::save, "Everything that changes.")
      .def("restore", &VectorEnv::restore, arg("saved"), "Goes on from there.")
      .def("episode", &VectorEnv::episode, arg("world"), arg("last"),
           "The run of an episode of one of the worlds that are kept.")
      .def_prop_ro(
          "learners", [](const VectorEnv& e) { return e.env().task().learners; }, "Who learns.")
      .def_prop_ro(
          "actions",
          [](const VectorEnv& e) {
            const auto names = e.env().action_names();
            return std::vector<std::string>(names.begin(), names.end());
          },
          "What the numbers of an action mean.")
      .def_prop_ro(
          "policy_words", [](const VectorEnv& e) { return policy_words(e.env()); },
          "What a policy's file says of what it sees and does.");
}

}  // namespace eyrie::python
