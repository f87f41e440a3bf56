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
  std::shared_ptr<const Results> results = env.results();
  const std::vector<float>&observations = results->observations,
        &last_observations = results->last_observations, &rewards = results->rewards;
  const std::vector<std::uint8_t>&masks = results->masks, &last_masks = results->last_masks,
        &alive = results->alive, &terminated = results->terminated, &truncated = results->truncated,
        &over = results->over;
  std::vector<float> actions = std::vector<float>(masks.size());
  std::uint64_t decisions = 0;

  Trainer(TaskSpec task, const Options& options)
      : env(std::move(task), scenario::Source::disk("."), options) {
    env.reset(options.seed);
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
    env.step(actions);
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
