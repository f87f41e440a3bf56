# SPDX-License-Identifier: MIT
from __future__ import annotations

import copy
import gc
import math
import multiprocessing
import operator
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import weakref
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

import eyrie


def test_a_world_flies_what_fly_flies(scenario: eyrie.Scenario, run: eyrie.Run) -> None:
    world = scenario.world()
    assert world.outcome == "running" and not world.over
    assert world.step(10**9) == run.steps
    assert (world.hash, world.steps) == (run.hash, run.steps)
    assert world.over and world.outcome != "running"
    assert world.step() == 0


def test_a_branch_goes_its_own_way(scenario: eyrie.Scenario) -> None:
    world = scenario.world(seed=1)
    world.step(50)
    branch = world.copy()
    assert branch.hash == world.hash
    branch.step(10)
    assert (world.steps, branch.steps) == (50, 60)
    world.step(10)
    assert world.hash == branch.hash
    assert copy.deepcopy(world).hash == copy.copy(world).hash == world.hash
    world.order("lose", player=scenario.players[0].name)
    world.step()
    branch.step()
    assert world.hash != branch.hash


def test_orders_wait_for_their_step(scenario: eyrie.Scenario) -> None:
    name = scenario.players[0].name
    world = scenario.world()
    world.order("lose", player=name, at_step=20)
    branch = world.copy()
    world.step(20)
    assert world.row(name, "kinematics") is not None
    world.step()
    assert world.row(name, "kinematics") is None
    branch.step(21)
    assert branch.hash == world.hash
    assert name in world.events["who"] and not len(world.copy().events)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"order": "fly_home", "player": "viper1"}, "fly_home"),
        ({"order": "lose", "player": "vipr1"}, "vipr1"),
        ({"order": "tree", "player": "viper1", "tree": "no_such"}, "no_such"),
        ({"order": "manual", "player": "viper1", "heading": math.nan}, "^heading: nan is no number"),
        ({"order": "manual", "player": "viper1", "heading": [1]}, "^heading: a list is no part"),
        ({"order": "lose", "player": "viper1", "do": "pause"}, "^do: an order has no such word"),
        ({"order": "lose", "player": "\ud800"}, "^player: "),
        ({"order": "lose", "player": "v" * 70000}, "an order has at most"),
        ({"order": "vote", "player": "viper1", "tree": "dogfight", "node": "roott"}, "did you mean"),
    ],
)
def test_wrong_orders_are_refused(words: dict[str, object], message: str) -> None:
    world = eyrie.load("merge").world()
    with pytest.raises((TypeError, ValueError), match=message):
        world.order(**words)  # type: ignore[arg-type]
    world.step(5)
    with pytest.raises(ValueError):
        world.order("lose", player="viper1", at_step=2)


def test_rows_are_read_where_they_are(scenario: eyrie.Scenario) -> None:
    world = scenario.world()
    rows = world.rows("aircraft", "kinematics")
    assert rows.shape == (len(scenario.players),)
    assert world.fields("aircraft", "kinematics")["speed"].unit == "m/s"
    before = rows["position.x"].copy()
    world.step(50)
    assert (rows["position.x"] != before).all()  # the world as it is
    moved = np.abs(rows["position.x"] - before) + np.abs(rows["position.y"])
    assert (moved > 0).all()
    with pytest.raises(ValueError, match="read-only"):
        rows["speed"][0] = 1
    with pytest.raises(ValueError):
        rows.flags.writeable = True
    for table, columns in world.tables.items():
        for column in columns:
            assert world.rows(table, column).dtype.itemsize > 0
    calls = world.fields("aircraft", "agent")["call"].choices
    assert calls[0] == "none"


def test_rows_keep_their_world(scenario: eyrie.Scenario) -> None:
    world = scenario.world()
    world.step(25)
    rows = world.rows("aircraft", "kinematics")
    kept = rows["position.x"].copy()
    gone = weakref.ref(world)
    del world
    gc.collect()
    assert gone() is None  # the engine's world lives on, that of Python does not
    filler = [scenario.world() for _ in range(10)]
    assert (rows["position.x"] == kept).all()
    del filler


def test_wrong_names_are_told(scenario: eyrie.Scenario) -> None:
    world = scenario.world()
    with pytest.raises(ValueError, match="no table 'aircrat'; did you mean 'aircraft'"):
        world.rows("aircrat", "kinematics")
    with pytest.raises(ValueError, match="no column 'kinematic'; did you mean 'kinematics'"):
        world.rows("aircraft", "kinematic")
    with pytest.raises(ValueError, match="no player"):
        world.row("nobody", "kinematics")
    with pytest.raises(ValueError, match="count: -1"):
        world.step(-1)
    with pytest.raises(TypeError):
        world.step(1.5)  # type: ignore[arg-type]
    for seed in (-1, 2**64):
        with pytest.raises(ValueError, match="seed"):
            scenario.world(seed)


def test_who_is_lost_takes_no_orders() -> None:
    scenario = eyrie.load("sweep")
    world = scenario.world(seed=3)
    world.order("weapons", player="eagle2", free=False, at_step=5)
    world.order("lose", player="eagle2")
    with pytest.raises(ValueError, match="eagle2 is no longer there"):
        world.order("weapons", player="eagle2", free=False, at_step=5)
    world.step()
    with pytest.raises(ValueError, match="eagle2 is no longer there"):
        world.order("lose", player="eagle2")
    world.order("weapons", flight="eagle", free=True)
    again = pickle.loads(pickle.dumps(world))
    world.step(10)
    again.step(10)
    assert again.hash == world.hash


def test_an_order_may_name_any_character(scenario: eyrie.Scenario) -> None:
    with pytest.raises(ValueError, match="no player '\N{GRINNING FACE}'"):
        scenario.world().order("lose", player="\N{GRINNING FACE}")


def test_a_world_is_pickled(scenario: eyrie.Scenario) -> None:
    world = scenario.world(seed=3)
    world.step(40)
    world.order("lose", player=scenario.players[0].name, at_step=45)
    again = pickle.loads(pickle.dumps(world))
    assert again.hash == world.hash and not len(again.events)
    world.step(100)
    again.step(100)
    assert again.hash == world.hash


def test_a_copy_of_what_is_over_is_over() -> None:
    world = eyrie.load("merge", set={"until": "1 s"}).world(seed=3)
    world.step(10**9)
    for one in (world, world.copy(), pickle.loads(pickle.dumps(world))):
        assert one.over and one.outcome == "time"
        with pytest.raises(ValueError, match=r"the mission is over \(time\)"):
            one.order("weapons", player="viper1", weapons="hold")


def _hash_after(world: eyrie.World, steps: int) -> str:
    world.step(steps)
    return world.hash


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_worlds_go_to_other_processes(scenario: eyrie.Scenario, method: str) -> None:
    world = scenario.world()
    world.step(10)
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context(method)) as others:
        theirs = others.submit(operator.attrgetter("hash"), world).result(timeout=120)
    assert theirs == world.hash


def test_a_forked_world_with_workers_says_so(scenario: eyrie.Scenario) -> None:
    world = scenario.world(workers=2)
    world.step(5)
    child = os.fork()
    if child == 0:
        code = 1
        try:
            world.step()
        except eyrie.Error as error:
            code = 0 if "forked" in str(error) else 2
        del world
        gc.collect()
        os._exit(code)
    assert os.waitpid(child, 0)[1] == 0
    world.step()


def test_threads_step_side_by_side(scenario: eyrie.Scenario) -> None:
    def fly(seed: int) -> str:
        return _hash_after(scenario.world(seed), 10**9)

    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(fly, [1, 2, 1, 2]))
    assert together[:2] == together[2:] and together[0] != together[1]


def test_a_world_in_use_is_told_so() -> None:
    world = eyrie.load("sweep").world()
    begun = threading.Event()

    def step() -> None:
        begun.set()
        world.step(10**9)

    thread = threading.Thread(target=step)
    thread.start()
    begun.wait()
    refused = 0
    while thread.is_alive():
        try:
            assert len(world.hash) == 18
        except eyrie.Error as error:
            assert "stepped" in str(error)
            refused += 1
        time.sleep(0)
    thread.join()
    assert refused > 0 and len(world.hash) == 18


def test_an_interrupt_ends_a_flight() -> None:
    scenario = eyrie.load("sweep")
    timer = threading.Timer(0.02, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            while True:
                scenario.world().step(10**9)
    finally:
        timer.join()


_DAEMON = """
import threading, time
import eyrie

@eyrie.behavior
def held(state: eyrie.State) -> eyrie.Proposal | None:
    "flies on"
    return eyrie.propose(1, heading=state.heading)

text = "extends: merge\\nname: mine\\nreplace: {blue.flights.viper.tree: mine}\\ntrees: {mine: held}\\n"
scenario = eyrie.load("mine", text=text, behaviors=[held])
def fly():
    while True:
        scenario.world().step(SIZE)
for _ in range(3):
    threading.Thread(target=fly, daemon=True).start()
time.sleep(0.3)
"""


@pytest.mark.parametrize("size", [1, 10**9])
def test_the_interpreter_may_end_while_a_daemon_thread_flies(size: int) -> None:
    ended = subprocess.run(
        [sys.executable, "-c", _DAEMON.replace("SIZE", str(size))],
        capture_output=True,
        text=True,
        timeout=100,
    )
    assert (ended.returncode, ended.stderr) == (0, "")


def test_memory_stays_flat(scenario: eyrie.Scenario) -> None:
    def resident() -> int:
        with open("/proc/self/statm") as statm:
            return int(statm.read().split()[1]) * os.sysconf("SC_PAGESIZE")

    world = scenario.world()

    def use() -> None:
        for _ in range(200):
            branch = world.copy()
            branch.step(20)
            branch.rows("aircraft", "kinematics")
            assert branch.events is not None
            eyrie.fly(scenario, until=0.5)

    use()
    before = resident()
    for _ in range(3):
        use()
    assert resident() - before < 8e6
