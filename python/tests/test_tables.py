# SPDX-License-Identifier: MIT
from __future__ import annotations

import json
import pickle

import numpy as np
import pyarrow
import pytest

import eyrie


def test_events_are_a_structured_array(run: eyrie.Run) -> None:
    events = run.events
    assert isinstance(events, eyrie.Table)
    assert events.shape == (len(events),)
    assert events.dtype["time_s"] == "f8" and events.dtype["step"] == "i8"
    assert events.dtype["event"].kind == "U"
    assert (np.diff(events["step"]) >= 0).all()
    launches = events[events["event"] == "launch"]
    assert isinstance(launches, eyrie.Table) and launches.columns["range_m"].unit == "m"
    assert events.columns["time_s"].help
    with pytest.raises(ValueError, match="read-only"):
        events["step"][0] = 1


def test_tracks_show_where_everybody_was(run: eyrie.Run) -> None:
    tracks = run.tracks()
    players = {one.name for one in run.scenario.players}
    assert players <= set(tracks["player"])
    name = run.scenario.players[0].name
    own = run.tracks(name)
    assert set(own["player"]) == {name}
    assert (np.diff(own["time_s"]) == 1).all()
    assert len(run.tracks(name, every=0.5)) == pytest.approx(2 * len(own), abs=2)
    assert own.columns["speed_m_s"].unit == "m/s"
    # a straight line is not far from the speed it is flown at
    moved = np.hypot(np.diff(own["north_m"]), np.diff(own["east_m"]))
    assert moved[:5] == pytest.approx(own["speed_m_s"][:5], rel=0.2)
    with pytest.raises(ValueError, match="no player"):
        run.tracks("nobody")
    for wrong in (0, -1, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="every"):
            run.tracks(every=wrong)


def test_decisions_have_the_fields_of_the_action(run: eyrie.Run, player: str) -> None:
    decisions = run.decisions(player)
    assert set(decisions["player"]) == {player}
    assert decisions.columns["heading_rad"].unit == "rad"
    assert set(decisions["status"]) <= {"running", "success", "failure"}
    assert len(run.decisions(player, every=1)) < len(decisions) / 5
    changes = run.decisions(player, changes=True)
    assert 0 < len(changes) < len(decisions)
    assert len(run.decisions()) > len(decisions)


def test_columns_are_plain_arrays(run: eyrie.Run) -> None:
    tracks = run.tracks()
    column = tracks["altitude_m"]
    assert type(column) is np.ndarray and np.shares_memory(column, tracks)
    highest = column.max()
    assert json.dumps(highest) and hash(highest) and isinstance(highest, float)
    assert not hasattr(column, "to_pandas")  # which a column of a table has not
    two = tracks[["time_s", "altitude_m"]]
    assert isinstance(two, eyrie.Table) and list(two.to_pandas()) == ["time_s", "altitude_m"]
    assert list(two.columns) == ["time_s", "altitude_m"] == two.to_arrow().column_names
    assert isinstance(tracks[3], np.void) and isinstance(tracks[:3], eyrie.Table)


def test_pandas_sees_the_same_numbers(run: eyrie.Run) -> None:
    frame = run.events.to_pandas()
    assert list(frame.columns) == list(run.events.dtype.names or ())
    assert frame["event"].tolist() == run.events["event"].tolist()
    assert np.shares_memory(frame["time_s"].to_numpy(), run.events)


def test_arrow_keeps_the_units(run: eyrie.Run) -> None:
    table = run.tracks().to_arrow()
    assert table.num_rows == len(run.tracks())
    assert table.schema.field("north_m").metadata[b"unit"] == b"m"
    assert table["player"][0].as_py() == run.tracks()["player"][0]


def test_tables_of_some_rows_go_to_other_processes(run: eyrie.Run) -> None:
    events = run.events
    last = events[np.argmax(events["time_s"])]
    assert last["time_s"] == events["time_s"].max()
    for table in (events.copy(), events[events["event"] == "launch"], events[[0, 1]], events[:2]):
        for protocol in (2, 4, 5):
            back = pickle.loads(pickle.dumps(table, protocol))
            assert back.tobytes() == table.tobytes()
            assert back.columns == table.columns


def test_a_table_is_pickled_with_its_units(run: eyrie.Run) -> None:
    events = pickle.loads(pickle.dumps(run.events))
    assert events.columns == run.events.columns and events.tobytes() == run.events.tobytes()
    assert not events.flags.writeable


def test_a_table_without_rows_has_its_columns() -> None:
    run = eyrie.fly("merge", until=0.02)
    events = run.events[:0]
    assert events.dtype == run.events.dtype and events.columns
    assert events.to_pandas().empty and events.to_arrow().num_rows == 0
    assert events.to_arrow().schema.field("event").type == pyarrow.string()
