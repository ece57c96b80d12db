"""Resonance margins."""

from __future__ import annotations

from towermodes import _towermodes as _rust
from towermodes._computed import Tabular
from towermodes._picture import Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Campbell(Tabular):
    """Natural frequencies against the rotor speed, and their distances from the excitations.

    >>> import towermodes as tm
    >>> campbell = tm.read("examples/nrel-5mw.toml").campbell()
    >>> campbell.verdict
    'warn'
    >>> margin = campbell.margins[0]
    >>> margin["label"], margin["multiple"], round(margin["distance"], 2)
    ('1st side-side bending', 1, -0.37)
    """

    __slots__ = ()

    _compute = _rust.Campbell
    _maker = "Tower.campbell"
    _core: _rust.Campbell

    @property
    def verdict(self) -> str:
        """The worst verdict: "pass", "warn", "fail" or "undecided".

        If the list of modes does not reach the highest excitation, the verdict is "warn" or "fail".
        It is "undecided" where nothing is checked: see `not_checked`.
        """
        return self._core.verdict

    @property
    def not_checked(self) -> list[str]:
        """Why nothing is checked: unknown operating speeds, or parts that the tower lacks.

        The list is empty where there are verdicts.
        """
        return self._core.not_checked

    @property
    def conclusion(self) -> str:
        """The conclusion in sentences."""
        return " ".join(self._core.conclusion)

    @property
    def margins(self) -> list[dict[str, Any]]:
        """The distance of every natural frequency from every excitation.

        The keys are those of the program's JSON: `label`, `multiple`, `nearest_rpm`,
        `excitation_hz`, `natural_hz`, `distance`, `verdict` and others.
        """
        margins: list[dict[str, Any]] = self.data["margins"]
        return margins

    @property
    def notes(self) -> list[str]:
        """Assumptions and omissions when the file was read, and assumptions on the rotor."""
        return self._core.notes

    @property
    def warnings(self) -> list[str]:
        """Possible mistakes of the input and limits of the results."""
        return self._core.warnings

    def to_csv(self) -> str:
        """One line per mode and excitation as CSV, as the program writes it."""
        return self._core.csv()

    def plot(self) -> Picture:
        """The Campbell diagram."""
        return Picture(self._core.svg())

    def _said(self) -> list[str]:
        return [*self.notes, *self.warnings]

    def _picture(self) -> str:
        return self._core.svg()
