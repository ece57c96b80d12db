"""The scatter of frequencies to first order: the digits of the program, closed forms, refusals."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys

import pytest

import towermodes as tm

STUDY = "examples/studies/uncertainty.toml"
DENSITY = "scale(material.density)"


def test_it_is_that_of_the_program(nrel: tm.Tower) -> None:
    words = ["sweep", STUDY, "--first-order", "--format", "json"]
    done = subprocess.run(
        [sys.executable, "-m", "towermodes", *words], capture_output=True, check=True
    )
    scatter = nrel.first_order(STUDY)
    assert scatter.data == json.loads(done.stdout)
    assert list(scatter.mean_hz) == ["side-side 1", "fore-aft 1"]
    assert sum(scatter.shares("fore-aft 1").values()) == pytest.approx(1.0)
    assert "share of the variance" in str(scatter)
    assert scatter.warnings == []
    assert pickle.loads(pickle.dumps(scatter)).data == scatter.data


def test_a_dict_needs_distributions_only(nrel: tm.Tower) -> None:
    study = {"sweep": {"vary": {"rna.mass": {"normal": [350e3, 7e3]}}}}
    scatter = nrel.first_order(study, modes=["fore-aft 1"])
    derivatives = nrel.sensitivities(["rna.mass"], modes=["fore-aft 1"])
    slope = float(derivatives.mode("fore-aft", 1)[0])
    assert scatter.deviation_hz["fore-aft 1"] == pytest.approx(abs(slope) * 7e3)
    assert scatter.shares("fore-aft 1") == {"rna.mass": pytest.approx(1.0)}
    with pytest.raises(KeyError, match="no mode torsion 1 among fore-aft 1"):
        scatter.shares("torsion 1")


def test_curvature_that_is_too_large_is_a_warning(nrel: tm.Tower) -> None:
    # Without an RNA the frequencies are proportional to the inverse root of the density.
    names = ["rna.mass", "rna.inertia.xx", "rna.inertia.yy", "rna.inertia.zz"]
    tower = nrel.with_(dict.fromkeys(names, 0.0))
    study = {"sweep": {"vary": {DENSITY: {"lognormal": [1.0, 0.4]}}}}
    scatter = tower.first_order(study, modes=["fore-aft 1"])
    shift = (1.4**-0.5 + 0.6**-0.5) / 2.0 - 1.0
    mean_hz = scatter.mean_hz["fore-aft 1"]
    assert scatter.mean_shift_hz["fore-aft 1"] / mean_hz == pytest.approx(shift, rel=1e-3)
    # The others are notes of the changes.
    [warning] = [text for text in scatter.warnings if "not reliable" in text]
    assert warning.startswith("fore-aft 1: the curvature moves the mean by ")
    assert "34 % of its standard deviation" in warning
    assert warning in repr(scatter)


def test_what_has_no_first_order_is_refused(nrel: tm.Tower) -> None:
    with pytest.raises(tm.TowerError, match="rna.mas"):
        nrel.first_order({"sweep": {"vary": {"rna.mas": {"normal": [350e3, 7e3]}}}})
    with pytest.raises(ValueError, match="distributions"):
        nrel.first_order({"sweep": {"base": "x", "table": "values.csv"}})
    with pytest.raises(TypeError, match="neither the path"):
        nrel.first_order(3)  # type: ignore[arg-type]
