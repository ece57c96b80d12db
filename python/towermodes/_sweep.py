"""Many towers at once."""

from __future__ import annotations

from towermodes import _towermodes as _rust
from towermodes._checks import whole, whole_or_none, word_or_none

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping, Sequence
    from typing import Any, Protocol, SupportsIndex

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from towermodes._solution import Family
    from towermodes._tower import Tower

    Array = NDArray[np.float64]

    class ArrowTable(Protocol):
        """A table of any library that has the Arrow PyCapsule interface."""

        def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

    Table = ArrowTable | Mapping[str, ArrayLike]


def swept(
    tower: Tower,
    table: Table,
    modes: SupportsIndex | Sequence[tuple[str, int] | str] | None,
    segments: SupportsIndex | None,
    method: str | None,
    rotary_inertia: bool,
    threads: SupportsIndex | None,
) -> SweepResult:
    """The results of `Tower.sweep`, which documents the arguments."""
    columns = _columns(table)
    options = sweep_options(modes, segments, method, rotary_inertia, threads)
    return SweepResult(columns, _rust.sweep(tower._core, columns, options))


def sweep_options(
    modes: SupportsIndex | Sequence[tuple[str, int] | str] | None,
    segments: SupportsIndex | None,
    method: str | None,
    rotary_inertia: bool,
    threads: SupportsIndex | None,
) -> dict[str, object]:
    """The arguments of a sweep as the module in Rust takes them."""
    count, names = _modes(modes)
    return {
        "modes": count,
        "names": names,
        "segments": whole_or_none("segments", segments, 1),
        "method": word_or_none("method", method),
        "rotary_inertia": bool(rotary_inertia),
        "threads": whole_or_none("threads", threads, 1),
    }


def _modes(
    modes: SupportsIndex | Sequence[tuple[str, int] | str] | None,
) -> tuple[int | None, list[str]]:
    if modes is None:
        return None, []
    if hasattr(modes, "__index__"):
        return whole("modes", modes, 1), []
    if isinstance(modes, str):
        return None, [modes]
    pairs = (name if isinstance(name, str) else f"{name[0]} {name[1]}" for name in modes)
    return None, list(pairs)


def _columns(table: Any) -> list[tuple[str, Array]]:
    """The columns of a table of any kind, as arrays of one length."""
    # A DataFrame of pandas would add its index to the stream, and needs pyarrow for it.
    if hasattr(table, "iloc") and hasattr(table, "columns"):
        return [(str(name), _numbers(str(name), table[name].to_numpy())) for name in table.columns]
    if hasattr(table, "__arrow_c_stream__"):
        return _rust.columns_of_stream(table.__arrow_c_stream__())
    if hasattr(table, "items"):
        return _of_one_length([(str(name), _numbers(str(name), v)) for name, v in table.items()])
    message = (
        f"the table is a {type(table).__name__}; it must be a dict of arrays, a DataFrame "
        "or an Arrow table"
    )
    raise TypeError(message)


def _numbers(name: str, values: object) -> Array:
    import numpy as np

    try:
        column: Array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        message = f"column {name} must hold numbers: {error}"
        raise TypeError(message) from None
    if column.ndim > 1:
        message = f"column {name} has {column.ndim} dimensions, but must have one"
        raise ValueError(message)
    return column


def _of_one_length(columns: list[tuple[str, Array]]) -> list[tuple[str, Array]]:
    """Columns in which a single number stands for a number in every row."""
    import numpy as np

    lengths = [len(column) for _, column in columns if column.ndim == 1]
    rows = lengths[0] if lengths else 1
    return [
        (name, column if column.ndim == 1 else np.full(rows, column)) for name, column in columns
    ]


class SweepResult:
    """The results of a sweep: one row for each tower, columns by the names of modes.

    `polars.DataFrame(result)`, `pyarrow.table(result)` and other libraries with the Arrow
    interface take it as a table; `pandas.DataFrame(result.to_dict())` does so without it.

    >>> import towermodes as tm
    >>> tower = tm.read("examples/nrel-5mw.toml")
    >>> result = tower.sweep({"rna.mass": [340e3, 350e3, -1.0]}, modes=2)
    >>> result.mode("fore-aft", 1)
    array([0.32..., 0.32...,        nan])
    >>> result.failures
    [(2, 'rna.mass: mass is -1 kg; it must not be negative')]
    """

    __slots__ = (
        "_certified",
        "_error_hz",
        "_frequency_hz",
        "_inputs",
        "_mass_kg",
        "_modes",
        "failures",
    )

    failures: list[tuple[int, str]]
    """What failed or is missing: the row, from 0, and the message."""

    def __init__(self, inputs: list[tuple[str, Array]], solved: tuple[Any, ...]) -> None:
        modes, frequency_hz, error_hz, mass_kg, certified, failures = solved
        self._inputs: list[tuple[str, Array]] = inputs
        self._modes: list[tuple[str, int, str]] = modes
        self._frequency_hz: Array = frequency_hz
        self._error_hz: Array = error_hz
        self._mass_kg: Array = mass_kg
        self._certified: NDArray[np.bool_] = certified
        self.failures = failures
        for array in (frequency_hz, error_hz, mass_kg, certified):
            array.flags.writeable = False

    @property
    def names(self) -> list[tuple[str, int]]:
        """Family and order of each mode: the columns of `frequency_hz`."""
        return [(family, order) for family, order, _ in self._modes]

    @property
    def frequency_hz(self) -> Array:
        """Natural frequencies of the beam, extrapolated, Hz: (rows, modes).

        They correspond to `Solution.extrapolated_hz` for the same number of segments, not to
        `Solution.frequency_hz`.

        NaN where a row has failed or lacks the mode; `failures` says why.
        """
        return self._frequency_hz

    @property
    def error_hz(self) -> Array:
        """Estimated errors of the frequencies without extrapolation, Hz: (rows, modes).

        The errors of the extrapolated frequencies are usually much smaller.
        """
        return self._error_hz

    @property
    def mass_kg(self) -> Array:
        """Masses of the towers without the rotor-nacelle assembly, kg: (rows,)."""
        return self._mass_kg

    @property
    def certified(self) -> NDArray[np.bool_]:
        """Whether it is proved that no mode is missing: (rows,); False where a row has failed."""
        return self._certified

    @property
    def inputs(self) -> dict[str, Array]:
        """The columns of the table of the sweep."""
        return dict(self._inputs)

    def mode(self, family: Family, order: int = 1) -> Array:
        """The frequencies of a mode by its name, extrapolated, Hz: (rows,).

        Raises:
            KeyError: The sweep has no such mode; its argument `modes` can name it.
        """
        return self._frequency_hz[:, self._place(family, order)]

    def error_of(self, family: Family, order: int = 1) -> Array:
        """The column of `error_hz` of a mode by its name, Hz: (rows,)."""
        return self._error_hz[:, self._place(family, order)]

    def _place(self, family: str, order: int) -> int:
        names = self.names
        if (family, order) in names:
            return names.index((family, order))
        there = ", ".join(f"{family} {order}" for family, order in names)
        message = f"no mode {family} {order} among the modes of the sweep: {there}"
        raise KeyError(message)

    def to_dict(self) -> dict[str, Any]:
        """The columns of the table: inputs, mass, certified, frequency and error of each mode."""
        columns: dict[str, Any] = dict(self._inputs)
        columns["mass_kg"] = self._mass_kg
        columns["certified"] = self._certified
        for place, (_, _, column) in enumerate(self._modes):
            columns[f"{column}_hz"] = self._frequency_hz[:, place]
            columns[f"{column}_error_hz"] = self._error_hz[:, place]
        return columns

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """The table as an Arrow stream, with the messages of failed rows in the column `error`."""
        return _rust.stream_of_results(
            self._inputs,
            [column for _, _, column in self._modes],
            self._mass_kg,
            self._certified,
            self._frequency_hz,
            self._error_hz,
            self.failures,
        )

    def __len__(self) -> int:
        return len(self._mass_kg)

    def __repr__(self) -> str:
        return "\n".join(self._lines())

    def _lines(self) -> Iterator[str]:
        failed = len(self.failures)
        yield f"{len(self)} towers, {failed} failed" if failed else f"{len(self)} towers"
        yield f"{'mode':<14}{'lowest Hz':>12}{'mean Hz':>12}{'highest Hz':>12}"
        for place, (family, order) in enumerate(self.names):
            column = self._frequency_hz[:, place]
            column = column[column == column]
            numbers = (column.min(), column.mean(), column.max()) if len(column) else ()
            cells = "".join(f"{number:>12.6g}" for number in numbers)
            yield f"{family} {order}".ljust(14) + cells
        for row, message in self.failures[:3]:
            yield f"row {row}: {message}"
        if failed > 3:
            yield f"and {failed - 3} more failed rows: see failures"
