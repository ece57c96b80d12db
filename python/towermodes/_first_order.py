"""The uncertainty of the frequencies of a tower to first order, from derivatives."""

from __future__ import annotations

from towermodes import _towermodes as _rust
from towermodes._computed import Tabular

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any


class FirstOrder(Tabular):
    """Mean and standard deviation of frequencies to first order in the varied input values.

    The frequencies are linear functions of the varied input values, with the exact derivatives at
    the mean values. `warnings` names the modes whose curvature is too large for this approximation.

    >>> import towermodes as tm
    >>> tower = tm.read("examples/nrel-5mw.toml")
    >>> vary = {
    ...     "rna.mass": {"normal": [350e3, 7e3]},
    ...     "material.density": {"lognormal": [8500, 100]},
    ... }
    >>> scatter = tower.first_order({"sweep": {"vary": vary}}, modes=["fore-aft 1"])
    >>> scatter.mean_hz, scatter.deviation_hz
    ({'fore-aft 1': 0.3214...}, {'fore-aft 1': 0.0027...})
    >>> scatter.shares("fore-aft 1")
    {'rna.mass': 0.99..., 'material.density': 0.007...}
    """

    __slots__ = ()

    _compute = _rust.first_order
    _maker = "Tower.first_order"

    @property
    def mean_hz(self) -> dict[str, float]:
        """The extrapolated frequency at the mean values, Hz, by the name of the mode.

        NaN for a mode without a first order; `data` has the reason.
        """
        return self._of_modes("mean_hz")

    @property
    def deviation_hz(self) -> dict[str, float]:
        """The standard deviations of the frequencies, Hz, by the name of the mode."""
        return self._of_modes("deviation_hz")

    @property
    def mean_shift_hz(self) -> dict[str, float]:
        """Estimated second-order shift of each mean by the curvature, Hz.

        `mean_hz` does not include it. NaN where it is not known.
        """
        return self._of_modes("mean_shift_hz")

    def shares(self, mode: str) -> dict[str, float]:
        """The share of each varied input value in the variance of a mode; they add up to 1.

        The joint contribution of two correlated values is divided equally between them, so a share
        may be negative.

        Raises:
            KeyError: There is no such mode.
        """
        modes = {one["mode"]: one for one in self.data["modes"]}
        if mode not in modes:
            message = f"no mode {mode} among {', '.join(modes)}"
            raise KeyError(message)
        names = [one["name"] for one in self.data["inputs"]]
        effects = modes[mode]["inputs"]
        # A mode without a first order has no effects.
        return {name: one["share"] for name, one in zip(names, effects, strict=False)}

    @property
    def warnings(self) -> list[str]:
        """Notes of the reader, and modes for which the first order is not accurate."""
        warnings: list[str] = self.data["warnings"]
        return warnings

    def _of_modes(self, key: str) -> dict[str, float]:
        return {one["mode"]: _number(one[key]) for one in self.data["modes"]}

    def _said(self) -> list[str]:
        return self.warnings


def with_rows(study: Mapping[str, Any]) -> Mapping[str, Any]:
    """A study in a dict; the number of rows, which a study requires, is added if it is missing."""
    sweep: Any = study.get("sweep")
    if not hasattr(sweep, "items") or "table" in sweep:
        return study
    return {**study, "sweep": {"sampling": "random", "rows": 1, **sweep}}


def _number(value: float | None) -> float:
    return float("nan") if value is None else value
