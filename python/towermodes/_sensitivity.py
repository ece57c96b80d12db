"""Derivatives of frequencies and mass."""

from __future__ import annotations

from towermodes import _towermodes as _rust
from towermodes._constant import constant
from towermodes._html import table_html
from towermodes._names import place_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterator
    from typing import Any

    import numpy as np
    from numpy.typing import NDArray

    from towermodes._names import Family

    Array = NDArray[np.float64]


class Sensitivities:
    """Derivatives of mass and natural frequencies of a tower with respect to its input values.

    The frequencies are extrapolated, as in a sweep. The derivatives are computed from the mode
    shapes, not as differences between the frequencies of two towers. If with fewer than 60 segments
    the error of a derivative is above 0.1 %, as often in soil, all derivatives are computed on a
    finer mesh, where their errors are about 0.1 %; `error_hz_per_unit` is an estimate of
    these errors; fewer than one in a thousand is more than three times as large.

    `polars.DataFrame(result)`, `pyarrow.table(result)` and other libraries with the Arrow
    interface convert the result to a table; without this interface use
    `pandas.DataFrame(result.to_dict())`.

    >>> import towermodes as tm
    >>> tower = tm.read("examples/nrel-5mw.toml")
    >>> result = tower.sensitivities(["rna.mass", "scale(stations[*].wall)"], modes=2)
    >>> result.modes
    [('side-side', 1), ('fore-aft', 1)]
    >>> result.elasticity.round(3)
    array([[-0.422, -0.427],
           [ 0.431,  0.43 ]])
    """

    __slots__ = (
        "_elasticity",
        "_error",
        "_frequency_hz",
        "_hz_per_unit",
        "_mass",
        "_modes",
        "_values",
        "_varied",
        "missing",
    )

    missing: list[tuple[str, tuple[Family, int], str]]
    """Derivatives that do not exist: the name of the input value, the mode, and the reason."""

    def __init__(self, derived: tuple[Any, ...]) -> None:
        import numpy as np

        varied, modes, frequency_hz, derivatives, mass, missing = derived
        self._varied: list[tuple[str, str, float]] = varied
        self._modes: list[tuple[Family, int, str]] = modes
        self._values: Array = np.array([value for _, _, value in varied], dtype=np.float64)
        self._frequency_hz: Array = frequency_hz
        self._hz_per_unit: Array
        self._error: Array
        self._elasticity: Array
        self._hz_per_unit, self._error, self._elasticity = derivatives
        self._mass: Array = mass
        names = self.modes
        self.missing = [(varied[row][0], names[mode], reason) for row, mode, reason in missing]
        for array in (self._values, frequency_hz, *derivatives, mass):
            array.flags.writeable = False

    def __setstate__(self, state: tuple[None, dict[str, Any]]) -> None:
        # A pickle has the arrays as arrays that can be written.
        for name, value in state[1].items():
            setattr(self, name, constant(value))

    @property
    def names(self) -> list[str]:
        """The names of the input values: the rows of the arrays."""
        return [name for name, _, _ in self._varied]

    @property
    def units(self) -> list[str]:
        """The units of the input values; empty for a value without a unit and for a factor."""
        return [unit for _, unit, _ in self._varied]

    @property
    def values(self) -> Array:
        """The input values: (inputs,); 1 for a factor (`scale`), 0 for `add`."""
        return self._values

    @property
    def modes(self) -> list[tuple[Family, int]]:
        """Family and order of each mode: the columns of the arrays."""
        return [(family, order) for family, order, _ in self._modes]

    @property
    def frequency_hz(self) -> Array:
        """Natural frequencies, extrapolated to the continuous beam, Hz: (modes,).

        Every station is a segment border, so the frequencies may differ from those of a sweep, but
        not by more than their errors.
        """
        return self._frequency_hz

    @property
    def hz_per_unit(self) -> Array:
        """Derivatives of the frequencies, Hz per unit of the input value: (inputs, modes).

        NaN where a frequency has no derivative; `missing` says why.
        """
        return self._hz_per_unit

    @property
    def error_hz_per_unit(self) -> Array:
        """Estimated errors of `hz_per_unit`, Hz per unit: (inputs, modes)."""
        return self._error

    @property
    def elasticity(self) -> Array:
        """Percent of the frequency per percent of the input value: (inputs, modes).

        NaN without a derivative, and for `add`.
        """
        return self._elasticity

    @property
    def mass_kg_per_unit(self) -> Array:
        """Derivatives of `Tower.structure_mass_kg`, kg per unit: (inputs,)."""
        return self._mass

    def mode(self, family: Family | str, order: int | None = None) -> Array:
        """The derivatives of a mode by its name, Hz per unit: (inputs,).

        Raises:
            KeyError: The mode is not among `modes`; the argument `modes` can name it.
        """
        return self._hz_per_unit[:, place_of(self.modes, family, order)]

    def to_dict(self) -> dict[str, Any]:
        """The columns of the table, with one row for each input value."""
        return {"name": self.names, "unit": self.units, **self._numbers()}

    def _numbers(self) -> dict[str, Array]:
        columns = {"value": self._values, "mass_kg_per_unit": self._mass}
        for place, (_, _, column) in enumerate(self._modes):
            columns[f"{column}_hz_per_unit"] = self._hz_per_unit[:, place]
            columns[f"{column}_error_hz_per_unit"] = self._error[:, place]
            columns[f"{column}_elasticity"] = self._elasticity[:, place]
        return columns

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """The table of `to_dict` as an Arrow stream."""
        texts = [("name", self.names), ("unit", self.units)]
        return _rust.stream_of_columns(texts, list(self._numbers().items()))

    def __len__(self) -> int:
        return len(self._varied)

    def __repr__(self) -> str:
        header, rows = self._cells()
        widths = [max(map(len, column)) for column in zip(header, *rows, strict=True)]
        return "\n".join(_line(row, widths) for row in (header, *rows))

    def _repr_html_(self) -> str:
        header, rows = self._cells()
        return table_html(header, rows, texts=(0, 2))

    def _cells(self) -> tuple[list[str], list[list[str]]]:
        """Number, value, unit, and derivatives of mass and frequencies."""
        header = ["number", "value", "unit", "d mass kg/unit"]
        header += [f"d {family} {order} Hz/unit" for family, order in self.modes]
        return header, list(self._rows())

    def _rows(self) -> Iterator[list[str]]:
        for place, (name, unit, value) in enumerate(self._varied):
            derivatives = [self._mass[place], *self._hz_per_unit[place]]
            numbers = ["-" if number != number else f"{number:.6g}" for number in derivatives]
            yield [name, f"{value:.6g}", unit, *numbers]


def _line(cells: list[str], widths: list[int]) -> str:
    aligned = (
        cell.ljust(width) if place in (0, 2) else cell.rjust(width)
        for place, (cell, width) in enumerate(zip(cells, widths, strict=True))
    )
    return "  ".join(aligned).rstrip()
