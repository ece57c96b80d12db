"""The component of OpenMDAO: values, units, exact derivatives where they are known, refusals."""

from __future__ import annotations

from typing import Any

import pytest

import towermodes as tm

om: Any = pytest.importorskip("openmdao.api")
component: Any = pytest.importorskip("towermodes.openmdao")

# OpenMDAO has warnings of its own.
pytestmark = pytest.mark.filterwarnings("default")


def problem(tower: tm.Tower, inputs: dict[str, str], modes: list[tuple[str, int]]) -> Any:
    problem = om.Problem(reports=False)
    part = component.TowerModes(tower=tower, inputs=inputs, modes=modes)
    problem.model.add_subsystem("tower", part, promotes=["*"])
    problem.setup()
    return problem


def test_values_are_those_of_the_tower(nrel: tm.Tower) -> None:
    inputs = {
        "mass": "rna.mass",
        "walls": "scale(stations[*].wall)",
        "higher": "add(stations[1].height)",
    }
    run = problem(nrel, inputs, [("fore-aft", 1), ("torsion", 1)])
    run.run_model()
    solution = nrel.solve(modes=3, segments=20)
    assert run.get_val("fore_aft_1_hz").item() == pytest.approx(
        solution.mode("fore-aft", 1).extrapolated_hz, rel=1e-12
    )
    assert run.get_val("torsion_1_hz").item() == pytest.approx(
        solution.mode("torsion", 1).extrapolated_hz, rel=1e-12
    )
    assert run.get_val("mass_kg").item() == pytest.approx(nrel.mass_kg, rel=1e-14)
    assert [run.get_val(name).item() for name in inputs] == [350e3, 1.0, 0.0]


def test_outputs_have_the_names_of_the_columns_of_a_sweep() -> None:
    floating = tm.read("examples/floating.toml")
    modes = [("surge", 1), ("yaw", 1), ("fore-aft", 1)]
    run = problem(floating, {"mass": "rna.mass"}, modes)
    run.run_model()
    columns = floating.sweep({"rna.mass": [floating.rna_mass_kg]}, modes=modes).to_dict()
    for name in ("surge_hz", "yaw_hz", "fore_aft_1_hz"):
        assert run.get_val(name).item() == columns[name][0]


def test_units_are_converted(nrel: tm.Tower) -> None:
    inputs = {"wall": "stations[0].wall", "mass": "rna.mass", "inertia": "rna.inertia.xx"}
    run = problem(nrel, inputs, [("fore-aft", 1)])
    run.set_val("wall", 40.0, units="mm")
    run.set_val("mass", 360.0, units="t")
    run.set_val("inertia", 4e4, units="t*m**2")
    run.run_model()
    changes = {"stations[0].wall": 0.04, "rna.mass": 360e3, "rna.inertia.xx": 4e7}
    changed = nrel.with_(changes).solve(modes=2, segments=20).mode("fore-aft", 1)
    assert run.get_val("fore_aft_1_hz").item() == pytest.approx(changed.extrapolated_hz, rel=1e-12)


def test_derivatives_that_are_known(nrel: tm.Tower) -> None:
    """Bending stiffness is proportional to Young's modulus, mass to density."""
    inputs = {"modulus": "material.youngs_modulus", "density": "material.density"}
    run = problem(nrel, inputs, [("fore-aft", 1)])
    run.run_model()
    found = run.compute_totals(["fore_aft_1_hz", "mass_kg"], ["modulus", "density"])
    frequency_hz = run.get_val("fore_aft_1_hz").item()
    expected = {
        # f is proportional to √E: fore-aft bending has no part of the shear modulus.
        ("fore_aft_1_hz", "modulus"): frequency_hz / (2.0 * 2.1e11),
        ("mass_kg", "density"): nrel.mass_kg / 8500.0,
    }
    for pair, value in expected.items():
        assert found[pair].item() == pytest.approx(value, rel=1e-7), pair
    assert found["mass_kg", "modulus"].item() == 0.0


def test_a_tower_that_cannot_be_is_an_analysis_error(nrel: tm.Tower) -> None:
    run = problem(nrel, {"wall": "stations[0].wall"}, [("fore-aft", 1)])
    run.set_val("wall", -0.01)
    with pytest.raises(om.AnalysisError, match=r"-0\.01 m"):
        run.run_model()


def test_an_unknown_number_is_refused(nrel: tm.Tower) -> None:
    with pytest.raises(ValueError, match="did you mean"):
        problem(nrel, {"wall": "stations[0].wal"}, [("fore-aft", 1)]).final_setup()
