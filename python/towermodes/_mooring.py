"""Mooring lines at rest, without their platform."""

from __future__ import annotations

from os import fsdecode

from towermodes import _towermodes as _rust

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os
    from typing import Any

    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


class MooringAtRest:
    """Mooring lines at the reference position of their platform.

    >>> import towermodes as tm
    >>> lines = tm.solve_mooring("examples/spar_MoorDyn.dat")
    >>> lines.stiffness.shape
    (6, 6)
    >>> round(float(lines.stiffness[0, 0]))
    41181
    """

    __slots__ = ("_core", "_data")

    def __init__(self, core: _rust.Answer) -> None:
        import json

        self._core = core
        self._data: dict[str, Any] = json.loads(core.json())

    def __str__(self) -> str:
        return self._core.table().rstrip("\n")

    def __repr__(self) -> str:
        return f"<MooringAtRest: {len(self._data['lines'])} lines>"

    @staticmethod
    def _array(values: object) -> Array:
        import numpy as np

        array = np.array(values, dtype=float)
        array.setflags(write=False)
        return array

    @property
    def stiffness(self) -> Array:
        """Stiffness against motions of the platform: (6, 6), N/m, N, N m.

        The motions are surge, sway, heave, roll, pitch and yaw of the reference point.
        """
        return self._array(self._data["stiffness"])

    @property
    def force(self) -> Array:
        """Force x, y, z (N) and moment about x, y, z (N m) on the platform."""
        return self._array(self._data["force"])

    @property
    def tension_n(self) -> Array:
        """Tension at both ends of each line: (lines, 2), N."""
        return self._array([line["tensions_n"] for line in self._data["lines"]])

    @property
    def on_seabed_m(self) -> Array:
        """Length of each line on the seabed, m."""
        return self._array([line["on_seabed_m"] for line in self._data["lines"]])

    @property
    def points_m(self) -> Array:
        """Positions of the points: (points, 3), m, z up from still water."""
        return self._array(self._data["points_m"])

    @property
    def notes(self) -> list[str]:
        """The assumptions made when the file was read, and omitted data."""
        return self._core.notes

    @property
    def data(self) -> dict[str, Any]:
        """All values with the keys of the program's JSON."""
        import json

        data: dict[str, Any] = json.loads(self._core.json())
        return data

    def to_json(self) -> str:
        """All values as JSON, as the program writes it."""
        return self._core.json()


def solve_mooring(path: str | bytes | os.PathLike[str]) -> MooringAtRest:
    """The lines of a file of MoorDyn or MAP++ at the reference position of the platform.

    Args:
        path: The file.

    Raises:
        TowerError: The file has mistakes, or a line cannot reach.
        ValueError: The file describes no mooring lines.
        OSError: The file cannot be read.

    >>> import towermodes as tm
    >>> lines = tm.solve_mooring("examples/spar_MoorDyn.dat")
    >>> lines.tension_n.shape
    (3, 2)
    """
    return MooringAtRest(_rust.solve_mooring(fsdecode(path)))
