"""Many towers at once."""

from __future__ import annotations

from os import fsdecode

from towermodes import _towermodes as _rust
from towermodes._checks import MOST, whole_or_none, word_or_none
from towermodes._columns import columns_of
from towermodes._constant import Constant, constant
from towermodes._found import study_text, with_base
from towermodes._names import modes_chosen, place_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterator
    from typing import Any, SupportsIndex

    import numpy as np
    from numpy.typing import NDArray

    from towermodes._columns import Table
    from towermodes._failures import Failures
    from towermodes._found import Study
    from towermodes._names import Family, Modes
    from towermodes._tower import Tower

    Array = NDArray[np.float64]
    # Columns with their names, and the number of their first row.
    Values = tuple[list[tuple[str, Array]], int]


def swept(
    tower: Tower,
    table: Table | Study,
    options: dict[str, object],
    ignore: list[str],
    rows: range | None,
    progress: Callable[[int, int], object] | None,
) -> SweepResult:
    """The results of `Tower.sweep`, which documents the arguments."""
    values, options = _values(tower, table, options, ignore, _rows(rows))
    columns, first_row = values
    solved = _rust.sweep(tower._core, columns, first_row, options, progress=progress)
    return SweepResult(columns, first_row, solved)


def sampled(tower: Tower, study: Study) -> dict[str, Array]:
    """The values of `Tower.sample`, which documents the arguments."""
    options = sweep_options(None, None, None, True, None)
    (columns, _), _ = _of_study(tower, study, options, [], None)
    return dict(columns)


def _rows(rows: range | None) -> tuple[int, int] | None:
    """The first row, and the row after the last one."""
    if rows is None:
        return None
    if not isinstance(rows, range):
        message = f"rows is {rows!r}; it must be a range, as range(0, 50_000)"
        raise TypeError(message)
    if rows.step != 1 or rows.start < 0 or rows.start >= rows.stop or rows.stop > MOST:
        message = f"rows is {rows!r}; it must be successive rows from 0, as range(0, 50_000)"
        raise ValueError(message)
    return rows.start, rows.stop


def _values(
    tower: Tower,
    table: Any,
    options: dict[str, object],
    ignore: list[str],
    rows: tuple[int, int] | None,
) -> tuple[Values, dict[str, object]]:
    """The columns of a sweep, and its options, which a study may decide."""
    is_path = isinstance(table, (str, bytes)) or hasattr(table, "__fspath__")
    if is_path and not fsdecode(table).lower().endswith(".toml"):
        columns, first_row = _rust.values_of_table(tower._core, fsdecode(table), ignore, rows)
        return (constant(columns), first_row), options
    if is_path or _is_study(table):
        return _of_study(tower, table, options, ignore, rows)
    columns = columns_of(table, ignore)
    if rows is None or not columns:
        return (columns, 0), options
    first, end = _rust.rows_within(rows, len(columns[0][1]))
    return ([(name, values[first:end]) for name, values in columns], first), options


def _is_study(table: object) -> bool:
    """Whether a dict has the tables of a study, and not columns."""
    return isinstance(table, dict) and hasattr(table.get("sweep"), "items")


def _of_study(
    tower: Tower,
    study: Any,
    options: dict[str, object],
    ignore: list[str],
    rows: tuple[int, int] | None,
) -> tuple[Values, dict[str, object]]:
    given = with_base(study) if hasattr(study, "items") else study
    text, name = study_text(given)
    values, options = _rust.values_of_study(tower._core, text, name, ignore, options, rows)
    columns, first_row = values
    return (constant(columns), first_row), options


def sweep_options(
    modes: Modes | None,
    segments: SupportsIndex | None,
    method: str | None,
    rotary_inertia: bool,
    threads: SupportsIndex | None,
) -> dict[str, object]:
    """The arguments of a sweep as the module in Rust takes them."""
    count, names = modes_chosen(modes)
    return {
        "modes": count,
        "names": names,
        "segments": whole_or_none("segments", segments, 1),
        "method": word_or_none("method", method),
        "rotary_inertia": bool(rotary_inertia),
        "threads": whole_or_none("threads", threads, 1),
    }


class SweepResult:
    """The results of a sweep: one row for each tower, columns by the names of modes.

    `polars.DataFrame(result)`, `pyarrow.table(result)` and other libraries with the Arrow
    interface convert the result to a table; without this interface use
    `pandas.DataFrame(result.to_dict())`.

    >>> import towermodes as tm
    >>> tower = tm.read("examples/nrel-5mw.toml")
    >>> result = tower.sweep({"rna.mass": [340e3, 350e3, -1.0]}, modes=2)
    >>> result.mode("fore-aft", 1)
    array([0.32..., 0.32...,        nan])
    >>> result.failures
    [(2, 'rna.mass: the mass is -1 kg; it must not be negative')]
    """

    __slots__ = (
        "_certified",
        "_error_hz",
        "_frequency_hz",
        "_inputs",
        "_mass_kg",
        "_modes",
        "_share",
        "failures",
        "first_row",
        "shared",
        "shared_rows",
        "warned_rows",
        "warnings",
    )

    first_row: int
    """The number of the first row in the table or the study; 0 without the argument `rows`."""
    failures: Failures
    """Rows that failed or lack a mode: a list of row number, from 0, and message."""
    warned_rows: int
    """Number of rows with probable input mistakes that this tower without changes does not have."""
    warnings: list[tuple[int, str]]
    """The first of these rows, up to five: the row, from 0, and the message."""
    shared_rows: int
    """Number of rows in which the `share` of a mode is below 0.6."""
    shared: list[tuple[int, str]]
    """The first of these rows, up to five: the row, from 0, and the modes with coupled motions."""

    def __init__(
        self, inputs: list[tuple[str, Array]], first_row: int, solved: tuple[Any, ...]
    ) -> None:
        # It needs `collections`, whose import takes two milliseconds.
        from towermodes._failures import Failures

        modes, frequency_hz, error_hz, share, mass_kg, certified, failures, remarks = solved
        self._inputs: list[tuple[str, Array]] = inputs
        self.first_row = first_row
        self._modes: list[tuple[Family, int, str]] = modes
        self._frequency_hz: Array = frequency_hz
        self._error_hz: Array = error_hz
        self._share: Array = share
        self._mass_kg: Array = mass_kg
        self._certified: NDArray[np.bool_] = certified
        self.failures = Failures(*failures)
        (self.warned_rows, self.warnings), (self.shared_rows, self.shared) = remarks
        for array in (frequency_hz, error_hz, share, mass_kg, certified):
            array.flags.writeable = False

    def __setstate__(self, state: tuple[None, dict[str, Any]]) -> None:
        # A pickle has the arrays as arrays that can be written.
        for name, value in state[1].items():
            setattr(self, name, constant(value))

    @property
    def names(self) -> list[tuple[Family, int]]:
        """Family and order of each mode: the columns of `frequency_hz`."""
        return [(family, order) for family, order, _ in self._modes]

    @property
    def frequency_hz(self) -> Array:
        """Natural frequencies, extrapolated to the continuous beam, Hz: (rows, modes).

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
    def share(self) -> Array:
        """The share of the family of each name in the energy of its mode: (rows, modes).

        It is near 1 for a mode with one type of motion. If it is below 0.6, the motion is
        distributed over several modes, and from one row to the next these modes may exchange their
        names; `shared` has the first of these rows.
        """
        return self._share

    @property
    def mass_kg(self) -> Array:
        """`Tower.structure_mass_kg` of the towers, kg: (rows,)."""
        return self._mass_kg

    @property
    def certified(self) -> NDArray[np.bool_]:
        """Whether it is proved that no mode is missing: (rows,); False where a row has failed."""
        return self._certified

    @property
    def inputs(self) -> dict[str, Array]:
        """The columns of the table of the sweep; they are copies."""
        refusal = "the inputs of a sweep do not change; dict(result.inputs) is a copy that can change"
        return Constant(dict(self._inputs), refusal)

    def mode(self, family: Family | str, order: int | None = None) -> Array:
        """The frequencies of a mode by its name, extrapolated, Hz: (rows,).

        The name is `"fore-aft", 1` or `"fore-aft 1"`; without a number, the first mode is meant.

        Raises:
            KeyError: The sweep has no such mode; its argument `modes` can name it.
        """
        return self._frequency_hz[:, place_of(self.names, family, order, "the modes of the sweep")]

    def error_of(self, family: Family | str, order: int | None = None) -> Array:
        """The column of `error_hz` of a mode by its name, Hz: (rows,)."""
        return self._error_hz[:, place_of(self.names, family, order, "the modes of the sweep")]

    def share_of(self, family: Family | str, order: int | None = None) -> Array:
        """The column of `share` of a mode by its name: (rows,)."""
        return self._share[:, place_of(self.names, family, order, "the modes of the sweep")]

    def to_dict(self) -> dict[str, Any]:
        """The columns of the table, with the names that `towermodes sweep` writes.

        They are the number of the row, the inputs, mass, certified, frequency, error and share
        of each mode, and in `error` the message of a row that failed.
        """
        import numpy as np

        rows = range(self.first_row, self.first_row + len(self))
        columns: dict[str, Any] = {"row": np.arange(rows.start, rows.stop), **dict(self._inputs)}
        columns["mass_kg"] = self._mass_kg
        columns["certified"] = self._certified
        for place, (_, _, column) in enumerate(self._modes):
            columns[f"{column}_hz"] = self._frequency_hz[:, place]
            columns[f"{column}_error_hz"] = self._error_hz[:, place]
            columns[f"{column}_share"] = self._share[:, place]
        messages = dict(self.failures)
        columns["error"] = [messages.get(row) for row in rows]
        return columns

    def __array__(self, dtype: object = None, copy: object = None) -> Array:
        message = (
            "a sweep has several arrays: take result.frequency_hz (rows, modes), "
            'result.mode("fore-aft", 1), or the columns of result.to_dict()'
        )
        raise TypeError(message)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """The table as an Arrow stream, with the messages of failed rows in the column `error`."""
        return _rust.stream_of_results(
            self.first_row,
            self._inputs,
            [column for _, _, column in self._modes],
            self._mass_kg,
            self._certified,
            self._frequency_hz,
            self._error_hz,
            self._share,
            self.failures._columns,
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
        for row, message in self.warnings[:3]:
            yield f"warning: row {row}: {message}"
        if self.warned_rows > 3:
            yield f"and {self.warned_rows - 3} more rows with unusual input: see warnings"
        for row, message in self.shared[:3]:
            yield f"row {row}: {message}"
        if self.shared_rows > 3:
            yield f"and {self.shared_rows - 3} more rows in which modes share a motion: see shared"
