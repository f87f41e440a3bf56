# SPDX-License-Identifier: MIT
"""What docs/python.md says is so."""

from __future__ import annotations

import ast
import os
import re
import warnings
from pathlib import Path
from typing import Any

import pytest

import eyrie
from eyrie import envs

PAGE = (Path(os.environ["EYRIE_PROGRAM_HOME"]) / "docs" / "python.md").read_text()
BLOCKS = re.findall(r"^```python\n(.*?)^```$", PAGE, re.DOTALL | re.MULTILINE)

#: a value of each field of a pilot's action
FIELDS: dict[str, Any] = {
    "heading": 1.5,
    "altitude": 6000,
    "speed": 250,
    "climb": 0.1,
    "load_factor": 4,
    "mode": "follow",
    "follow": {"position": (1, 2, 3), "velocity": (1, 2, 3), "time": 0, "offset": (-100, 0, 0)},
    "route": 0,
    "target": 0,
    "release": {"track": 1, "store": 0},
    "trigger": False,
    "radar": True,
    "call": "none",
    "dispense": "none",
}


def test_the_code_runs_as_it_stands(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("mine.yaml").write_text("extends: sweep\nname: mine\nuntil: 3 kg\n")
    assert len(BLOCKS) == 7
    names: dict[str, Any] = {}
    BLOCKS[0] = BLOCKS[0].replace("seed=7", "seed=7, until=60")  # a minute of it is enough
    for block in BLOCKS:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of spaces that could be otherwise
            exec(compile(block, "docs/python.md", "exec"), names)
    said = capsys.readouterr().out
    assert "mine.yaml 3 " in said and "climb_away" in said


def test_the_options_of_environments_are_ones() -> None:
    words = re.search(r"`opponents=(\{.*?\})`.*?`rewards=(\{.*?\})`", PAGE, re.DOTALL)
    assert words
    opponents, rewards = map(ast.literal_eval, words.groups())
    env = envs.Env("merge", opponents=opponents, rewards=rewards)
    env.reset(seed=1)


def test_the_orders_are_ones() -> None:
    orders = (Path(os.environ["EYRIE_PROGRAM_HOME"]) / "docs" / "live.md").read_text()
    found = re.findall(r'"order":"(?:tree|vote)",[^`}]*', orders)
    assert len(found) == 2
    for one in found:
        eyrie.load("sweep").world().order(**ast.literal_eval(f"{{{one}}}"))


def test_the_fields_of_an_action_are_all_of_them() -> None:
    table = PAGE[PAGE.index("| pilots |") :].split("\n\n")[0]
    assert re.findall(r"^\| `(\w+)`", table, re.MULTILINE) == list(FIELDS)

    @eyrie.behavior
    def whole(state: eyrie.State) -> eyrie.Proposal:
        """says something of everything"""
        return eyrie.propose(900, **FIELDS)

    text = "extends: merge\nname: mine\nuntil: 1 s\nreplace: {blue.flights.viper.tree: mine}\n"
    run = eyrie.fly("mine", text=text + "trees: {mine: {whole: {}}}\n", behaviors=[whole])
    columns = run.decisions("viper1").dtype.names or ()
    action = columns[columns.index("heading_rad") :]
    assert all(one.startswith(name) for one, name in zip(action, FIELDS, strict=True)), action
    for enumeration in ("mode", "call", "dispense"):
        row = re.search(rf"^\| `{enumeration}` \| (.*?)[:;]", table, re.MULTILINE)
        assert row
        for choice in re.findall(r"`(\w+)`", row[1]):
            FIELDS[enumeration] = choice
            eyrie.fly(run.scenario, until=0.2)
