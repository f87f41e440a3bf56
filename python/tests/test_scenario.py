# SPDX-License-Identifier: MIT
from __future__ import annotations

import enum
import pickle
from pathlib import Path

import numpy as np
import pytest

import eyrie


def test_a_scenario_tells_of_itself(scenario: eyrie.Scenario) -> None:
    assert scenario.name == "merge"
    assert scenario.dt == 0.02
    assert scenario.players[0].side in ("blue", "red")
    assert scenario.players[0].kind == "aircraft"
    assert any(name.endswith("merge.yaml") for name in scenario.files)
    assert "sweep" in eyrie.scenarios()


def test_data_and_scenarios_come_with_the_package() -> None:
    home = Path(eyrie.__file__).parent / "home"
    assert (home / "scenarios" / "sweep.yaml").is_file()
    assert (home / "data" / "aircraft").is_dir()


def test_mistakes_have_their_place(tmp_path: Path) -> None:
    file = tmp_path / "mine.yaml"
    file.write_text("extends: sweep\nname: mine\ndecisons: 10 Hz\nuntil: 4 kg\n")
    with pytest.raises(eyrie.ConfigError) as caught:
        eyrie.load(file)
    problems = caught.value.problems
    assert [(one.file, one.line) for one in problems] == [(str(file), 3), (str(file), 4)]
    assert all(one.column > 0 for one in problems)
    assert "decisons" in problems[0].message
    assert f"{file}:3:1: " in str(caught.value)
    again = pickle.loads(pickle.dumps(caught.value))
    assert again.problems == problems and str(again) == str(caught.value)


def test_a_wrong_override_is_a_mistake() -> None:
    with pytest.raises(eyrie.ConfigError, match="did you mean 'eagle'"):
        eyrie.load("sweep", set={"blue.flights.eagel.tree": "veteran"})


def test_a_scenario_that_is_not_there_is_named() -> None:
    with pytest.raises(eyrie.MissingError, match="no scenario 'swep'; did you mean 'sweep'") as caught:
        eyrie.load("swep")
    assert isinstance(caught.value, FileNotFoundError)


def test_values_of_overrides_are_yaml() -> None:
    def until(value: eyrie._scenario.Value) -> float:
        return eyrie.load("merge", set={"until": value}).until

    assert until("1 min") == 60
    assert eyrie.load("merge", set={"seed": np.int64(12)}).seed == 12
    assert eyrie.load("merge", set={"seed": np.array(12)}).seed == 12
    assert eyrie.load("merge", set={"orders": []}).seed == eyrie.load("merge").seed
    with pytest.raises(ValueError, match="until: nan"):
        until(float("nan"))
    class Seeds(enum.IntEnum):
        LUCKY = 12

    assert eyrie.load("merge", set={"seed": Seeds.LUCKY}).seed == 12
    for wrong in (object(), b"10 s"):
        with pytest.raises(TypeError, match="no value of a parameter"):
            until(wrong)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="a mapping"):
        eyrie.load("merge", set="until=10 s")


def test_a_scenario_is_pickled_with_its_files(tmp_path: Path) -> None:
    file = tmp_path / "mine.yaml"
    file.write_text("extends: merge\nname: mine\n")
    scenario = eyrie.load(file, set={"until": "20 s"})
    packed = pickle.dumps(scenario)
    file.unlink()
    again = pickle.loads(packed)
    assert again.name == "mine" and again.until == 20
    assert eyrie.fly(again).hash == eyrie.fly(scenario).hash
