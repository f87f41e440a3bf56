# SPDX-License-Identifier: MIT
from __future__ import annotations

import functools
import math
import os
import pickle
import signal
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import eyrie

kept: list[eyrie.State] = []
seen: list[tuple[Any, ...]] = []


@eyrie.behavior
def climb_away(
    state: eyrie.State,
    to: float = eyrie.param(30000, "ft", (0, 60000), help="where it goes"),
    vote: float = eyrie.param(500, limits=(0, 1000), help="how strongly"),
    hurry: bool = eyrie.param(True, help="at full speed"),
) -> eyrie.Proposal | None:
    """goes up, whoever is there

    A second paragraph is for who reads the code.
    """
    if state.altitude > to:
        return None
    seen.append((state.player, state.time, to, hurry, state.leads))
    return eyrie.propose(
        vote, heading=state.heading, altitude=to, speed=300 if hurry else 200, mode="hold"
    )


@eyrie.behavior(name="is_high")
def _is_high(
    state: eyrie.State, above: float = eyrie.param(0, "m", help="from where on")
) -> bool:
    """holds above an altitude"""
    return bool(state.altitude > above)


def _loaded(node: str, *more: eyrie.Behavior) -> eyrie.Scenario:
    text = "extends: merge\nname: mine\nuntil: 3 s\nreplace: {blue.flights.viper.tree: mine}\n"
    text += f"trees: {{mine: {{selector: [{node}, navigate]}}}}\n"
    return eyrie.load("mine", text=text, behaviors=[climb_away, _is_high, *more])


def _with(node: str, *more: eyrie.Behavior, **options: Any) -> eyrie.Run:
    return eyrie.fly(_loaded(node, *more), **options)


def test_a_behavior_flies_and_is_explained(tmp_path: Path) -> None:
    seen.clear()
    run = _with("climb_away: {to: 25000 ft, vote: 40, hurry: false}")
    player, _, to, hurry, leads = seen[0]
    assert (player, hurry, leads) == (1, False, True)
    assert to == pytest.approx(7620)
    decisions = run.decisions("viper1")
    assert set(decisions["leader"]) == {"climb_away"}
    assert set(decisions["vote"]) == {40.0}
    assert decisions["altitude_m"][0] == pytest.approx(7620)
    assert decisions["speed_m_s"][0] == 200
    assert decisions["mode_order"][0] == "hold"
    assert "climb_away" in str(run.explain("viper1", at=1))
    # the same again, and out of its file
    assert _with("climb_away: {to: 25000 ft, vote: 40, hurry: false}").hash == run.hash
    folder = run.save(tmp_path / "run")
    again = eyrie.open(folder, behaviors=[climb_away, _is_high])
    assert (again.decisions("viper1")["altitude_m"] == decisions["altitude_m"]).all()
    with pytest.raises(eyrie.RunError, match="there is no node 'climb_away'"):
        eyrie.open(folder)


def test_parameters_are_checked_as_those_of_every_node() -> None:
    for node, message in [
        ("climb_away: {too: 3 ft}", "did you mean 'to'"),
        ("climb_away: {to: 3 kg}", "3 kg"),
        ("climb_away: {to: 90000 ft}", "outside"),
        ("climb_awy: {}", "did you mean 'climb_away'"),
    ]:
        with pytest.raises(eyrie.ConfigError, match=message) as caught:
            _with(node)
        assert caught.value.problems[0].file == "mine" and caught.value.problems[0].line == 5


def test_conditions_are_behaviors_that_answer_yes_or_no() -> None:
    high = _with("{sequence: [is_high: {above: 10 ft}, climb_away]}")
    assert set(high.decisions("viper1")["leader"]) == {"climb_away"}
    low = _with("{sequence: [is_high: {above: 90000 ft}, climb_away]}")
    assert "climb_away" not in set(low.decisions("viper1")["leader"])


def test_a_behavior_is_called_with_any_state() -> None:
    low = SimpleNamespace(altitude=100, heading=1.0, player=1, time=0, leads=True)
    answer = climb_away(low)
    assert answer.vote == 500 and answer.fields["altitude"] == 9144  # SI, as from a tree
    assert climb_away(low, to=50.0) is None and climb_away(low, 50.0) is None
    answer = climb_away(low, 7000.0, hurry=False)
    assert answer.fields["altitude"] == 7000 and answer.fields["speed"] == 200
    with pytest.raises(TypeError, match="multiple values"):
        climb_away(low, 7000.0, to=50.0)
    assert climb_away.name == "climb_away" and "goes up" in (climb_away.__doc__ or "")


def test_what_a_behavior_raises_is_the_fault_of_the_run() -> None:
    @eyrie.behavior
    def clumsy(state: eyrie.State) -> None:
        """falls over its own feet"""
        if state.time > 1:
            raise KeyError("where are my feet")

    with pytest.raises(eyrie.FaultError, match="where are my feet") as caught:
        _with("clumsy", clumsy)
    words = str(caught.value)
    assert "viper1" in words and "clumsy" in words
    assert "test_behavior.py" in words and "raise KeyError" in words  # the traceback
    assert str(pickle.loads(pickle.dumps(caught.value))) == words  # to another process
    assert caught.value.run is not None and 1 <= caught.value.run.duration < 1.3


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (eyrie.propose(math.nan), "vote is nan"),
        (eyrie.propose(1, heading=math.inf), "heading is inf"),
        (eyrie.propose(1, hedding=1.0), "did you mean 'heading'"),
        (eyrie.propose(1, heading="north"), "'north' is no value"),
        (eyrie.propose(1, heading=True), "True is no value"),
        (eyrie.propose(1, mode="hovering"), "no 'hovering'"),
        (eyrie.propose(1, release={"track": 3}), "'store'"),
        (eyrie.propose(1, release={"track": 3, "store": 0, "stor": 1}), "'stor'; did you mean 'store'"),
        (eyrie.propose(1, follow={"position": (0, 0, 0)}), "'velocity'"),
        (eyrie.Proposal(None, {}), "NoneType"),  # type: ignore[arg-type]
        (eyrie.Proposal(1, {3: 4}), "no field 3"),  # type: ignore[dict-item]
        (eyrie.Proposal(1, {"\udc80": 4}), r"no field '\\udc80'"),
        (np.float64(1), "not .*1.0"),
        ("what", "not 'what'"),
    ],
)
def test_answers_that_mean_nothing_end_the_run(answer: Any, message: str) -> None:
    @eyrie.behavior
    def odd(state: eyrie.State) -> Any:
        """answers what it was told to"""
        return answer

    with pytest.raises(eyrie.FaultError, match=message):
        _with("odd", odd)


def test_a_state_is_good_for_one_tick() -> None:
    @eyrie.behavior
    def keeper(state: eyrie.State) -> None:
        """keeps what it must not"""
        with pytest.raises(AttributeError, match="did you mean 'altitude'"):
            assert state.altitud
        kept.append(state)

    _with("keeper", keeper)
    with pytest.raises(eyrie.Error, match="gone"):
        assert kept[0].altitude
    with pytest.raises(eyrie.Error, match="gone"):
        kept[0].random()


def test_random_numbers_are_those_of_the_seed() -> None:
    drawn: list[tuple[float, float]] = []

    @eyrie.behavior
    def dice(state: eyrie.State) -> None:
        """throws twice"""
        drawn.append((state.random(), state.random()))

    _with("dice", dice, seed=5)
    first = drawn.copy()
    drawn.clear()
    _with("dice", dice, seed=5)
    assert drawn == first and len({one for pair in first for one in pair}) > len(first)
    assert all(0 <= one < 1 for pair in first for one in pair)


def test_what_remembers_is_noticed() -> None:
    asked: list[int] = []

    @eyrie.behavior
    def counter(state: eyrie.State) -> eyrie.Proposal:
        """does otherwise the second time"""
        asked.append(1)
        return eyrie.propose(50, heading=len(asked) / 100, altitude=5000, mode="hold")

    run = _with("counter", counter)
    with pytest.raises(eyrie.RunError, match="not the run that was recorded"):
        run.tracks()


def test_an_interrupt_in_a_behavior_ends_the_flight() -> None:
    @eyrie.behavior
    def stopper(state: eyrie.State) -> None:
        """presses the key"""
        os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        _with("stopper", stopper)


def test_an_interrupt_in_a_behavior_ends_what_was_asked_and_nothing_else() -> None:
    pressed: list[float] = []
    keys = [0.5]

    @eyrie.behavior
    def stopper(state: eyrie.State) -> eyrie.Proposal:
        """presses the key"""
        if keys and state.time >= keys[0]:
            keys.clear()
            os.kill(os.getpid(), signal.SIGINT)
        pressed.append(state.time)
        return eyrie.propose(50, heading=1.0, altitude=5000, mode="hold")

    world = _loaded("stopper", stopper).world()
    rows = world.rows("aircraft", "kinematics")
    with pytest.raises(KeyboardInterrupt):
        world.step(10**9)
    assert world.outcome == "running" and 24 <= world.steps < 30
    before = rows["position.x"].copy()
    world.step(10**9)  # on from there
    assert world.outcome == "time" and (rows["position.x"] != before).all()
    run = _with("stopper", stopper)
    assert run.hash == world.hash

    keys.append(0.5)
    with pytest.raises(KeyboardInterrupt):
        run.tracks()
    assert len(run.tracks())
    assert max(pressed) > 2


def test_traces_have_any_words() -> None:
    @eyrie.behavior
    def odd(state: eyrie.State) -> None:
        """says what is no Unicode"""
        raise ValueError("bad \udc80 name")

    with pytest.raises(eyrie.FaultError, match=r"ValueError: bad \\udc80 name"):
        _with("odd", odd)


def test_numbers_of_numpy_are_numbers() -> None:
    @eyrie.behavior
    def numbers(
        state: eyrie.State,
        whole: float = eyrie.param(np.int64(3), "km", (0, 9), help="x"),
        half: float = eyrie.param(np.float32(0.5), help="x"),
        flag: bool = eyrie.param(np.bool_(True), help="x"),
    ) -> Any:
        """is asked by NumPy"""
        assert (whole, half, flag) == (3000.0, 0.5, True)
        high = np.bool_(state.altitude > 5)
        return eyrie.propose(1, heading=np.float32(1), trigger=high) if high else high

    assert not numbers(SimpleNamespace(altitude=3))
    assert len(_with("numbers", numbers).decisions())


def test_wrong_definitions_are_named() -> None:
    with pytest.raises(TypeError, match="to: its default"):

        @eyrie.behavior
        def plain(state: eyrie.State, to: float = 3) -> None:
            """has a plain default"""

    with pytest.raises(ValueError, match="no unit 'nmii'"):

        @eyrie.behavior
        def unit(state: eyrie.State, to: float = eyrie.param(3, "nmii", help="x")) -> None:
            """has no such unit"""

    with pytest.raises(ValueError, match="platform"):
        eyrie.behavior(platform="ship")
        eyrie.behavior(name="x", platform="ship")(lambda state: None)
    with pytest.raises(eyrie.ConfigError, match="already a node 'pursue'"):
        again = eyrie.behavior(name="pursue")(lambda state: None)
        eyrie.load("merge", behaviors=[again])
    with pytest.raises(TypeError, match="behaviors: "):
        eyrie.load("merge", behaviors=[len])  # type: ignore[list-item]
    with pytest.raises(ValueError, match="status"):
        eyrie.propose(1, status="done")
    for vote in ("50", True):
        with pytest.raises(TypeError, match="vote: .* is no number"):
            eyrie.propose(vote)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="n: its default cannot be 1000"):
        eyrie.behavior(name="x")(lambda state, n=eyrie.param(10**400, help="x"): None)
    with pytest.raises(TypeError, match="n: it is called by its name"):
        eyrie.behavior(name="x")(lambda state, n=eyrie.param(1, help="x"), /: None)
    for first in (lambda: None, lambda n=eyrie.param(1, help="x"): None, lambda *, state: None):
        with pytest.raises(TypeError, match="the state first"):
            eyrie.behavior(name="x")(first)
    with pytest.raises(TypeError, match="to: None is no number"):
        nothing = eyrie.param(None, help="x")  # type: ignore[arg-type]
        eyrie.behavior(name="none")(lambda state, to=nothing: None)
    with pytest.raises(TypeError, match="name: .* has none of its own"):
        eyrie.behavior(functools.partial(lambda state: None))
    with pytest.raises(ValueError, match="'' is no name"):
        eyrie.behavior(name="")(lambda state: None)
    with pytest.raises(ValueError, match="to: its default 3 km is outside"):
        eyrie.behavior(name="far")(lambda state, to=eyrie.param(3, "km", (0, 2), help="x"): None)
    for other in (True, "text"):
        with pytest.raises(ValueError, match="no number and has none, not 'm'"):
            eyrie.param(other, "m", help="x")


def test_a_release_of_what_there_is_not_is_none() -> None:
    @eyrie.behavior
    def shooter(state: eyrie.State) -> Any:
        """asks for missiles that nobody has"""
        n = int(state.time * 10)
        release = {"track": 1 + n // 4 % 8, "store": 256 + n % 4}
        return eyrie.propose(900, release=release, mode="route", route=256)

    run = _with("shooter", shooter)
    assert not (run.events["event"] == "launch").any()


def test_a_scenario_with_behaviors_is_pickled() -> None:
    scenario = _with("climb_away").scenario
    again = pickle.loads(pickle.dumps(scenario))
    assert eyrie.fly(again).hash == eyrie.fly(scenario).hash


def test_workers_take_turns() -> None:
    run = _with("climb_away: {to: 25000 ft}")
    assert _with("climb_away: {to: 25000 ft}", workers=3).hash == run.hash
