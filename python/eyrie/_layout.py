# SPDX-License-Identifier: MIT
"""The types of the rows of worlds, as the engine describes them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _core


class Field(NamedTuple):
    """What stands in a field of a row."""

    unit: str  #: SI, "" for none
    choices: dict[int, str]  #: what the values of an enumeration are called


_SCALARS = {"f64": "f8", "f32": "f4", "u8": "u1", "u16": "u2", "u32": "u4", "u64": "u8", "i8": "i1",
            "i16": "i2", "i32": "i4", "i64": "i8"}


#: By column: the type of its rows, and what stands in their fields.
Layout = dict[str, tuple[np.dtype[np.void], dict[str, Field]]]


def layouts_of(scenario: _core.Scenario) -> dict[str, Layout]:
    """The columns of each table of a scenario's worlds."""
    return {
        table: {
            column: (_dtype(stride, fields), {one[0]: Field(one[4], one[5]) for one in fields})
            for column, stride, fields in columns
        }
        for table, columns in scenario.schema
    }


def _dtype(stride: int, fields: list[Any]) -> np.dtype[np.void]:
    formats: list[Any] = []
    for _, _, scalar, count, _, _ in fields:
        of = _SCALARS.get(scalar)
        formats.append(f"V{count}" if of is None else of if count == 1 else (of, (count,)))
    return np.dtype(
        {
            "names": [field[0] for field in fields],
            "formats": formats,
            "offsets": [field[1] for field in fields],
            "itemsize": stride,
        }
    )
