"""Resonance, comparison of methods, agreement of descriptions: the results of the program."""

from __future__ import annotations

import copy
import json
import pickle

import numpy as np
import pytest
from test_solution import program

import towermodes as tm


def test_margins_are_those_of_the_program(nrel: tm.Tower) -> None:
    campbell = nrel.campbell()
    assert campbell.to_json() == program("campbell", "examples/nrel-5mw.toml", "--format", "json")
    assert campbell.to_csv() == program("campbell", "examples/nrel-5mw.toml", "--format", "csv")
    assert repr(campbell).startswith(program("campbell", "examples/nrel-5mw.toml").rstrip("\n"))
    assert campbell.verdict == campbell.data["verdict"]
    assert campbell.conclusion
    assert campbell.plot().startswith("<svg")
    assert "<svg" in campbell._repr_html_()
    assert campbell.warnings == []


def test_damping_is_that_of_the_program() -> None:
    file = "examples/monopile.toml"
    options = ["--loss-factor", "tower=0.004", "--loss-factor", "soil=0.02", "--chord-moment=6073"]
    damping = tm.read(file).damping({"tower": 0.004, "soil": 0.02}, chord_moment_m3=6073)
    assert damping.to_json() == program("damping", file, *options, "--format", "json")
    assert damping.to_csv() == program("damping", file, *options, "--format", "csv")
    assert repr(damping).startswith(program("damping", file, *options).rstrip("\n"))
    assert any("damping of the foundation is not included" in note for note in damping.notes)
    assert damping.warnings == []
    first = damping.modes[0]
    ratios = [part["damping_ratio"] or 0.0 for part in first["parts"]]
    assert first["damping_ratio"] == pytest.approx(sum(ratios), rel=1e-14)


def test_damping_of_numbers_and_its_refusals(nrel: tm.Tower) -> None:
    tower = tm.Tower(
        stations=[[0.0, 6.0, 0.027], [87.6, 3.87, 0.019]],
        material={"density": 8500.0, "youngs_modulus": 2.1e11, "shear_modulus": 8.08e10},
        rna={"mass": 350e3},
        damping={"tower_loss_factor": 0.01},
    )
    ratios = [mode["damping_ratio"] for mode in tower.damping().modes]
    assert ratios == pytest.approx([0.005] * 8, rel=1e-14)
    with pytest.raises(ValueError, match="the unknown part `steel`"):
        nrel.damping({"steel": 0.004})
    with pytest.raises(ValueError, match="must be from 0 to 1"):
        nrel.damping({"tower": 4})
    with pytest.raises(ValueError, match="without the chord moment"):
        nrel.damping(lift_slope=5.0)
    with pytest.raises(ValueError, match="must be positive"):
        nrel.damping(chord_moment_m3=-1.0)
    with pytest.raises(TypeError, match="the loss factor of soil is 'much'"):
        nrel.damping({"soil": "much"})  # type: ignore[dict-item]


def test_results_go_from_process_to_process(nrel: tm.Tower) -> None:
    results = [
        nrel.solve(modes=3, points=11),
        nrel.campbell(margin=0.1),
        nrel.check(tm.read("examples/nrel-5mw.yaml")),
        nrel.examine(),
        nrel.damping({"tower": 0.004}, modes=2),
    ]
    for result in results:
        other = pickle.loads(pickle.dumps(result))
        assert type(other) is type(result)
        assert other.to_json() == result.to_json()  # type: ignore[attr-defined]
        if not isinstance(result, tm.Agreement):  # A pickle of a tower does not name its file.
            assert repr(other) == repr(result)
        assert copy.deepcopy(result) is result
    comparison = nrel.compare("rmje", segments=20, modes=2)
    again = pickle.loads(pickle.dumps(comparison))
    assert (again.frequency_hz == comparison.frequency_hz).all()
    converted = nrel.convert("bmodes")
    assert pickle.loads(pickle.dumps(converted)).companion == converted.companion


def test_margins_by_hand(nrel: tm.Tower) -> None:
    campbell = nrel.campbell(rpm=12.0, multiples=[1, 3], margin=0.1, blades=3, modes=2)
    f1 = nrel.solve(modes=2).mode("fore-aft", 1).frequency_hz
    by_name = {(m["label"], m["multiple"]): m for m in campbell.margins}
    assert by_name["1st fore-aft bending", 3]["distance"] == pytest.approx(0.6 / f1 - 1.0)
    assert len(by_name) == 4


def test_a_rotor_must_be_known() -> None:
    tower = tm.read("examples/reference-tower.toml")
    assert tower.campbell().not_checked == ["operating speeds unknown"]
    campbell = tower.campbell(rpm=(6.9, 12.1))
    assert any("3 are assumed" in note for note in campbell.notes)
    with pytest.raises(ValueError, match="the margin is 2"):
        tower.campbell(rpm=(6.9, 12.1), margin=2.0)
    with pytest.raises(ValueError, match="a multiple is 0"):
        tower.campbell(rpm=12.0, multiples=[0])
    with pytest.raises(tm.TowerError):
        tower.campbell(rpm=(12.0, 6.0))


def test_methods_are_compared(nrel: tm.Tower) -> None:
    comparison = nrel.compare(["rmje", "spectral"], segments=20, modes=3)
    assert [method for method, _ in comparison.columns] == ["rmje", "spectral"]
    assert comparison.labels[1] == "1st fore-aft bending"
    assert comparison.frequency_hz.shape == (2, 3)
    assert comparison.frequency_hz[0] == pytest.approx(
        nrel.solve(method="rmje", segments=20, modes=3).frequency_hz, rel=1e-14
    )
    assert comparison.relative_difference[1] == pytest.approx(np.zeros(3), abs=1e-12)
    assert "relative difference from spectral" in repr(comparison)
    assert comparison.plot().startswith("<svg")
    assert "<svg" in comparison._repr_html_()
    assert comparison.to_csv().count("\n") == 7
    assert comparison.warnings == []
    assert len(nrel.compare(modes=1).columns) == 7
    with pytest.raises(ValueError, match="'x' is not a method"):
        nrel.compare(["x"])  # type: ignore[list-item]


def test_descriptions_of_one_tower_agree(nrel: tm.Tower) -> None:
    agreement = nrel.check(tm.read("examples/nrel-5mw.yaml"))
    words = ("examples/nrel-5mw.toml", "examples/nrel-5mw.yaml", "--format", "json")
    assert agreement.to_json() == program("check", *words)
    assert agreement.verdict == agreement.data["verdict"] == "pass"
    assert "verdict: pass" in repr(agreement)
    assert "<pre>" in agreement._repr_html_()
    lighter = tm.Tower.from_toml(nrel.to_toml().replace("0.0351", "0.030"))
    disagreement = nrel.check(lighter)
    assert disagreement.verdict == "fail"
    assert disagreement.notes == []


def test_one_description_is_summarised(nrel: tm.Tower) -> None:
    examination = nrel.examine()
    words = ("examples/nrel-5mw.toml", "--format", "json")
    assert examination.to_json() == program("check", *words)
    assert examination.data["mass_kg"] == nrel.mass_kg
    assert examination.data == json.loads(examination.to_json())
    assert "tower-top flexibility" in repr(examination)
    assert "<pre>" in examination._repr_html_()
