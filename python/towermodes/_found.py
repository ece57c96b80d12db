"""Towers with computed input values: designs and calibrations."""

from __future__ import annotations

from os import fsdecode

from towermodes import _towermodes as _rust
from towermodes._computed import Tabular
from towermodes._toml import tower_file

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os
    from collections.abc import Mapping
    from typing import Any

    import numpy as np
    from numpy.typing import NDArray

    from towermodes._tower import Tower

    Study = str | bytes | os.PathLike[str] | Mapping[str, Any]


def study_text(study: Study) -> tuple[str, str]:
    """The text of a study, and the name of its file."""
    if isinstance(study, (str, bytes)) or hasattr(study, "__fspath__"):
        return _rust.source(fsdecode(study))
    if hasattr(study, "items"):
        return tower_file(study), "<description>"
    message = f"{study!r} is neither the path of a file nor a dict with its tables"
    raise TypeError(message)


def with_base(study: Mapping[str, Any]) -> Mapping[str, Any]:
    """The study of a sweep in a dict, with the base tower that a study requires."""
    sweep: Any = study.get("sweep")
    if not hasattr(sweep, "items"):
        return study
    return {**study, "sweep": {"base": "this tower", **sweep}}


class Found(Tabular):
    """A tower with input values from a design or a calibration."""

    __slots__ = ()

    _list = ""
    """The key of the varied input values in the data."""
    _value = ""
    """The key of the values found."""

    @property
    def tower(self) -> Tower:
        """The tower with the values found."""
        return type(self._towers[0])._of(self._core.tower)

    @property
    def values(self) -> dict[str, float]:
        """The values found, by the name of the input value."""
        return {one["name"]: one[self._value] for one in self.data[self._list]}


class Design(Found):
    """A light tower whose frequencies are in given bands.

    >>> import towermodes as tm
    >>> tower = tm.read("examples/nrel-5mw.toml")
    >>> study = {
    ...     "design": {
    ...         "variables": {"scale(stations[*].wall)": {"between": [0.7, 1.5]}},
    ...         "frequencies": {"side-side 1": {"min": 0.3}},
    ...     }
    ... }
    >>> design = tower.design(study)
    >>> design.values
    {'scale(stations[*].wall)': 0.86543...}
    >>> round(design.mass_kg), design.is_stationary
    (300877, True)
    """

    __slots__ = ()

    _compute = _rust.design
    _maker = "Tower.design"
    _list = "variables"
    _value = "after"

    @property
    def mass_kg(self) -> float:
        """`Tower.structure_mass_kg` of the tower found, kg."""
        mass: float = self.data["mass_kg"]
        return mass

    @property
    def is_stationary(self) -> bool:
        """Whether the first-order conditions hold before rounding to steps (KKT residual)."""
        is_stationary: bool = self.data["is_stationary"]
        return is_stationary

    @property
    def warnings(self) -> list[str]:
        """Notes of the reader, and possible defects of the result."""
        warnings: list[str] = self.data["warnings"]
        return warnings


class Calibration(Found):
    """A tower with input values fitted to measured frequencies.

    >>> import towermodes as tm
    >>> tower = tm.read("examples/nrel-5mw.toml")
    >>> measured = {
    ...     "calibrate": {"unknowns": {"rna.mass": {}}},
    ...     "measured": [{"mode": "fore-aft 1", "frequency": 0.325, "deviation": 0.001}],
    ... }
    >>> fit = tower.calibrate(measured)
    >>> fit.values, fit.deviations
    ({'rna.mass': 341127...}, {'rna.mass': 2467...})
    >>> fit.tower.rna_mass_kg
    341127...
    """

    __slots__ = ()

    _compute = _rust.calibrate
    _maker = "Tower.calibrate"
    _list = "numbers"
    _value = "value"

    @property
    def deviations(self) -> dict[str, float]:
        """The standard deviations of the fitted input values, by name; NaN at a bound."""
        numbers = self.data["numbers"]
        return {one["name"]: _number(one["deviation"]) for one in numbers}

    @property
    def correlation(self) -> NDArray[np.float64]:
        """The correlations of the fitted input values: (values, values); NaN at a bound."""
        import numpy as np

        return np.array(self.data["correlations"], dtype=np.float64)

    @property
    def covariance(self) -> NDArray[np.float64]:
        """The covariances of the fitted input values: (values, values); NaN at a bound.

        The entries are the product of two standard deviations and their correlation, in the units
        of the two values.
        """
        import numpy as np

        deviations = np.array(list(self.deviations.values()))
        covariance: NDArray[np.float64] = self.correlation * np.outer(deviations, deviations)
        return covariance

    @property
    def residuals(self) -> dict[str, float]:
        """Fitted minus measured frequency in standard deviations, by the name of the mode."""
        return {one["mode"]: one["residual"] for one in self.data["measured"]}

    @property
    def remarks(self) -> list[str]:
        """Input values that the measurements do not determine, and possible defects of the fit."""
        remarks: list[str] = self.data["remarks"]
        return remarks


def _number(value: float | None) -> float:
    return float("nan") if value is None else value
