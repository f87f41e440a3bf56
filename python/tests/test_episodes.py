# SPDX-License-Identifier: MIT
from __future__ import annotations

import gymnasium
import numpy as np
import pytest

from eyrie import envs


def test_an_episode_that_is_over_is_not_flown_on() -> None:
    env = envs.Env("merge", set={"until": "1 s"})
    env.reset(seed=1)
    saved = env.save()
    action = np.zeros(len(env.actions), np.float32)
    while not env.step(action)[3]:
        pass
    for late in (lambda: env.step(action), env.save):
        with pytest.raises(gymnasium.error.ResetNeeded, match="the episode is over"):
            late()
    env.restore(saved)
    env.step(np.full(len(action), 1e130))  # the bound, without a warning
    env.reset()
    env.step(action)


def test_who_learns_alone_goes_on_among_several() -> None:
    alone, several = envs.Env("merge"), envs.parallel("merge")
    alone.reset(seed=1)
    several.reset(seed=2)
    seen, _ = several.restore(alone.save())
    assert several.agents == several.possible_agents == list(seen)
    several.step({who: np.zeros(len(several.actions), np.float32) for who in several.agents})


def test_a_policy_of_ours_is_an_opponent_from_anywhere() -> None:
    env = envs.Env("merge", opponents={"bandit1": ["eyrie:scenarios/policies/merge.safetensors"]})
    env.reset(seed=1)
    env.step(np.zeros(env.action_space.shape, np.float32))
