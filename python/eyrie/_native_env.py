# SPDX-License-Identifier: MIT
"""The native environment behind those of :mod:`eyrie.envs`: who is fought, what is rewarded, its arrays."""

from __future__ import annotations

import itertools
import json
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import number, path, several, switch, text, whole
from ._run import Run
from ._scenario import Scenario, Sets, home, override_lines

Floats = npt.NDArray[np.float32]
Infos = dict[str, Any]

#: Trees of the scenario by player, and files of policies (``.safetensors``).
Opponents = Mapping[str, Iterable[str | os.PathLike[str]]]
NOBODY: Opponents = MappingProxyType({})
#: Weights by term; or the weight, and the ends of the term's range in m or m/s.
Rewards = Mapping[str, float | tuple[float, float, float]]
AS_THE_TASK_SAYS: Rewards = MappingProxyType({})


class Saved:
    """Where an environment stood: made by ``save()``, for ``restore()`` of it or one of the same task."""

    def __init__(self, core: _core.SavedEnv, draws: Any) -> None:
        self.core = core
        self.draws = draws  # of the seeds of episodes to come
        self.agents: list[str] | None = None  # by Parallel: who is in the episode

    def __reduce__(self) -> Any:
        raise TypeError("what an environment saved is kept in this process only")


class _Pool:
    """Policies that fly for opponents: each is a tree of its own."""

    def __init__(self, lines: list[str]) -> None:
        self.taken = {".".join(line.partition("=")[0].split(".")[:2]) for line in lines}
        self.trees: dict[str, Any] = {}
        self.folders: list[str] = []

    def tree(self, who: str, name: str | os.PathLike[str]) -> str:
        if isinstance(name, str) and not name.endswith(".safetensors"):
            return text(who, name)
        if isinstance(name, str) and name.startswith("eyrie:"):
            file = name  # Eyrie's own, from anywhere
        else:
            found = Path(path(who, name)).resolve()
            self.folders.append(str(found.parent))
            file = str(found)
        numbers = itertools.count(len(self.trees) + 1)
        tree = next(name for name in map("policy_{}".format, numbers) if f"trees.{name}" not in self.taken)
        self.trees[f"trees.{tree}"] = {"policy": {"file": json.dumps(file, ensure_ascii=False)}}
        return tree


class Native:
    """What the environments have in common: the engine's, open until it is closed."""

    def __init__(
        self,
        task: str,
        worlds: int,
        threads: int,
        set: Sets,
        opponents: Opponents,
        rewards: Rewards,
        privileged: bool,
        *,
        several_learn: bool = False,
    ) -> None:
        if not isinstance(opponents, Mapping):
            raise TypeError(f"opponents: {opponents!r} is no mapping of players to lists of trees")
        if not isinstance(rewards, Mapping):
            raise TypeError(f"rewards: {rewards!r} is no mapping of terms to weights")
        lines = override_lines(set)
        pool = _Pool(lines)
        trees = {
            text("opponents", who): [
                pool.tree(f"opponents: {who}", one) for one in several(f"opponents: {who}", its, "trees")
            ]
            for who, its in opponents.items()
        }
        self.core = core = _core.vector_env(
            text("task", task),
            lines + override_lines(pool.trees),
            trees,
            {text("rewards", term): _weight(term, weight) for term, weight in rewards.items()},
            whole("num_envs", worlds, 1),
            whole("threads", threads, 1, 256),
            switch("privileged", privileged),
            home(),
            pool.folders,
        )
        self.learners = core.learners
        if len(self.learners) != 1 and not several_learn:
            raise ValueError(f"in {task} several learn: eyrie.envs.parallel({task!r})")
        self.actions = core.actions
        self.observations = core.observations
        self.last_observations = core.last_observations
        self.rewards = core.rewards
        self.alive = core.alive.view(np.bool_)
        self.terminated = core.terminated.view(np.bool_)
        self.truncated = core.truncated.view(np.bool_)
        self.over = core.over.view(np.bool_)
        self.masks = core.masks.view(np.bool_)
        self.last_masks = core.last_masks.view(np.bool_)

    def __reduce__(self) -> Any:
        raise TypeError(
            "an environment is not pickled: make one of the same task on the other side, with the same seed and actions"
        )

    def save(self, draws: np.random.Generator) -> Saved:
        return Saved(self.core.save(), draws.bit_generator.state)

    def restore(self, saved: Saved, draws: np.random.Generator) -> None:
        if not isinstance(saved, Saved):
            raise TypeError(f"{saved!r} is not what save() gives")
        self.core.restore(saved.core)
        draws.bit_generator.state = saved.draws

    def episode(self, world: int, last: bool) -> Run:
        recorded = self.core.episode(whole("index", world), switch("last", last))
        return Run(recorded, Scenario(recorded.scenario))

    def observation_space(self) -> gymnasium.Space[Any]:
        return gymnasium.spaces.Box(-1, 1, (self.observations.shape[2],), np.float32)

    def action_space(self) -> gymnasium.Space[Any]:
        return gymnasium.spaces.Box(-1, 1, (len(self.actions),), np.float32)


def no_drawing(render_mode: None) -> None:
    """What render_mode may be, so that nobody waits for pictures."""
    if render_mode is not None:
        raise ValueError(f"render_mode: {render_mode!r}, but environments draw nothing: episode() has a debrief")


class Played:
    """What every environment tells of the engine's."""

    _native: Native

    @property
    def actions(self) -> list[str]:
        """What the numbers of an action mean."""
        return self._native.actions

    def episode(self, *, last: bool = False) -> Run:
        """The run of this episode so far, or of the one that ended last."""
        return self._native.episode(0, last)

    @property
    def policy_words(self) -> dict[str, str]:
        """What a policy's file says of what it sees and does: its metadata but for ``network``, see
        docs/howto/fly-a-policy.md."""
        return self._native.core.policy_words


def as_actions(actions: Any, shape: tuple[int, ...]) -> Floats:
    try:
        numbers = np.asarray(actions)
        if numbers.dtype.kind not in "fiub":
            raise TypeError
    except (TypeError, ValueError):
        raise TypeError(f"actions: {actions!r} is no array of numbers of shape {shape}") from None
    with np.errstate(over="ignore"):  # what is beyond [-1, 1] is taken as the bound
        numbers = np.ascontiguousarray(numbers, np.float32).reshape(numbers.shape)
    if numbers.shape != shape:
        raise ValueError(f"actions: shape {numbers.shape} is not {shape}")
    return numbers


def _weight(
    term: str, given: float | tuple[float, float, float]
) -> tuple[float, tuple[float, float] | None]:
    numbers = [number(f"rewards: {term}", one) for one in (given if isinstance(given, tuple | list) else (given,))]
    if len(numbers) not in (1, 3):
        raise ValueError(f"rewards: {term}: {given!r} is neither a weight nor a weight and two ends of a range")
    return numbers[0], (numbers[1], numbers[2]) if len(numbers) == 3 else None
