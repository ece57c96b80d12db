# Made by python/stubs.sh; do not edit.
"""
The classes and functions of the package.
"""

from _typeshed import Incomplete, SupportsGetItem
from typing import Any, Final, SupportsFloat, SupportsIndex, final

__all__ = ["VERSION", "Answer", "Converted", "Found", "Solution", "Tower", "TurbineModes", "calibrate", "campbell", "check", "close", "columns_of_stream", "compare", "damping", "design", "examine", "first_order", "mode_named", "read", "read_text", "rows_within", "run", "sensitivities", "solve_mooring", "solve_substructure", "source", "stream_of_columns", "stream_of_results", "sweep", "tower_file_keys", "turbine_campbell", "values_of_study", "values_of_table"]

VERSION: Final[str]
"""
The version of the package.
"""

@final
class Answer:
    """
    A result in the forms of the program.
    """
    @property
    def conclusion(self, /) -> list[str]:
        """
        The conclusion in sentences.
        """
    def csv(self, /) -> str:
        """
        The CSV, as the program writes it; nothing if there is none.
        """
    def json(self, /) -> str:
        """
        The JSON, as the program writes it.
        """
    @property
    def not_checked(self, /) -> list[str]:
        """
        Why nothing is checked; empty if the distances are checked.
        """
    @property
    def notes(self, /) -> list[str]:
        """
        Notes of the reader and on the computation.
        """
    def svg(self, /) -> str:
        """
        The picture as SVG; nothing if there is none.
        """
    def table(self, /) -> str:
        """
        The table, as the program writes it.
        """
    @property
    def verdict(self, /) -> str:
        """
        The worst verdict: `pass`, `warn`, `fail`, or `undecided` if nothing is checked.
        """
    @property
    def warnings(self, /) -> list[str]:
        """
        Possible mistakes of the input, and limits of the results.
        """

@final
class Converted:
    """
    The files of a tower in another format.
    """
    def __new__(cls, /, tower: Tower, format: str, sections_file: str | None, from_height_m: SupportsFloat | SupportsIndex | None) -> Converted:
        """
        Writes a tower in a format.
        """
    @property
    def companion(self, /) -> tuple[str, str] | None:
        """
        Name and text of the second file of a BModes deck.
        """
    @property
    def notes(self, /) -> list[str]:
        """
        The notes of the reader, and notes on data that the format cannot store.
        """
    @property
    def text(self, /) -> str:
        """
        The text of the file.
        """

@final
class Found:
    """
    A tower with input values from a design or a calibration.
    """
    def json(self, /) -> str:
        """
        The JSON, as the program writes it.
        """
    def table(self, /) -> str:
        """
        The table, as the program writes it.
        """
    @property
    def tower(self, /) -> Tower:
        """
        The tower with the computed values.
        """

@final
class Solution:
    """
    The lowest modes of a tower.
    """
    @property
    def buckling_load_factor(self, /) -> float | None:
        """
        The factor on the acceleration of gravity at which the tower buckles.
        """
    def cells(self, /) -> tuple[list[str], list[list[str]], str]:
        """
        The header and the cells of the table, and the lines below it.
        """
    @property
    def certificate(self, /) -> tuple[bool, int, float]:
        """
        Whether no mode is missing, the number of counted modes, and the frequency up to which they
        are counted, Hz.
        """
    def column(self, /, key: str) -> "Incomplete":
        """
        The values of a column of the CSV, one for each mode: numbers as an array, texts as a list.
        """
    @property
    def columns(self, /) -> Any:
        """
        All columns by their keys.
        """
    def csv(self, /) -> str:
        """
        The CSV of the program.
        """
    @property
    def degree(self, /) -> int | None:
        """
        Polynomial degree of spectral elements.
        """
    @property
    def degrees_of_freedom(self, /) -> int:
        """
        Degrees of freedom of the whole tower.
        """
    @property
    def effective_mass(self, /) -> Incomplete:
        """
        Effective modal masses: shape (modes, 6).
        """
    @property
    def effective_mass_shares(self, /) -> Incomplete | None:
        """
        Sums of the effective masses as fractions of the totals: shape (6). None if there is no such
        sum.
        """
    @property
    def error_hz(self, /) -> Incomplete:
        """
        Total errors, Hz.
        """
    @property
    def height_m(self, /) -> Incomplete:
        """
        The heights of `shape`, m.
        """
    @property
    def joint_shape(self, /) -> Incomplete:
        """
        The motions of the joints of the substructure: (modes, joints, 6).
        """
    def json(self, /) -> str:
        """
        The JSON of the program.
        """
    @property
    def labels(self, /) -> list[str]:
        """
        The names of the modes in words.
        """
    @property
    def member_shape(self, /) -> Incomplete:
        """
        The translations of points within the members of the substructure: (modes, 3 members, 3).
        """
    @property
    def method(self, /) -> str:
        """
        The method.
        """
    @property
    def modal_mass(self, /) -> Incomplete:
        """
        Modal masses, kg; kg m² for torsion and yaw.
        """
    @property
    def names(self, /) -> list[tuple[str, int]]:
        """
        Family and order of each mode.
        """
    @property
    def notes(self, /) -> list[str]:
        """
        The notes of the reader.
        """
    @property
    def rigid_inertia(self, /) -> Incomplete:
        """
        Rigid-body inertia matrix of the whole tower about its base: shape (6, 6).
        """
    @property
    def second(self, /) -> list[tuple[str, float] | None]:
        """
        For each mode, the other family with the largest share of its energy, and this share.
        """
    @property
    def segments(self, /) -> int:
        """
        Number of segments or elements.
        """
    @property
    def shape(self, /) -> Incomplete:
        """
        The shapes at equal heights: (modes, heights, 6).
        """
    @property
    def shape_there(self, /) -> Incomplete:
        """
        The shapes at the requested heights: (modes, heights, 6).
        """
    @property
    def station_height_m(self, /) -> Incomplete:
        """
        The heights of `station_shape`, m.
        """
    @property
    def station_shape(self, /) -> Incomplete:
        """
        The shapes at the stations: (modes, stations, 6).
        """
    def svg(self, /) -> str:
        """
        The picture of the mode shapes as SVG.
        """
    def table(self, /) -> str:
        """
        The table of the program.
        """
    @property
    def uncertain_hz(self, /) -> tuple[float, float] | None:
        """
        The interval in which modes may be missing, Hz.
        """
    @property
    def warnings(self, /) -> list[str]:
        """
        Possible mistakes of the input, and limits of the results.
        """

@final
class Tower:
    """
    A tower.
    """
    @property
    def base_m(self, /) -> float:
        """
        The height of the base, m.
        """
    def change(self, /, name: str) -> tuple[str, list[tuple[str, float]], str]:
        """
        The operation of a change (`set`, `scale` or `add`), its input values, and its unit.
        """
    def changed(self, /, changes: SupportsGetItem[int, tuple[str, SupportsFloat | SupportsIndex]]) -> Tower:
        """
        The tower with changed input values: names of changes and their values.
        """
    @property
    def files(self, /) -> list[str]:
        """
        The files it was read from.
        """
    @property
    def format(self, /) -> str:
        """
        The format of its file.
        """
    @property
    def gravity_m_per_s2(self, /) -> float:
        """
        Acceleration of gravity, m/s².
        """
    @property
    def height_m(self, /) -> float:
        """
        Height from the base to the top, m.
        """
    def is_equal(self, /, other: Tower) -> bool:
        """
        Whether both towers have the same description and the same options of the solution.
        """
    @property
    def joints(self, /) -> list[tuple[str, list[float]]]:
        """
        Names and positions of the joints of the substructure, m.
        """
    @property
    def mass_kg(self, /) -> float:
        """
        Mass without the rotor-nacelle assembly, kg.
        """
    @property
    def members(self, /) -> list[tuple[str, list[str]]]:
        """
        Names of the members of the substructure, and of their first and second joint.
        """
    @property
    def name(self, /) -> str:
        """
        Its name; may be empty.
        """
    @property
    def notes(self, /) -> list[str]:
        """
        The notes of the reader.
        """
    def parameters(self, /) -> list[tuple[str, float, str, str]]:
        """
        Name, value, unit and meaning of each input value.
        """
    @staticmethod
    def restore(state: "tuple[object, ...]") -> Tower:
        """
        The tower with this state.
        """
    @property
    def rna_mass_kg(self, /) -> float:
        """
        Mass of the rotor-nacelle assembly, kg.
        """
    def solve(self, /, options: "dict[str, object]") -> Solution:
        """
        The lowest modes.
        """
    def state(self, /) -> "tuple[object, ...]":
        """
        The data that [`restore`](Self::restore) needs.
        """
    def static_balance(self, /) -> str:
        """
        Weight, buoyancy and mooring forces of a floating tower as JSON.
        """
    @property
    def stations(self, /) -> Incomplete:
        """
        Height, outer diameter and wall thickness of the stations, m.
        """
    @property
    def structure_mass_kg(self, /) -> float:
        """
        Mass of the tower and of the members of a substructure, kg.
        """
    @property
    def substructure_masses_kg(self, /) -> list[tuple[str, float]]:
        """
        The mass of the substructure by kind, kg; nothing without a substructure.
        """
    def svg(self, /) -> str:
        """
        The picture of the tower as SVG.
        """
    @property
    def top_m(self, /) -> float:
        """
        The height of the top, m.
        """
    @property
    def turbine_blades(self, /) -> int | None:
        """
        Number of blades of its turbine; none without a turbine.
        """
    @property
    def turbine_missing(self, /) -> str:
        """
        Why it has no turbine.
        """
    @property
    def turbine_notes(self, /) -> list[str]:
        """
        The notes on the tower and on its turbine.
        """
    @property
    def warnings(self, /) -> list[str]:
        """
        Input that is possible but probably a mistake.
        """

@final
class TurbineModes:
    """
    The modes of a turbine at a rotor speed.
    """
    def __new__(cls, /, tower: Tower, rpm: SupportsFloat | SupportsIndex, limit_hz: SupportsFloat | SupportsIndex) -> TurbineModes:
        """
        The modes of the turbine of a tower below a limit (Hz) at a rotor speed (rpm).
        """
    @property
    def bounds_hz(self, /) -> Incomplete:
        """
        Lower and upper bounds, Hz: (modes, 2).
        """
    @property
    def certified(self, /) -> bool:
        """
        Whether the list is complete and the turbine stable.
        """
    @property
    def energy(self, /) -> Incomplete:
        """
        Fractions of the elastic energy: (modes, parts).
        """
    @property
    def energy_parts(self, /) -> list[str]:
        """
        The names of the parts of `energy`.
        """
    @property
    def error_hz(self, /) -> Incomplete:
        """
        Estimated discretization errors, Hz; NaN if there is no estimate.
        """
    @property
    def frequency_hz(self, /) -> Incomplete:
        """
        Natural frequencies, Hz.
        """
    @property
    def growing(self, /) -> int:
        """
        Least number of unstable modes; 0 if it is unknown.
        """
    @property
    def limit_hz(self, /) -> float:
        """
        The limit, Hz.
        """
    @property
    def names(self, /) -> list[str]:
        """
        Their names.
        """
    @property
    def negative_energy(self, /) -> tuple[int, int]:
        """
        Numbers of modes of negative energy: expected and found.
        """
    @property
    def nodding(self, /) -> list[str | None]:
        """
        `tilt` or `yaw` for whirls whose backward and forward waves are almost equal.
        """
    @property
    def notes(self, /) -> list[str]:
        """
        Notes on the turbine.
        """
    @property
    def rotor_speed_rpm(self, /) -> float:
        """
        The rotor speed, rpm.
        """
    @property
    def second(self, /) -> list[tuple[str, float] | None]:
        """
        For each mode, the other part with the most elastic energy, and its fraction.
        """
    @property
    def share(self, /) -> Incomplete:
        """
        Fractions of the elastic energy of the modes in the parts that name them.
        """
    @property
    def unresisted(self, /) -> int:
        """
        Number of motions without stiffness, which are not in the list.
        """

def calibrate(tower: Tower, text: str, name: str, free: SupportsGetItem[int, str], options: "dict[str, object]", *, progress: Any | None = None) -> Found:
    """
    The fit to measurements; `free` are the input values to be fitted instead of those of the file.
    """

def campbell(tower: Tower, rotor: "dict[str, object]", options: "dict[str, object]") -> Answer:
    """
    The diagram of a tower.
    """

def check(first: Tower, second: Tower) -> Answer:
    """
    Compares the second tower with the first.
    """

def close() -> None:
    """
    Prevents other threads from returning to Python; Python calls this function at its exit.
    """

def columns_of_stream(capsule: "object", choose: "object") -> "list[tuple[str, Incomplete]]":
    """
    The columns of a table as numbers; a missing value is NaN. The given function receives all names
    and returns the positions of the columns to read.
    """

def compare(tower: Tower, methods: SupportsGetItem[int, str], segments: SupportsGetItem[int, SupportsIndex], modes: SupportsIndex, rotary_inertia: bool) -> Answer:
    """
    Solves a tower by each method with each number of segments (at least one).
    """

def damping(tower: Tower, given: "dict[str, object]", options: "dict[str, object]") -> Answer:
    """
    The damping of the modes of a tower.
    """

def design(tower: Tower, text: str, name: str, *, progress: Any | None = None) -> Found:
    """
    The tower that a design computes.
    """

def examine(tower: Tower) -> Answer:
    """
    Summarises a tower.
    """

def first_order(tower: Tower, text: str, name: str, options: "dict[str, object]", *, progress: Any | None = None) -> Answer:
    """
    Frequencies to first order for the distributions of a study, with this tower as its base.
    """

def mode_named(name: str) -> tuple[str, int, str]:
    """
    Family, order and column of the mode with a name such as `fore-aft 1`.
    """

def read(path: "str", options: "dict[str, object]") -> Tower:
    """
    The tower of a file.
    """

def read_text(text: str, name: str) -> Tower:
    """
    The tower of a text in any format; `name` is used as the name of the file.
    """

def rows_within(rows: tuple[SupportsIndex, SupportsIndex], count: SupportsIndex) -> tuple[int, int]:
    """
    The requested rows of a table: the first row, and the row after the last one.
    """

def run(words: "list[str]") -> "int":
    """
    Runs the program with the words of a command line, the first of which is the name of the
    program; returns the exit code.
    """

def sensitivities(tower: Tower, names: "list[str] | None", options: "dict[str, object]") -> "tuple[Incomplete, ...]":
    """
    The derivatives with respect to named changes, or to each input value of the tower.
    """

def solve_mooring(path: "str") -> Answer:
    """
    The lines of a MoorDyn or MAP++ file at the reference position of the platform.
    """

def solve_substructure(path: "str", modes: SupportsIndex, clamped: bool, subdyn: bool) -> Answer:
    """
    The lowest modes of a SubDyn file.
    """

def source(path: "str") -> tuple[str, str]:
    """
    The text of a file, and its name.
    """

def stream_of_columns(texts: "list[tuple[str, list[str]]]", numbers: "list[tuple[str, Incomplete]]") -> "object":
    """
    A table of texts and numbers as a stream, with the columns of texts first. NaN is written as a
    missing value.
    """

def stream_of_results(first_row: SupportsIndex, inputs: "list[tuple[str, Incomplete]]", modes: "list[str]", mass_kg: "object", certified: "object", frequency_hz: "object", error_hz: "object", share: "object", failures: "tuple[object, object, object]") -> "object":
    """
    A table of results as a stream: the number of each row, the inputs, the mass, whether the row is
    certified, frequency, error and share of each mode, and the reason why a row failed. NaN is
    written as a missing value.
    """

def sweep(tower: Tower, columns: "list[tuple[str, Incomplete]]", first_row: SupportsIndex, options: "dict[str, object]", *, progress: Any | None = None) -> tuple[list[tuple[str, int, str]], Incomplete, Incomplete, Incomplete, Incomplete, Incomplete, tuple[Incomplete, Incomplete, Incomplete], list[tuple[int, list[tuple[int, str]]]]]:
    """
    Solves the tower with the input values of each row; the rows are counted from
    `first_row` on.
    """

def tower_file_keys() -> list[list[str]]:
    """
    The keys of a tower file, and those of its table `[tower]`.
    """

def turbine_campbell(tower: Tower, rpm: SupportsGetItem[int, SupportsFloat | SupportsIndex], limit_hz: SupportsFloat | SupportsIndex | None, rotor: "dict[str, object]") -> Answer:
    """
    The diagram of the turbine on a tower; if no speeds are given, at the default speeds.
    """

def values_of_study(tower: Tower, text: str, name: str, ignore: "list[str]", options: "dict[str, object]", rows: tuple[SupportsIndex, SupportsIndex] | None) -> "tuple[tuple[list[tuple[str, Incomplete]], int], dict[str, object]]":
    """
    The values of a study with this tower as its base, and the options of the sweep: those given,
    else those of the study.
    """

def values_of_table(tower: Tower, path: "str", ignore: "list[str]", rows: tuple[SupportsIndex, SupportsIndex] | None) -> "tuple[list[tuple[str, Incomplete]], int]":
    """
    The values of a table in a file: a column for each change of a tower.
    """
