# Made from the columns of modes by a test with TOWERMODES_BLESS=1; do not edit.
"""The numbers of modes."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]


class ModeArrays:
    """The numbers of all modes of a solution as arrays."""

    __slots__ = ()

    _core: Any

    def column(self, key: str) -> Any:
        """A column of the CSV by its key, one value for each mode: an array, or a list of texts.

        Raises:
            KeyError: There is no such column.

        >>> import towermodes as tm
        >>> solution = tm.read("examples/nrel-5mw.toml").solve(modes=2)
        >>> solution.column("label")
        ['1st side-side bending', '1st fore-aft bending']
        >>> solution.column("energy.strain.fore_aft").round(3)
        array([0., 1.])
        """
        return self._core.column(key)

    @property
    def share(self) -> Array:
        """Share of its own family in its energy: (modes,)."""
        array: Array = self.column("share")
        return array

    @property
    def frequency_hz(self) -> Array:
        """Natural frequency of the discretized tower, not extrapolated, Hz: (modes,)."""
        array: Array = self.column("frequency_hz")
        return array

    @property
    def period_s(self) -> Array:
        """Period; infinite for a motion without stiffness, s: (modes,)."""
        array: Array = self.column("period_s")
        return array

    @property
    def algebraic_error_hz(self) -> Array:
        """Bound on the error of the eigenvalue computation, Hz: (modes,)."""
        array: Array = self.column("algebraic_error_hz")
        return array

    @property
    def discretization_error_hz(self) -> Array:
        """Estimate of the discretization error, Hz: (modes,)."""
        array: Array = self.column("discretization_error_hz")
        return array

    @property
    def extrapolated_hz(self) -> Array:
        """Frequency of the beam, extrapolated from several numbers of segments, Hz: (modes,)."""
        array: Array = self.column("extrapolated_hz")
        return array

    @property
    def modal_mass_kg(self) -> Array:
        """Modal mass for the shape as normalized; none for torsion and yaw, kg: (modes,)."""
        array: Array = self.column("modal_mass_kg")
        return array

    @property
    def modal_inertia_kg_m2(self) -> Array:
        """Modal inertia of torsion and yaw, kg m²: (modes,)."""
        array: Array = self.column("modal_inertia_kg_m2")
        return array


class ModeNumbers:
    """The numbers of one mode."""

    __slots__ = ()

    def _value(self, key: str) -> float:
        raise NotImplementedError

    @property
    def share(self) -> float:
        """Share of its own family in its energy."""
        return self._value("share")

    @property
    def frequency_hz(self) -> float:
        """Natural frequency of the discretized tower, not extrapolated, Hz."""
        return self._value("frequency_hz")

    @property
    def period_s(self) -> float:
        """Period; infinite for a motion without stiffness, s."""
        return self._value("period_s")

    @property
    def algebraic_error_hz(self) -> float:
        """Bound on the error of the eigenvalue computation, Hz."""
        return self._value("algebraic_error_hz")

    @property
    def discretization_error_hz(self) -> float:
        """Estimate of the discretization error, Hz."""
        return self._value("discretization_error_hz")

    @property
    def extrapolated_hz(self) -> float:
        """Frequency of the beam, extrapolated from several numbers of segments, Hz."""
        return self._value("extrapolated_hz")

    @property
    def modal_mass_kg(self) -> float:
        """Modal mass for the shape as normalized; none for torsion and yaw, kg."""
        return self._value("modal_mass_kg")

    @property
    def modal_inertia_kg_m2(self) -> float:
        """Modal inertia of torsion and yaw, kg m²."""
        return self._value("modal_inertia_kg_m2")
