# SPDX-License-Identifier: MIT
"""Environments for Gymnasium and PettingZoo over the native vector environment.

Who imports this module can say ``gymnasium.make("Eyrie/Merge-v0")`` and ``gymnasium.make_vec(
"Eyrie/Merge-v0", num_envs=64, vectorization_mode="vector_entry_point")``; :func:`parallel` is for tasks in which several learn. Needs gymnasium, and
pettingzoo for :func:`parallel`.
"""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
from gymnasium.vector import AutoresetMode

from . import _core
from ._arguments import no_options, switch
from ._native_env import (
    AS_THE_TASK_SAYS,
    NOBODY,
    Floats,
    Infos,
    Native,
    Opponents as Opponents,
    Played,
    Rewards as Rewards,
    Saved as Saved,
    as_actions,
    no_drawing,
)
from ._run import Run
from ._scenario import Sets

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


class Env(Played, gymnasium.Env[Floats, Floats]):
    """One world in which one learns: ``gymnasium.make("Eyrie/Merge-v0")``.

    Observations are numbers in [-1, 1], shape (numbers,), float32; actions likewise, shape (actions,),
    named by :attr:`actions`. ``info["mask"]`` says which of them can do anything now.

    Args:
        task: one of :func:`tasks`.
        set: overrides of its scenario, as for :func:`eyrie.load`.
        opponents: ``{"bandit1": ["veteran", "banzai", "past.safetensors"]}``: who begins each episode
            with one of these, drawn by its seed: trees of the scenario, or policies (self-play). Others as
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
        no_drawing(render_mode)
        self._native = Native(task, 1, 1, set, opponents, rewards, privileged)
        self._over = False
        self.render_mode = None
        self.observation_space = self._native.observation_space()
        self.action_space = self._native.action_space()

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Floats, Infos]:
        """Begins an episode: the first observation of the learner, and the info with its mask.

        Args:
            seed: of this episode and all after it; None: the next one of the same row of seeds.
            options: there are none.
        """
        no_options(options)
        super().reset(seed=seed)
        self._native.core.reset(int(self.np_random.integers(_SEEDS)))
        self._over = False
        return self._native.observations[0, 0].copy(), self._info()

    def step(self, action: npt.ArrayLike) -> tuple[Floats, float, bool, bool, Infos]:
        """One decision, 0.1 s: observation, reward, whether it ended, whether the time was up, info.

        What is beyond [-1, 1] is taken as the bound. When the episode is over the observation is its last one.

        Raises:
            ValueError: NaN, or another shape than that of :attr:`action_space`.
            gymnasium.error.ResetNeeded: the episode is over.
            eyrie.FaultError: a step could not be made.
        """
        self._demand_episode()
        native = self._native
        native.core.step(as_actions(action, (len(native.actions),))[None, None])
        terminated, truncated = bool(native.terminated[0, 0]), bool(native.truncated[0, 0])
        self._over = over = terminated or truncated
        seen = (native.last_observations if over else native.observations)[0, 0].copy()
        return seen, float(native.rewards[0, 0]), terminated, truncated, self._info(over)

    def save(self) -> Saved:
        """Where the episode stands, to go on from there again: for search, and for tests."""
        self._demand_episode()
        return self._native.save(self.np_random)

    def restore(self, saved: Saved) -> tuple[Floats, Infos]:
        """Goes on from there; what reset() gives."""
        self._native.restore(saved, self.np_random)
        self._over = False
        return self._native.observations[0, 0].copy(), self._info()

    def close(self) -> None:
        """Frees the world; after it nothing but close() works."""
        self._native.core.close()

    def _demand_episode(self) -> None:
        if self._over:
            raise gymnasium.error.ResetNeeded("the episode is over: reset() begins one")

    def _info(self, over: bool = False) -> Infos:
        native = self._native
        return {"mask": (native.last_masks if over else native.masks)[0, 0].copy()}


class VectorEnv(Played, gymnasium.vector.VectorEnv[Floats, Floats, npt.NDArray[Any]]):
    """Many worlds in which one learns, one call for a step of all.

    ``gymnasium.make_vec("Eyrie/Merge-v0", num_envs=64, vectorization_mode="vector_entry_point")``.
    A world begins anew in the step in which its episode ends; ``infos["final_obs"]`` then has the last
    observation in its row, ``infos["final_info"]`` its mask, and ``infos["_final_obs"]`` says where. ``infos["mask"]`` is as in
    :class:`Env`, one row for each world.

    The arrays that step() gives, but for the rewards, are those that the engine writes into, not copied: read-only, and
    the same in every step. Take a ``.copy()`` of what is to be kept, or say ``copy=True``.

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
        no_drawing(render_mode)
        self._native = Native(task, num_envs, threads, set, opponents, rewards, privileged)
        self.num_envs = num_envs = len(self._native.over)
        self.render_mode = None
        self._copy = switch("copy", copy)
        self.single_observation_space = self._native.observation_space()
        self.single_action_space = self._native.action_space()
        self.observation_space = gymnasium.vector.utils.batch_space(
            self.single_observation_space, num_envs
        )
        self.action_space = gymnasium.vector.utils.batch_space(self.single_action_space, num_envs)

    def reset(
        self,
        *,
        seed: int | list[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Floats, Infos]:
        """Begins an episode in every world: the first observations, and the info with their masks.

        Args:
            seed: of all episodes; each world gets its own of it. A list of seeds is a ValueError.
            options: there are none.
        """
        if isinstance(seed, list):
            raise ValueError("seed: one for all worlds; each gets its own of it")
        no_options(options)
        super().reset(seed=seed)
        self._native.core.reset(int(self.np_random.integers(_SEEDS)))
        return self._given(self._native.observations[:, 0]), self._infos()

    def step(
        self, actions: npt.ArrayLike
    ) -> tuple[Floats, npt.NDArray[Any], npt.NDArray[Any], npt.NDArray[Any], Infos]:
        """One decision in every world: observations, rewards, terminated, truncated, infos.

        Where an episode ends the next one begins in the same call: the observation is the first of that one.
        What is beyond [-1, 1] is taken as the bound.

        Raises:
            ValueError: NaN, or another shape than that of :attr:`action_space`.
            eyrie.FaultError: a step could not be made.
        """
        native = self._native
        native.core.step(as_actions(actions, (self.num_envs, len(native.actions)))[:, None])
        return (
            self._given(native.observations[:, 0]),
            native.rewards[:, 0].copy(),  # which wrappers change in place
            self._given(native.terminated[:, 0]),
            self._given(native.truncated[:, 0]),
            self._infos(),
        )

    def episode(self, index: int = 0, *, last: bool = False) -> Run:
        """The run of the episode of a world that is kept (the first), so far or that ended last."""
        return self._native.episode(index, last)

    def save(self) -> Saved:
        """Where all episodes stand, to go on from there again."""
        return self._native.save(self.np_random)

    def restore(self, saved: Saved) -> tuple[Floats, Infos]:
        """Goes on from there; what reset() gives."""
        self._native.restore(saved, self.np_random)
        return self._given(self._native.observations[:, 0]), self._infos()

    def close_extras(self, **kwargs: Any) -> None:
        """Ends the threads and frees the worlds; close() calls it."""
        self._native.core.close()

    def _given(self, values: npt.NDArray[Any]) -> npt.NDArray[Any]:
        return values.copy() if self._copy else values

    def _infos(self) -> Infos:
        native = self._native
        over = native.over.copy()
        infos: Infos = {"mask": self._given(native.masks[:, 0])}
        if over.any():
            infos["final_obs"] = self._given(native.last_observations[:, 0])
            infos["final_info"] = {"mask": self._given(native.last_masks[:, 0]), "_mask": over}
            infos["_final_obs"] = infos["_final_info"] = over
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

    native = Native(task, 1, 1, set, opponents, rewards, privileged, several_learn=True)
    return Parallel(task, native)


register()  # Gymnasium looks for nothing by itself
