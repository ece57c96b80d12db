"""Damping of modes."""

from __future__ import annotations

from towermodes import _towermodes as _rust
from towermodes._computed import Answer

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


class Damping(Answer):
    """Damping ratios of the modes: contributions of parts, and aerodynamic damping.

    >>> import towermodes as tm
    >>> damping = tm.read("examples/nrel-5mw.toml").damping({"tower": 0.004}, modes=2)
    >>> damping.modes[0]["label"], round(damping.modes[0]["damping_ratio"], 9)
    ('1st side-side bending', 0.002)
    """

    __slots__ = ()

    _compute = _rust.damping
    _maker = "Tower.damping"

    @property
    def modes(self) -> list[dict[str, Any]]:
        """The modes with the keys of the program's JSON.

        `damping_ratio` is the sum of the parts whose loss factor is given, or None; `parts` has the
        energy and the damping of each part, `aerodynamic` the damping by the rotor at its lowest
        and at its highest speed, `energy_parts` the fractions of all energy.
        """
        modes: list[dict[str, Any]] = self.data["modes"]
        return modes
