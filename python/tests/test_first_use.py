"""What users try first: every table as an argument, studies, names, dicts with mistakes."""

from __future__ import annotations

import copy
import inspect
import json
import pickle
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import towermodes as tm
from towermodes import _towermodes as rust

STATIONS = [[0.0, 6.0, 0.027], [87.6, 3.87, 0.019]]
STEEL = {"density": 8500.0, "youngs_modulus": 2.1e11, "shear_modulus": 8.08e10}
ANY_TOWER: Any = tm.Tower


def test_every_table_of_the_tower_file_is_an_argument() -> None:
    file, tower = rust.tower_file_keys()
    assert {"ground", "turbine", "drivetrain"} <= set(file)
    arguments = set(inspect.signature(tm.Tower).parameters)
    assert arguments == (set(file) - {"tower"}) | set(tower)


@pytest.mark.parametrize("path", ["monopile-layers.toml", "nrel-5mw-turbine.toml"])
def test_the_tables_of_a_file_are_arguments(path: str) -> None:
    tomllib = pytest.importorskip("tomllib")
    text = Path("examples", path).read_text("utf-8")
    tables = tomllib.loads(text)
    made = ANY_TOWER(**tables.pop("tower"), **tables)
    assert made == tm.Tower.from_toml(text)


def test_modes_of_a_solve_are_chosen_by_name(nrel: tm.Tower) -> None:
    solution = nrel.solve(modes=["axial 1", ("torsion", 2)])
    assert {("axial", 1), ("torsion", 2)} <= set(solution.names)
    assert solution.certified
    all_modes = nrel.solve(modes=len(solution))
    assert (solution.frequency_hz == all_modes.frequency_hz).all()
    with pytest.raises(ValueError, match="'fore-aft'"):
        nrel.solve(modes=["foreaft 1"])
    with pytest.raises(ValueError, match="torsion 40 is not among the lowest"):
        nrel.solve(modes="torsion 40")


def test_names_of_modes_are_tuples_in_dicts_too(nrel: tm.Tower) -> None:
    variables = {"scale(stations[*].wall)": {"between": [0.7, 1.5]}}
    texts = {"variables": variables, "frequencies": {"side-side 1": {"min": 0.3}}}
    tuples = {"variables": variables, "frequencies": {("side-side", 1): {"min": 0.3}}}
    assert nrel.design({"design": tuples}).data == nrel.design({"design": texts}).data
    measured = {"mode": ("fore-aft", 1), "frequency": 0.325, "deviation": 0.001}
    fit = nrel.calibrate({"calibrate": {"unknowns": {"rna.mass": {}}}, "measured": [measured]})
    assert list(fit.residuals) == ["fore-aft 1"]


def test_columns_are_left_out(nrel: tm.Tower) -> None:
    table = {"#id": ["a", "b"], "site": ["n", "s"], "rna.mass": [340e3, 350e3]}
    expected = nrel.sweep({"rna.mass": [340e3, 350e3]}).frequency_hz
    pandas, polars = pytest.importorskip("pandas"), pytest.importorskip("polars")
    for given in (table, pandas.DataFrame(table), polars.DataFrame(table)):
        result = nrel.sweep(given, ignore=["site"])
        assert (result.frequency_hz == expected).all()
        assert list(result.inputs) == ["rna.mass"]
        with pytest.raises(ValueError, match="no column 'town' to ignore"):
            nrel.sweep(given, ignore=["site", "town"])
    with pytest.raises(ValueError, match="all columns are skipped"):
        nrel.sweep({"#id": [1.0]})


def test_a_table_in_a_file_is_a_table(nrel: tm.Tower, tmp_path: Path) -> None:
    path = tmp_path / "values.csv"
    path.write_text("#id,rna.mass\na,340e3\nb,350e3\n")
    result = nrel.sweep(path)
    assert (result.frequency_hz == nrel.sweep({"rna.mass": [340e3, 350e3]}).frequency_hz).all()
    with pytest.raises(ValueError, match=r"column 2: .*; skip the column by ignore=\[\"rna.mas\"\]"):
        path.write_text("#id,rna.mas\na,340e3\n")
        nrel.sweep(path)
    with pytest.raises(FileNotFoundError, match=r"No such file or directory: .*none\.csv") as none:
        nrel.sweep(tmp_path / "none.csv")
    assert none.value.filename == str(tmp_path / "none.csv")


def test_a_study_is_that_of_the_program(nrel: tm.Tower, tmp_path: Path) -> None:
    sweep = {
        "sampling": "sobol",
        "rows": 40,
        "seed": 3,
        "vary": {"rna.mass": {"uniform": [3.3e5, 3.7e5]}},
        "results": {"modes": [("torsion", 1)], "segments": 30},
    }
    sample = nrel.sample({"sweep": sweep})
    result = nrel.sweep({"sweep": sweep})
    assert result.names == [("torsion", 1)]
    assert (result.inputs["rna.mass"] == sample["rna.mass"]).all()
    assert (result.frequency_hz == nrel.sweep(sample, modes="torsion 1", segments=30).frequency_hz).all()
    assert nrel.sweep({"sweep": sweep}, modes=2).frequency_hz.shape == (40, 2)
    path = tmp_path / "study.toml"
    path.write_text(
        '[sweep]\nbase = "none.toml"\nsampling = "sobol"\nrows = 40\nseed = 3\n'
        '[sweep.vary]\n"rna.mass" = { uniform = [3.3e5, 3.7e5] }\n'
    )
    assert (nrel.sample(path)["rna.mass"] == sample["rna.mass"]).all()
    with pytest.raises(ValueError, match="ignore applies only to a table"):
        nrel.sweep(path, ignore=["site"])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"stations": [STATIONS[0], [87.6, 3.87, None]]}, r"stations\[1\]\[2\] is None; it must"),
        ({"stations": [STATIONS[0], [87.6, 3.87, float("nan")]]}, r"stations\[1\]"),
        ({"material": {**STEEL, "density": 8500 + 1j}}, r"material\.density is \(8500\+1j\)"),
        ({"rna": {"mass": "heavy"}}, r"rna\.mass: "),
        ({"rna": {"inertia": {"zz": object}}}, r"rna\.inertia\.zz is <class"),
        ({"shear": "yes"}, r"^shear: "),
    ],
)
def test_a_mistake_names_its_entry(arguments: dict[str, object], message: str) -> None:
    with pytest.raises((TypeError, tm.TowerError), match=message):
        ANY_TOWER(**{"stations": STATIONS, "material": STEEL, **arguments})


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"step": 0}, r'design\.variables\["rna.mass"\]\.step: '),
        ({"between": [1e5, None]}, r'design\.variables\["rna.mass"\]\.between\[1\] is None'),
        ({"between": [2e5, 1e5]}, r'design\.variables\["rna.mass"\]'),
        ({"betwen": 1}, r'design\.variables\["rna.mass"\]\.betwen: '),
    ],
)
def test_a_mistake_in_a_study_names_its_entry(
    nrel: tm.Tower, change: dict[str, object], message: str
) -> None:
    variable = {"between": [1e5, 4e5], **change}
    study = {"variables": {"rna.mass": variable}, "frequencies": {"fore-aft 1": {"min": 0.3}}}
    with pytest.raises((TypeError, tm.TowerError), match=message):
        nrel.design({"design": study})


def test_places_in_warnings_count_from_0() -> None:
    tower = tm.Tower(stations=[[0.0, 6.0, 0.0027], STATIONS[1]], material=STEEL)
    (warning,) = tower.warnings
    assert warning.startswith("stations[0].wall: wall thickness 0.0027 m")
    assert pickle.loads(pickle.dumps(tower)).warnings == [warning]
    result = tm.Tower(stations=STATIONS, material=STEEL).sweep({"stations[0].wall": [0.0027]})
    assert result.warnings == [(0, warning)]


SAND = {"type": "sand", "friction_angle": 36.0, "effective_unit_weight": 9.5e3}
CLAY = {
    "type": "clay",
    "undrained_strength": 90e3,
    "strain_at_half_strength": 0.007,
    "strength_factor": 0.5,
    "effective_unit_weight": 9e3,
}


def layered(*soils: dict[str, object]) -> tm.Tower:
    """A tower in layers of 10 m."""
    tops = [-10.0 * place for place in range(len(soils))]
    pairs = zip(tops, soils, strict=True)
    layers = [{**soil, "top": top, "bottom": top - 10.0} for top, soil in pairs]
    return tm.Tower(
        stations=[[-25.0, 6.0, 0.06], [0.0, 6.0, 0.06], [60.0, 4.0, 0.02]],
        material=STEEL,
        ground={"surface": 0.0, "submerged": True, "model": "api", "layer": layers},
    )


def test_what_is_missing_is_named_by_its_entry() -> None:
    with pytest.raises(tm.TowerError, match=r"^ground\.layer\[1\].*: api needs the factor J"):
        layered(SAND, {key: value for key, value in CLAY.items() if key != "strength_factor"}, SAND)


def test_a_name_of_several_numbers_says_which_entry_has_none() -> None:
    tower = layered(SAND, CLAY, SAND)
    instead = "ground.layer[0].friction_angle, ground.layer[2].friction_angle"
    for name in ("ground.layer[*].friction_angle", "scale(ground.layer[*].friction_angle)"):
        with pytest.raises(ValueError, match=r"ground\.layer\[1\] has no friction angle") as caught:
            tower.with_({name: 1.0})
        assert str(caught.value).endswith(f"use the names that exist: {instead}")
    stiffer = tower.with_({f"scale({instead})": 1.01})
    assert stiffer.parameters["ground.layer[2].friction_angle"] == pytest.approx(36.36)


def test_numbers_of_a_tower_refuse_to_be_written(nrel: tm.Tower) -> None:
    for numbers in (nrel.parameters, nrel.parameter_units, nrel.parameter_meanings):
        with pytest.raises(TypeError, match="tower.with_"):
            numbers["rna.mass"] = 1.0  # type: ignore[assignment]
        with pytest.raises(TypeError, match="tower.with_"):
            numbers.update({})
    own = dict(nrel.parameters)
    own["rna.mass"] = 1.0
    assert nrel.parameters["rna.mass"] == 350e3
    assert type(copy.copy(nrel.parameters)) is dict
    assert json.loads(json.dumps(nrel.parameters)) == nrel.parameters


@pytest.mark.parametrize("value", [1 + 2j, np.complex64(1 + 2j), np.array(1 + 2j)])
def test_a_complex_number_is_refused(nrel: tm.Tower, value: Any) -> None:
    calls: list[Callable[[], object]] = [
        lambda: nrel.with_({"rna.mass": value}),
        lambda: nrel.sweep({"rna.mass": value}),
        lambda: nrel.solve(heights_m=[value]),
        lambda: nrel.campbell(rpm=value),
        lambda: ANY_TOWER(stations=STATIONS, material=STEEL, rna=value),
        lambda: ANY_TOWER(stations=STATIONS, material=STEEL, rna={"mass": value}),
    ]
    for call in calls:
        with pytest.raises(TypeError):
            call()


def test_the_covariance_of_a_fit(nrel: tm.Tower) -> None:
    fit = nrel.calibrate("crates/towermodes-cli/tests/inputs/measured/tower.toml")
    deviations = np.array(list(fit.deviations.values()))
    assert np.sqrt(np.diag(fit.covariance)) == pytest.approx(deviations, rel=1e-12)
    assert fit.covariance[0, 1] == fit.covariance[1, 0]


def test_progress_is_reported_and_its_exception_ends_the_work(monopile: tm.Tower) -> None:
    class Enough(Exception):
        pass

    def enough(*_: int) -> None:
        raise Enough

    done: list[tuple[int, int]] = []
    rows = {"rna.mass": np.linspace(3e5, 4e5, 300)}
    monopile.sweep(rows, progress=lambda *now: done.append(now))
    assert done[-1] == (300, 300)
    walls = [name for name in monopile.parameters if name.endswith(".wall")]
    study = {
        "variables": {name: {"between": [0.01, 0.2], "step": 0.0001} for name in walls},
        "frequencies": {"fore-aft 1": {"min": monopile.solve(modes=2).frequency_hz[0]}},
    }
    vary = {name: {"normal": [monopile.parameters[name], 1e-3]} for name in monopile.parameters}
    with pytest.raises(Enough):
        monopile.sweep({"rna.mass": np.linspace(3e5, 4e5, 30_000)}, progress=enough)
    with pytest.raises(Enough):
        for _ in range(100):
            monopile.design({"design": study}, progress=enough)
    with pytest.raises(Enough):
        for _ in range(100):
            monopile.first_order({"sweep": {"vary": vary}}, segments=4000, progress=enough)
