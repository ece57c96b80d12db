"""Turbines with rotating rotors and flexible blades."""

from __future__ import annotations

from math import isfinite

from towermodes import _towermodes as _rust
from towermodes._checks import number, number_or_none, whole
from towermodes._computed import Computed, Pictured
from towermodes._constant import constant

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any, SupportsIndex

    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from towermodes._tower import Tower

    Array = NDArray[np.float64]


class Turbine:
    """A tower with its nacelle, drivetrain and rotating rotor of flexible blades.

    `Tower.turbine` makes it. Structure only: no aerodynamics, no controller, constant rotor speed.

    >>> import towermodes as tm
    >>> turbine = tm.read("examples/nrel-5mw-turbine.toml").turbine
    >>> turbine
    <Turbine 'NREL 5 MW turbine on land': 3 blades>
    >>> modes = turbine.modes(12.1, limit_hz=1.0)
    >>> modes.names[:3]
    ['1st tower fore-aft', '1st tower side-side', '1st flapwise backward whirl']
    >>> modes.certified
    True
    """

    __slots__ = ("_tower",)

    _tower: Tower

    def __init__(self, *_: object, **__: object) -> None:
        message = "a Turbine is made by Tower.turbine"
        raise TypeError(message)

    @classmethod
    def _of(cls, tower: Tower) -> Turbine:
        turbine = cls.__new__(cls)
        turbine._tower = tower
        return turbine

    @property
    def tower(self) -> Tower:
        """The tower, with the turbine as a rigid body on it."""
        return self._tower

    @property
    def blades(self) -> int:
        """Number of blades."""
        return self._tower._core.turbine_blades or 0

    @property
    def notes(self) -> list[str]:
        """Assumptions and omissions when the file was read, including those on the turbine."""
        return self._tower._core.turbine_notes

    def modes(self, rpm: float, limit_hz: float) -> TurbineModes:
        """All modes below a frequency at a rotor speed, with bounds from eigenvalue counts.

        Args:
            rpm: The rotor speed, rpm; 0 is standstill.
            limit_hz: The upper limit of the frequencies, Hz.

        Raises:
            ValueError: Speed or limit is impossible.

        >>> import towermodes as tm
        >>> turbine = tm.read("examples/nrel-5mw-turbine.toml").turbine
        >>> turbine.modes(0.0, 1.0).names[2]
        '1st flapwise backward whirl'
        """
        speed, limit = number("rpm", rpm), number("limit_hz", limit_hz)
        if not isfinite(speed):
            message = f"rpm is {speed}; it must be a finite number"
            raise ValueError(message)
        return TurbineModes._of((self._tower,), speed, limit)

    def campbell(
        self,
        rpm: ArrayLike = (),
        *,
        limit_hz: float | None = None,
        operating_rpm: Sequence[float] | None = None,
        multiples: Sequence[SupportsIndex] = (),
        margin: float = 0.05,
    ) -> TurbineCampbell:
        """The coupled Campbell diagram: all modes below a frequency, followed over the rotor speed.

        Args:
            rpm: Rotor speeds, rpm, at which the turbine is solved besides the operating speeds; by
                default 25 from standstill to 1.2 times the highest operating speed. Where curves
                come close to each other, speeds are added.
            limit_hz: The upper limit of the frequencies, Hz; by default above the highest
                excitation and the second bending modes of the tower.
            operating_rpm: Lowest and highest operating speed; by default those of the file,
                otherwise the lowest and the highest of `rpm`.
            multiples: Multiples of the rotor speed; by default 1, B, 2B, 3B with B blades.
            margin: Required distance as a fraction of the natural frequency: 0.05 is 5 %.

        Raises:
            ValueError: The rotor speed is not known, or a value is impossible.

        >>> import towermodes as tm
        >>> turbine = tm.read("examples/nrel-5mw-turbine.toml").turbine
        >>> campbell = turbine.campbell([0.0, 6.0, 12.1], limit_hz=1.0)
        >>> campbell.certified
        True
        >>> campbell.names[0]
        '1st tower fore-aft'
        """
        import numpy as np

        speeds = [number("rpm", one) for one in np.ravel(np.asarray(rpm, dtype=object))]
        operating = None
        if operating_rpm is not None:
            if len(operating_rpm) != 2:
                message = f"operating_rpm is {operating_rpm!r}; it must be (lowest, highest)"
                raise ValueError(message)
            lowest, highest = operating_rpm
            operating = (number("operating_rpm", lowest), number("operating_rpm", highest))
        rotor: dict[str, object] = {
            "rpm": operating,
            "blades": None,
            "multiples": [whole("a multiple", multiple, 1) for multiple in multiples],
            "margin": number("margin", margin),
        }
        limit = number_or_none("limit_hz", limit_hz)
        return TurbineCampbell._of((self._tower,), speeds, limit, rotor)

    def __eq__(self, other: object) -> bool:
        """Whether both have equal towers and the same input values."""
        if not isinstance(other, Turbine):
            return NotImplemented
        return self._tower == other._tower

    def __hash__(self) -> int:
        return hash((self._tower, self.blades))

    def __reduce__(self) -> tuple[object, ...]:
        return (Turbine._of, (self._tower,))

    def __repr__(self) -> str:
        name = f"{self._tower.name!r}: " if self._tower.name else ""
        return f"<Turbine {name}{self.blades} blades>"


class TurbineModes(Computed):
    """The modes of a turbine at a rotor speed, by rising frequency.

    Arrays have one entry per mode. Frequencies are in the fixed frame, not in the rotating
    frame.

    >>> import towermodes as tm
    >>> modes = tm.read("examples/nrel-5mw-turbine.toml").turbine.modes(12.1, 1.0)
    >>> print(modes)
    6 modes below 1 Hz at 12.1 rpm
    ...
    """

    __slots__ = ()

    _compute = _rust.TurbineModes
    _maker = "Turbine.modes"
    _core: _rust.TurbineModes

    @property
    def turbine(self) -> Turbine:
        """The turbine."""
        return Turbine._of(self._towers[0])

    @property
    def rotor_speed_rpm(self) -> float:
        """The rotor speed, rpm."""
        return self._core.rotor_speed_rpm

    @property
    def limit_hz(self) -> float:
        """The frequency below which the list contains all modes, Hz."""
        return self._core.limit_hz

    @property
    def certified(self) -> bool:
        """Whether eigenvalue counts prove that no mode is missing and that none is unstable."""
        return self._core.certified

    @property
    def negative_energy(self) -> tuple[int, int]:
        """Numbers of modes of negative energy: for a stable turbine at this speed, and found.

        Both are 0 unless the rotor turns faster than the lowest natural frequency of its blades.
        """
        return self._core.negative_energy

    @property
    def growing(self) -> int:
        """Least number of unstable modes; 0 if there is none or if the number is not known.

        `certified` is true only if no mode is unstable.
        """
        return self._core.growing

    @property
    def unresisted(self) -> int:
        """Number of motions without stiffness, such as yaw of a platform without moorings.

        They are slower than 1.6e-6 Hz and are not in the list. The rotation of a free shaft is not
        counted.
        """
        return self._core.unresisted

    @property
    def frequency_hz(self) -> Array:
        """Natural frequencies, Hz: (modes,)."""
        array: Array = self._core.frequency_hz
        return array

    @property
    def bounds_hz(self) -> Array:
        """Lower and upper bounds of the frequencies, from eigenvalue counts, Hz: (modes, 2)."""
        array: Array = self._core.bounds_hz
        return array

    @property
    def error_hz(self) -> Array:
        """Estimates of the discretization errors, Hz: (modes,); NaN where there is none."""
        array: Array = self._core.error_hz
        return array

    @property
    def names(self) -> list[str]:
        """Names of the modes, each given to one mode only: "1st flapwise backward whirl"."""
        return self._core.names

    @property
    def share(self) -> Array:
        """Fractions of the elastic energy of the modes in the parts that name them: (modes,)."""
        array: Array = self._core.share
        return array

    @property
    def second(self) -> list[tuple[str, float] | None]:
        """Of each mode the other part with the most elastic energy, and its fraction, or None."""
        return self._core.second

    @property
    def nodding(self) -> list[str | None]:
        """For each mode "tilt" or "yaw", or None.

        It is given for whirls whose backward and forward waves together mostly tilt or mostly yaw
        the nacelle, as at standstill.
        """
        return self._core.nodding

    @property
    def energy(self) -> dict[str, Array]:
        """Fractions of the elastic energy by part: each (modes,). For each mode they sum to 1.

        The parts are the motions of a floating platform (`platform_surge` to `platform_yaw`), the
        local motion of the frame below the tower (`substructure`), `tower_fore_aft`,
        `tower_side_side`, `tower_torsion`, `tower_axial`, `yaw_drive`, `shaft`, and `flapwise`,
        `edgewise`, `blade_torsion`, `blade_axial`, each with `_collective`, `_forward` and
        `_backward`.
        """
        shares: Array = self._core.energy
        return {part: shares[:, k] for k, part in enumerate(self._core.energy_parts)}

    @property
    def notes(self) -> list[str]:
        """Assumptions and omissions when the file was read."""
        return self._core.notes

    def to_dict(self) -> dict[str, object]:
        """A table with a row for each mode: `pandas.DataFrame(modes.to_dict())`."""
        return {
            "name": self.names,
            "share": self.share,
            "frequency_hz": self.frequency_hz,
            "lower_hz": self.bounds_hz[:, 0],
            "upper_hz": self.bounds_hz[:, 1],
            "error_hz": self.error_hz,
            **self.energy,
        }

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        count = f"{len(self)} mode{'' if len(self) == 1 else 's'}"
        head = f"{count} below {self.limit_hz:g} Hz at {self.rotor_speed_rpm:g} rpm"
        rows = [
            f"{hz:12.6f} Hz  {name}"
            for hz, name in zip(self.frequency_hz, self.names, strict=True)
        ]
        proof = "complete and stable" if self.certified else "unstable or not certified"
        return "\n".join([head, *rows, proof])


class TurbineCampbell(Pictured):
    """Modes of a turbine followed over the rotor speed, and their distances from the excitations.

    Frequencies are in the fixed frame, not in the rotating frame. Arrays of numbers are
    (curves, speeds), NaN where a curve has left the diagram.

    >>> import towermodes as tm
    >>> turbine = tm.read("examples/nrel-5mw-turbine.toml").turbine
    >>> campbell = turbine.campbell([0.0, 12.1], limit_hz=1.0)
    >>> campbell.frequency_hz.shape == (len(campbell.names), len(campbell.rpm))
    True
    """

    __slots__ = ("_parsed",)

    _compute = _rust.turbine_campbell
    _maker = "Turbine.campbell"
    _parsed: dict[str, Any]

    @property
    def turbine(self) -> Turbine:
        """The turbine."""
        return Turbine._of(self._towers[0])

    @property
    def verdict(self) -> str:
        """The worst verdict: "pass", "warn", "fail" or "undecided".

        It is "warn" or "fail" if the modes do not cover all excitations or are not certified at the
        operating speeds.
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
    def certified(self) -> bool:
        """Whether counts prove at all speeds that no mode is missing and that none is unstable."""
        is_certified: bool = self._json["is_certified"]
        return is_certified

    @property
    def certified_at(self) -> NDArray[np.bool_]:
        """Whether counts prove this at each rotor speed: (speeds,)."""
        import numpy as np

        speeds = self._json["speeds"]
        return np.array([speed["is_complete"] for speed in speeds], dtype=np.bool_)

    @property
    def limit_hz(self) -> float:
        """The frequency up to which all modes are followed, Hz."""
        limit_hz: float = self._json["limit_hz"]
        return limit_hz

    @property
    def rpm(self) -> Array:
        """The rotor speeds at which the turbine was solved, rpm: (speeds,)."""
        return _array([speed["rotor_speed_rpm"] for speed in self._json["speeds"]])

    @property
    def names(self) -> list[str]:
        """The titles of the curves: the names of their modes over most of the operating speeds.

        Where curves veer, the names change along them: see `names_at`.
        """
        return [curve["label"] for curve in self._json["curves"]]

    @property
    def names_at(self) -> list[list[str | None]]:
        """The name of the mode of each curve at each speed, None where it has left the diagram.

        At each speed a name is that of one mode, as in `Turbine.modes` at this speed.

        >>> import towermodes as tm
        >>> turbine = tm.read("examples/nrel-5mw-turbine.toml").turbine
        >>> campbell = turbine.campbell([0.0, 12.1], limit_hz=1.0)
        >>> sorted(row[-1] for row in campbell.names_at if row[-1])[:2]
        ['1st edgewise backward whirl', '1st flapwise backward whirl']
        """
        points = self._points()
        return [[None if point is None else point["label"] for point in row] for row in points]

    @property
    def share(self) -> Array:
        """Fractions of the elastic energy in the parts of `names_at`: (curves, speeds)."""
        return self._numbers("share")

    @property
    def partners(self) -> list[int | None]:
        """For each whirl, the index of the whirl of the same motion in the opposite direction."""
        return [curve["partner"] for curve in self._json["curves"]]

    @property
    def frequency_hz(self) -> Array:
        """Natural frequencies, Hz: (curves, speeds)."""
        return self._numbers("frequency_hz")

    @property
    def lower_hz(self) -> Array:
        """Lower bounds of the frequencies, from eigenvalue counts, Hz: (curves, speeds)."""
        return self._numbers("lower_hz")

    @property
    def upper_hz(self) -> Array:
        """Upper bounds of the frequencies, from eigenvalue counts, Hz: (curves, speeds)."""
        return self._numbers("upper_hz")

    @property
    def error_hz(self) -> Array:
        """Discretization errors, Hz: (curves, speeds).

        They are estimated at the lowest and highest speed of the diagram and of operation; at other
        speeds they are NaN.
        """
        return self._numbers("error_hz")

    @property
    def energy(self) -> dict[str, Array]:
        """Fractions of the elastic energy by part, as in `TurbineModes`: each (curves, speeds)."""
        points = self._points()
        shares = [[point and _shares(point["energy"]) for point in curve] for curve in points]
        parts = next((list(of) for curve in shares for of in curve if of), [])
        return {part: _array([[_of(of, part) for of in c] for c in shares]) for part in parts}

    @property
    def margins(self) -> list[dict[str, Any]]:
        """The distance of every curve from every excitation, with the keys of the program's JSON."""
        margins: list[dict[str, Any]] = self.data["margins"]
        return margins

    @property
    def _json(self) -> dict[str, Any]:
        """The data, parsed once."""
        if not hasattr(self, "_parsed"):
            self._parsed = self.data
        return self._parsed

    def _points(self) -> list[list[dict[str, Any] | None]]:
        """The points of each curve at all speeds, None where it has left the diagram."""
        speeds = [speed["rotor_speed_rpm"] for speed in self._json["speeds"]]
        curves = [
            {point["rotor_speed_rpm"]: point for point in curve["points"]}
            for curve in self._json["curves"]
        ]
        return [[curve.get(rpm) for rpm in speeds] for curve in curves]

    def _numbers(self, key: str) -> Array:
        """A number of each point: (curves, speeds)."""
        return _array([[_of(point, key) for point in curve] for curve in self._points()])

    def to_dict(self) -> dict[str, object]:
        """A table with a row for each curve and speed: `pandas.DataFrame(campbell.to_dict())`."""
        import numpy as np

        is_there = np.isfinite(self.frequency_hz)
        curve, speed = np.nonzero(is_there)
        names, names_at = self.names, self.names_at
        numbers = {
            "share": self.share,
            "frequency_hz": self.frequency_hz,
            "lower_hz": self.lower_hz,
            "upper_hz": self.upper_hz,
            "error_hz": self.error_hz,
            **self.energy,
        }
        return {
            "curve": curve,
            "curve_name": [names[k] for k in curve],
            "name": [names_at[k][j] for k, j in zip(curve, speed, strict=True)],
            "rpm": self.rpm[speed],
            **{name: values[is_there] for name, values in numbers.items()},
        }


_PLATFORM = ("surge", "sway", "heave", "roll", "pitch", "yaw")


def _shares(energy: dict[str, Any]) -> dict[str, float]:
    """Fractions of energy by the names of `TurbineModes.energy`."""
    platform = zip(_PLATFORM, energy["platform"], strict=True)
    shares = {f"platform_{motion}": share for motion, share in platform}
    for part, share in energy.items():
        if isinstance(share, dict):
            ways = ("collective", "forward", "backward")
            shares.update({f"{part}_{way}": share[way] for way in ways})
        elif part != "platform":
            shares[part] = share
    return shares


def _of(values: dict[str, Any] | None, key: str) -> float:
    """A number of a point; NaN where there is none."""
    value = values[key] if values else None
    return float("nan") if value is None else float(value)


def _array(numbers: list[Any]) -> Array:
    """Numbers as an array that cannot be written."""
    import numpy as np

    array: Array = constant(np.array(numbers, dtype=np.float64))
    return array
