"""Designs and calibrations: the digits of the program, towers found, refusals with places."""

from __future__ import annotations

import copy
import json
import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import towermodes as tm

INPUTS = Path("crates/towermodes-cli/tests/inputs")
DESIGN = INPUTS / "design/mass.toml"
MEASURED = INPUTS / "measured/tower.toml"


def program(command: str, study: Path) -> dict[str, object]:
    words = [command, "examples/nrel-5mw.toml", str(study), "--format", "json"]
    done = subprocess.run(
        [sys.executable, "-m", "towermodes", *words], capture_output=True, check=True
    )
    result: dict[str, object] = json.loads(done.stdout)
    return result


def test_a_design_is_that_of_the_program(nrel: tm.Tower) -> None:
    design = nrel.design(DESIGN)
    assert design.data == program("design", DESIGN)
    assert design.is_stationary
    assert design.tower.mass_kg == pytest.approx(design.mass_kg, rel=1e-12)
    frequency = design.tower.solve().mode("side-side", 1).extrapolated_hz
    assert frequency == pytest.approx(0.3, rel=1e-6)
    factor = design.values["scale(stations[*].wall)"]
    assert design.tower.stations[:, 2] == pytest.approx(factor * nrel.stations[:, 2])
    assert "KKT residual" in str(design)


def test_a_calibration_is_that_of_the_program(nrel: tm.Tower) -> None:
    fit = nrel.calibrate(MEASURED)
    assert fit.data == program("calibrate", MEASURED)
    assert list(fit.values) == ["rna.mass", "scale(stations[*].wall)"]
    assert fit.tower.rna_mass_kg == pytest.approx(fit.values["rna.mass"], rel=1e-7)
    assert fit.correlation.shape == (2, 2)
    assert np.diag(fit.correlation).tolist() == [1.0, 1.0]
    solved = fit.tower.solve().mode("fore-aft", 1).extrapolated_hz
    assert (solved - 0.325) / 0.001 == pytest.approx(fit.residuals["fore-aft 1"], abs=1e-3)
    one = nrel.calibrate(MEASURED, free="rna.mass")
    assert list(one.values) == ["rna.mass"]


def test_results_are_pickled(nrel: tm.Tower) -> None:
    fit = nrel.calibrate(MEASURED)
    again = pickle.loads(pickle.dumps(fit))
    assert again.data == fit.data
    assert copy.copy(fit) is fit


def test_mistakes_of_files_have_places(nrel: tm.Tower) -> None:
    with pytest.raises(tm.TowerError) as caught:
        nrel.calibrate(INPUTS / "measured/names.toml")
    assert (caught.value.line, caught.value.column) == (2, 1)
    assert len(caught.value.mistakes) == 2
    with pytest.raises(tm.TowerError, match="did you mean `stations") as caught:
        nrel.design(INPUTS / "design/misspelled.toml")
    assert caught.value.line == 3
    with pytest.raises(FileNotFoundError):
        nrel.design("nowhere.toml")


def test_mistakes_of_dicts_have_names(nrel: tm.Tower) -> None:
    measured = {"mode": "fore-aft 1", "frequency": 0.325, "deviation": 0.001}
    unknowns: dict[str, object] = {"rna.mass": {}, "scale(stations[*].wall)": {}}
    tables = {"calibrate": {"unknowns": unknowns}, "measured": [measured]}
    with pytest.raises(ValueError, match=r"^calibrate\.unknowns\[.*\]: 2 unknowns cannot be found from 1 measurement"):
        nrel.calibrate(tables)
    with pytest.raises(ValueError, match=r"^measured\[0\]: measurement 1 is of the mode surge"):
        nrel.calibrate({**tables, "measured": [{**measured, "mode": "surge"}]}, free=["rna.mass"])
    with pytest.raises(tm.TowerError, match="deviation is -1, but must be positive"):
        nrel.calibrate({**tables, "measured": [{**measured, "deviation": -1.0}]})
    with pytest.raises(ValueError, match="did you mean `rna.mass`"):
        nrel.calibrate(tables, free=["rna.mas"])
    with pytest.raises(TypeError, match="neither the path of a file nor a dict"):
        nrel.calibrate(3)  # type: ignore[arg-type]


def test_what_cannot_be_reached_is_refused_with_the_nearest(nrel: tm.Tower) -> None:
    measured = [{"mode": "fore-aft 1", "frequency": 5.0, "deviation": 0.001}]
    with pytest.raises(tm.SolveError, match="no value of the fitted inputs gives the measured frequency"):
        nrel.calibrate({"measured": measured}, free=["rna.mass"])
    variables = {"stations[*].wall": {"between": [0.012, 0.040], "each": "number"}}
    study = {"variables": variables, "frequencies": {"fore-aft 1": {"min": 0.36}}}
    with pytest.raises(tm.SolveError, match="nearest: 0.34") as caught:
        nrel.design({"design": study})
    assert caught.value.hint is not None
