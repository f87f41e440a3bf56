// SPDX-License-Identifier: MIT
#pragma once
/// \file  Many worlds of one task, stepped together: actions in, observations and rewards out.
#include <stdexcept>

#include "core/executor.hpp"
#include "pilot/policy/controls.hpp"
#include "pilot/policy/observation.hpp"
#include "record/run_file.hpp"
#include "scenario/mission.hpp"
#include "scenario/scenario.hpp"
#include "sim/simulation.hpp"
#include "train/task.hpp"

namespace eyrie::train {

/// Sizes of the arrays.
struct Shape {
  std::size_t envs = 0, agents = 0, observation = 0, action = 0;
};

/// What comes of a call, all written by each and always at the same place in memory. Rows are in
/// the order environment, agent, number.
struct Results {
  explicit Results(const Shape& shape);

  std::vector<float> observations;       ///< envs x agents x observation, in [-1, 1]; 0 of the dead
  std::vector<std::uint8_t> masks;       ///< envs x agents x action: 1 if it could do anything now
  std::vector<std::uint8_t> alive;       ///< envs x agents
  std::vector<float> rewards;            ///< envs x agents
  std::vector<std::uint8_t> terminated;  ///< envs x agents: killed, home, or the fight is decided
  std::vector<std::uint8_t> truncated;   ///< envs x agents: alive when the time was up
  std::vector<std::uint8_t> over;        ///< envs: the episode was, and the next one has begun
  std::vector<float> last_observations;  ///< as observations, of the episodes that are over; else 0
  std::vector<std::uint8_t> last_masks;  ///< as masks, likewise
};

/// A step that an environment could not make.
struct Faulted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Options {
  std::size_t envs = 1;
  unsigned workers = 1;           ///< threads, the calling one included; they change speed alone
  std::uint64_t seed = 1;         ///< of the seeds of all episodes
  std::size_t keep_episodes = 1;  ///< so many of the first environments can give run files
};

/// An episode that is over.
struct Finished {
  std::uint64_t seed = 0;
  std::uint64_t steps = 0;  ///< of the world; 0: there is none yet
  scenario::Outcome outcome = scenario::Outcome::running;
};

/// N worlds of one task. A decision of every learner, at the scenario's rate, is one step.
///
/// An action is a number in [-1, 1] for each control or vote, see pilot::Controls; what is beyond
/// is taken as the bound. It becomes an order (manual, or vote) of the step in which the first
/// learner decides, so that the orders of an episode are its recording. The observation is what the
/// agent perceives between two steps. An episode ends when the scenario does, or when no learner is
/// left; then the next one begins in the same call (same-step auto-reset).
///
/// The same (task, seed, actions) give the same bits whatever the number of workers. A step
/// allocates nothing, not even where an episode begins.
///
/// Misuse (actions of another size, one that is NaN, one of a dead agent that is not 0) throws
/// std::invalid_argument with words before anything is changed. A scenario's mistakes throw
/// ConfigError, the constructor's others std::invalid_argument. A step that cannot be finished (a
/// node that throws), also of those that an episode begins with, throws Faulted; then
/// only reset() and reset_one() go on.
class VectorEnv {
 public:
  VectorEnv(TaskSpec task, scenario::Source source, const Options& options);
  ~VectorEnv();
  VectorEnv(VectorEnv&&) noexcept;
  VectorEnv& operator=(VectorEnv&&) noexcept;

  [[nodiscard]] const TaskSpec& task() const { return task_; }
  [[nodiscard]] const Shape& shape() const { return shape_; }
  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] const scenario::Scenario& scenario() const { return *scenario_; }
  [[nodiscard]] const pilot::Observation& observation() const { return observation_; }
  /// Without any if the actions are votes.
  [[nodiscard]] const pilot::Controls& controls() const { return controls_; }
  /// Of each number of an action: a control, or the path of the node whose vote it is.
  [[nodiscard]] std::span<const std::string> action_names() const { return action_names_; }
  /// s, from decision to decision.
  [[nodiscard]] double seconds() const { return seconds_; }

  /// Begins the first episode of every environment, as after construction with that seed.
  void reset(std::uint64_t seed);
  /// Begins an episode of one environment with a seed of its own; the others go on.
  void reset_one(std::size_t env, std::uint64_t seed);
  /// `actions`: envs x agents x action.
  void step(std::span<const float> actions);
  /// Of the last of these calls, or of restore(); whoever holds them may outlive this object.
  [[nodiscard]] std::shared_ptr<const Results> results() const { return results_; }

  /// Seed of the episode that goes on.
  [[nodiscard]] std::uint64_t seed(std::size_t env) const;
  /// The last one that is over.
  [[nodiscard]] const Finished& finished(std::size_t env) const;
  [[nodiscard]] const sim::World& world(std::size_t env) const;

  /// Everything that changes, to go on from there again; good for this object and for others of the
  /// same task and number of environments.
  struct Slot;
  struct Snapshot {
    std::uint64_t task = 0, seed = 0;  ///< task: hash of all that decides how an episode goes
    std::vector<Slot> slots;
  };
  [[nodiscard]] std::shared_ptr<const Snapshot> save() const;
  void restore(const Snapshot& snapshot);

  /// The episode that goes on, or the last one that is over, as a run file for replay, explain and
  /// the debrief page. It is flown once more for that. std::invalid_argument if it is not kept.
  [[nodiscard]] record::RunFile episode(std::size_t env, bool last_one = false) const;

 private:
  struct Lane;
  struct Learner {
    PlayerId id;
    std::vector<std::uint16_t> nodes;  ///< 1 + index, whose votes are the actions
  };
  struct Choice {
    PlayerId player;
    std::vector<std::uint16_t> trees;
  };

  [[nodiscard]] std::uint64_t hash_of_task() const;
  [[nodiscard]] const Slot& slot(std::size_t env) const;
  void read_learners();
  void read_opponents();
  void check_actions(std::span<const float> actions) const;
  /// Begins an episode and flies until everybody has perceived something and it is the learner's
  /// turn.
  void begin(Slot& slot, std::uint64_t seed, Lane& lane) const;
  /// Left in the drum of a learner; nothing once he is gone.
  [[nodiscard]] std::optional<std::uint32_t> rounds_of(const sim::World& world,
                                                       std::size_t agent) const;
  void end(Slot& slot) const;
  [[nodiscard]] std::uint64_t next_seed(std::size_t env) const;
  void command(Slot& slot, std::size_t agent, const float* action,
               std::vector<sim::Order>& orders) const;
  void advance(std::span<Slot> group, Lane& lane, const float* actions) const;
  void order(Slot& slot, std::vector<sim::Order>& orders, const float* actions) const;
  void look(Slot& slot, scenario::Judge& judge, const sim::Workspace& work) const;
  void judge(Slot& slot, std::size_t env, Lane& lane);
  void tell_fault(std::size_t env) const;
  /// Calls `use(lane, env, next)` with runs of environments that are stepped together, on all
  /// cores.
  template <class Use>
  void each_run(Use use);
  void show(std::size_t env);
  void show_now(std::size_t env);
  void observe(Slot& slot, std::size_t agent, float* observation, std::uint8_t* mask) const;

  TaskSpec task_;
  Options options_;
  std::shared_ptr<const scenario::Scenario> scenario_;
  pilot::Observation observation_;
  pilot::Controls controls_;
  std::vector<std::string> action_names_;
  std::vector<Learner> learners_;
  std::vector<Choice> choices_;
  Shape shape_;
  std::shared_ptr<Results> results_;
  std::uint32_t period_ = 5;  ///< steps of the world
  std::uint32_t lead_ = 0;    ///< of its steps, until the first learner decides
  double seconds_ = 0.1;
  std::uint64_t hash_ = 0;  ///< of the task
  std::size_t room_ = 0;    ///< for the orders of the longest episode
  std::vector<Slot> slots_;
  std::vector<std::unique_ptr<Lane>> lanes_;  ///< one for each worker
  std::unique_ptr<Executor> executor_;
};

}  // namespace eyrie::train
