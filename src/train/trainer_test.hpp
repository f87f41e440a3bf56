// SPDX-License-Identifier: MIT
#pragma once
/// \file  For tests only: environments to train in.
#include "core/draw.hpp"
#include "scenario/source.hpp"
#include "train/vector_env.hpp"

namespace eyrie::train {

/// Environments with their arrays, and random actions for them.
struct Trainer {
  VectorEnv env;
  std::vector<float> observations, last_observations, rewards;
  std::vector<std::uint8_t> masks, last_masks, alive, terminated, truncated, over;
  std::vector<float> actions;
  std::uint64_t decisions = 0;

  Trainer(TaskSpec task, const Options& options)
      : env(std::move(task), scenario::Source::disk("."), options) {
    const Shape& s = env.shape();
    const std::size_t agents = s.envs * s.agents;
    observations.resize(agents * s.observation);
    last_observations.resize(agents * s.observation);
    masks.resize(agents * s.action);
    last_masks.resize(agents * s.action);
    for (auto* one : {&alive, &terminated, &truncated})
      one->resize(agents);
    rewards.resize(agents);
    over.resize(s.envs);
    actions.resize(agents * s.action);
    env.reset(options.seed, arrays());
  }
  Arrays arrays() {
    return {observations,      masks,     alive, rewards, terminated, truncated, over,
            last_observations, last_masks};
  }
  /// Each is a function of the number of the decision and its place.
  void act() {
    const Shape& s = env.shape();
    for (std::size_t i = 0; i < actions.size(); ++i) {
      Draw draw(7, PlayerId{static_cast<std::uint32_t>(i + 1)}, Stream::test, decisions / 10);
      actions[i] = alive[i / s.action] ? static_cast<float>(draw.uniform(-1, 1)) : 0;
    }
    ++decisions;
  }
  void step() {
    act();
    env.step(actions, arrays());
  }
  /// Everything that a caller can see, in one number after another.
  std::vector<float> seen() const {
    std::vector<float> all = observations;
    all.insert(all.end(), last_observations.begin(), last_observations.end());
    all.insert(all.end(), rewards.begin(), rewards.end());
    for (const auto* one : {&masks, &alive, &terminated, &truncated, &over})
      all.insert(all.end(), one->begin(), one->end());
    return all;
  }
};

}  // namespace eyrie::train
