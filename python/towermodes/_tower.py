"""Towers."""

from __future__ import annotations

import copyreg

from towermodes import _towermodes as _rust
from towermodes._campbell import Campbell
from towermodes._checks import (
    heights_inside,
    number,
    number_or_none,
    whole,
    whole_or_none,
    word,
    word_or_none,
    words,
)
from towermodes._constant import Constant
from towermodes._convert import Converted
from towermodes._damping import Damping
from towermodes._errors import TowerError
from towermodes._first_order import FirstOrder, with_rows
from towermodes._found import Calibration, Design, study_text, with_base
from towermodes._names import mode_name, modes_chosen
from towermodes._picture import Picture
from towermodes._sensitivity import Sensitivities
from towermodes._solution import Solution
from towermodes._study import Agreement, Comparison, Examination
from towermodes._sweep import SweepResult, sampled, sweep_options, swept
from towermodes._toml import table as first_of_table
from towermodes._toml import tower_file
from towermodes._turbine import Turbine

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence
    from typing import Any, Literal, SupportsFloat, SupportsIndex

    import numpy as np
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Self

    from towermodes._columns import Table as Sweepable
    from towermodes._found import Study
    from towermodes._names import Modes

    Method = Literal[
        "rmje-exact", "rmje", "cardanic-exact", "cardanic", "lumped", "bmodes", "spectral"
    ]
    Format = Literal["toml", "bmodes", "elastodyn", "windio"]
    Table = Mapping[str, Any]

#: The message if input values of a tower are assigned.
NO_WRITING = 'a tower does not change; tower.with_({"rna.mass": 360e3}) makes another one'


class Tower:
    """A tower. It never changes; `with_` makes another one.

    The arguments are the tables of the tower file and the keys of its table [tower], with the same
    keys and units.

    Args:
        stations: Rows of height, outer diameter and wall thickness, m, from the base to the top,
            and the name of the material if there are several.
        properties: Instead of stations: lists of properties per length.
        material: `density`, `youngs_modulus`, and `shear_modulus` or `poissons_ratio`.
        materials: Several materials by their names.
        rna: The rotor-nacelle assembly: `mass`, and `center` and `inertia`; or a number, the mass.
        turbine: In place of rna: nacelle, drivetrain and flexible blades.
        name: The name of the tower.
        outfitting_factor: Multiplies the density, for paint, bolts, flanges.
        shear: Shear deformation: True, or a shear coefficient.
        point_mass: Masses: dicts with `height`, `mass`, and `inertia`.
        foundation: `type` and its keys.
        substructure: Joints and members under the tower: `joint`, `member` and others.
        mooring: Mooring lines of a floating platform: `line`, `line_type`, `point` and others.
        soil: Soil springs over the height: dicts with `rows`.
        ground: Soil in layers around the embedded pile: `surface`, `submerged`, `layer` and others.
        added_mass: Tables of added mass: dicts with `rows`.
        water: `level`, and `bed`, `density` and others.
        wires: Sets of guy wires: dicts.
        gravity: `acceleration`; or a number, the acceleration in m/s².
        rotor: `blades` and `rpm`.
        drivetrain: `rotor_inertia` and others, for a rotor that is free to rotate.
        damping: Loss factors, and data of the blades: `tower_loss_factor` and others.
        missing_parts: Parts of the structure that the source of the tower has and this model lacks:
            `"substructure"`, `"mooring-lines"` and others. The results have a note on them, and
            resonance is not checked.

    Raises:
        TowerError: The input values do not describe a valid tower.

    >>> import towermodes as tm
    >>> tower = tm.Tower(
    ...     stations=[[0.0, 6.0, 0.027], [87.6, 3.87, 0.019]],
    ...     material={"density": 8500.0, "youngs_modulus": 2.1e11, "shear_modulus": 8.08e10},
    ...     rna={"mass": 350e3},
    ... )
    >>> round(tower.solve().mode("fore-aft", 1).frequency_hz, 5)
    0.30021
    """

    __slots__ = ("_core",)

    _core: _rust.Tower

    def __init__(
        self,
        *,
        stations: ArrayLike | Sequence[Sequence[object]] | None = None,
        properties: Table | None = None,
        material: Table | None = None,
        materials: Mapping[str, Table] | None = None,
        rna: Table | SupportsFloat | None = None,
        turbine: Table | None = None,
        name: str | None = None,
        outfitting_factor: float | None = None,
        shear: bool | float | None = None,
        point_mass: Sequence[Table] | None = None,
        foundation: Table | None = None,
        substructure: Table | None = None,
        mooring: Table | None = None,
        soil: Sequence[Table] | None = None,
        ground: Table | None = None,
        added_mass: Sequence[Table] | None = None,
        water: Table | None = None,
        wires: Sequence[Table] | None = None,
        gravity: Table | SupportsFloat | None = None,
        rotor: Table | None = None,
        drivetrain: Table | None = None,
        damping: Table | None = None,
        missing_parts: Sequence[str] | None = None,
    ) -> None:
        given: dict[str, object] = dict(locals())
        del given["self"]
        _, keys = _rust.tower_file_keys()
        tower = {key: given.pop(key) for key in keys}
        tower = {key: value for key, value in tower.items() if value is not None}
        given["rna"] = first_of_table("mass", rna)
        given["gravity"] = first_of_table("acceleration", gravity)
        text = tower_file({**given, "tower": tower})
        self._core = _rust.read_text(text, "<description>")

    @classmethod
    def _of(cls, core: _rust.Tower) -> Self:
        tower = cls.__new__(cls)
        tower._core = core
        return tower

    @classmethod
    def from_toml(cls, text: str) -> Self:
        """Reads a tower from the text of a tower file.

        Raises:
            TowerError: The text has mistakes; the exception has their lines and columns.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> tm.Tower.from_toml(tower.to_toml()) == tower
        True
        """
        if text.strip() and "=" not in text and "\n" not in text.strip():
            message = f"{text!r} is not the text of a tower file"
            raise TowerError(message, hint=f"towermodes.read({text!r}) reads a file")
        return cls._of(_rust.read_text(text, "<string>.toml"))

    @property
    def name(self) -> str:
        """The name; may be empty."""
        return self._core.name

    @property
    def height_m(self) -> float:
        """Height of the tower from its base to its top, m."""
        return self._core.height_m

    @property
    def base_m(self) -> float:
        """Height of the base, m, in the datum of the stations."""
        return self._core.base_m

    @property
    def top_m(self) -> float:
        """Height of the top, m, in the datum of the stations."""
        return self._core.top_m

    @property
    def mass_kg(self) -> float:
        """Mass with outfitting and point masses, without the rotor-nacelle assembly, kg."""
        return self._core.mass_kg

    @property
    def structure_mass_kg(self) -> float:
        """Mass of the tower (`mass_kg`) and of the members of a substructure, kg."""
        return self._core.structure_mass_kg

    @property
    def rna_mass_kg(self) -> float:
        """Mass of the rotor-nacelle assembly, kg; 0 if there is none."""
        return self._core.rna_mass_kg

    @property
    def gravity_m_per_s2(self) -> float:
        """Acceleration of gravity, m/s²; 0 if gravity is left out."""
        return self._core.gravity_m_per_s2

    @property
    def static_balance(self) -> dict[str, object] | None:
        """Weights, buoyancy and mooring lines of a floating tower at its reference position.

        The keys are those of `static_balance` in the JSON of the program: weights and forces in N,
        the remaining force and moment (`residual_force_n`, `residual_moment_n_m`, in x, y, z), the
        `equilibrium` in m and degrees (None if no equilibrium is found), and whether the modes have
        the stiffness of the lines at the equilibrium. The result is None for a tower that does not
        float, without gravity, or if the buoyancy of the platform is not known.

        >>> import towermodes as tm
        >>> balance = tm.read("examples/floating-lines.toml").static_balance
        >>> balance["buoyancy_n"], round(balance["residual_force_n"][2])
        (81000000.0, -28868)
        """
        import json

        balance: dict[str, object] | None = json.loads(self._core.static_balance())
        return balance

    @property
    def stations(self) -> NDArray[np.float64]:
        """Height, outer diameter and wall thickness of the stations, m: (stations, 3)."""
        stations: NDArray[np.float64] = self._core.stations
        return stations

    @property
    def format(self) -> str:
        """The format of its file: "TOML", "BModes", "windIO"."""
        return self._core.format

    @property
    def files(self) -> list[str]:
        """The files it was read from, the main one first."""
        return self._core.files

    @property
    def notes(self) -> list[str]:
        """Assumptions made when the file was read; data that is left out; changes by `with_`."""
        return self._core.notes

    @property
    def joints(self) -> dict[str, tuple[float, float, float]]:
        """The joints of the substructure by their names, with their positions, m.

        Empty for a tower that does not stand on members.
        """
        return {name: (x, y, z) for name, (x, y, z) in self._core.joints}

    @property
    def members(self) -> dict[str, tuple[str, str]]:
        """The members of the substructure by their names, with the names of their joints."""
        return {name: (first, second) for name, (first, second) in self._core.members}

    @property
    def substructure_masses_kg(self) -> dict[str, float]:
        """The mass of the substructure by kind, kg; empty without a substructure.

        Members, marine growth, filling (water in members), masses on joints, soil that moves with
        the supports, transition piece, and the added mass of the water around members, which has no
        weight.
        """
        return dict(self._core.substructure_masses_kg)

    @property
    def warnings(self) -> list[str]:
        """Input that is possible but probably a mistake, with file and line if they are known."""
        return self._core.warnings

    @property
    def parameters(self) -> dict[str, float]:
        """The input values of the tower by their names in the tower file.

        Indices count from 0. `with_` and `sweep` take these names. The tower does not change, so
        this dict cannot be changed; `dict(tower.parameters)` is a copy that can be changed.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> tower.parameters["rna.mass"]
        350000.0
        """
        values = {name: value for name, value, _, _ in self._core.parameters()}
        return Constant(values, NO_WRITING)

    @property
    def parameter_units(self) -> dict[str, str]:
        """The units of `parameters`; empty for a value without a unit."""
        units = {name: unit for name, _, unit, _ in self._core.parameters()}
        return Constant(units, NO_WRITING)

    @property
    def parameter_meanings(self) -> dict[str, str]:
        """The meaning of each of `parameters` in a few words."""
        meanings = {name: meaning for name, _, _, meaning in self._core.parameters()}
        return Constant(meanings, NO_WRITING)

    def with_(self, changes: Mapping[str, SupportsFloat]) -> Self:
        """A tower with changed input values; its `notes` list the changes.

        Args:
            changes: Names and values. `rna.mass` sets a value, `stations[*].wall` sets the value of
                each station, `scale(stations[*].wall)` multiplies, `add(stations[1].height)` adds.

        Raises:
            ValueError: The tower has no such input value, or two changes contradict each other.
            TowerError: The result is not a valid tower.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> other = tower.with_({"rna.mass": 360e3, "scale(stations[*].wall)": 2.0})
        >>> other.stations[:, 2]
        array([0.0702, 0.0494])
        """
        if not hasattr(changes, "items"):
            message = f"changes is {changes!r}; it must be a dict of names and values"
            raise TypeError(message)
        pairs = [(name, number(name, value)) for name, value in changes.items()]
        return type(self)._of(self._core.changed(pairs))

    def to_toml(self) -> str:
        """The tower as the text of a tower file; reading it gives exactly the same input values."""
        return self.convert("toml").text

    def solve(
        self,
        modes: Modes | None = None,
        *,
        method: Method | None = None,
        segments: SupportsIndex | None = None,
        degree: SupportsIndex | None = None,
        points: SupportsIndex = 101,
        heights_m: Iterable[float] = (),
        rotary_inertia: bool = True,
        hinge_position: float | None = None,
        added_mass: str | float = "own",
        limits: bool = True,
    ) -> Solution:
        """Computes the lowest natural frequencies and mode shapes.

        Other Python threads run meanwhile.

        Args:
            modes: Number of modes; by default 8, or the number in a BModes deck. Or names of modes,
                as in `sweep`: then the list of lowest modes is long enough to contain these.
            method: The method; by default "rmje-exact", or "bmodes" for a BModes deck.
            segments: Number of segments or elements; by default about 100.
            degree: Polynomial degree of the elements of the method "spectral"; by default it is
                raised until the frequencies converge.
            points: Number of equally spaced heights of the mode shapes.
            heights_m: More heights for the mode shapes: `Solution.shape_at_heights`, m.
            rotary_inertia: Whether sections have rotary inertia in bending.
            hinge_position: Position of the hinges of the method "cardanic": distance from each end
                as a fraction of the segment length.
            added_mass: Frequency-dependent added mass of a floating platform: "own" (each mode has
                the added mass at its own frequency), "infinite" (at infinite frequency, as in a
                linearization by OpenFAST), "zero" (at zero frequency), or a frequency, Hz.
            limits: Whether a computation that would need more than 4 GiB or ten minutes is refused.

        Raises:
            SolveError: The tower buckles, is unstable or cannot be solved.
            OptionError: The options are impossible for this tower.
            ValueError: An option is unknown or does not apply to the method.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> tower.solve(modes=2).frequency_hz
        array([0.319..., 0.321...])
        >>> tower.solve(modes=["torsion 1"]).mode("torsion", 1).frequency_hz
        1.5655...
        """
        heights = heights_inside(heights_m, self.base_m, self.top_m)
        count, names = modes_chosen(modes)
        options = _solve_options(count, method, segments, degree, points, heights, rotary_inertia)
        options["hinge_position"] = number_or_none("hinge_position", hinge_position)
        options["added_mass"] = str(added_mass)
        options["limits"] = bool(limits)
        return _with_modes(names, lambda more: Solution._of((self,), {**options, **more}))

    def sweep(
        self,
        table: Sweepable | Study,
        *,
        modes: Modes | None = None,
        segments: SupportsIndex | None = None,
        method: Method | None = None,
        rotary_inertia: bool = True,
        threads: SupportsIndex | None = None,
        ignore: Iterable[str] = (),
        rows: range | None = None,
        progress: Callable[[int, int], object] | None = None,
    ) -> SweepResult:
        """Changes this tower by each row of a table or a study and solves it.

        Other Python threads run meanwhile, and Ctrl-C ends it. A row that does not describe a valid
        tower or cannot be solved raises no exception: its numbers are NaN, and its message is in
        `failures`. Rows and indices in names count from 0.

        Args:
            table: A dict of arrays and numbers, a DataFrame of pandas or polars, or another table
                with the Arrow interface. The names of the columns are those of `with_`:
                `rna.mass` sets a value, `scale(stations[*].wall)` multiplies. A column whose name
                begins with `#`, such as a number of the row, is ignored. Or the path of a table in
                CSV or Parquet; or a study: the path of a TOML file with [sweep], whose `base` is
                not read, or a dict with the same tables.
            modes: Number of lowest modes of this tower, 4 by default, whose names become columns;
                or names of modes: `[("fore-aft", 1), "torsion 1"]`.
            segments: Number of segments; by default 20, except for the method "spectral", which
                chooses its elements, and for a BModes deck, which has elements of its own. The
                frequencies are extrapolated from several meshes and have five to seven correct
                digits; they correspond to `Solution.extrapolated_hz`.
            method: As in `solve`.
            rotary_inertia: As in `solve`.
            threads: Number of threads; by default all processors. The results do not depend on
                it. With 1, the calling thread does the work.
            ignore: Names of other columns that are ignored.
            rows: The rows that are solved, by default all: `range(0, 50_000)` for the first 50 000.
                A table in a file that does not fit into memory is solved in several calls; `row`
                and `failures` have the numbers of the rows in the table.
            progress: Called about once a second with the number of rows that are done and of all
                rows; an exception in it ends the sweep.

        Raises:
            ValueError: A column is not an input of this tower, columns have different lengths, or
                there are no such rows.
            TypeError: A column does not hold numbers.
            SolveError: This tower itself cannot be solved.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> result = tower.sweep({"rna.mass": [340e3, 350e3], "scale(stations[*].wall)": 1.1})
        >>> result.frequency_hz.shape
        (2, 4)
        >>> bool(result.mode("fore-aft", 1)[0] > result.mode("fore-aft", 1)[1])
        True
        """
        options = sweep_options(modes, segments, method, rotary_inertia, threads)
        return swept(self, table, options, words("a column to ignore", ignore), rows, progress)

    def sample(self, study: Study) -> dict[str, NDArray[np.float64]]:
        """The values of the rows of a study, which `sweep` would solve.

        Args:
            study: As in `sweep`.

        Raises:
            TowerError: The study has mistakes; for a file, the exception has their places.
            ValueError: The tower has no such input value.
            OSError: The file cannot be read.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> vary = {"rna.mass": {"uniform": [3.3e5, 3.7e5]}}
        >>> study = {"sweep": {"sampling": "sobol", "rows": 4, "seed": 1, "vary": vary}}
        >>> {name: values.shape for name, values in tower.sample(study).items()}
        {'rna.mass': (4,)}
        >>> tower.sweep(study, modes=1).frequency_hz.shape
        (4, 1)
        """
        return sampled(self, study)

    def sensitivities(
        self,
        names: Iterable[str] | None = None,
        *,
        modes: Modes | None = None,
        segments: SupportsIndex | None = None,
        method: Method | None = None,
        rotary_inertia: bool = True,
    ) -> Sensitivities:
        """Derivatives of the mass and the frequencies with respect to the input values.

        They are computed from the mode shapes, not as differences between the frequencies of two
        towers, for every input value and every method. They are derivatives of the extrapolated
        frequencies that a sweep with the same arguments has. Other Python threads run meanwhile,
        and Ctrl-C ends the computation.

        Args:
            names: Names as in `with_`: `rna.mass` for an input value, `scale(stations[*].wall)` for
                a factor on several values, `add(rna.mass)` for an addition; by default each input
                value of the tower on which the frequencies can depend.
            modes: As in `sweep`.
            segments: As in `sweep`.
            method: As in `sweep`.
            rotary_inertia: Whether sections have rotary inertia in bending.

        Raises:
            ValueError: The tower has no such input value or no such mode, or a name sets several
                input values that are not equal, so that there is no single value to start from.
            SolveError: The modes of the tower cannot be computed.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> tower.sensitivities(["rna.mass", "stations[0].wall"], modes=[("fore-aft", 1)])
        number             value  unit  d mass kg/unit  d fore-aft 1 Hz/unit
        rna.mass          350000  kg                 0          -3.92...e-07
        stations[0].wall  0.0351  m        6.11327e+06               3.190...
        """
        options = sweep_options(modes, segments, method, rotary_inertia, None)
        chosen = None if names is None else words("a name of a number", names)
        return Sensitivities(_rust.sensitivities(self._core, chosen, options))

    def first_order(
        self,
        study: Study,
        *,
        modes: Modes | None = None,
        segments: SupportsIndex | None = None,
        method: Method | None = None,
        rotary_inertia: bool = True,
        progress: Callable[[int], object] | None = None,
    ) -> FirstOrder:
        """Mean and standard deviation of the frequencies for uncertain input values.

        The result is that of `towermodes sweep --first-order`: the frequencies are linear functions
        of the varied input values, with the exact derivatives at the mean values, and no rows are
        solved. Other Python threads run meanwhile, and Ctrl-C ends the computation.

        Args:
            study: The path of a sweep study with [sweep.vary], whose `base` is not read, or
                a dict with the same tables, in which only the distributions are needed.
            modes: As in `sweep`; by default those of the study.
            segments: As in `sweep`; by default those of the study.
            method: As in `sweep`; by default that of the study.
            rotary_inertia: Whether sections have rotary inertia in bending.
            progress: As in `design`.

        Raises:
            TowerError: The study has mistakes; for a file, the exception has their places.
            ValueError: The study has no distributions, or they have no first order.
            SolveError: The tower at the mean values cannot be solved.
            OSError: The file cannot be read.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> scatter = tower.first_order("examples/studies/uncertainty.toml")
        >>> scatter.deviation_hz["fore-aft 1"]
        0.00533...
        """
        options = sweep_options(modes, segments, method, rotary_inertia, None)
        given = with_rows(with_base(study)) if isinstance(study, dict) else study
        return FirstOrder._of((self,), *study_text(given), options, progress=progress)

    def design(
        self, study: Study, *, progress: Callable[[int], object] | None = None
    ) -> Design:
        """Finds a light tower whose frequencies are in given bands.

        The tower is a local minimum of the mass, found from exact derivatives; a lighter tower may
        exist elsewhere. Other Python threads run meanwhile, and Ctrl-C ends the search.

        Args:
            study: The path of a study, a TOML file with [design], or a dict with the same tables.
                The name of a mode may be a tuple: `{("fore-aft", 1): {"min": 0.3}}`.
            progress: Called about once a second with the number of towers solved so far; an
                exception in it ends the search.

        Raises:
            TowerError: The study has mistakes; for a file, the exception has their places.
            ValueError: The tower has no such mode, or the study contradicts itself.
            SolveError: No tower meets the goals of the study; the message describes the nearest.
            OSError: The file cannot be read.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> design = tower.design("crates/towermodes-cli/tests/inputs/design/mass.toml")
        >>> round(design.tower.mass_kg)
        300877
        """
        return Design._of((self,), *study_text(study), progress=progress)

    def calibrate(
        self,
        measured: Study,
        *,
        free: Iterable[str] = (),
        method: Method | None = None,
        segments: SupportsIndex | None = None,
        rotary_inertia: bool = True,
        progress: Callable[[int], object] | None = None,
    ) -> Calibration:
        """Fits input values of this tower to measured frequencies.

        The fit is a weighted least squares fit with exact derivatives. It explains the
        measurements; it does not validate the model. Other Python threads run meanwhile, and
        Ctrl-C ends it.

        Args:
            measured: The path of a TOML file with [[measured]] and [calibrate.unknowns], or a dict
                with the same tables.
            free: Names of the input values to be fitted; by default all unknowns of `measured`.
            method: As in `solve`.
            segments: As in `solve`.
            rotary_inertia: Whether sections have rotary inertia in bending.
            progress: As in `design`.

        Raises:
            TowerError: The measurements have mistakes; for a file, the exception has their places.
            ValueError: The tower has no such input value or mode, or there are too few
                measurements.
            SolveError: The measurements do not determine the input values, or no input values give
                the measured frequencies.
            OSError: The file cannot be read.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> fit = tower.calibrate("crates/towermodes-cli/tests/inputs/measured/tower.toml")
        >>> fit.residuals
        {'fore-aft 1': ..., 'side-side 1': ...}
        """
        text, name = study_text(measured)
        chosen = words("a name of a number", free)
        options = _solve_options(None, method, segments, None, 2, [], rotary_inertia)
        return Calibration._of((self,), text, name, chosen, options, progress=progress)

    def campbell(
        self,
        *,
        rpm: Sequence[float] | float | None = None,
        blades: SupportsIndex | None = None,
        multiples: Sequence[SupportsIndex] = (),
        margin: float = 0.05,
        modes: SupportsIndex | None = None,
        method: Method | None = None,
        segments: SupportsIndex | None = None,
    ) -> Campbell:
        """Checks the distances of the natural frequencies from the excitations of the rotor.

        Args:
            rpm: Lowest and highest operating speed, rpm, or one constant speed; by default those
                of the file.
            blades: Number of blades; by default that of the file, otherwise 3.
            multiples: Multiples of the rotor speed; by default 1, B, 2B, 3B with B blades.
            margin: Required distance as a fraction of the natural frequency: 0.05 is 5 %.
            modes: Number of modes; by default 8, or up to 40 if the excitations need more.
            method: As in `solve`.
            segments: As in `solve`.

        Raises:
            ValueError: The rotor speed is not known, or an option is impossible.

        >>> import towermodes as tm
        >>> tm.read("examples/nrel-5mw.toml").campbell().verdict
        'warn'
        """
        rotor: dict[str, object] = {
            "rpm": _speeds(rpm),
            "blades": whole_or_none("blades", blades, 1),
            "multiples": [whole("a multiple", multiple, 1) for multiple in multiples],
            "margin": number("margin", margin),
        }
        options = _solve_options(modes, method, segments, None, 2, [], True)
        return Campbell._of((self,), rotor, options)

    @property
    def turbine(self) -> Turbine | None:
        """The turbine on the tower, with its rotating rotor; None if the file has none.

        `turbine_missing` has the reason why there is none.

        >>> import towermodes as tm
        >>> tm.read("examples/nrel-5mw-turbine.toml").turbine.blades
        3
        >>> tm.read("examples/nrel-5mw.toml").turbine is None
        True
        """
        return None if self._core.turbine_blades is None else Turbine._of(self)

    @property
    def turbine_missing(self) -> str | None:
        """Why there is no `turbine`; None if there is one.

        >>> import towermodes as tm
        >>> tm.read("examples/nrel-5mw.toml").turbine_missing
        'the tower has no turbine with flexible blades'
        """
        return None if self.turbine is not None else self._core.turbine_missing

    def damping(
        self,
        loss_factors: Mapping[str, float] | None = None,
        *,
        chord_moment_m3: float | None = None,
        lift_slope: float | None = None,
        air_density_kg_per_m3: float | None = None,
        rpm: Sequence[float] | float | None = None,
        blades: SupportsIndex | None = None,
        modes: SupportsIndex | None = None,
        method: Method | None = None,
        segments: SupportsIndex | None = None,
    ) -> Damping:
        """Damping ratios of the modes: contributions of parts, and aerodynamic damping.

        The damping ratio of a part is half its loss factor times its fraction of the strain energy
        of the mode (water: of the kinetic energy). There are no default loss factors: parts without
        a loss factor contribute nothing, and the notes name them.

        Args:
            loss_factors: Loss factors (twice the damping ratio) by part: "tower", "substructure",
                "foundation", "soil", "wires", "water" or the name of a material; by default the
                values of the file.
            chord_moment_m3: Integral of chord times radius over one blade, m³; by default the value
                of the file. Without it there is no aerodynamic damping.
            lift_slope: Slope of the lift coefficient, per rad; by default the value of the file,
                otherwise 2 pi.
            air_density_kg_per_m3: Density of air, kg/m³; by default the value of the file,
                otherwise 1.225.
            rpm: As in `campbell`.
            blades: As in `campbell`.
            modes: Number of modes, from the lowest.
            method: As in `solve`.
            segments: As in `solve`.

        Raises:
            ValueError: The tower has no such part, or a value is impossible.
            SolveError: The modes of the tower cannot be computed.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> first = tower.damping(chord_moment_m3=6073, modes=2).modes[1]
        >>> [round(100 * at["damping_ratio"], 1) for at in first["aerodynamic"]]
        [2.8, 5.0]
        """
        parts = (loss_factors or {}).items()
        given: dict[str, object] = {
            "loss_factors": [
                (word("a part", part), number(f"the loss factor of {part}", value))
                for part, value in parts
            ],
            "chord_moment_m3": number_or_none("chord_moment_m3", chord_moment_m3),
            "lift_slope": number_or_none("lift_slope", lift_slope),
            "air_density_kg_per_m3": number_or_none(
                "air_density_kg_per_m3", air_density_kg_per_m3
            ),
            "rpm": _speeds(rpm),
            "blades": whole_or_none("blades", blades, 1),
        }
        options = _solve_options(modes, method, segments, None, 2, [], True)
        return Damping._of((self,), given, options)

    def compare(
        self,
        methods: Sequence[Method] | Method = (),
        *,
        segments: SupportsIndex | Sequence[SupportsIndex] = 60,
        modes: SupportsIndex = 8,
        rotary_inertia: bool = True,
    ) -> Comparison:
        """Compares methods: frequencies, differences from the reference solution, time of a solve.

        Args:
            methods: The methods; by default all.
            segments: One or several numbers of segments.
            modes: Number of modes.
            rotary_inertia: Whether sections have rotary inertia in bending.

        >>> import towermodes as tm
        >>> comparison = tm.read("examples/nrel-5mw.toml").compare(["rmje", "bmodes"], modes=2)
        >>> comparison.frequency_hz.shape
        (2, 2)
        """
        several = segments if hasattr(segments, "__iter__") else [segments]
        numbers = [whole("segments", number, 1) for number in several] or [60]
        count = whole("modes", modes, 1)
        names = [methods] if isinstance(methods, str) else list(methods)
        return Comparison._of((self,), names, numbers, count, rotary_inertia)

    def check(self, other: Tower) -> Agreement:
        """Compares this tower with another description of the same tower.

        Masses, stiffnesses and frequencies are compared, in total and along the height.

        Raises:
            TowerError: The towers have no heights in common.

        >>> import towermodes as tm
        >>> tower = tm.read("examples/nrel-5mw.toml")
        >>> tower.check(tm.read("examples/nrel-5mw.yaml")).verdict
        'pass'
        """
        if not isinstance(other, Tower):
            message = f"other is {other!r}; it must be a Tower"
            raise TypeError(message)
        return Agreement._of((self, other))

    def examine(self) -> Examination:
        """Masses, stiffnesses and centre of mass, in total and along the height.

        >>> import towermodes as tm
        >>> tm.read("examples/nrel-5mw.toml").examine().data["mass_kg"]
        347374...
        """
        return Examination._of((self,))

    def convert(
        self,
        format: Format,
        *,
        sections_file: str | None = None,
        from_height_m: float | None = None,
    ) -> Converted:
        """The tower in another format.

        Args:
            format: "toml", "bmodes", "elastodyn" (a tower file) or "windio".
            sections_file: The name of the second file of a BModes deck.
            from_height_m: Height at which the flexible tower of ElastoDyn begins, m.

        Raises:
            TowerError: The format cannot store this tower.

        >>> import towermodes as tm
        >>> converted = tm.read("examples/nrel-5mw.toml").convert("elastodyn")
        >>> print(converted.text[:40])
        ------- ELASTODYN V1.00.* TOWER INPUT FI
        """
        if format == "bmodes" and sections_file is None:
            sections_file = "sections.dat"
        return Converted._of((self,), format, sections_file, from_height_m)

    def plot(self) -> Picture:
        """The picture of the tower with its surroundings."""
        return Picture(self._core.svg())

    def __eq__(self, other: object) -> bool:
        """Whether both have the same input values, names and options for their solution."""
        if not isinstance(other, Tower):
            return NotImplemented
        return self._core.is_equal(other._core)

    def __hash__(self) -> int:
        return hash((self.name, self.height_m, self.mass_kg, self.rna_mass_kg))

    def __reduce__(self) -> tuple[object, ...]:
        return (_restored, (self._core.state(), type(self)))

    def __repr__(self) -> str:
        name = f"{self.name!r}: " if self.name else ""
        rna = f"{self.rna_mass_kg / 1e3:.3f} t" if self.rna_mass_kg else "none"
        return (
            f"<Tower {name}{self.base_m:g} m to {self.top_m:g} m, "
            f"{self.mass_kg / 1e3:.3f} t, RNA {rna}>"
        )

    def _repr_svg_(self) -> str:
        return self._core.svg()


def _core_of(state: tuple[object, ...]) -> _rust.Tower:
    return _rust.Tower.restore(state)


# The tower of a design in the pickle of the design.
copyreg.pickle(_rust.Tower, lambda core: (_core_of, (core.state(),)))


#: Solutions are searched for named modes up to this number of modes.
MOST_MODES = 48


def _with_modes(names: list[str], solved: Callable[[dict[str, object]], Solution]) -> Solution:
    """A solution that has the named modes; without names the first one."""
    if not names:
        return solved({})
    wanted = [mode_name(name)[:2] for name in names]
    for count in range(8, MOST_MODES + 1, 8):
        solution = solved({"modes": count})
        missing = [mode for mode in wanted if mode not in solution.names]
        if not missing:
            return solution
    family, order = missing[0]
    message = f"{family} {order} is not among the lowest {MOST_MODES} modes; give a number of modes"
    raise ValueError(message)


def _restored(state: tuple[object, ...], cls: type[Tower] = Tower) -> Tower:
    return cls._of(_rust.Tower.restore(state))


def _speeds(rpm: Any) -> tuple[float, float] | None:
    """The lowest and the highest speed of a rotor."""
    if rpm is None:
        return None
    # A NumPy scalar is neither an int nor a list.
    speeds: list[Any] = list(rpm) if hasattr(rpm, "__len__") else [rpm, rpm]
    if isinstance(rpm, str) or len(speeds) != 2:
        message = f"rpm is {rpm!r}; it must be one speed or (lowest, highest)"
        raise ValueError(message)
    return (number("rpm", speeds[0]), number("rpm", speeds[1]))


def _solve_options(
    modes: SupportsIndex | None,
    method: str | None,
    segments: SupportsIndex | None,
    degree: SupportsIndex | None,
    points: SupportsIndex,
    heights_m: list[float],
    rotary_inertia: bool,
) -> dict[str, object]:
    return {
        "modes": whole_or_none("modes", modes, 1),
        "method": word_or_none("method", method),
        "segments": whole_or_none("segments", segments, 1),
        "degree": whole_or_none("degree", degree, 2),
        "points": whole("points", points, 2),
        "heights_m": heights_m,
        "rotary_inertia": bool(rotary_inertia),
        "hinge_position": None,
        "added_mass": "own",
        "limits": True,
    }
