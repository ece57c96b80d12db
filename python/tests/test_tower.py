"""Towers: read, made of numbers, written, compared, pickled."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest
from conftest import examples

import towermodes as tm

STEEL = {"density": 8500.0, "youngs_modulus": 2.1e11, "shear_modulus": 8.08e10}
STATIONS = [[0.0, 6.0, 0.027], [87.6, 3.87, 0.019]]


def test_a_tower_is_what_its_file_says(nrel: tm.Tower) -> None:
    assert nrel.name == "NREL 5 MW tower with RNA"
    assert (nrel.base_m, nrel.top_m, nrel.height_m) == (0.0, 87.6, 87.6)
    assert nrel.rna_mass_kg == 350e3
    assert nrel.gravity_m_per_s2 == 0.0
    assert nrel.format == "TOML"
    assert [Path(file).name for file in nrel.files] == ["nrel-5mw.toml"]
    assert nrel.stations.tolist() == [[0.0, 6.0, 0.0351], [87.6, 3.87, 0.0247]]
    # The mass of a linear tube by hand: Simpson's rule is exact for a cubic.
    z = np.array([0.0, 43.8, 87.6])
    diameter = np.interp(z, [0.0, 87.6], [6.0, 3.87])
    wall = np.interp(z, [0.0, 87.6], [0.0351, 0.0247])
    area = np.pi * (diameter - wall) * wall
    mass = 8500.0 * 87.6 / 6.0 * (area[0] + 4.0 * area[1] + area[2])
    assert nrel.mass_kg == pytest.approx(mass, rel=1e-12)


def test_a_tower_of_numbers_is_the_tower_of_its_file() -> None:
    tower = tm.Tower(stations=STATIONS, material=STEEL, rna={"mass": 350e3}, name="x")
    text = """
        name = "x"
        [material]
        density = 8500.0
        youngs_modulus = 2.1e11
        shear_modulus = 8.08e10
        [tower]
        stations = [[0.0, 6.0, 0.027], [87.6, 3.87, 0.019]]
        [rna]
        mass = 350e3
    """
    assert tower == tm.Tower.from_toml(text)
    # Arrays, tuples and numbers of NumPy are numbers too.
    steel = {key: np.float64(value) for key, value in STEEL.items()}
    same = tm.Tower(stations=np.array(STATIONS), material=steel, rna=350e3, name="x")
    assert same == tower
    assert hash(same) == hash(tower)
    assert same != tm.Tower(stations=STATIONS, material=STEEL, rna=350.1e3, name="x")
    assert same != "x"


def test_each_table_of_the_tower_file_is_an_argument() -> None:
    tower = tm.Tower(
        name='a "quoted" \\ name',
        stations=[[-20.0, 6.0, 0.06, "steel"], [87.6, 3.87, 0.019, "steel"]],
        materials={"steel": STEEL},
        outfitting_factor=1.05,
        shear=True,
        rna={"mass": 350e3, "center": [0.0, 0.0, 2.0], "inertia": {"xx": 4e7, "yy": 2e7}},
        point_mass=[{"height": 10.0, "mass": 1e5, "name": "platform"}],
        foundation={
            "type": "springs",
            "lateral": 1e9,
            "rocking": 5e10,
            "vertical": float("inf"),
            "torsion": 5e10,
        },
        soil=[{"rows": [[-20.0, 5e7, 5e7], [-10.0, 0.0, 0.0]]}],
        added_mass=[{"rows": [[-5.0, 100.0], [0.0, 0.0]]}],
        water={"level": 0.0, "bed": -10.0, "flooded": True},
        wires=[{"height": 60.0, "count": 3, "stiffness": 1e6, "angle_deg": 45.0}],
        gravity=9.81,
        rotor={"blades": 3, "rpm": [6.9, 12.1]},
    )
    assert tower.name == 'a "quoted" \\ name'
    assert tower.gravity_m_per_s2 == 9.81
    assert tm.Tower.from_toml(tower.to_toml()) == tower
    assert tower.solve(modes=2).certified
    table = {
        "z_m": [0.0, 90.0],
        "mass_kg_per_m": [5600.0, 2500.0],
        "ei_fore_aft_n_m2": [6.1e11, 1.2e11],
        "gj_n_m2": [4.7e11, 0.9e11],
        "ea_n": [1.4e11, 0.6e11],
        "polar_inertia_kg_m": [5.0e4, 0.9e4],
    }
    assert tm.Tower(properties=table).height_m == 90.0


def test_values_that_are_no_numbers_are_refused() -> None:
    with pytest.raises(TypeError, match="it must be a number, a text, a list"):
        tm.Tower(stations=STATIONS, material=STEEL, rna={"mass": 1 + 2j})


@pytest.mark.parametrize("path", examples(), ids=lambda path: path.name)
def test_every_example_is_read_pickled_and_written(path: Path) -> None:
    tower = tm.read(path)
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(tower, protocol))
        assert again == tower
        assert (again.notes, again.format) == (tower.notes, tower.format)
    assert copy.deepcopy(tower) == tower
    assert (again.solve(modes=3).frequency_hz == tower.solve(modes=3).frequency_hz).all()
    assert tm.Tower.from_toml(tower.to_toml()).mass_kg == tower.mass_kg
    assert repr(tower).startswith("<Tower ")
    assert tower.plot().startswith("<svg")
    assert tower._repr_svg_() == tower.plot()


def test_a_pickle_keeps_the_blade_of_the_turbine() -> None:
    tower = tm.read("examples/small-turbine/ElastoDyn.dat")
    campbell = tower.campbell()
    again = pickle.loads(pickle.dumps(tower)).campbell()
    assert again.to_json() == campbell.to_json()
    assert any(line["of"] == "blade" for line in campbell.data["lines"])


def test_reading_options_are_those_of_the_program() -> None:
    windio = "examples/nrel-5mw.yaml"
    assert tm.read(windio, no_rna=True).rna_mass_kg == 0.0
    assert tm.read("examples/monopile.toml", no_gravity=True).gravity_m_per_s2 == 0.0
    deck = tm.read("examples/small-turbine/ElastoDyn.dat", rotor="free")
    assert deck != tm.read("examples/small-turbine/ElastoDyn.dat")
    assert tm.read("examples/nrel-5mw.bmi", bmodes_quirks=True).format == "BModes"
    tower_file = "examples/small-turbine/" + next(
        path.name for path in Path("examples/small-turbine").glob("*ower*")
    )
    alone = tm.read(tower_file, tower_height_m=30.0, tower_base_m=2.0)
    assert (alone.base_m, alone.top_m) == (2.0, 30.0)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"part": "tower"}, "part applies only to windIO"),
        ({"rotor": "free"}, "the file has no `drivetrain`"),
        ({"bmodes_quirks": True}, "bmodes_quirks applies only to BModes"),
        ({"subset": (1, 1)}, "subset applies only to HAWC2"),
        ({"tower_height_m": 80.0}, "tower_height_m applies only"),
        ({"tower_base_m": 8.0}, "tower_base_m applies only"),
        ({"part": "blade"}, "part is 'blade'; it must be 'all', 'tower' or 'monopile'"),
        ({"rotor": "open"}, "rotor is 'open'; it must be 'locked' or 'free'"),
        ({"subset": (0, 1)}, "subset is 0; it must be at least 1"),
    ],
)
def test_an_option_without_effect_is_refused(options: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        tm.read("examples/nrel-5mw.toml", **options)  # type: ignore[arg-type]


def test_notes_and_warnings_are_lists(tmp_path: Path) -> None:
    tower = tm.read("crates/towermodes-cli/tests/inputs/millimetres.toml")
    assert tower.warnings[0].startswith("crates/towermodes-cli/tests/inputs/millimetres.toml:9: ")
    assert "lengths are in m, not mm" in tower.warnings[0]
    assert tm.read("examples/nrel-5mw.toml", no_rna=True).notes == []
    again = tm.read("examples/reference-tower.toml", no_rna=True)
    assert again.notes == ["the file has no rotor-nacelle assembly: --no-rna has no effect"]


def test_a_tower_cannot_be_changed(nrel: tm.Tower) -> None:
    with pytest.raises(AttributeError):
        nrel.name = "other"  # type: ignore[misc]
    with pytest.raises(AttributeError):
        nrel.new = 1  # type: ignore[attr-defined]


def test_conversions_are_read_back(nrel: tm.Tower, tmp_path: Path) -> None:
    f1 = nrel.solve().mode("fore-aft", 1).frequency_hz
    for format, name in [("toml", "a.toml"), ("bmodes", "a.bmi"), ("windio", "a.yaml")]:
        converted = nrel.convert(format)  # type: ignore[arg-type]
        converted.save(tmp_path / name)
        again = tm.read(tmp_path / name)
        assert again.solve(segments=100).mode("fore-aft", 1).frequency_hz == pytest.approx(
            f1, rel=1e-3
        )
        assert repr(converted).startswith("<Converted: ")
    deck = nrel.convert("bmodes", sections_file="a_sections.dat")
    assert deck.companion is not None
    assert deck.companion[0] == "a_sections.dat"
    elastodyn = nrel.convert("elastodyn", from_height_m=10.0)
    assert any("torsion" in note or "RNA" in note for note in elastodyn.notes) or elastodyn.text
    with pytest.raises(ValueError, match="from_height_m applies only to the format elastodyn"):
        nrel.convert("toml", from_height_m=10.0)
    with pytest.raises(ValueError, match="'xml' is not a format"):
        nrel.convert("xml")  # type: ignore[arg-type]


def test_numbers_have_names(nrel: tm.Tower) -> None:
    parameters = nrel.parameters
    assert parameters["rna.mass"] == 350e3
    assert parameters["stations[1].wall"] == 0.0247
    assert parameters.keys() == nrel.parameter_units.keys() == nrel.parameter_meanings.keys()
    assert nrel.parameter_units["rna.mass"] == "kg"
    assert nrel.parameter_meanings["stations[1].wall"]


def test_other_numbers_are_another_tower(nrel: tm.Tower) -> None:
    changed = nrel.with_({"rna.mass": 360e3, "scale(stations[*].wall)": 1.1})
    assert changed.rna_mass_kg == 360e3
    assert changed.stations[:, 2] == pytest.approx([1.1 * 0.0351, 1.1 * 0.0247])
    assert nrel.rna_mass_kg == 350e3
    assert changed.notes[0] == "rna.mass = 360000 kg by with_; the file has 350000"
    by_text = nrel.to_toml().replace("350000", "360000")
    assert tm.Tower.from_toml(by_text) == nrel.with_({"rna.mass": np.float64(360e3)})
    assert pickle.loads(pickle.dumps(changed)) == changed
    with pytest.raises(ValueError, match=r"did you mean `rna\.mass`"):
        nrel.with_({"rna.mas": 1.0})
    with pytest.raises(ValueError, match="already changes"):
        nrel.with_({"scale(stations[*].wall)": 1.1, "stations[0].wall": 0.03})
    with pytest.raises(tm.TowerError, match=r"stations\[0\]\.wall: .*-1 m; it must be positive") as caught:
        nrel.with_({"stations[0].wall": -1.0})
    assert caught.value.line is None


class Named(tm.Tower):
    """A class of a user."""


def test_towers_of_other_classes_stay_so() -> None:
    tower = Named.from_toml(tm.read("examples/nrel-5mw.toml").to_toml())
    changed = tower.with_({"rna.mass": np.float32(3e5)})
    assert type(changed) is Named
    assert type(pickle.loads(pickle.dumps(changed))) is Named


def test_numbers_may_be_those_of_numpy() -> None:
    steel = {"density": np.int64(8500), "youngs_modulus": 2.1e11, "shear_modulus": 8.08e10}
    plain = tm.Tower(stations=STATIONS, material={**steel, "density": 8500}, rna=3e5, gravity=9.5)
    for kind in (np.float32, np.float64, np.array, np.int64):
        tower = tm.Tower(stations=STATIONS, material=steel, rna=kind(300_000), gravity=9.5)
        assert tower == plain
    with pytest.raises(tm.TowerError, match=r"stations\[1\]\.diameter: "):
        tm.Tower(stations=[STATIONS[0], [80.0, -1.0, 0.02]], material=steel)


def test_a_path_is_not_the_text_of_a_file() -> None:
    with pytest.raises(tm.TowerError, match="is not the text of a tower file") as caught:
        tm.Tower.from_toml("examples/nrel-5mw.toml")
    assert "towermodes.read" in str(caught.value.hint)
    assert tm.read(b"examples/nrel-5mw.toml").name == tm.read("examples/nrel-5mw.toml").name


def test_a_picture_is_no_png(nrel: tm.Tower, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="ends with .png"):
        nrel.plot().save(tmp_path / "tower.png")


def test_a_pickle_keeps_how_the_shear_modulus_is_given() -> None:
    steel = {"density": 8500.0, "youngs_modulus": 2.1e11, "poissons_ratio": 0.3}
    tower = tm.Tower(stations=STATIONS, material=steel)
    stiffer = {"material.youngs_modulus": 2.3e11}
    expected = tower.with_(stiffer).solve(modes=3).frequency_hz
    # All stiffnesses grow with E, because Poisson's ratio stays.
    ratio = expected / tower.solve(modes=3).frequency_hz
    assert ratio == pytest.approx(np.sqrt(2.3 / 2.1), rel=1e-12)
    again = pickle.loads(pickle.dumps(tower)).with_(stiffer)
    assert again.solve(modes=3).frequency_hz.tolist() == expected.tolist()
    assert tm.Tower.from_toml(tower.to_toml()).with_(stiffer) == tower.with_(stiffer)


def test_a_deck_without_its_method_has_a_note() -> None:
    deck = tm.read("examples/nrel-5mw.bmi")
    for format in ("toml", "windio"):
        notes = deck.convert(format).notes
        assert any("solved by the method bmodes with" in note for note in notes)
    assert not any("solved by the method" in note for note in deck.convert("bmodes").notes)


def test_a_tower_file_with_a_drivetrain_has_a_free_rotor() -> None:
    path = "examples/measured/swift-v27.toml"
    locked, free = (tm.read(path, rotor=rotor).solve(2) for rotor in ("locked", "free"))
    assert locked.mode("side-side", 1).frequency_hz == pytest.approx(1.0378, abs=5e-5)
    assert free.mode("side-side", 1).frequency_hz == pytest.approx(1.0441, abs=5e-5)
    # The centre of mass beside the axis couples the planes slightly.
    both = [solution.mode("fore-aft", 1).frequency_hz for solution in (locked, free)]
    assert both[0] == pytest.approx(both[1], rel=1e-6)
