"""Methods compared on one tower, and descriptions of one tower compared."""

from __future__ import annotations

from towermodes._html import text_html
from towermodes._picture import Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    import numpy as np
    from numpy.typing import NDArray

    from towermodes import _towermodes as _rust


def _parsed(text: str) -> dict[str, Any]:
    import json

    data: dict[str, Any] = json.loads(text)
    return data


class Comparison:
    """Several methods compared on one tower.

    >>> import towermodes as tm
    >>> comparison = tm.read("examples/nrel-5mw.toml").compare(["rmje"], segments=[20, 40], modes=2)
    >>> comparison.columns
    [('rmje', 20), ('rmje', 40)]
    >>> bool((abs(comparison.relative_difference) < 1e-3).all())
    True
    """

    __slots__ = ("_core",)

    _core: _rust.Comparison

    @classmethod
    def _of(cls, core: _rust.Comparison) -> Comparison:
        comparison = cls.__new__(cls)
        comparison._core = core
        return comparison

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

    @property
    def data(self) -> dict[str, Any]:
        """All results with the keys of the program's JSON."""
        return _parsed(self.to_json())

    @property
    def warnings(self) -> list[str]:
        """Warnings of the reference solution, and of methods that lack modes."""
        return self._core.warnings

    def to_json(self) -> str:
        """All results as JSON, as the program writes it."""
        return self._core.json()

    def to_csv(self) -> str:
        """One line per mode and method as CSV, as the program writes it."""
        return self._core.csv()

    def plot(self) -> Picture:
        """The picture of the differences from the reference solution."""
        return Picture(self._core.svg())

    def __repr__(self) -> str:
        warnings = "".join(f"warning: {warning}\n" for warning in self.warnings)
        return (self._core.table() + warnings).rstrip("\n")

    def _repr_html_(self) -> str:
        return text_html(repr(self), self._core.svg())


class Agreement:
    """Two descriptions of the same tower compared.

    >>> import towermodes as tm
    >>> first, second = tm.read("examples/nrel-5mw.toml"), tm.read("examples/nrel-5mw.yaml")
    >>> agreement = first.check(second)
    >>> agreement.verdict, agreement.data["mass_kg"]["verdict"]
    ('pass', 'pass')
    """

    __slots__ = ("_core",)

    _core: _rust.Agreement

    @classmethod
    def _of(cls, core: _rust.Agreement) -> Agreement:
        agreement = cls.__new__(cls)
        agreement._core = core
        return agreement

    @property
    def verdict(self) -> str:
        """The worst verdict: "pass", "warn" or "fail"."""
        return self._core.verdict

    @property
    def data(self) -> dict[str, Any]:
        """All values with the keys of the program's JSON."""
        return _parsed(self.to_json())

    @property
    def notes(self) -> list[str]:
        """Assumptions and omissions when the files were read, and omissions of the comparison."""
        return self._core.notes

    def to_json(self) -> str:
        """All values as JSON, as the program writes it."""
        return self._core.json()

    def __repr__(self) -> str:
        return self._core.table().rstrip("\n")

    def _repr_html_(self) -> str:
        return text_html(repr(self))


class Examination:
    """Masses and stiffnesses of one tower, in total and along the height.

    >>> import towermodes as tm
    >>> examination = tm.read("examples/nrel-5mw.toml").examine()
    >>> round(examination.data["center_of_mass_m"], 2)
    38.18
    """

    __slots__ = ("_core",)

    _core: _rust.Examination

    @classmethod
    def _of(cls, core: _rust.Examination) -> Examination:
        examination = cls.__new__(cls)
        examination._core = core
        return examination

    @property
    def data(self) -> dict[str, Any]:
        """All values with the keys of the program's JSON."""
        return _parsed(self.to_json())

    def to_json(self) -> str:
        """All values as JSON, as the program writes it."""
        return self._core.json()

    def __repr__(self) -> str:
        return self._core.table().rstrip("\n")

    def _repr_html_(self) -> str:
        return text_html(repr(self))
