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


def test_results_go_from_process_to_process(nrel: tm.Tower) -> None:
    results = [
        nrel.solve(modes=3, points=11),
        nrel.campbell(margin=0.1),
        nrel.check(tm.read("examples/nrel-5mw.yaml")),
        nrel.examine(),
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
    with pytest.raises(ValueError, match=r"give rpm=\(lowest, highest\)"):
        tower.campbell()
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
