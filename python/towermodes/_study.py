"""Methods compared on one tower, and descriptions of one tower compared."""

from __future__ import annotations

from towermodes import _towermodes as _rust
from towermodes._computed import Pictured, Tabular

TYPE_CHECKING = False
if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Comparison(Pictured):
    """Several methods compared on one tower.

    >>> import towermodes as tm
    >>> comparison = tm.read("examples/nrel-5mw.toml").compare(["rmje"], segments=[20, 40], modes=2)
    >>> comparison.columns
    [('rmje', 20), ('rmje', 40)]
    >>> bool((abs(comparison.relative_difference) < 1e-3).all())
    True
    """

    __slots__ = ()

    _compute = _rust.compare
    _maker = "Tower.compare"

    @property
    def columns(self) -> list[tuple[str, int]]:
        """Method and number of segments or elements: the rows of the arrays."""
        return [(column["method"], column["segments"]) for column in self.data["methods"]]

    @property
    def labels(self) -> list[str]:
        """The names of the modes in words."""
        return [mode["label"] for mode in self.data["modes"]]

    @property
    def frequency_hz(self) -> NDArray[np.float64]:
        """The frequencies, Hz: (methods, modes); NaN if a method lacks the mode."""
        return self._numbers("frequencies_hz")

    @property
    def relative_difference(self) -> NDArray[np.float64]:
        """Relative differences from the reference solution: (methods, modes)."""
        return self._numbers("relative_differences")

    def _numbers(self, key: str) -> NDArray[np.float64]:
        import numpy as np

        return np.array([column[key] for column in self.data["methods"]], dtype=np.float64)


class Agreement(Tabular):
    """Two descriptions of the same tower compared.

    >>> import towermodes as tm
    >>> first, second = tm.read("examples/nrel-5mw.toml"), tm.read("examples/nrel-5mw.yaml")
    >>> agreement = first.check(second)
    >>> agreement.verdict, agreement.data["mass_kg"]["verdict"]
    ('pass', 'pass')
    """

    __slots__ = ()

    _compute = _rust.check
    _maker = "Tower.check"
    _core: _rust.Answer

    @property
    def verdict(self) -> str:
        """The worst verdict: "pass", "warn" or "fail"."""
        return self._core.verdict

    @property
    def notes(self) -> list[str]:
        """Assumptions and omissions when the files were read, and omissions of the comparison."""
        return self._core.notes


class Examination(Tabular):
    """Masses and stiffnesses of one tower, in total and along the height.

    >>> import towermodes as tm
    >>> examination = tm.read("examples/nrel-5mw.toml").examine()
    >>> round(examination.data["center_of_mass_m"], 2)
    38.18
    """

    __slots__ = ()

    _compute = _rust.examine
    _maker = "Tower.examine"
