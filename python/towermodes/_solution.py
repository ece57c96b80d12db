"""Natural frequencies and mode shapes."""

from __future__ import annotations

from towermodes._computed import Computed
from towermodes._html import solution_html
from towermodes._mode_columns import ModeArrays, ModeNumbers
from towermodes._names import place_of
from towermodes._picture import Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    import numpy as np
    from numpy.typing import NDArray

    from towermodes import _towermodes as _rust
    from towermodes._names import Family
    from towermodes._sensitivity import Sensitivities
    from towermodes._tower import Tower

    Array = NDArray[np.float64]


def _solve(tower: _rust.Tower, options: dict[str, object]) -> _rust.Solution:
    return tower.solve(options)


class Solution(ModeArrays, Computed):
    """The lowest modes of a tower, with their errors and the proof that none is missing.

    Arrays have one entry per mode, by rising frequency; of a repeated pair the fore-aft mode comes
    first. Because the place in the list changes where frequencies cross, take a mode by its name:
    `solution.mode("fore-aft", 1)`.

    >>> import towermodes as tm
    >>> solution = tm.read("examples/nrel-5mw.toml").solve(modes=3)
    >>> print(solution)
    NREL 5 MW tower with RNA
    <BLANKLINE>
     mode  mode shape             frequency Hz     ± error  period s
        1  1st side-side bending    0.31947040  0.00000045     3.130
        2  1st fore-aft bending     0.32146321  0.00000046     3.111
        3  1st torsion              1.56550943  0.00000070    0.6388
    <BLANKLINE>
    tower 347.374 t, RNA 350.000 t | rmje-exact, 100 segments | complete: exactly 3 modes below ...
    effective modal mass of these modes: ...
    """

    __slots__ = ()

    _compute = staticmethod(_solve)
    _maker = "Tower.solve"
    _core: _rust.Solution

    @property
    def tower(self) -> Tower:
        """The tower that was solved."""
        return self._towers[0]

    @property
    def error_hz(self) -> Array:
        """Errors of `frequency_hz`, discretization plus eigenvalue computation, Hz: (modes,)."""
        array: Array = self._core.error_hz
        return array

    @property
    def modal_mass(self) -> Array:
        """Modal masses for the shapes as normalized: (modes,), kg; kg m² for torsion and yaw."""
        array: Array = self._core.modal_mass
        return array

    @property
    def effective_mass(self) -> Array:
        """Effective modal masses in x, y, z, kg, and about x, y, z, kg m²: (modes, 6)."""
        array: Array = self._core.effective_mass
        return array

    @property
    def effective_mass_shares(self) -> Array | None:
        """Sums of the effective masses of these modes as fractions of the total masses: (6,).

        None if each mode has the added mass at its own frequency: such masses do not add up.
        The columns `effective_mass_shares.x` and so on have the fractions of each mode.
        """
        array: Array | None = self._core.effective_mass_shares
        return array

    @property
    def rigid_inertia(self) -> Array:
        """Inertia of the whole tower against rigid motions about its base: (6, 6).

        The motions are x, y, z and rotations about x, y, z; kg, kg m, kg m².
        """
        array: Array = self._core.rigid_inertia
        return array

    @property
    def shape(self) -> Array:
        """The mode shapes at `height_m`: (modes, heights, 6).

        The last axis is translation x (fore-aft), y (side-side), z (up), rotation about x, y, z.
        The largest translation is 1, and rotations are in rad for a translation of 1 m; for torsion
        and yaw the largest rotation is 1.

        >>> import towermodes as tm
        >>> solution = tm.read("examples/nrel-5mw.toml").solve(modes=2, points=11)
        >>> solution.shape.shape
        (2, 11, 6)
        """
        array: Array = self._core.shape
        return array

    @property
    def height_m(self) -> Array:
        """The heights of `shape`, m: (heights,), from the base to the top."""
        array: Array = self._core.height_m
        return array

    @property
    def station_shape(self) -> Array:
        """The mode shapes at `station_height_m`: (modes, stations, 6), like `shape`."""
        array: Array = self._core.station_shape
        return array

    @property
    def station_height_m(self) -> Array:
        """The heights of the stations of the tower, m: (stations,)."""
        array: Array = self._core.station_height_m
        return array

    @property
    def shape_at_heights(self) -> Array:
        """The mode shapes at the argument `heights_m` of `Tower.solve`: (modes, heights, 6)."""
        array: Array = self._core.shape_there
        return array

    @property
    def joint_shape(self) -> Array:
        """The motion of the joints of the substructure: (modes, joints, 6).

        The order is that of `Tower.joints`, and the normalization that of `shape`. The axis of the
        joints is empty for a tower without a substructure of members.
        """
        array: Array = self._core.joint_shape
        return array

    @property
    def member_shape(self) -> Array:
        """The translation of points within the members of the substructure: (modes, members, 3, 3).

        The order is that of `Tower.members`, and the normalization that of `shape`. The third axis
        is the point, at a quarter, a half and three quarters of the member from its first joint;
        the last axis is x, y, z.
        """
        points: Array = self._core.member_shape
        modes, rows, _ = points.shape
        return points.reshape(modes, rows // 3, 3, 3)

    @property
    def names(self) -> list[tuple[Family, int]]:
        """Family and order of each mode: `("fore-aft", 1)`."""
        names: list[tuple[Family, int]] = self._core.names  # type: ignore[assignment]
        return names

    @property
    def labels(self) -> list[str]:
        """The names of the modes in words: "1st fore-aft bending"."""
        return self._core.labels

    @property
    def method(self) -> str:
        """The method."""
        return self._core.method

    @property
    def segments(self) -> int:
        """Number of segments or elements."""
        return self._core.segments

    @property
    def degree(self) -> int | None:
        """Polynomial degree of the elements of the method "spectral"; None for other methods."""
        return self._core.degree

    @property
    def degrees_of_freedom(self) -> int:
        """Degrees of freedom of the whole tower."""
        return self._core.degrees_of_freedom

    @property
    def certified(self) -> bool:
        """Whether the count of eigenvalues proves that no mode is missing.

        The proof is that exactly `count` modes exist below `complete_below_hz`. An incomplete list
        raises an exception, except if the added mass of a floating platform depends on frequency
        and leaves an uncertain interval: `uncertain_hz`. If the number of modes cuts a pair of
        equal frequencies, the other mode of the last pair is counted but not in the list.
        """
        return self._core.certificate[0]

    @property
    def count(self) -> int:
        """The number of modes below `complete_below_hz`, counted without computing them.

        It is larger than the number of modes in the list if the list ends within a pair.
        """
        return self._core.certificate[1]

    @property
    def complete_below_hz(self) -> float:
        """The frequency below which exactly `count` modes exist, Hz."""
        return self._core.certificate[2]

    @property
    def uncertain_hz(self) -> tuple[float, float] | None:
        """The interval outside which the list is complete, Hz; None if it is complete everywhere."""
        return self._core.uncertain_hz

    @property
    def buckling_load_factor(self) -> float | None:
        """The factor on gravity at which the tower buckles.

        None without gravity, and for a floating tower.
        """
        return self._core.buckling_load_factor

    @property
    def notes(self) -> list[str]:
        """Assumptions made when the file was read; data that is left out; changes by `with_`."""
        return self._core.notes

    @property
    def warnings(self) -> list[str]:
        """Possible mistakes of the input and limits of the results.

        They are also in the table that `print` shows. They are not Python warnings, because a tower
        that is solved a thousand times would repeat each of them a thousand times.
        """
        return self._core.warnings

    @property
    def modes(self) -> list[Mode]:
        """The modes by rising frequency."""
        return [Mode(self, index) for index in range(len(self))]

    def mode(self, family: Family | str, order: int | None = None) -> Mode:
        """The mode with a family and an order in it, from 1, or with a name: `"fore-aft 1"`.

        Raises:
            KeyError: The list has no such mode; a longer list may contain it.
            ValueError: There is no such family.

        >>> import towermodes as tm
        >>> solution = tm.read("examples/nrel-5mw.toml").solve()
        >>> solution.mode("torsion").label
        '1st torsion'
        """
        return Mode(self, place_of(self.names, family, order))

    def sensitivities(self, names: Iterable[str] | None = None) -> Sensitivities:
        """Derivatives of the frequencies of these modes with respect to the input values.

        The result is that of `Tower.sensitivities` for the same modes, method, rotary inertia and,
        if it was given, number of segments. The options `degree` and `hinge_position` of
        `Tower.solve` have no effect.

        Args:
            names: As in `Tower.sensitivities`; by default each input value of the tower.

        Raises:
            ValueError: As in `Tower.sensitivities`.
            SolveError: A slightly changed tower, from which a derivative follows, has no modes.

        >>> import towermodes as tm
        >>> solution = tm.read("examples/nrel-5mw.toml").solve(modes=2)
        >>> solution.sensitivities(["rna.mass"]).elasticity
        array([[-0.42..., -0.42...]])
        """
        options = self._arguments[0]
        return self.tower.sensitivities(
            names,
            modes=self.names,
            method=options["method"],
            segments=options["segments"],
            rotary_inertia=options["rotary_inertia"],
        )

    def to_json(self) -> str:
        """All results as JSON, as the program writes it."""
        return self._core.json()

    def to_csv(self) -> str:
        """One line per mode as CSV, as the program writes it."""
        return self._core.csv()

    def plot(self) -> Picture:
        """The picture of the mode shapes beside the tower."""
        return Picture(self._core.svg())

    def __len__(self) -> int:
        return len(self._core.names)

    def __getitem__(self, place: int) -> Mode:
        """The mode at a place in the list, from 0; from the end if it is negative."""
        number = range(len(self))[place]
        if isinstance(number, range):
            message = "a solution has no slices; take them of its modes: solution.modes[:2]"
            raise TypeError(message)
        return Mode(self, number)

    def __iter__(self) -> Iterator[Mode]:
        return iter(self.modes)

    def __eq__(self, other: object) -> bool:
        """Whether both are solutions of equal towers by the same options."""
        if not isinstance(other, Solution):
            return NotImplemented
        same = (self._towers, self._arguments) == (other._towers, other._arguments)
        return same or (self.tower == other.tower and self.to_json() == other.to_json())

    def __hash__(self) -> int:
        return hash((self.tower, len(self)))

    def __repr__(self) -> str:
        warnings = "".join(f"warning: {warning}\n" for warning in self.warnings)
        return (self._core.table() + warnings).rstrip("\n")

    def _repr_html_(self) -> str:
        return solution_html(self._core)


class Mode(ModeNumbers):
    """A mode of a solution.

    >>> import towermodes as tm
    >>> mode = tm.read("examples/nrel-5mw.toml").solve().mode("side-side", 1)
    >>> mode
    <Mode 1: 1st side-side bending, 0.31947 Hz>
    >>> mode.error_hz < 1e-6
    True
    """

    __slots__ = ("_index", "_solution")

    def __init__(self, solution: Solution, index: int) -> None:
        self._solution = solution
        self._index = index

    def __eq__(self, other: object) -> bool:
        """Whether both are the same mode of equal solutions."""
        if not isinstance(other, Mode):
            return NotImplemented
        return (self._index, self._solution) == (other._index, other._solution)

    def __hash__(self) -> int:
        return hash((self._index, self._solution))

    def _value(self, key: str) -> float:
        return float(self._solution.column(key)[self._index])

    @property
    def number(self) -> int:
        """Place in the list, from 1."""
        return self._index + 1

    @property
    def family(self) -> Family:
        """The type of motion: "fore-aft", "side-side", "torsion" or "axial".

        For rigid-body motions of a floating tower "surge", "sway", "heave", "roll", "pitch" or
        "yaw"; for local modes of a frame under the tower "substructure". Where motions are
        coupled, `share` says how much of the energy is in this one.
        """
        return self._solution.names[self._index][0]

    @property
    def share(self) -> float:
        """The share of its family in the energy of the mode, 0 to 1.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> tower = tower.with_(changes={"scale(rna.inertia.zz)": 0.63})
        >>> [(mode.label, round(mode.share, 2)) for mode in tower.solve(modes=4).modes[2:]]
        [('1st torsion', 0.69), ('2nd side-side bending', 0.69)]
        """
        return self._value("share")

    @property
    def second(self) -> tuple[Family, float] | None:
        """The other family with the largest share of the energy, and this share, or None.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> tower = tower.with_(changes={"scale(rna.inertia.zz)": 0.63})
        >>> family, share = tower.solve(modes=4)[2].second
        >>> family, round(share, 2)
        ('side-side', 0.31)
        """
        return self._solution._core.second[self._index]  # type: ignore[return-value]

    @property
    def order(self) -> int:
        """Order within the family, from 1."""
        return self._solution.names[self._index][1]

    @property
    def label(self) -> str:
        """The name in words: "1st fore-aft bending"."""
        return self._solution.labels[self._index]

    @property
    def error_hz(self) -> float:
        """Error of `frequency_hz`, discretization plus eigenvalue computation, Hz."""
        return float(self._solution.error_hz[self._index])

    @property
    def modal_mass(self) -> float:
        """Modal mass for the shape as normalized, kg; kg m² for torsion and yaw."""
        return float(self._solution.modal_mass[self._index])

    @property
    def effective_mass(self) -> Array:
        """Effective modal masses in x, y, z, kg, and about x, y, z, kg m²: (6,)."""
        array: Array = self._solution.effective_mass[self._index]
        return array

    @property
    def shape(self) -> Array:
        """The shape at `Solution.height_m`: (heights, 6), as `Solution.shape`."""
        array: Array = self._solution.shape[self._index]
        return array

    def __repr__(self) -> str:
        return f"<Mode {self.number}: {self.label}, {self.frequency_hz:.5g} Hz>"
