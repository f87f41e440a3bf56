# SPDX-License-Identifier: MIT
"""The examples that need no network library, and what the others have made."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(os.environ["EYRIE_PROGRAM_HOME"])
EXAMPLES = ROOT / "examples" / "python"
POLICIES = ROOT / "scenarios" / "policies"


def _said(tmp_path: Path, *words: str) -> str:
    """What a script of the examples prints; what it writes goes to a folder of the test."""
    made = subprocess.run(
        [sys.executable, *words],
        env={**os.environ, "PYTHONPATH": str(EXAMPLES), "EYRIE_EXAMPLES_OUT": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert made.returncode == 0, made.stderr
    return made.stdout


@pytest.mark.parametrize(("task", "policy"), [("merge", "merge"), ("merge_votes", "merge_votes")])
def test_who_has_learned_beats_the_veteran_more_often_than_not(
    tmp_path: Path, task: str, policy: str
) -> None:
    said = _said(
        tmp_path,
        "-c",
        "from common import *; from pathlib import Path;"
        f"print(outcomes(merge_with(tree_of({task!r}, Path({str(POLICIES / policy)!r} + '.safetensors'))), range(FRESH, FRESH + 200))['won'])",
    )
    assert int(said) > 100


def test_a_tree_is_tuned_without_gradients(tmp_path: Path) -> None:
    said = _said(
        tmp_path,
        str(EXAMPLES / "tune_tree.py"),
        *("--generations", "2", "--candidates", "8", "--seeds", "2", "--judged", "10"),
    )
    assert "written by hand, 10 fresh seeds: won " in said
    assert "trees:" in (tmp_path / "tuned_fight.yaml").read_text()
    assert (tmp_path / "learned-tuned" / "run.eyrie").is_file()


def test_what_a_shield_is_worth_is_measured(tmp_path: Path) -> None:
    said = _said(tmp_path, str(EXAMPLES / "shield.py"), "--seeds", "8")
    rows = [line.split("|") for line in said.splitlines()[2:]]
    assert [row[1].strip() for row in rows] == ["alone", "avoid_ground", "verify", "both"]
    assert rows[3][6].strip() == "0"  # no flight with a gun nose to nose under verify
