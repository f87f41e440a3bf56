# SPDX-License-Identifier: MIT
"""Runs: flown, opened, looked at, kept."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from . import _core
from ._arguments import path, paths, seconds, several, switch, text as checked_text
from ._behavior import Behavior
from ._errors import FaultError
from ._scenario import Scenario, Sets, cores_of, flight_options, load
from ._tables import Table, table_of


class StoryLine(NamedTuple):
    """Something worth telling."""

    time: float  #: s
    who: str
    text: str


class Explanation:
    """Decisions with every node's answer.

    ``str()`` is what ``eyrie explain`` prints, but for the outcome under ``explain()``; ``data`` the same as lists and dictionaries, whose keys
    docs/howto/explain-a-decision.md has. Numbers are in SI.
    """

    def __init__(self, text: str, data: list[dict[str, Any]]) -> None:
        self.text = text
        self.data = data

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return f"<eyrie.Explanation of {len(self.data)} decisions; print() shows them>"


class Run:
    """A flight from its first world to its end: made by :func:`fly` or :func:`open`.

    It holds what the flight was made from, not what happened: tables and explanations are made by
    flying it again, exactly, when they are asked for. It never changes, and any number of threads may
    look at it.
    """

    def __init__(self, core: _core.Recorded, scenario: Scenario) -> None:
        self._core = core
        self._scenario = scenario

    @property
    def scenario(self) -> Scenario:
        """What was flown."""
        return self._scenario

    @property
    def seed(self) -> int:
        """Of every draw."""
        return self._core.seed

    @property
    def steps(self) -> int:
        """How many it has."""
        return self._core.steps

    @property
    def duration(self) -> float:
        """From its start to its end, s."""
        return self._core.until

    @property
    def hash(self) -> str:
        """Of the world at its end, ``0x`` and 16 hexadecimal digits: what ``eyrie fly`` prints."""
        return self._core.hash

    @property
    def outcome(self) -> str:
        """How it ended, in a line for people."""
        return self._core.outcome

    @property
    def build(self) -> str:
        """What the program called itself that recorded it."""
        return self._core.build

    @cached_property
    def events(self) -> Table:
        """Everything that happened, a row each; docs/events.md describes the columns."""
        return table_of(self._core.events())

    @cached_property
    def story(self) -> list[StoryLine]:
        """The run in the field's words, as ``eyrie fly`` tells it."""
        return [StoryLine(*line) for line in self._core.story()]

    def tracks(self, player: str | None = None, *, every: float | None = None) -> Table:
        """Where everybody was.

        Args:
            player: whose rows, one of those that were there at the start; None: everybody's, missiles included.
            every: s between two rows, of one step at least; None: 1 s, of missiles 0.2 s.
        """
        if every is not None:
            every = seconds("every", every, above=True)
        return table_of(self._core.tracks(_name(player), every))

    def decisions(
        self, player: str | None = None, *, every: float = 0, changes: bool = False
    ) -> Table:
        """What was decided: who led, and each field of the action.

        Args:
            player: whose; None: everybody's.
            every: at most one decision of a player in each so many s of the run; 0: all.
            changes: only those in which somebody else leads, another tree decides or an order is
                another one than before.
        """
        return table_of(self._core.decisions(_name(player), seconds("every", every), switch("changes", changes)))

    def explain(
        self,
        player: str | None = None,
        *,
        at: float | None = None,
        start: float | None = None,
        end: float | None = None,
        event: str = "",
        changes: bool = False,
    ) -> Explanation:
        """Why somebody did what it did.

        ``explain()`` has the decisions on which the run turned; ``explain("eagle1")`` where another
        behavior took the lead; ``explain("eagle1", at=312.4)`` the first decision from then on, with
        every node's answer; ``start`` and ``end`` all decisions in between; ``event="launch"`` the
        decisions that such events come of.

        Args:
            player: whose decisions.
            at: s, one decision.
            start, end: s, all decisions in that time; one alone: from there to the end, or up to there.
            event: a word of the name of an event, or of the story's line.
            changes: where another behavior took the lead, also with ``start`` and ``end``.

        Times are those of the tables. The terminal's are rounded to a tenth of a second, and what is
        typed there means the first decision that is printed as that.

        Raises:
            ValueError: nothing was decided in that time, or two arguments ask for different things.
        """
        for name, time in (("at", at), ("start", start), ("end", end)):
            if time is not None:
                seconds(name, time)
        if start is not None and end is not None and start > end:
            raise ValueError(f"start: {start} s is after end: {end} s")
        player, event, changes = _name(player), checked_text("event", event), switch("changes", changes)
        given = {"at": at, "event": event or None, "start": start, "end": end, "changes": changes or None}
        asked = [name for name, value in given.items() if value is not None]
        if len(asked) > 1 and asked[0] in ("at", "event"):
            raise ValueError(f"{asked[0]} excludes {asked[1]}")
        if player is None:
            if asked:
                raise ValueError("whose decisions? explain() by itself has those on which the run turned")
            text, data = self._core.key_moments()
        else:
            until = 1e9 if end is None else end
            text, data = self._core.explain(player, at, start or 0, until, changes or not asked, event)
        return Explanation(text, json.loads(data))

    def save(self, folder: str | os.PathLike[str], *, replace: bool = False) -> Path:
        """Writes the folder that ``eyrie fly --out`` makes: run.eyrie, events.csv, flight.acmi.

        Gives where it is. Every command of the program takes it, and :func:`open`.

        Raises:
            FileExistsError: something is there; a run only with ``replace``, anything else always.
            OSError: nothing can be made there.
        """
        return Path(self._core.save(path("folder", folder), switch("replace", replace)))

    def __reduce__(self) -> Any:
        raise TypeError("a run is not pickled: save() it, and open() it on the other side")

    def __copy__(self) -> Run:
        return self  # it never changes

    def __deepcopy__(self, memo: dict[int, Any]) -> Run:
        return self

    def __repr__(self) -> str:
        return f"<eyrie.Run of {self.scenario.name!r}, seed {self.seed}, {self.outcome}, hash {self.hash}>"


def fly(
    scenario: str | os.PathLike[str] | Scenario = "sweep",
    *,
    seed: int | None = None,
    text: str | None = None,
    set: Sets = (),
    until: float | None = None,
    workers: int = 1,
    plugins: Iterable[str | os.PathLike[str]] = (),
    include: Iterable[str | os.PathLike[str]] = (),
    behaviors: Iterable[Behavior] = (),
) -> Run:
    """Flies a scenario to its end.

    Args:
        scenario: a file, the name of one of Eyrie's own, or one that is loaded.
        seed: of every draw, in [0, 2**64); None takes the scenario's own.
        text, set, plugins, include, behaviors: as for :func:`load`.
        until: when it ends at the latest, s; None takes the scenario's own.
        workers: threads that make a step; they never change what comes of it.

    Raises:
        MissingError, ConfigError: as for :func:`load`.
        FaultError: a step could not be made; its ``run`` is what was flown before.
    """
    if not isinstance(scenario, Scenario):
        scenario = load(
            scenario, text=text, set=set, plugins=plugins, include=include, behaviors=behaviors
        )
    elif text is not None or set or plugins or include or behaviors:
        raise TypeError("a scenario that is loaded takes no text, set, plugins ... any more")
    core, fault = _core.fly(scenario._core, *flight_options(seed, until, workers))
    run = Run(core, scenario)
    if fault:
        error = FaultError(fault)
        error.run = run
        raise error
    return run


def open(
    run: str | os.PathLike[str],
    *,
    plugins: Iterable[str | os.PathLike[str]] = (),
    behaviors: Iterable[Behavior] = (),
) -> Run:
    """Opens a run folder or its run.eyrie.

    Args:
        run: the folder or the file.
        plugins: where the plug-ins of the run are now; their code is run.
        behaviors: those of Python that its trees name.

    Raises:
        RunError: it is none, damaged, or of a build with another world.
    """
    behaviors = several("behaviors", behaviors, "behaviors")
    core = _core.open(path("run", run), paths("plugins", plugins), cores_of(behaviors))
    return Run(core, Scenario(core.scenario, behaviors))


def _name(player: str | None) -> str | None:
    return None if player is None else checked_text("player", player)
