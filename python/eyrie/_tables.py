# SPDX-License-Identifier: MIT
"""Structured arrays of NumPy that know the units of their columns: tables, and the rows of worlds."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple, cast, overload

import numpy as np
import numpy.typing as npt

from . import _core

if TYPE_CHECKING:
    import pandas
    import pyarrow


class Column(NamedTuple):
    """What a column holds."""

    unit: str  #: of its numbers, "" for none
    help: str


class Table(np.ndarray[Any, np.dtype[np.void]]):
    """A structured array of one dimension, a row for each element.

    ``table["time_s"]`` is a column, a plain array; ``table[3]`` a row; ``table[table["event"] ==
    "launch"]`` a table of some rows. A number that is not there is NaN, a whole number 0, words are "". ``columns`` says
    what each column holds; it goes with slices.
    """

    columns: dict[str, Column]

    def __array_finalize__(self, made_from: Any) -> None:
        self.columns = getattr(made_from, "columns", {})

    def __reduce__(self) -> Any:
        made, arguments, state = cast("tuple[Any, ...]", super().__reduce__())
        return made, arguments, (state, self.columns, self.flags.writeable)

    def __setstate__(self, state: Any) -> None:
        values, self.columns, writeable = state
        super().__setstate__(values)
        if not writeable:  # NumPy refuses to say of some what they are, that they may be written into
            self.flags.writeable = False

    @overload  # type: ignore[override]
    def __getitem__(self, key: str) -> npt.NDArray[Any]: ...
    @overload
    def __getitem__(self, key: int | np.integer[Any]) -> np.void: ...
    @overload
    def __getitem__(self, key: slice | list[int] | list[str] | npt.NDArray[Any]) -> Table: ...
    def __getitem__(self, key: Any) -> Any:
        got = super().__getitem__(key)
        if isinstance(got, Table) and got.dtype.names is None:
            return got.view(np.ndarray)
        if isinstance(got, Table):  # of some columns, if a list of names was asked for
            got.columns = {name: self.columns[name] for name in got.dtype.names or () if name in self.columns}
        return got

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame whose numbers are those of this table, not copied."""
        import pandas

        names = self.dtype.names or ()
        return pandas.DataFrame({name: np.asarray(self[name]) for name in names}, copy=False)

    def to_arrow(self) -> pyarrow.Table:
        """An Arrow table, units and meanings in the metadata of its fields.

        Rows lie one behind the other here and columns there: each column is copied once.
        """
        import pyarrow

        arrays, fields = [], []
        for name in self.dtype.names or ():
            values = np.ascontiguousarray(self[name])
            if values.dtype.kind == "U":
                arrays.append(pyarrow.array(values.tolist(), pyarrow.string()))
            else:
                arrays.append(pyarrow.array(values))
            about = self.columns.get(name, Column("", ""))
            fields.append(pyarrow.field(name, arrays[-1].type, metadata=about._asdict()))
        return pyarrow.Table.from_arrays(arrays, schema=pyarrow.schema(fields))


#: (name, unit, help, kind, values or codes, words), as the engine hands columns over
Columns = list[tuple[str, str, str, str, object, list[str]]]


def table_of(columns: Columns) -> Table:
    """Puts columns together."""
    formats = {"number": lambda _: "f8", "integer": lambda _: "i8", "words": _width}
    dtype = np.dtype([(name, formats[kind](words)) for name, _, _, kind, _, words in columns])
    arrays = [cast("npt.NDArray[Any]", values) for _, _, _, _, values, _ in columns]
    rows = len(arrays[0]) if arrays else 0
    table = cast(Table, np.empty(rows, dtype).view(Table))
    for (name, _, _, kind, _, words), values in zip(columns, arrays, strict=True):
        if kind != "words":
            table[name] = values
        elif rows:
            table[name] = np.array(words)[values]
    table.columns = {name: Column(unit, text) for name, unit, text, _, _, _ in columns}
    table.flags.writeable = False
    return table


def _width(words: list[str]) -> str:
    return f"U{max((len(word) for word in words), default=1) or 1}"


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
