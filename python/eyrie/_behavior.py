# SPDX-License-Identifier: MIT
"""Behaviors that are written in Python, for trying an idea: each costs microseconds when it is asked."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from typing import Any, NamedTuple, overload

import numpy as np

from . import _core
from ._arguments import number, text

#: What a behavior sees; good while it is asked.
State = _core.State


class Parameter(NamedTuple):
    """What a tree may say of a behavior."""

    default: Any
    unit: str
    limits: tuple[float | None, float | None]
    help: str


class Proposal(NamedTuple):
    """An action that is recommended, and how strongly."""

    vote: float
    fields: dict[str, Any]
    status: str = "running"


def param(
    default: float | bool | str | np.generic,
    unit: str = "",
    limits: tuple[float | None, float | None] = (None, None),
    *,
    help: str,
) -> Any:
    """The default of a parameter: ``within: float = eyrie.param(5, "nmi", (0, 27), help="...")``.

    Args:
        default: a number in ``unit``, a switch or a text.
        unit: in which ``default`` and ``limits`` are, "" for none. Trees write any unit of that
            dimension; the behavior gets SI.
        limits: the least and the most that trees may say, None for no limit.
        help: a sentence for who writes trees.
    """
    if not isinstance(limits, tuple) or len(limits) != 2:
        raise TypeError(f"limits: {limits!r} is no pair: (least, most), None for no limit")
    if unit and isinstance(default, str | bool | np.bool_):
        raise ValueError(f"unit: {default!r} is no number and has none, not {unit!r}")
    least, most = (None if one is None else number("limits", one) for one in limits)
    if not (-math.inf if least is None else least) <= (math.inf if most is None else most):
        raise ValueError(f"limits: nothing is within {limits!r}")
    return Parameter(default, text("unit", unit), (least, most), text("help", help))


def propose(vote: float, *, status: str = "running", **fields: Any) -> Proposal:
    """What a behavior answers: recommends an action with a vote.

    Args:
        vote: how strongly, finite and from 0 up; 0 abstains.
        status: ``"running"``, or ``"success"`` when its task is done.
        fields: what it wants, in SI: ``heading=1.57, altitude=6000, speed=250``; choices by name
            (``mode="hold"``), tracks by number. A field that is left out is "no opinion".
    """
    if status not in _STATUS:
        raise ValueError(f"status: {status!r} is none of {', '.join(_STATUS)}")
    return Proposal(number("vote", vote), fields, status)


class Behavior:
    """A behavior or condition that trees may name, made by :func:`behavior`.

    It can still be called as the function that it is, with any object as its state; what is left out
    is the default, in SI.
    """

    def __init__(
        self, function: Callable[..., Any], core: _core.Behavior, parameters: list[str]
    ) -> None:
        self._core = core
        self._defaults = list(zip(parameters, core.defaults, strict=True))
        self.function = function
        self.__doc__ = function.__doc__
        self.__module__ = function.__module__

    @property
    def name(self) -> str:
        """What trees call it."""
        return self._core.name

    def __call__(self, state: Any, *values: Any, **named: Any) -> Any:
        return self.function(state, *values, **{**dict(self._defaults[len(values) :]), **named})

    def __reduce__(self) -> str:
        return self.function.__qualname__  # found there by its name

    def __repr__(self) -> str:
        return f"<eyrie.Behavior {self.name!r}>"


@overload
def behavior(function: Callable[..., Any], /) -> Behavior: ...
@overload
def behavior(
    *, name: str | None = None, platform: str = "pilot"
) -> Callable[[Callable[..., Any]], Behavior]: ...
def behavior(
    function: Callable[..., Any] | None = None,
    /,
    *,
    name: str | None = None,
    platform: str = "pilot",
) -> Any:
    """Makes a function a behavior that trees may name.

    The function gets the state and its parameters. It answers :func:`propose` (...); None, which is a
    failure; or True or False, as a condition. Its docstring is the help. What it raises ends the run
    before that step, with the traceback in :class:`FaultError`. It must not remember anything between
    two calls, or a run is not the same when it is flown again, which is noticed then.

    Args:
        name: what trees call it; None: the name of the function.
        platform: whose trees: ``"pilot"`` or ``"driver"``.
    """
    if function is None:
        return lambda it: _made(it, name, platform)
    return _made(function, name, platform)


_STATUS = {"failure": 0, "running": 1, "success": 2}


def _made(function: Callable[..., Any], name: str | None, platform: str) -> Behavior:
    if platform not in ("pilot", "driver"):
        raise ValueError(f"platform: {platform!r} is neither 'pilot' nor 'driver'")
    lines = []
    names = []
    parameters = list(inspect.signature(function).parameters.values())
    if (
        not parameters
        or parameters[0].kind in (inspect.Parameter.KEYWORD_ONLY, inspect.Parameter.VAR_KEYWORD)
        or isinstance(parameters[0].default, Parameter)
    ):
        raise TypeError("a behavior is called with the state first: def it(state, ...)")
    for one in parameters[1:]:
        if not isinstance(one.default, Parameter):
            raise TypeError(f"{one.name}: its default is to be an eyrie.param(...)")
        if one.kind is one.POSITIONAL_ONLY:
            raise TypeError(f"{one.name}: it is called by its name, and stands before a '/'")
        value, unit, (least, most), help = one.default
        if isinstance(value, np.generic):
            value = value.item()
        if not isinstance(value, (bool, int, float, str)):
            raise TypeError(f"{one.name}: {value!r} is no number, switch or text")
        kind = "switch" if isinstance(value, bool) else "text" if isinstance(value, str) else "number"
        lines.append((one.name, kind, unit, value, least, most, help))
        names.append(one.name)

    def ask(state: Any, *values: Any) -> tuple[int, float, dict[str, Any]]:
        return _answer(function(state, **dict(zip(names, values, strict=True))))

    its_name = getattr(function, "__name__", None) if name is None else text("name", name)
    if its_name is None:
        raise TypeError(f"name: {function!r} has none of its own; say @eyrie.behavior(name=...)")
    help = inspect.cleandoc(function.__doc__ or "").split("\n")[0]
    return Behavior(function, _core.behavior(its_name, help, platform, ask, lines), names)


def _answer(said: Any) -> tuple[int, float, dict[str, Any]]:
    if isinstance(said, Proposal):
        return _STATUS[said.status], float(said.vote), {
            field: bool(value) if isinstance(value, np.bool_) else value for field, value in said.fields.items()
        }
    if isinstance(said, np.bool_):
        said = bool(said)
    if said is None or said is False:
        return _STATUS["failure"], 0.0, {}
    if said is True:
        return _STATUS["success"], 0.0, {}
    raise TypeError(f"a behavior answers eyrie.propose(...), None, True or False, not {said!r}")
