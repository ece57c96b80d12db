"""Derivatives: differences of sweeps, values that are known, tables, refusals."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import towermodes as tm

NAMES = ["rna.mass", "scale(stations[*].wall)", "add(stations[1].height)"]


def test_derivatives_are_the_differences_of_a_sweep(nrel: tm.Tower) -> None:
    result = nrel.sensitivities(NAMES, modes=4)
    assert result.names == NAMES
    assert result.units == ["kg", "", "m"]
    assert result.values.tolist() == [350e3, 1.0, 0.0]
    assert result.hz_per_unit.shape == result.error_hz_per_unit.shape == (3, 4)
    for row, (name, step) in enumerate(zip(NAMES, [100.0, 1e-4, 1e-3], strict=True)):
        value = result.values[row]
        swept = nrel.sweep({name: [value + step, value - step]}, modes=result.modes)
        expected = (swept.frequency_hz[0] - swept.frequency_hz[1]) / (2.0 * step)
        assert result.hz_per_unit[row] == pytest.approx(expected, rel=1e-5)
        mass = (swept.mass_kg[0] - swept.mass_kg[1]) / (2.0 * step)
        assert result.mass_kg_per_unit[row] == pytest.approx(mass, rel=1e-6)
    relative = result.hz_per_unit * result.values[:, None] / result.frequency_hz
    assert result.elasticity[:2] == pytest.approx(relative[:2])
    assert np.isnan(result.elasticity[2]).all()


@pytest.mark.parametrize("method", ["cardanic", "bmodes", "spectral"])
def test_other_methods_have_derivatives_too(nrel: tm.Tower, method: str) -> None:
    names = ["material.youngs_modulus"]
    modes = [("fore-aft", 1)]
    result = nrel.sensitivities(names, modes=modes, method=method)  # type: ignore[arg-type]
    # f is proportional to √E: fore-aft bending has no part of the shear modulus.
    assert result.elasticity[0, 0] == pytest.approx(0.5, rel=1e-6)


def test_every_number_is_the_default(nrel: tm.Tower) -> None:
    result = nrel.sensitivities(modes=2)
    assert set(result.names) <= set(nrel.parameters)
    assert {"material.density", "stations[0].wall", "rna.mass"} <= set(result.names)
    assert len(result) == len(result.names)


def test_modes_are_taken_by_name(nrel: tm.Tower) -> None:
    result = nrel.sensitivities(["rna.mass"], modes=["torsion 1", ("fore-aft", 2)])
    assert result.modes == [("torsion", 1), ("fore-aft", 2)]
    lowest = nrel.sensitivities("rna.mass", modes=6)
    assert result.mode("torsion") == pytest.approx(lowest.mode("torsion", 1), rel=1e-9)
    with pytest.raises(KeyError, match="no mode axial 1 among the 2 modes"):
        result.mode("axial")


def test_a_derivative_that_does_not_exist_is_missing_with_its_reason() -> None:
    floating = tm.read("examples/floating.toml")
    result = floating.sensitivities(["rna.mass"], modes=12)
    for name, mode, reason in result.missing:
        assert math.isnan(result.mode(*mode)[result.names.index(name)])
        assert reason
    assert len(result.missing) == np.isnan(result.hz_per_unit).sum()


def test_tables(nrel: tm.Tower) -> None:
    pyarrow = pytest.importorskip("pyarrow")
    result = nrel.sensitivities(NAMES, modes=1)
    table = pyarrow.table(result)
    assert table.column_names == list(result.to_dict())
    assert table["name"].to_pylist() == NAMES
    assert table["side_side_1_hz_per_unit"].to_pylist() == result.hz_per_unit[:, 0].tolist()
    assert table["side_side_1_elasticity"].null_count == 1
    assert result._repr_html_().count("<tr>") == 4
    with pytest.raises(ValueError, match="read-only"):
        result.hz_per_unit[0, 0] = 0.0


@pytest.mark.parametrize(
    ("names", "kind", "message"),
    [
        (["rna.mas"], ValueError, "did you mean `rna.mass`"),
        (["stations[*].wall"], ValueError, r"use scale\(…\) or add\(…\)"),
        ([], ValueError, "nothing is varied"),
        ([1.0], TypeError, "a name of a number is 1.0"),
    ],
)
def test_wrong_names_say_what_is_wrong(
    nrel: tm.Tower, names: list[str], kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        nrel.sensitivities(names)


@pytest.mark.parametrize("method", [None, "cardanic", "bmodes", "spectral"])
def test_a_solution_has_the_derivatives_of_its_modes(nrel: tm.Tower, method: str | None) -> None:
    options: dict[str, Any] = {"method": method}
    solution = nrel.solve(3, **options)
    result = solution.sensitivities(NAMES)
    assert result.modes == solution.names
    expected = nrel.sensitivities(NAMES, modes=solution.names, **options)
    assert np.array_equal(result.hz_per_unit, expected.hz_per_unit, equal_nan=True)
    finer = nrel.solve(3, segments=60, rotary_inertia=False).sensitivities(NAMES)
    expected = nrel.sensitivities(NAMES, modes=finer.modes, segments=60, rotary_inertia=False)
    assert np.array_equal(finer.hz_per_unit, expected.hz_per_unit, equal_nan=True)


def test_the_mass_of_a_sweep_has_the_derivative_that_is_given() -> None:
    """Walls of the members of a substructure count in both."""
    jacket = tm.read("examples/jacket.toml")
    walls = "scale(substructure.member[*].wall_thickness)"
    found = jacket.sensitivities([walls], modes=1)
    swept = jacket.sweep({walls: [0.999, 1.0, 1.001]}, modes=1)
    below, own, above = swept.mass_kg
    assert own == pytest.approx(jacket.structure_mass_kg, rel=1e-12)
    # A tube's area is quadratic in its wall.
    assert (above - below) / 0.002 == pytest.approx(found.mass_kg_per_unit[0], rel=1e-9)
