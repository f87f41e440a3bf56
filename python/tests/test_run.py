# SPDX-License-Identifier: MIT
from __future__ import annotations

import errno
import os
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest

import eyrie

AS_PROGRAM = {**os.environ, "EYRIE_HOME": os.environ["EYRIE_PROGRAM_HOME"]}


def test_the_sweep_ends_with_the_hash_of_the_program(tmp_path: Path) -> None:
    program = os.environ["EYRIE_PROGRAM"]
    said = subprocess.run(
        [program, "fly", "sweep", "--quiet", "--out", str(tmp_path / "sweep")],
        capture_output=True, text=True, check=True, env=AS_PROGRAM,
    ).stdout
    wanted = re.search(r"world hash (0x[0-9a-f]{16}) after (\d+) steps", said)
    assert wanted, said
    run = eyrie.fly("sweep")
    assert (run.hash, run.steps) == (wanted[1], int(wanted[2]))
    # and what the program has recorded is the same run
    opened = eyrie.open(tmp_path / "sweep")
    assert opened.hash == run.hash
    saved = run.save(tmp_path / "mine")
    for name in ("events.csv", "flight.acmi"):
        assert (saved / name).read_bytes() == (tmp_path / "sweep" / name).read_bytes()
    said = subprocess.run(
        [program, "replay", str(saved)], capture_output=True, text=True, env=AS_PROGRAM
    ).stdout
    assert run.hash in said


def test_overrides_change_the_run(run: eyrie.Run) -> None:
    other = eyrie.fly("merge", seed=run.seed + 1)
    assert other.hash != run.hash
    assert eyrie.fly("merge", seed=run.seed).hash == run.hash
    short = eyrie.fly("merge", set={"until": "10 s"})
    assert short.duration == 10
    assert eyrie.fly("merge", until=10).hash == short.hash
    assert eyrie.fly("merge", set=["until=10 s"], workers=3).hash == short.hash


def test_a_run_is_kept_and_opened(run: eyrie.Run, tmp_path: Path) -> None:
    folder = run.save(tmp_path / "run")
    assert sorted(path.name for path in folder.iterdir()) == ["events.csv", "flight.acmi", "run.eyrie"]
    for place in (folder, folder / "run.eyrie", str(folder)):
        again = eyrie.open(place)
        assert (again.hash, again.seed, again.outcome) == (run.hash, run.seed, run.outcome)
    with pytest.raises(FileExistsError, match="name another folder or say replace=True"):
        run.save(folder)
    assert run.save(folder, replace=True) == folder
    (folder / "mine.txt").write_text("not of a run")
    with pytest.raises(FileExistsError):
        run.save(folder, replace=True)
    assert (folder / "mine.txt").exists()


def test_where_nothing_can_be_made_is_told(run: eyrie.Run, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("x")
    with pytest.raises(NotADirectoryError, match="cannot make"):
        run.save(tmp_path / "file" / "below")
    for place, code in (("x" * 300, errno.ENAMETOOLONG), ("", errno.EINVAL), ("..", errno.EINVAL)):
        with pytest.raises(OSError) as caught:
            run.save(place and tmp_path / place)
        assert caught.value.errno == code and not isinstance(caught.value, FileExistsError)
    with pytest.raises(FileExistsError, match="is a file"):
        run.save(tmp_path / "file")


def test_what_is_no_run_is_refused(tmp_path: Path) -> None:
    with pytest.raises(eyrie.RunError, match="nothing"):
        eyrie.open(tmp_path / "nothing")
    (tmp_path / "run.eyrie").write_bytes(b"EYRIERUN and then nothing of it")
    with pytest.raises(eyrie.RunError, match="run.eyrie"):
        eyrie.open(tmp_path)


def test_decisions_are_explained(run: eyrie.Run, player: str) -> None:
    turned = run.explain()
    assert turned.data and player in str(turned)
    changes = run.explain(player)
    assert {"from", "to", "why"} <= set(changes.data[0])
    whole = run.explain(player, at=5)
    assert len(whole.data) == 1
    assert whole.data[0]["player"] == player
    assert whole.data[0]["time_s"] >= 5
    assert whole.data[0]["nodes"]
    assert "state" in whole.data[0]
    several = run.explain(player, start=5, end=6)
    assert 5 < len(several.data) < 20
    with pytest.raises(ValueError, match=r"no player 'nobody9'"):
        run.explain("nobody9")
    with pytest.raises(ValueError, match="no such event"):
        run.explain(player, event="coffee")
    with pytest.raises(ValueError, match=rf"1e\+08 s: the run ends at {run.duration:g} s"):
        run.explain(player, at=1e8)
    with pytest.raises(ValueError, match="at: nan s"):
        run.explain(player, at=float("nan"))
    with pytest.raises(ValueError, match="whose decisions"):
        run.explain(at=5)
    everything = run.explain(player, start=0)
    assert len(everything.data) > len(changes.data)
    assert everything.data == run.explain(player, end=1e9).data == run.explain(player, start=0, end=1e9).data
    assert "nodes" in everything.data[0]
    with pytest.raises(ValueError, match="at excludes event"):
        run.explain(player, at=5, event="launch")
    with pytest.raises(ValueError, match="at excludes start"):
        run.explain(player, at=5, start=3)
    with pytest.raises(ValueError, match="event excludes changes"):
        run.explain(player, event="launch", changes=True)


def test_the_story_is_told(run: eyrie.Run) -> None:
    times = [line.time for line in run.story]
    assert times == sorted(times)
    assert any(line.who for line in run.story)


def test_wrong_arguments_are_named(scenario: eyrie.Scenario) -> None:
    with pytest.raises(ValueError, match=r"seed: -1"):
        eyrie.fly(scenario, seed=-1)
    with pytest.raises(ValueError, match=r"seed: 18446744073709551616"):
        eyrie.fly(scenario, seed=2**64)
    with pytest.raises(ValueError, match=r"until: "):
        eyrie.fly(scenario, until=float("nan"))
    with pytest.raises(ValueError, match="workers: 0"):
        eyrie.fly(scenario, workers=0)
    with pytest.raises(TypeError):
        eyrie.fly(scenario, seed="one")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="seed: .*True.* is no whole number"):
        eyrie.fly(scenario, seed=np.True_)  # type: ignore[arg-type]
    assert eyrie.fly(scenario, seed=np.uint64(3), until=0.1).seed == 3  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="is loaded takes no"):
        eyrie.fly(scenario, set={"until": "10 s"})
