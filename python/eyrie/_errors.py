# SPDX-License-Identifier: MIT
"""What can go wrong, as exceptions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from ._run import Run


class Error(Exception):
    """Everything that Eyrie raises of its own; wrong arguments are ValueError and TypeError."""


class Problem(NamedTuple):
    """One mistake in a file and its place. Lines and columns count from 1; 0 means unknown."""

    file: str
    line: int
    column: int
    message: str


class ConfigError(Error):
    """Mistakes in a scenario, all of them at once.

    ``str()`` has a line for each, ``sweep.yaml:14:9: ...``; ``problems`` has them one by one.
    """

    problems: tuple[Problem, ...]

    def __init__(self, text: str, problems: Iterable[tuple[str, int, int, str]] = ()) -> None:
        super().__init__(text)
        self.problems = tuple(Problem(*one) for one in problems)

    def __reduce__(self) -> tuple[Any, ...]:
        return (ConfigError, (str(self), tuple(tuple(one) for one in self.problems)))


class MissingError(Error, FileNotFoundError):
    """There is no scenario of that name."""

    def __str__(self) -> str:
        return str(self.args[0])


class RunError(Error):
    """A recorded run cannot be opened, or flown again as it was."""


class FaultError(Error):
    """A step could not be made: code that takes part in it raised, or gave what means nothing.

    ``run`` is what was flown before, if it was ``eyrie.fly()`` that flew.
    """

    run: Run | None = None

    def __reduce__(self) -> tuple[Any, ...]:
        return (FaultError, self.args)  # without the run, which is not pickled
