# SPDX-License-Identifier: MIT
"""Several learners in one world, for PettingZoo."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from pettingzoo import ParallelEnv

from ._arguments import whole
from ._native_env import Floats, Infos, Native, Played, Saved, as_actions

#: What step() gives, of each agent: observation, reward, terminated, truncated, info.
Results = tuple[
    dict[str, Floats], dict[str, float], dict[str, bool], dict[str, bool], dict[str, Infos]
]


class Parallel(Played, ParallelEnv[str, Floats, Floats]):  # type: ignore[misc]
    """Made by :func:`eyrie.envs.parallel`."""

    def __init__(self, task: str, native: Native) -> None:
        self.metadata = {"name": f"eyrie_{task.lower()}_v0", "render_modes": []}
        self.render_mode = None
        self._native = native
        self._seeds = np.random.default_rng()
        self.possible_agents = list(native.learners)
        self.agents: list[str] = []
        self.observation_spaces = {who: native.observation_space() for who in native.learners}
        self.action_spaces = {who: native.action_space() for who in native.learners}
        self._row = {who: row for row, who in enumerate(native.learners)}
        self._numbers = np.zeros((1, len(native.learners), len(native.actions)), np.float32)

    def observation_space(self, agent: str) -> Any:
        return self.observation_spaces[agent]

    def action_space(self, agent: str) -> Any:
        return self.action_spaces[agent]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, Floats], dict[str, Infos]]:
        """Begins an episode. There are no options; PettingZoo's own test gives some."""
        if seed is not None:
            self._seeds = np.random.default_rng(whole("seed", seed))
        self._native.core.reset(int(self._seeds.integers(2**32)))
        self.agents = list(self.possible_agents)
        return self._seen(self._native.observations), self._infos()

    def step(self, actions: dict[str, Floats]) -> Results:
        native = self._native
        if not self.agents:
            raise RuntimeError("nobody is in an episode: reset() begins one")
        if not isinstance(actions, Mapping):
            raise TypeError(f"actions: {actions!r} is no mapping of agents to actions")
        if strangers := [who for who in actions if who not in self._row]:
            raise ValueError(f"actions: {strangers[0]!r} is none of {', '.join(self.possible_agents)}")
        if missing := [who for who in self.agents if who not in actions]:
            raise ValueError(f"actions: there is none of {', '.join(missing)}")
        self._numbers[:] = 0
        for who in self.agents:
            self._numbers[0, self._row[who]] = as_actions(actions[who], self._numbers.shape[2:])
        native.core.step(self._numbers)
        terminated, truncated = native.terminated[0], native.truncated[0]
        over = bool(native.over[0])
        results = (
            self._seen(native.last_observations if over else native.observations),
            {who: float(native.rewards[0, self._row[who]]) for who in self.agents},
            {who: bool(terminated[self._row[who]]) for who in self.agents},
            {who: bool(truncated[self._row[who]]) for who in self.agents},
            self._infos(over),
        )
        self.agents = [
            who
            for who in self.agents
            if not (over or terminated[self._row[who]] or truncated[self._row[who]])
        ]
        return results

    def save(self) -> Saved:
        """Where the episode stands, to go on from there again."""
        saved = self._native.save(self._seeds)
        saved.agents = list(self.agents)
        return saved

    def restore(self, saved: Saved) -> tuple[dict[str, Floats], dict[str, Infos]]:
        """Goes on from there; what reset() gives."""
        native = self._native
        native.restore(saved, self._seeds)
        alone = [who for who in self.possible_agents if native.alive[0, self._row[who]]]
        self.agents = alone if saved.agents is None else list(saved.agents)
        return self._seen(native.observations), self._infos()

    def close(self) -> None:
        self._native.core.close()
        self.agents = []

    def _seen(self, values: Floats) -> dict[str, Floats]:
        return {who: values[0, self._row[who]].copy() for who in self.agents}

    def _infos(self, over: bool = False) -> dict[str, Infos]:
        masks = self._native.last_masks if over else self._native.masks
        return {who: {"mask": masks[0, self._row[who]].copy()} for who in self.agents}
