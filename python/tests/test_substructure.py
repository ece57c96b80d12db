"""Substructures of SubDyn without their towers: arrays, digits of the program, mistakes."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from test_solution import program

import towermodes as tm

TRIPOD = "examples/tripod_SubDyn.dat"


def test_digits_are_those_of_the_program() -> None:
    modes = tm.solve_substructure(TRIPOD, modes=4)
    said = json.loads(program("solve", TRIPOD, "--modes", "4", "--format", "json"))
    assert modes.frequency_hz.tolist() == [mode["frequency_hz"] for mode in said["modes"]]
    assert modes.shape.shape == (4, len(modes.joints), 6)
    assert modes.member_shape.shape == (4, said["substructure"]["members"], 3, 3)
    assert not modes.shape.flags.writeable


def test_masses_sum_to_the_whole() -> None:
    modes = tm.solve_substructure(TRIPOD, modes=1)
    masses = modes.masses_kg
    added = masses.pop("added")
    assert added == 0.0
    whole = modes.data["substructure"]["mass_kg"]
    np.testing.assert_allclose(sum(masses.values()), whole, rtol=1e-12)


def test_held_joints_and_elements_of_subdyn_are_options() -> None:
    free = tm.solve_substructure(TRIPOD, modes=1)
    held = tm.solve_substructure(TRIPOD, modes=1, clamped=True)
    coarse = tm.solve_substructure(TRIPOD, modes=1, method="subdyn")
    assert held.frequency_hz[0] > free.frequency_hz[0]
    assert coarse.data["method"] == "subdyn"
    with pytest.raises(ValueError, match="must be 'spectral' or 'subdyn'"):
        tm.solve_substructure(TRIPOD, method="bmodes")  # type: ignore[arg-type]


def test_another_file_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="no SubDyn file"):
        tm.solve_substructure("examples/nrel-5mw.toml")
    with pytest.raises(OSError, match="none"):
        tm.solve_substructure(tmp_path / "none.dat")


def test_a_tower_without_members_has_no_joints() -> None:
    tower = tm.read("examples/nrel-5mw.toml")
    solution = tower.solve(modes=2)
    assert solution.joint_shape.shape == (2, 0, 6)
    assert solution.member_shape.shape == (2, 0, 3, 3)
    assert (tower.joints, tower.members, tower.substructure_masses_kg) == ({}, {}, {})
