# SPDX-License-Identifier: MIT
"""Worlds as values: stepped, copied, given orders, and read row by row."""

from __future__ import annotations

import json
import math
from typing import Any, cast

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import text, whole
from ._errors import Error, FaultError
from ._scenario import Scenario
from ._tables import Field, Table, table_of


class World:
    """Everything that changes in a flight. Made by :meth:`Scenario.world`.

    A world is a value: :meth:`copy` is a branch that goes its own way, and two worlds with the same
    :attr:`hash` are the same bit by bit. It is for one thread at a time; one that is used while
    another thread steps it raises :class:`Error`. Stepping lets other threads of Python run.

    A world can be pickled: it is flown again on the other side, from its scenario, seed and orders.
    """

    def __init__(self, core: _core.World, scenario: Scenario) -> None:
        self._core = core
        self._scenario = scenario

    @property
    def scenario(self) -> Scenario:
        """What it is a world of."""
        return self._scenario

    @property
    def seed(self) -> int:
        """Of every draw."""
        return self._core.seed

    @property
    def steps(self) -> int:
        """How many steps were made since the start."""
        return self._core.steps

    @property
    def time(self) -> float:
        """Since the start, s."""
        return self._core.time

    @property
    def hash(self) -> str:
        """Of everything in it, ``0x`` and 16 hexadecimal digits."""
        return self._core.hash

    @property
    def outcome(self) -> str:
        """``running``, or why the mission is over: ``blue_home``, ``time``, ..."""
        return self._core.outcome

    @property
    def over(self) -> bool:
        """Whether no step can be made any more. Known once step() has come there."""
        return self._core.outcome != "running"

    def step(self, count: int = 1) -> int:
        """Makes steps; gives how many: fewer than asked for at the end of the mission.

        Raises:
            FaultError: a step could not be made. The world is as it was before it.
            KeyboardInterrupt: so is it then, and goes on with the next call.
        """
        count = whole("count", count)
        made = self._core.step(count)
        if made < count and self._core.fault:
            raise FaultError(self._core.fault)
        return made

    @property
    def events(self) -> Table:
        """What happened in the steps of the last call of step(); the columns of docs/events.md."""
        return table_of(self._core.events())

    def copy(self) -> World:
        """A branch: another world that goes on from here, with the orders that wait."""
        return World(self._core.copy(), self._scenario)

    __copy__ = copy

    def __deepcopy__(self, memo: dict[int, Any]) -> World:
        return self.copy()

    def order(self, order: str, *, at_step: int | None = None, **words: Any) -> None:
        """Gives an order to a player or to everybody of a flight.

        ``world.order("tree", player="eagle1", tree="short_skate")``; docs/live.md has all of
        them. Numbers are in SI.

        Args:
            order: what kind: ``"tree"``, ``"manual"``, ``"weapons"``, ...
            at_step: from which step on, counted as :attr:`steps`; None: from the next one on.
            words: what the kind asks for; ``player=`` or ``flight=`` says whom it means.

        Raises:
            ValueError: with what is wrong with it, or the mission is over.
        """
        if "do" in words:
            raise ValueError(f"do: an order has no such word, got {words['do']!r}")
        asked = {word: _plain(word, value) for word, value in {"order": text("order", order), **words}.items()}
        said = json.dumps(asked, ensure_ascii=False)
        self._core.order(said, None if at_step is None else whole("at_step", at_step))

    @property
    def tables(self) -> dict[str, list[str]]:
        """The columns of each table."""
        return {table: list(columns) for table, columns in self._scenario._layouts.items()}

    def fields(self, table: str, column: str) -> dict[str, Field]:
        """What stands in each field of a column."""
        self.rows(table, column)  # which knows what is wrong with the names
        return dict(self._scenario._layouts[table][column][1])

    def rows(self, table: str, column: str) -> npt.NDArray[np.void]:
        """The live rows of a column: a structured array of shape (players,), in spawn order.

        ``world.rows("aircraft", "kinematics")["position.z"]``. It is read-only, nothing is copied,
        and it keeps the world alive. It always shows the world as it is: after step() the new
        values stand in it. Who is born later is not in it, and where somebody has left, the rows
        behind him have closed up and the last one is zero: then ask again, or take a ``.copy()`` to
        keep what was. The units are in :meth:`fields`.
        """
        values = self._core.rows(text("table", table), text("column", column))  # which knows what is wrong with the names
        return values.view(self._scenario._layouts[table][column][0])

    def row(self, player: str, column: str) -> np.void | None:
        """The row of one player, as in :meth:`rows`; None if it is gone.

        It shows whoever stands in that row: take it anew after a step.
        """
        found = self._core.find(text("player", player))
        return None if found is None else cast(np.void, self.rows(found[0], column)[found[1]])

    def __repr__(self) -> str:
        return f"<eyrie.World of {self._scenario.name!r}, {self.time:.2f} s, hash {self.hash}>"

    def __reduce__(self) -> tuple[Any, ...]:
        if self._core.fault:
            raise Error("a world that has come to a fault cannot be pickled: " + self._core.fault)
        core = self._core
        state = (core.seed, core.until, core.workers, core.orders(), core.steps, core.hash)
        return (_flown_again, (_core.version_text(), self.scenario, state))


def _plain(word: str, value: Any) -> Any:
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, str):
        return text(word, value)
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"{word}: {value} is no number that an order can have")
    if value is None or isinstance(value, bool | int | float):
        return value
    raise TypeError(f"{word}: a {type(value).__name__} is no part of an order")


def _flown_again(
    build: str, scenario: Scenario, state: tuple[int, float, int, bytes, int, str]
) -> World:
    if build != _core.version_text():
        raise Error(f"this world was pickled by {build}; this is {_core.version_text()}")
    seed, until, workers, orders, steps, hash = state
    core = _core.world(scenario._core, seed, until, workers)
    core.set_orders(orders)
    core.step_to(steps)
    if core.steps != steps or core.hash != hash:
        raise Error("this world is not as it was when it was pickled: something that takes part in "
                    "it, such as a plug-in, does otherwise the second time")
    return World(core, scenario)
