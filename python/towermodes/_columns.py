"""Tables of any kind as columns of numbers."""

from __future__ import annotations

from towermodes import _towermodes as _rust

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping
    from typing import Any, Protocol

    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

    class ArrowTable(Protocol):
        """A table of any library that has the Arrow PyCapsule interface."""

        def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

    Table = ArrowTable | Mapping[str, Any]

#: The contents of arrays without numbers, by the kind of their type, and the remedy.
KINDS = {
    "b": ("booleans", "write 0.0 and 1.0 if they are numbers"),
    "c": ("complex numbers", "take their real part: values.real"),
    "M": ("dates", "give numbers in the unit of the parameter"),
    "m": ("time differences", "give numbers in the unit of the parameter"),
    "U": ("texts", "convert them: values.astype(float)"),
    "S": ("bytes", "convert them: values.astype(float)"),
    "T": ("texts", "convert them: values.astype(float)"),
    "V": ("records", "give one column for each field"),
}


def columns_of(table: Any, ignore: Iterable[str] = ()) -> list[tuple[str, Array]]:
    """The columns of a table, as arrays of one length: copies that cannot be written.

    A missing value is NaN. Columns whose names begin with `#` and the columns to ignore are
    left out.
    """
    left_out = list(ignore)
    columns = _read(table, lambda names: _chosen(names, left_out))
    for _, column in columns:
        column.flags.writeable = False
    return columns


def _chosen(names: list[str], ignore: list[str]) -> list[int]:
    """The indices of the columns that are not left out."""
    for name in ignore:
        if name not in names:
            message = f"the table has no column {name!r} to ignore; its columns are {names!r}"
            raise ValueError(message)
    left_out = [name in ignore or name.startswith("#") for name in names]
    if names and all(left_out):
        message = "all columns are skipped; at least one must name an input value to change"
        raise ValueError(message)
    return [place for place, is_out in enumerate(left_out) if not is_out]


def _read(table: Any, choose: Callable[[list[str]], list[int]]) -> list[tuple[str, Array]]:
    kind = type(table).__name__
    if kind == "Series":
        message = "the table is a Series; make it a table with one column: series.to_frame()"
        raise TypeError(message)
    # A DataFrame of pandas would add its index to the stream, and needs pyarrow for it.
    if hasattr(table, "iloc") and hasattr(table, "columns"):
        names = [str(name) for name in table.columns]
        return _numbers_of((names[n], table.iloc[:, n].to_numpy()) for n in choose(names))
    if hasattr(table, "__arrow_c_stream__"):
        return _rust.columns_of_stream(table.__arrow_c_stream__(), choose)
    if hasattr(table, "items"):
        pairs = [(str(name), values) for name, values in table.items()]
        chosen = choose([name for name, _ in pairs])
        return _of_one_length(_numbers_of(pairs[n] for n in chosen))
    message = f"the table is a {kind}; it must be a dict of arrays, a DataFrame, an Arrow table, \
the path of a table, or a study"
    if hasattr(table, "collect"):
        message = f"the table is a {kind}; compute it first: .collect()"
    raise TypeError(message)


def _numbers_of(columns: Iterable[tuple[str, object]]) -> list[tuple[str, Array]]:
    return [(name, _numbers(name, values)) for name, values in columns]


def _numbers(name: str, values: object) -> Array:
    """A copy of a column as numbers."""
    import numpy as np

    try:
        given = np.asarray(values)
    except ValueError as error:
        message = f"column {name} must hold numbers: {error}"
        raise TypeError(message) from None
    if isinstance(values, np.ma.MaskedArray) and values.mask.any():
        message = (
            f"column {name} must hold numbers, but {values.mask.sum()} of them are masked; "
            "fill them (a row with NaN fails), or remove their rows: values.filled(float('nan'))"
        )
        raise TypeError(message)
    if given.dtype.kind in KINDS:
        wrong, remedy = KINDS[given.dtype.kind]
        message = f"column {name} must hold numbers, not {wrong}; {remedy}"
        raise TypeError(message)
    if given.ndim > 1:
        message = f"column {name} has {given.ndim} dimensions, but must have one"
        raise ValueError(message)
    if given.dtype.kind == "O":
        given = np.array([_number(name, one) for one in given.flat]).reshape(given.shape)
    return np.array(given, dtype=np.float64, order="C")


def _number(name: str, value: Any) -> float:
    """A number of a column of Python objects."""
    from decimal import Decimal
    from numbers import Real

    if value is None or type(value).__name__ == "NAType":
        return float("nan")
    if isinstance(value, (Real, Decimal)) and not isinstance(value, bool):
        try:
            return float(value)
        except OverflowError:
            message = f"column {name} has a number that is larger than a float can be"
            raise OverflowError(message) from None
    message = f"column {name} must hold numbers, but has {value!r}"
    raise TypeError(message)


def _of_one_length(columns: list[tuple[str, Array]]) -> list[tuple[str, Array]]:
    """Columns in which a single number applies to every row."""
    import numpy as np

    lengths = [(name, len(column)) for name, column in columns if column.ndim == 1]
    first, rows = lengths[0] if lengths else ("", 1)
    for name, length in lengths:
        if length != rows:
            message = f"column {first} has {rows} rows, but column {name} has {length}"
            raise ValueError(message)
    return [(name, one if one.ndim == 1 else np.full(rows, one)) for name, one in columns]
