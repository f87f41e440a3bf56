# SPDX-License-Identifier: MIT
"""Scenarios: loaded from files, with overrides."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from . import _core
from ._arguments import number, path, paths, several, text as checked_text, whole
from ._behavior import Behavior
from ._errors import Error
from ._tables import Layout, layouts_of

if TYPE_CHECKING:
    from ._world import World

#: What an override may be: a text is YAML as ``--set`` takes it, ``"2 nmi"``.
Value = str | bool | int | float | None | list[Any] | tuple[Any, ...] | dict[str, Any]
#: Overrides by path, or lines ``path=value``.
Sets = Mapping[str, Value] | Iterable[str]


class Player(NamedTuple):
    """Somebody who takes part from the start."""

    name: str  #: "eagle1"
    kind: str  #: "aircraft", "vehicle"
    type: str  #: "f15c"
    label: str  #: "F-15C"
    side: str  #: "blue", "red", "none"
    flight: str  #: its flight or convoy
    rank: int  #: 1 leads at the start


class Scenario:
    """A scenario that is ready to fly: made by :func:`load`, it never changes.

    It may be used by any number of worlds and threads, and pickled: it takes the texts of its files
    along, but not the files of plug-ins; behaviors of Python must be known there by their names.
    """

    def __init__(self, core: _core.Scenario, behaviors: Iterable[Behavior] = ()) -> None:
        self._core = core
        self._behaviors = list(behaviors)

    @cached_property
    def _layouts(self) -> dict[str, Layout]:
        return layouts_of(self._core)

    @property
    def name(self) -> str:
        """As its file says."""
        return self._core.name

    @property
    def file(self) -> str:
        """The file it was loaded from; ``eyrie:scenarios/...`` is one of Eyrie's own."""
        return self._core.file

    @property
    def files(self) -> dict[str, str]:
        """The text of every file it was made from."""
        return self._core.files

    @property
    def seed(self) -> int:
        """The seed that is flown if nobody says another one."""
        return self._core.seed

    @property
    def until(self) -> float:
        """When a flight ends at the latest, s."""
        return self._core.until

    @property
    def dt(self) -> float:
        """Length of a step, s."""
        return self._core.dt

    @property
    def players(self) -> list[Player]:
        """Who takes part, in the order of their ids, which count from 1."""
        return [Player(*one) for one in self._core.players]

    def world(
        self, seed: int | None = None, *, until: float | None = None, workers: int = 1
    ) -> World:
        """The world at step 0.

        Args:
            seed: of every draw, in [0, 2**64); None takes the scenario's own.
            until: when the mission ends at the latest, s; None takes the scenario's own.
            workers: threads that make a step, in [1, 256]; they never change what comes of it and
                pay from about two thousand players on.
        """
        from ._world import World

        return World(_core.world(self._core, *flight_options(seed, until, workers)), self)

    def __repr__(self) -> str:
        return f"<eyrie.Scenario {self.name!r} of {self.file!r}, {len(self.players)} players>"

    def __reduce__(self) -> tuple[Any, ...]:
        core = self._core
        return (_from_texts, (core.file, core.files, core.sets, core.plugins, self._behaviors))


def load(
    scenario: str | os.PathLike[str] = "sweep",
    *,
    text: str | None = None,
    set: Sets = (),
    plugins: Iterable[str | os.PathLike[str]] = (),
    include: Iterable[str | os.PathLike[str]] = (),
    behaviors: Iterable[Behavior] = (),
) -> Scenario:
    """Loads a scenario.

    Args:
        scenario: a file, or the name of one of Eyrie's own: ``"sweep"``.
        text: what would stand in the file; ``scenario`` is then only what it is called in mistakes.
        set: overrides, ``{"blue.flights.eagle.tree": "veteran"}``; a text is YAML as the program's
            ``--set`` takes it, so ``"2 nmi"`` is a length and ``"[1, 2]"`` a list.
        plugins: shared libraries with behaviors and models; their code is run. What the scenario
            names itself is opened only if it stands here, too.
        include: folders that the scenario may include files of, besides its own.
        behaviors: made by :func:`behavior`; its trees may name them.

    Raises:
        MissingError: there is no such scenario.
        ConfigError: it has mistakes; ``problems`` has all of them with file, line and column.
    """
    behaviors = several("behaviors", behaviors, "behaviors")
    folders = paths("include", include)
    if missing := [folder for folder in folders if not Path(folder).is_dir()]:
        raise ValueError(f"include: there is no folder {missing[0]!r}")
    core = _core.load(
        path("scenario", scenario),
        None if text is None else checked_text("text", text),
        override_lines(set),
        paths("plugins", plugins),
        folders,
        cores_of(behaviors),
        home(),
    )
    return Scenario(core, behaviors)


def home() -> str:
    """The folder with ``data`` and ``scenarios``: EYRIE_HOME, or the one inside the package."""
    given = os.environ.get("EYRIE_HOME")
    if given and not (Path(given) / "data").is_dir():
        raise Error(f"EYRIE_HOME is {given!r}, where there is no folder 'data'")
    return given or str(Path(__file__).parent / "home")


def scenarios() -> list[str]:
    """The names of Eyrie's own scenarios."""
    return sorted(path.stem for path in (Path(home()) / "scenarios").glob("*.yaml"))


def override_lines(sets: Sets) -> list[str]:
    """``path=value`` for each override."""
    if isinstance(sets, Mapping):
        sets = [f"{path}={_yaml(value, path)}" for path, value in sets.items()]
    elif isinstance(sets, str) or not isinstance(sets, Iterable):
        raise TypeError("set: a mapping of paths to values, or a list of lines 'path=value'")
    return [checked_text("set", line) for line in sets]


def flight_options(
    seed: int | None, until: float | None, workers: int
) -> tuple[int | None, float | None, int]:
    """With what a flight begins, checked."""
    return (
        None if seed is None else whole("seed", seed),
        None if until is None else number("until", until),
        whole("workers", workers, 1, 256),
    )


def _yaml(value: Any, path: str) -> str:
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.ndim == 0):
        value = value.item()
    if value is None:
        return "null"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{path}: {value} is no value of a parameter")
    if isinstance(value, int | float):
        return int.__repr__(value) if isinstance(value, int) else float.__repr__(value)
    if isinstance(value, str):
        return value
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key}: {_yaml(one, path)}" for key, one in value.items()) + "}"
    if isinstance(value, Iterable) and not isinstance(value, bytes):
        return "[" + ", ".join(_yaml(one, path) for one in value) + "]"
    raise TypeError(f"{path}: a {type(value).__name__} is no value of a parameter")


def _from_texts(
    file: str,
    files: dict[str, str],
    sets: list[str],
    plugins: list[str],
    behaviors: list[Behavior],
) -> Scenario:
    core = _core.load_texts(file, files, sets, plugins, cores_of(behaviors))
    return Scenario(core, behaviors)


def cores_of(behaviors: Iterable[Behavior]) -> list[_core.Behavior]:
    """What the engine knows of them."""
    cores = []
    for one in behaviors:
        if not isinstance(one, Behavior):
            raise TypeError(f"behaviors: {one!r} is none; @eyrie.behavior makes one")
        cores.append(one._core)
    return cores
