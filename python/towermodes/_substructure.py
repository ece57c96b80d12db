"""The modes of substructures without their towers."""

from __future__ import annotations

from os import fsdecode

from towermodes import _towermodes as _rust
from towermodes._checks import whole

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os
    from typing import Literal, SupportsIndex

    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


class SubstructureModes:
    """The lowest modes of a substructure of SubDyn, with the proof that none is missing.

    >>> import towermodes as tm
    >>> modes = tm.solve_substructure("examples/tripod_SubDyn.dat", modes=3)
    >>> modes.shape.shape
    (3, 9, 6)
    >>> len(modes.joints) == modes.shape.shape[1]
    True
    """

    __slots__ = ("_core", "_data")

    def __init__(self, core: _rust.Answer) -> None:
        import json

        self._core = core
        self._data: dict[str, Any] = json.loads(core.json())

    def __str__(self) -> str:
        return self._core.table().rstrip("\n")

    def __repr__(self) -> str:
        return f"<SubstructureModes: {len(self._data['modes'])} modes>"

    def _of_each(self, key: str) -> Array:
        import numpy as np

        values = np.array([mode[key] for mode in self._data["modes"]], dtype=float)
        values.setflags(write=False)
        return values

    @property
    def frequency_hz(self) -> Array:
        """Natural frequencies, Hz."""
        return self._of_each("frequency_hz")

    @property
    def error_hz(self) -> Array:
        """Errors of the frequencies, discretization plus eigenvalue computation, Hz."""
        return self._of_each("discretization_error_hz") + self._of_each("algebraic_error_hz")

    @property
    def joints(self) -> dict[str, tuple[float, float, float]]:
        """The joints by their names in the file, with their positions, m."""
        joints = self._data["substructure"]["joints"]
        return {joint["name"]: tuple(joint["position_m"]) for joint in joints}

    @property
    def shape(self) -> Array:
        """The motion of each joint: (modes, joints, 6), in the order of `joints`.

        The last axis is translation x, y, z (m), rotation about x, y, z (rad), for a modal mass of
        1 kg.
        """
        return self._of_each("motions")

    @property
    def member_shape(self) -> Array:
        """The translation of points within members: (modes, members, 3, 3).

        The third axis is the point, at a quarter, a half and three quarters of the member; the last
        is x, y, z, m, for a modal mass of 1 kg.
        """
        return self._of_each("members")

    @property
    def masses_kg(self) -> dict[str, float]:
        """The mass by kind, kg: members, growth, filling, joints, soil, and added mass of water."""
        masses = self._data["substructure"]["masses"]
        return {name.removesuffix("_kg"): mass for name, mass in masses.items()}

    @property
    def complete_below_hz(self) -> float:
        """The frequency below which no mode is missing, as an eigenvalue count proves, Hz."""
        return float(self._data["complete_below_hz"])

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


def solve_substructure(
    path: str | bytes | os.PathLike[str],
    *,
    modes: SupportsIndex = 8,
    clamped: bool = False,
    method: Literal["spectral", "subdyn"] = "spectral",
) -> SubstructureModes:
    """The lowest modes of a SubDyn file: a jacket, tripod or monopile without its tower.

    Args:
        path: The file.
        modes: How many modes.
        clamped: Hold the interface joints; otherwise they are free.
        method: "spectral", beams whose degree rises until the frequencies have converged, or
            "subdyn", the element of SubDyn with the divisions of the file.

    Raises:
        TowerError: The file has mistakes, or the substructure is unstable.
        ValueError: An option is unknown, or the file is no SubDyn file.
        OSError: The file cannot be read.

    >>> import towermodes as tm
    >>> held = tm.solve_substructure("examples/tripod_SubDyn.dat", modes=1, clamped=True)
    >>> bool(held.frequency_hz[0] > 0)
    True
    """
    if method not in ("spectral", "subdyn"):
        message = f"method is {method!r}; it must be 'spectral' or 'subdyn'"
        raise ValueError(message)
    count = whole("modes", modes, 1)
    core = _rust.solve_substructure(fsdecode(path), count, bool(clamped), method == "subdyn")
    return SubstructureModes(core)
