# SPDX-License-Identifier: MIT
"""What callers say, checked before the engine gets it: a mistake is told with the argument's name."""

from __future__ import annotations

import math
import operator
import os
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

_WORD = 2**64 - 1


def whole(name: str, value: Any, least: int = 0, most: int = _WORD) -> int:
    """A whole number in [least, most]."""
    if isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: {value!r} is no whole number")
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name}: {value!r} is no whole number") from None
    if not least <= number <= most:
        raise ValueError(f"{name}: {number} is outside [{least}, {'2**64)' if most == _WORD else f'{most}]'}")
    return number


def number(name: str, value: Any) -> float:
    """Any number, also one that is not finite."""
    if isinstance(value, str | bytes | bool):
        raise TypeError(f"{name}: {value!r} is no number")
    try:
        return float(value)
    except (TypeError, OverflowError):
        raise TypeError(f"{name}: {value!r} is no number") from None


def no_options(options: Any) -> None:
    """Those that Gymnasium hands to reset(): there are none."""
    if options is not None and not isinstance(options, Mapping):
        raise TypeError(f"options: {options!r} is no mapping")
    if options:
        raise ValueError(f"options: reset() has none, got {', '.join(map(repr, options))}")


def seconds(name: str, value: Any, *, above: bool = False) -> float:
    """A time from 0 up, or above 0."""
    time = number(name, value)
    if not 0 <= time < math.inf or (above and time == 0):
        raise ValueError(f"{name}: {time:g} s is no time {'above' if above else 'from'} 0{'' if above else ' up'}")
    return time


def switch(name: str, value: Any) -> bool:
    """True or False."""
    if not isinstance(value, bool | np.bool_):
        raise TypeError(f"{name}: {value!r} is neither True nor False")
    return bool(value)


def text(name: str, value: Any) -> str:
    """A text that UTF-8 can hold."""
    if not isinstance(value, str):
        raise TypeError(f"{name}: {value!r} is no text")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise ValueError(f"{name}: {value!r} is no text of whole characters") from None
    return value


def path(name: str, value: Any) -> str:
    """A path that the system can take."""
    if not isinstance(value, str | os.PathLike):
        raise TypeError(f"{name}: {value!r} is no path")
    given = text(name, os.fspath(value))
    if "\0" in given:
        raise ValueError(f"{name}: {given!r} has a NUL, which no path has")
    return given


def several(name: str, values: Any, of: str) -> list[Any]:
    """A list of what callers may give in any kind of row; a text by itself is none."""
    if isinstance(values, str | bytes | os.PathLike) or not isinstance(values, Iterable):
        raise TypeError(f"{name}: {values!r} is no list of {of}")
    return list(values)


def paths(name: str, values: Any) -> list[str]:
    """A list of paths."""
    return [path(name, one) for one in several(name, values, "paths")]
