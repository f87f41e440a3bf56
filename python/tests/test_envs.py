# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
import os
import pickle
import struct
import time
import warnings
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode
from pettingzoo.test import parallel_api_test, parallel_seed_test

import eyrie
from eyrie import envs

ONE = sorted(name for name in envs.tasks() if name != "sweep")


@pytest.mark.parametrize("task", ONE)
def test_gymnasium_finds_the_tasks(task: str) -> None:
    env = gymnasium.make(envs.gymnasium_name(task))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of spaces that could be otherwise
        check_env(env.unwrapped)
    env.close()


def _flown(env: envs.Env, seed: int, steps: int) -> tuple[list[Any], float]:
    seen, _ = env.reset(seed=seed)
    rows, reward = [seen], 0.0
    draw = np.random.default_rng(seed)
    for _ in range(steps):
        action = draw.uniform(-1, 1, len(env.actions)).astype(np.float32)
        seen, gained, terminated, truncated, info = env.step(action)
        rows.append(seen)
        reward += gained
        assert info["mask"].shape == (len(env.actions),)
        if terminated or truncated:
            break
    return rows, reward


def test_the_same_seed_and_actions_give_the_same_numbers() -> None:
    one, other = envs.Env("merge"), envs.Env("merge")
    first, second = _flown(one, 4, 200), _flown(other, 4, 200)
    assert (np.array(first[0]) == np.array(second[0])).all() and first[1] == second[1]
    assert (np.array(_flown(other, 5, 50)[0][:2]) != np.array(first[0][:2])).any()
    run = one.episode()
    assert run.duration > 0 and len(run.tracks())


def test_many_worlds_are_stepped_by_one_call() -> None:
    made = gymnasium.make_vec(
        "Eyrie/Merge-v0", num_envs=6, vectorization_mode="vector_entry_point", threads=2
    )
    env = made.unwrapped
    assert isinstance(env, envs.VectorEnv)
    assert env.metadata["autoreset_mode"] == AutoresetMode.SAME_STEP
    seen, infos = env.reset(seed=3)
    assert seen.shape == (6, env.single_observation_space.shape[0])  # type: ignore[index]
    assert env.observation_space.contains(seen)
    assert infos["mask"].shape == (6, len(env.actions))
    alone = envs.VectorEnv("merge", 6)
    alone.reset(seed=3)
    draw = np.random.default_rng(1)
    ended = 0
    for _ in range(400):
        actions = draw.uniform(-1, 1, (6, len(env.actions))).astype(np.float32)
        again, rewards, terminated, truncated, infos = env.step(actions)
        other = alone.step(actions)
        assert np.shares_memory(seen, again)  # not copied
        assert (other[0] == again).all() and (other[1] == rewards).all()
        rewards *= 0  # as wrappers do; not those that the engine writes into
        assert ("final_obs" in infos) == bool((terminated | truncated).any())
        ended += int((terminated | truncated).sum())
    with pytest.raises(ValueError, match="read-only"):
        seen[0, 0] = 1
    kept = envs.VectorEnv("merge", 2, copy=True)
    before, _ = kept.reset(seed=1)
    assert not np.shares_memory(before, kept.step(np.zeros((2, len(env.actions)), np.float32))[0])


def test_wrong_actions_are_refused() -> None:
    env = envs.VectorEnv("merge", 2)
    n = len(env.actions)
    env.reset(seed=1)
    for actions in (np.zeros((3, n)), np.zeros((2, n + 1)), np.zeros(n)):
        with pytest.raises(ValueError, match="shape"):
            env.step(actions)
    with pytest.raises(ValueError):
        env.step(np.full((2, n), np.nan, np.float32))
    with pytest.raises(ValueError, match="one for all"):
        env.reset(seed=[1, 2])
    env.close()
    with pytest.raises(eyrie.Error, match="closed"):
        env.reset(seed=1)


def test_wrong_options_are_named() -> None:
    with pytest.raises(ValueError, match="no task 'merg'; did you mean 'merge'"):
        envs.Env("merg")
    with pytest.raises(ValueError, match="several learn"):
        envs.Env("sweep")
    with pytest.raises(eyrie.ConfigError):
        envs.Env("merge", set={"nothing.of.that": 3})
    with pytest.raises((eyrie.ConfigError, ValueError), match="no_such_tree"):
        envs.Env("merge", opponents={"bandit1": ["no_such_tree"]})
    wrong: Any
    for wrong in (None, ["veteran"], {"bandit1": "veteran"}):
        with pytest.raises(TypeError, match="opponents: "):
            envs.Env("merge", opponents=wrong)
    wrong = None
    with pytest.raises(TypeError, match="rewards: None"):
        envs.Env("merge", rewards=wrong)
    with pytest.raises(ValueError, match="num_envs"):
        envs.VectorEnv("merge", 0)
    for number in (0, 10**9):
        with pytest.raises(ValueError, match="environments|num_envs"):
            envs.VectorEnv("merge", number)
    with pytest.raises(ValueError, match="'viper1' learns"):
        envs.Env("merge_votes", opponents={"viper1": ["dogfight"]})
    with pytest.raises(ValueError, match="environment 1 of 1"):
        envs.VectorEnv("merge", 1).episode(1)
    one = envs.Env("merge")
    one.reset(seed=1)
    with pytest.raises(ValueError, match="shape"):
        one.step(np.zeros((len(one.actions), 1), np.float32))
    with pytest.raises(TypeError, match="None is not what save"):
        one.restore(wrong)
    with pytest.raises(ValueError, match="threads"):
        envs.VectorEnv("merge", 1, threads=0)
    several = envs.parallel("sweep")
    several.reset(seed=1)
    with pytest.raises(ValueError, match="actions: there is none of eagle2, eagle3, eagle4"):
        several.step({"eagle1": np.zeros(len(several.actions), np.float32)})


def test_who_is_privileged_sees_more() -> None:
    def seen(privileged: bool) -> Any:
        env = envs.Env("bvr", privileged=privileged)
        env.reset(seed=1)
        return [env.step(np.zeros(len(env.actions), np.float32))[0] for _ in range(10)]

    assert (np.array(seen(True)) != np.array(seen(False))).any()


def test_several_learn_by_pettingzoo() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        parallel_api_test(envs.parallel("sweep"), num_cycles=300)
        parallel_seed_test(lambda: envs.parallel("sweep"), num_cycles=30)


def test_rewards_are_weighed_otherwise() -> None:
    def gained(**rewards: Any) -> float:
        env = envs.Env("merge", rewards=rewards)
        env.reset(seed=1)
        return sum(env.step(np.zeros(len(env.actions), np.float32))[1] for _ in range(50))

    assert gained(alive=0.1) == pytest.approx(gained(alive=0) + 0.5, abs=1e-4)
    assert gained(alive=0, nose_on=(2, 1e5, 2e5)) > 9  # nose to nose for five seconds
    with pytest.raises(ValueError, match="no term 'nose_onn'; did you mean 'nose_on'"):
        envs.Env("merge", rewards={"nose_onn": 1})
    assert gained(closeness=(1, 500, 500)) != pytest.approx(gained(closeness=(1, 1e5, 1e5)))
    for ranged in ("closeness", "formation"):
        with pytest.raises(ValueError, match=f"{ranged} needs a range"):
            envs.Env("merge", rewards={ranged: 1})
    with pytest.raises(ValueError, match="closing"):
        envs.Env("merge", rewards={"closing": 1})  # over what?
    with pytest.raises(ValueError, match="reward alive has no range"):
        envs.Env("merge", rewards={"alive": (1, 100, 200)})
    with pytest.raises(ValueError, match="reward alive: its weight 1e.40 is outside"):
        envs.Env("merge", rewards={"alive": 1e40})


def test_reset_has_no_options() -> None:
    for env in (envs.Env("merge"), envs.VectorEnv("merge", 2)):
        env.reset(seed=1, options={})
        with pytest.raises(ValueError, match="options: reset.. has none, got 'reset_mask'"):
            env.reset(options={"reset_mask": np.array([True, False])})


def test_what_was_saved_goes_on_alike() -> None:
    env = envs.VectorEnv("merge", 3, threads=2, copy=True)
    env.reset(seed=2)
    draw = np.random.default_rng(1)
    actions = draw.uniform(-1, 1, (600, 3, len(env.actions))).astype(np.float32)
    for a in actions[:100]:
        env.step(a)
    saved = env.save()
    first = [env.step(a) for a in actions[100:]]
    other = envs.VectorEnv("merge", 3, copy=True)
    for one in (env, other):
        one.restore(saved)
        for a, was in zip(actions[100:], first, strict=True):
            now = one.step(a)
            assert all((x == y).all() for x, y in zip(now[:4], was[:4], strict=True))
    with pytest.raises(ValueError, match="another task, scenario or number"):
        envs.VectorEnv("merge", 2).restore(saved)
    other_tree = envs.VectorEnv("merge", 3, set={"trees.zz": {"navigate": {"vote": 1}}})
    for stranger in (other_tree, envs.VectorEnv("merge_votes", 3)):
        with pytest.raises(ValueError, match="another task"):
            stranger.restore(saved)
    for thing in (env, saved):
        with pytest.raises(TypeError):
            pickle.dumps(thing)


def test_the_seeds_to_come_are_saved_too() -> None:
    env = envs.Env("merge")
    env.reset(seed=2)
    saved = env.save()
    first = env.reset()[0]
    env.restore(saved)
    assert (env.reset()[0] == first).all()
    several = envs.parallel("sweep").unwrapped
    with pytest.raises(RuntimeError, match="reset"):
        several.step({})
    several.reset(seed=2)
    before = several.save()
    act = {who: np.zeros(len(several.actions), np.float32) for who in several.agents}
    seen = several.step(act)[0]
    several.restore(before)
    again = several.step(act)[0]
    assert all((seen[who] == again[who]).all() for who in seen)
    with pytest.raises(TypeError, match="actions: .* is no mapping"):
        several.step([act])
    with pytest.raises(TypeError, match="seed: "):
        several.reset(seed=1.5)
    over = several.agents
    several.agents = []  # as after its end
    ended = several.save()
    several.reset(seed=3)
    several.restore(ended)
    assert over and not several.agents
    several.restore(before)
    assert several.agents == over
    with pytest.raises(ValueError, match="'eagle9' is none of eagle1"):
        several.step({**act, "eagle9": act["eagle1"]})
    assert "observation" in several.policy_words
    several.close()
    with pytest.raises(RuntimeError, match="reset"):
        several.step(act)


def test_nothing_is_drawn() -> None:
    for make in (envs.Env, envs.VectorEnv):
        with pytest.raises(ValueError, match="render_mode: 'human'"):
            make("merge", render_mode="human")  # type: ignore[arg-type]


def _crashed(env: envs.Env) -> Any:
    """The last step of a flight into the ground."""
    env.reset(seed=1)
    action = np.zeros(len(env.actions), np.float32)
    action[1] = -1
    while True:
        step = env.step(action)
        if step[2] or step[3]:
            return step


def test_the_dead_can_do_nothing_and_their_episode_is_kept() -> None:
    env = envs.Env("merge")
    seen, _, terminated, _, info = _crashed(env)
    assert terminated and not seen.any() and not info["mask"].any()
    env.reset()
    assert env.episode(last=True).outcome == "blue_lost"
    many = envs.VectorEnv("merge", 1)
    many.reset(seed=1)
    action = np.zeros((1, len(many.actions)), np.float32)
    action[0, 1] = -1
    infos: dict[str, Any] = {}
    while "final_info" not in infos:
        infos = many.step(action)[4]
    assert not infos["final_info"]["mask"][0].any() and infos["mask"][0].any()


def _has_threads(count: int) -> bool:
    """Linux lists a thread for a moment after it was joined."""
    deadline = time.monotonic() + 30
    while len(os.listdir("/proc/self/task")) != count and time.monotonic() < deadline:
        time.sleep(0.01)
    return len(os.listdir("/proc/self/task")) == count


def test_what_is_closed_is_freed() -> None:
    before = len(os.listdir("/proc/self/task"))
    env = envs.VectorEnv("merge", 16, threads=4)
    assert _has_threads(before + 3)
    seen = env.reset(seed=1)[0]
    env.close()
    assert _has_threads(before)
    assert np.isfinite(seen).all()
    env.close()
    with pytest.raises(eyrie.Error, match="closed"):
        env.policy_words


def _forked(env: envs.VectorEnv) -> int:
    """0 if a child of fork() can step it, 1 if it is refused there."""
    child = os.fork()
    if child == 0:
        try:
            env.step(np.zeros((2, len(env.actions)), np.float32))
            os._exit(0)
        except eyrie.Error:
            os._exit(1)
        finally:
            os._exit(2)  # not back into the tests
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


@pytest.mark.filterwarnings("ignore:This process")
def test_forked_environments_are_whole_or_refused() -> None:
    for threads in (1, 2):
        env = envs.VectorEnv("merge", 2, threads=threads)
        env.reset(seed=1)
        assert _forked(env) == threads - 1
        env.step(np.zeros((2, len(env.actions)), np.float32))


def _policy(path: Path, words: dict[str, str], numbers: list[float]) -> Path:
    """A network whose answer is always the same."""
    inputs = words["observation"].count("\n")
    tensors = {
        "a.weight": np.zeros((len(numbers), inputs), np.float32),
        "a.bias": np.array(numbers, np.float32),
    }
    header: dict[str, Any] = {"__metadata__": {**words, "network": "linear a"}}
    data = b""
    for name, values in tensors.items():
        header[name] = {
            "dtype": "F32",
            "shape": values.shape,
            "data_offsets": [len(data), len(data) + values.nbytes],
        }
        data += values.tobytes()
    text = json.dumps(header).encode()
    path.write_bytes(struct.pack("<Q", len(text)) + text + data)
    return path


def test_a_policy_that_was_saved_flies_as_in_training(tmp_path: Path) -> None:
    env = envs.Env("merge")
    numbers = [0.0, 0.0, 0.5, 0.1, -1.0, -1.0]  # at him, wherever he is
    file = _policy(tmp_path / "steady.safetensors", env.policy_words, numbers)
    env.reset(seed=1)
    for _ in range(300):
        env.step(np.array(numbers, np.float32))
    trained = env.episode()
    flown = eyrie.fly(
        str(tmp_path / "flown.yaml"),
        text=f"""
extends: eyrie:scenarios/tasks/merge.yaml
name: flown
seed: {trained.seed}
insert:
  trees.learned: {{policy: {{file: {file}}}}}
replace: {{blue.flights.viper.tree: learned}}
""",
        until=30,
    )
    one, other = (run.tracks("viper1", every=1) for run in (trained, flown))
    assert len(one) >= 30
    # training begins with the learner's second turn, 0.1 s later
    for column, near in (("north_m", 10), ("east_m", 10), ("altitude_m", 10), ("heading_deg", 0.6)):
        assert one[column][:30] == pytest.approx(other[column][:30], abs=near)
    assert abs(one["heading_deg"][29] - one["heading_deg"][0]) > 5  # he was turned at
    against = envs.Env("merge", opponents={"bandit1": [file]})
    against.reset(seed=1)
    for _ in range(100):
        against.step(np.zeros(len(numbers), np.float32))
    who = against.episode().explain("bandit1", at=5).data
    assert "policy" in json.dumps(who)
    with pytest.raises(eyrie.ConfigError, match="cannot read"):
        envs.Env("merge", opponents={"bandit1": ["nobody.safetensors"]})
    mine = {"trees.policy_1": {"navigate": None}}  # a tree of that name is the user's own
    envs.Env("merge", opponents={"bandit1": [file, "policy_1"]}, set=mine)


def test_votes_are_saved_as_votes() -> None:
    words = envs.Env("merge_votes").policy_words
    assert words["votes"] == "linear" and "controls" not in words
