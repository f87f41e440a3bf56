# SPDX-License-Identifier: MIT
"""Environments for Gymnasium and PettingZoo over the native vector environment.

Who imports this module can say ``gymnasium.make("Eyrie/Merge-v0")`` and ``gymnasium.make_vec(
"Eyrie/Merge-v0", num_envs=64, vectorization_mode="vector_entry_point")``; :func:`parallel` is for tasks in which several learn. Needs gymnasium, and
pettingzoo for :func:`parallel`.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.vector import AutoresetMode

from . import _core
from ._errors import Error
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

_SEEDS = 2**32


def tasks() -> dict[str, str]:
    """The tasks that come with Eyrie, and what each is."""
    return _core.tasks()


def gymnasium_name(task: str) -> str:
    """``Eyrie/MergeVotes-v0`` for ``merge_votes``."""
    return f"Eyrie/{task.title().replace('_', '')}-v0"


def register() -> None:
    """Registers :func:`gymnasium_name` of every task in which one learns."""
    for task in tasks():
        name = gymnasium_name(task)
        if len(_core.task_learners(task)) == 1 and name not in gymnasium.registry:
            gymnasium.register(
                name,
                entry_point="eyrie.envs:Env",
                vector_entry_point="eyrie.envs:VectorEnv",
                kwargs={"task": task},
            )


class Saved:
    """Where an environment stood: made by ``save()``, for ``restore()`` of it or one of the same task."""

    def __init__(self, core: _core.SavedEnv) -> None:
        self.core = core

    def __reduce__(self) -> Any:
        raise TypeError("what an environment saved is kept in this process only")


class _Pool:
    """Policies that fly for opponents: each is a tree of its own."""

    def __init__(self) -> None:
        self.trees: dict[str, Any] = {}
        self.folders: list[str] = []

    def tree(self, name: str | os.PathLike[str]) -> str:
        if isinstance(name, str) and not name.endswith(".safetensors"):
            return name
        file = Path(name).resolve()
        self.folders.append(str(file.parent))
        tree = f"policy_{len(self.trees) + 1}"
        self.trees[f"trees.{tree}"] = {"policy": {"file": str(file)}}
        return tree


class _Native:
    """What the environments have in common: the engine's, open until it is closed."""

    def __init__(
        self,
        task: str,
        worlds: int,
        *,
        set: Sets,
        opponents: Opponents,
        rewards: Rewards,
        threads: int,
        privileged: bool,
    ) -> None:
        if worlds < 1:
            raise ValueError(f"num_envs: {worlds}")
        if not 1 <= threads <= 256:
            raise ValueError(f"threads: {threads} is outside [1, 256]")
        pool = _Pool()
        trees = {who: [pool.tree(one) for one in trees] for who, trees in opponents.items()}
        self._core: _core.VectorEnv | None = _core.vector_env(
            task,
            override_lines(set) + override_lines(pool.trees),
            trees,
            {term: _weight(weight) for term, weight in rewards.items()},
            worlds,
            threads,
            privileged,
            home(),
            pool.folders,
        )
        core = self._core
        self.learners = core.learners
        self.actions = core.actions
        self.observations = core.observations
        self.last_observations = core.last_observations
        self.rewards = core.rewards
        self.terminated = core.terminated.view(np.bool_)
        self.truncated = core.truncated.view(np.bool_)
        self.over = core.over.view(np.bool_)
        self.masks = core.masks.view(np.bool_)

    @property
    def core(self) -> _core.VectorEnv:
        if self._core is None:
            raise Error("this environment is closed")
        return self._core

    def close(self) -> None:
        self._core = None

    def __reduce__(self) -> Any:
        raise TypeError(
            "an environment is not pickled: make one of the same task on the other side, with the same seed and actions"
        )

    def episode(self, world: int, last: bool) -> Run:
        recorded = self.core.episode(world, last)
        return Run(recorded, Scenario(recorded.scenario))

    def observation_space(self) -> gymnasium.Space[Any]:
        return gymnasium.spaces.Box(-1, 1, (self.observations.shape[2],), np.float32)

    def action_space(self) -> gymnasium.Space[Any]:
        return gymnasium.spaces.Box(-1, 1, (len(self.actions),), np.float32)


class Env(gymnasium.Env[Floats, Floats]):
    """One world in which one learns: ``gymnasium.make("Eyrie/Merge-v0")``.

    Observations are numbers in [-1, 1], shape (numbers,), float32; actions likewise, shape (actions,),
    named by :attr:`actions`. ``info["mask"]`` says which of them can do anything now.

    Args:
        task: one of :func:`tasks`.
        set: overrides of its scenario, as for :func:`eyrie.load`.
        opponents: ``{"bandit1": ["ace", "novice", "past.safetensors"]}``: who begins each episode with
            one of these, drawn by its seed: trees of the scenario, or policies (self-play). Others as
            the scenario says.
        rewards: other weights of the task's terms, or further terms (docs/train.md): ``{"win": 2,
            "closeness": (0.01, 500, 5000)}``, with the ends of a range where the term has one; 0 takes
            a term away.
        privileged: the learner sees the truth instead of what its sensors found.
    """

    metadata = {"render_modes": []}

    def __init__(
        self,
        task: str,
        *,
        set: Sets = (),
        opponents: Opponents = NOBODY,
        rewards: Rewards = AS_THE_TASK_SAYS,
        privileged: bool = False,
        render_mode: None = None,
    ) -> None:
        self._native = _Native(
            task,
            1,
            set=set,
            opponents=opponents,
            rewards=rewards,
            threads=1,
            privileged=privileged,
        )
        if len(self._native.learners) != 1:
            raise ValueError(f"in {task} several learn: eyrie.envs.parallel({task!r})")
        self.render_mode = render_mode
        self.observation_space = self._native.observation_space()
        self.action_space = self._native.action_space()

    @property
    def actions(self) -> list[str]:
        """What the numbers of an action mean."""
        return self._native.actions

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Floats, Infos]:
        super().reset(seed=seed)
        self._native.core.reset(int(self.np_random.integers(_SEEDS)))
        return self._native.observations[0, 0].copy(), self._info()

    def step(self, action: Floats) -> tuple[Floats, float, bool, bool, Infos]:
        native = self._native
        native.core.step(_as_actions(action, (1, 1, len(native.actions))))
        terminated, truncated = bool(native.terminated[0, 0]), bool(native.truncated[0, 0])
        over = terminated or truncated
        seen = (native.last_observations if over else native.observations)[0, 0].copy()
        return seen, float(native.rewards[0, 0]), terminated, truncated, self._info()

    @property
    def policy_words(self) -> dict[str, str]:
        """What a policy's file says of what it sees and does: its metadata but for ``network``, see
        docs/howto/fly-a-policy.md."""
        return self._native.core.policy_words

    def episode(self, *, last: bool = False) -> Run:
        """The run of this episode so far, or of the one that ended last."""
        return self._native.episode(0, last)

    def save(self) -> Saved:
        """Where the episode stands, to go on from there again: for search, and for tests."""
        return Saved(self._native.core.save())

    def restore(self, saved: Saved) -> tuple[Floats, Infos]:
        """Goes on from there; what reset() gives."""
        self._native.core.restore(saved.core)
        return self._native.observations[0, 0].copy(), self._info()

    def close(self) -> None:
        self._native.close()

    def _info(self) -> Infos:
        return {"mask": self._native.masks[0, 0].copy()}


class VectorEnv(gymnasium.vector.VectorEnv[Floats, Floats, npt.NDArray[Any]]):
    """Many worlds in which one learns, one call for a step of all.

    ``gymnasium.make_vec("Eyrie/Merge-v0", num_envs=64, vectorization_mode="vector_entry_point")``.
    A world begins anew in the step in which its episode ends; ``infos["final_obs"]`` then has the last
    observation in its row, and ``infos["_final_obs"]`` says where. ``infos["mask"]`` is as in
    :class:`Env`, one row for each world.

    The arrays that step() gives are those that the engine writes into, not copied: read-only, and the
    same in every step. Take a ``.copy()`` of what is to be kept, or say ``copy=True``.

    Args:
        num_envs: how many worlds.
        threads: that step them; they never change what comes of it.
        task, set, opponents, rewards, privileged: as for :class:`Env`.
    """

    metadata = {"render_modes": [], "autoreset_mode": AutoresetMode.SAME_STEP}

    def __init__(
        self,
        task: str,
        num_envs: int = 1,
        *,
        set: Sets = (),
        opponents: Opponents = NOBODY,
        rewards: Rewards = AS_THE_TASK_SAYS,
        threads: int = 1,
        privileged: bool = False,
        copy: bool = False,
        render_mode: None = None,
    ) -> None:
        self._native = _Native(
            task,
            num_envs,
            set=set,
            opponents=opponents,
            rewards=rewards,
            threads=threads,
            privileged=privileged,
        )
        if len(self._native.learners) != 1:
            raise ValueError(f"in {task} several learn: eyrie.envs.parallel({task!r})")
        self.num_envs = num_envs
        self.render_mode = render_mode
        self._copy = copy
        self.single_observation_space = self._native.observation_space()
        self.single_action_space = self._native.action_space()
        self.observation_space = gymnasium.vector.utils.batch_space(
            self.single_observation_space, num_envs
        )
        self.action_space = gymnasium.vector.utils.batch_space(self.single_action_space, num_envs)

    @property
    def actions(self) -> list[str]:
        """What the numbers of an action mean."""
        return self._native.actions

    def reset(
        self,
        *,
        seed: int | list[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Floats, Infos]:
        if isinstance(seed, list):
            raise ValueError("seed: one for all worlds; each gets its own of it")
        super().reset(seed=seed)
        self._native.core.reset(int(self.np_random.integers(_SEEDS)))
        return self._given(self._native.observations[:, 0]), self._infos()

    def step(
        self, actions: Floats
    ) -> tuple[Floats, npt.NDArray[Any], npt.NDArray[Any], npt.NDArray[Any], Infos]:
        native = self._native
        numbers = np.asarray(actions)
        if numbers.shape != (self.num_envs, len(native.actions)):
            raise ValueError(
                f"actions: shape {numbers.shape} is not {(self.num_envs, len(native.actions))}"
            )
        native.core.step(_as_actions(numbers, (self.num_envs, 1, len(native.actions))))
        return (
            self._given(native.observations[:, 0]),
            self._given(native.rewards[:, 0]),
            self._given(native.terminated[:, 0]),
            self._given(native.truncated[:, 0]),
            self._infos(),
        )

    @property
    def policy_words(self) -> dict[str, str]:
        """As of :class:`Env`."""
        return self._native.core.policy_words

    def episode(self, index: int = 0, *, last: bool = False) -> Run:
        """The run of the episode of a world that is kept (the first), so far or that ended last."""
        return self._native.episode(index, last)

    def save(self) -> Saved:
        """Where all episodes stand, to go on from there again."""
        return Saved(self._native.core.save())

    def restore(self, saved: Saved) -> tuple[Floats, Infos]:
        """Goes on from there; what reset() gives."""
        self._native.core.restore(saved.core)
        return self._given(self._native.observations[:, 0]), self._infos()

    def close_extras(self, **kwargs: Any) -> None:
        self._native.close()

    def _given(self, values: npt.NDArray[Any]) -> npt.NDArray[Any]:
        return values.copy() if self._copy else values

    def _infos(self) -> Infos:
        native = self._native
        over = native.over.copy()
        infos: Infos = {"mask": self._given(native.masks[:, 0])}
        if over.any():
            infos["final_obs"] = self._given(native.last_observations[:, 0])
            infos["_final_obs"] = over
        return infos


def parallel(
    task: str = "sweep",
    *,
    set: Sets = (),
    opponents: Opponents = NOBODY,
    rewards: Rewards = AS_THE_TASK_SAYS,
    privileged: bool = False,
) -> Any:
    """A task as a ``pettingzoo.ParallelEnv``: an agent for each learner, by its name.

    The arguments are those of :class:`Env`. Observations, actions and infos are those of
    :class:`Env`, in dictionaries by agent. Who is lost or home is no agent any more.
    """
    from ._parallel import Parallel

    native = _Native(
        task,
        1,
        set=set,
        opponents=opponents,
        rewards=rewards,
        threads=1,
        privileged=privileged,
    )
    return Parallel(task, native)


def _as_actions(actions: Any, shape: tuple[int, int, int]) -> Floats:
    numbers = np.ascontiguousarray(actions, np.float32)
    if numbers.size != shape[0] * shape[1] * shape[2]:
        raise ValueError(f"actions: {numbers.size} numbers, not {shape[0] * shape[1] * shape[2]}")
    return numbers.reshape(shape)


def _weight(given: float | tuple[float, float, float]) -> tuple[float, tuple[float, float] | None]:
    if isinstance(given, tuple):
        weight, low, high = given
        return float(weight), (float(low), float(high))
    return float(given), None


register()  # Gymnasium looks for nothing by itself
