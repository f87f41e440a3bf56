# SPDX-License-Identifier: MIT
"""Wrong arguments are told by their names."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import eyrie
from eyrie import envs

WORLD: dict[str, Callable[[Any], object]] = {
    "scenario": eyrie.load,
    "text": lambda it: eyrie.load("x", text=it),
    "plugins": lambda it: eyrie.load("merge", plugins=it),
    "include": lambda it: eyrie.load("merge", include=it),
    "behaviors": lambda it: eyrie.load("merge", behaviors=it),
    "set": lambda it: eyrie.load("merge", set=it),
    "until": lambda it: eyrie.load("merge").world(until=it),
    "workers": lambda it: eyrie.load("merge").world(workers=it),
    "seed": lambda it: eyrie.load("merge").world(it),
    "count": lambda it: eyrie.load("merge").world().step(it),
    "at_step": lambda it: eyrie.load("merge").world().order("tree", at_step=it),
    "table": lambda it: eyrie.load("merge").world().rows(it, "agent"),
    "player": lambda it: eyrie.load("merge").world().row(it, "agent"),
    "run": eyrie.open,
    "limits": lambda it: eyrie.param(3, "m", it, help="x"),
    "unit": lambda it: eyrie.param(3, it, help="x"),
    "help": lambda it: eyrie.param(3, help=it),
    "name": lambda it: eyrie.behavior(name=it)(lambda state: None),
    "task": envs.Env,
    "num_envs": lambda it: envs.VectorEnv("merge", it),
    "threads": lambda it: envs.VectorEnv("merge", 1, threads=it),
    "privileged": lambda it: envs.Env("merge", privileged=it),
    "opponents": lambda it: envs.Env("merge", opponents={"bandit1": it}),
    "rewards: win": lambda it: envs.Env("merge", rewards={"win": it}),
    "index": lambda it: envs.VectorEnv("merge", 1).episode(it),
    "last": lambda it: envs.Env("merge").episode(last=it),
    "copy": lambda it: envs.VectorEnv("merge", 1, copy=it),
    "options": lambda it: envs.Env("merge").reset(options=it),
    "actions": lambda it: envs.Env("merge").step(it),
}
WRONG: dict[str, list[Any]] = {
    "text": [b"extends: merge", "# \ud800"],
    "plugins": ["mine.so", 3],
    "include": ["/tmp", Path("/tmp"), [3], ["/tmp/nowhere"]],
    "behaviors": [3],
    "set": [[3], ["until=\ud800"], 3],
    "until": ["3 s", [3]],
    "workers": [1.5, "2", -1, 257, 10**30, True],
    "count": [1.5, "2", -1, 2**64],
    "at_step": [1.5, -1, 2**64],
    "limits": [5, (1,), ("1", None), (2, 1), (float("nan"), 3)],
    "num_envs": [1.5, "2", 0, 2**64, True],
    "threads": [1.5, 0, 10**30],
    "privileged": ["no", None, 1],
    "opponents": ["veteran", 3, [3]],
    "rewards: win": ["2", None, (1, 2), [], (1, 2, "3")],
    "index": [-1, 1.5, "0", True],
    "last": ["no", None, 1],
    "copy": ["no", None, 1],
    "options": [3, "x"],
    "actions": [None, "0", {"turn": 1}, [[0.0], 1], np.float32(0)],
}


@pytest.mark.parametrize("name", WORLD)
def test_each_is_told_by_its_name(name: str) -> None:
    for wrong in WRONG.get(name, [3.5, object()]):
        with pytest.raises((TypeError, ValueError), match=f"^{name}: ") as caught:
            WORLD[name](wrong)
        assert "incompatible" not in str(caught.value)


def test_those_of_a_run_too(run: eyrie.Run, tmp_path: Path) -> None:
    wrong: dict[str, Callable[[], object]] = {
        "player": lambda: run.tracks(3),  # type: ignore[arg-type]
        "every": lambda: run.decisions(every="1"),  # type: ignore[arg-type]
        "at": lambda: run.explain("viper1", at="1"),  # type: ignore[arg-type]
        "event": lambda: run.explain("viper1", event=3),  # type: ignore[arg-type]
        "start": lambda: run.explain("viper1", start=10, end=5),
        "folder": lambda: run.save(str(tmp_path / "a\0b")),
        "replace": lambda: run.save(tmp_path / "a", replace="no"),  # type: ignore[arg-type]
        "changes": lambda: run.decisions(changes="no"),  # type: ignore[arg-type]
    }
    for name, ask in wrong.items():
        with pytest.raises((TypeError, ValueError), match=f"^{name}: "):
            ask()
    assert not list(tmp_path.iterdir())


def test_numbers_of_numpy_are_numbers() -> None:
    given: Any = {"seed": np.uint64(3), "until": np.float32(2), "workers": np.int64(1)}
    count: Any = np.int32(2)
    assert eyrie.load("merge").world(**given).step(count) == 2
    options: Any = {"privileged": np.bool_(True), "rewards": {"win": np.float32(2), "closeness": [1, 500, 5000]}}
    envs.Env("merge", **options)


def test_a_home_that_is_none_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("EYRIE_HOME", str(tmp_path))
    for ask in (eyrie.load, eyrie.scenarios, lambda: envs.Env("merge")):
        with pytest.raises(eyrie.Error, match="EYRIE_HOME is .*no folder 'data'"):
            ask()


def test_opponents_have_the_nearest_name() -> None:
    with pytest.raises(ValueError, match="no player 'bandit'; did you mean 'bandit1'"):
        envs.Env("merge", opponents={"bandit": ["veteran"]})


def test_a_run_is_saved_and_not_pickled(run: eyrie.Run) -> None:
    with pytest.raises(TypeError, match=r"save\(\) it"):
        pickle.dumps(run)
    assert copy.deepcopy(run) is run and copy.copy(run) is run


def test_threads_that_cannot_be_started_are_named() -> None:
    tried = """
import resource
from eyrie import envs
resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))  # less than their stacks
envs.VectorEnv("merge", 256, threads=256)
"""
    said = subprocess.run([sys.executable, "-P", "-c", tried], capture_output=True, text=True)
    assert said.stderr.splitlines()[-1].endswith("256 threads cannot be started: Resource temporarily unavailable")
    assert "BlockingIOError" in said.stderr  # what Python calls an OSError of that number


def test_types_of_arguments_can_be_named() -> None:
    opponents: envs.Opponents = {"bandit1": ["veteran"]}
    rewards: envs.Rewards = {"win": 2.0}
    env = envs.VectorEnv("merge", 2, opponents=opponents, rewards=rewards)
    env.reset(seed=1)
    env.step(np.zeros((2, len(env.actions))))  # of any kind of number
    saved: envs.Saved = env.save()
    env.restore(saved)
    env.close()
