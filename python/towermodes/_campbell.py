"""Resonance margins."""

from __future__ import annotations

from towermodes import _towermodes as _rust
from towermodes._computed import Pictured

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Campbell(Pictured):
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

    _compute = _rust.campbell
    _maker = "Tower.campbell"

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
