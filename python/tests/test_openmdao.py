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


# Inputs whose initial value is 0, so that no step relative to it exists, and a step for each.
AT_ZERO = {
    "add(rna.mass)": 1e3,
    "add(stations[*].wall)": 1e-4,
    "add(stations[1].height)": 1e-2,
    "add(rna.inertia.yy)": 1e5,
    "rna.center[1]": 1e-3,
}


@pytest.mark.parametrize("change", AT_ZERO)
def test_derivatives_at_zero_are_those_of_the_sweep(nrel: tm.Tower, change: str) -> None:
    run = problem(nrel, {"x": change}, [("fore-aft", 1), ("side-side", 1)])
    run.run_model()
    found = run.compute_totals(["fore_aft_1_hz", "side_side_1_hz", "mass_kg"], ["x"])
    step = AT_ZERO[change]
    swept = nrel.sweep({change: [step, -step]}, modes=[("fore-aft", 1), ("side-side", 1)])
    # The difference has an error of the second order in the step.
    for place, output in enumerate(["fore_aft_1_hz", "side_side_1_hz"]):
        up, down = swept.frequency_hz[:, place]
        expected = (up - down) / (2.0 * step)
        assert found[output, "x"].item() == pytest.approx(expected, rel=1e-4, abs=1e-9 / step)
    mass = (swept.mass_kg[0] - swept.mass_kg[1]) / (2.0 * step)
    assert found["mass_kg", "x"].item() == pytest.approx(mass, rel=1e-6)


def test_an_optimizer_moves_an_input_that_begins_at_zero(nrel: tm.Tower) -> None:
    run = problem(nrel, {"extra": "add(rna.mass)"}, [("fore-aft", 1)])
    run.model.add_design_var("extra", lower=-5e4, upper=1e5, ref=1e5)
    run.model.add_objective("fore_aft_1_hz")
    run.driver = om.ScipyOptimizeDriver(optimizer="SLSQP", disp=False)
    run.setup()
    assert run.run_driver().success
    assert run.get_val("extra").item() == pytest.approx(1e5)


def test_inputs_that_share_numbers_have_derivatives(nrel: tm.Tower) -> None:
    inputs = {
        "walls": "scale(stations[*].wall)",
        "extra": "add(stations[1].wall)",
        "all": "scale(stations[*].wall)".replace("scale", "scale "),
    }
    run = problem(nrel, inputs, [("fore-aft", 1)])
    run.set_val("walls", 1.1)
    run.set_val("extra", 0.002)
    run.set_val("all", 0.9)
    run.run_model()
    data = run.check_partials(out_stream=None, form="central", step=1e-5)
    assert max(entry["rel error"].forward for entry in data["tower"].values()) < 1e-6


def test_a_factor_of_zero_has_a_derivative(nrel: tm.Tower) -> None:
    run = problem(nrel, {"inertia": "scale(rna.inertia.yy)"}, [("fore-aft", 1)])
    run.set_val("inertia", 0.0)
    run.run_model()
    found = run.compute_totals(["fore_aft_1_hz"], ["inertia"])["fore_aft_1_hz", "inertia"].item()
    tower = nrel.with_({"rna.inertia.yy": 0.0})
    one = tower.sensitivities(["rna.inertia.yy"], modes=[("fore-aft", 1)])
    expected = one.hz_per_unit[0, 0] * nrel.parameters["rna.inertia.yy"]
    assert found == pytest.approx(expected, rel=1e-12)
    assert found < 0.0


def test_numbers_that_differ_are_not_set_to_one_value(nrel: tm.Tower) -> None:
    with pytest.raises(ValueError, match=r"from 0.0247 to 0.0351 .* scale\(stations\[\*\].wall\)"):
        problem(nrel, {"wall": "stations[*].wall"}, [("fore-aft", 1)])
    both = "set(stations[0].wall,stations[1].wall)"
    with pytest.raises(ValueError, match=r"use scale\(stations\[0\].wall,stations\[1\].wall\)"):
        problem(nrel, {"wall": both}, [("fore-aft", 1)])
    equal = nrel.with_({"stations[*].wall": 0.03})
    run = problem(equal, {"wall": both}, [("fore-aft", 1)])
    run.run_model()
    assert run.get_val("wall").item() == 0.03


def test_modes_have_names_of_modes(nrel: tm.Tower) -> None:
    with pytest.raises(ValueError, match="did you mean 'fore-aft'"):
        component.TowerModes(tower=nrel, inputs={"x": "rna.mass"}, modes=[("fore-aff", 1)])
    with pytest.raises(ValueError, match="inputs is empty"):
        component.TowerModes(tower=nrel, inputs={}, modes=[("fore-aft", 1)])
    run = problem(nrel, {"x": "rna.mass"}, ["fore-aft 1"])  # type: ignore[list-item]
    run.run_model()
    assert run.get_val("fore_aft_1_hz").item() > 0.3


def test_a_tower_that_cannot_be_is_an_analysis_error(nrel: tm.Tower) -> None:
    run = problem(nrel, {"wall": "stations[0].wall"}, [("fore-aft", 1)])
    run.set_val("wall", -0.01)
    with pytest.raises(om.AnalysisError, match=r"-0\.01 m"):
        run.run_model()


def test_an_unknown_number_is_refused(nrel: tm.Tower) -> None:
    with pytest.raises(ValueError, match="did you mean"):
        problem(nrel, {"wall": "stations[0].wal"}, [("fore-aft", 1)]).final_setup()
