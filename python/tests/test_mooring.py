"""Mooring lines without their platform: arrays, digits of the program, mistakes."""

from __future__ import annotations

import json

import numpy as np
import pytest
from test_solution import program

import towermodes as tm

SPAR = "examples/spar_MoorDyn.dat"


def test_digits_are_those_of_the_program() -> None:
    lines = tm.solve_mooring(SPAR)
    said = json.loads(program("solve", SPAR, "--format", "json"))
    assert lines.stiffness.tolist() == said["stiffness"]
    assert lines.force.tolist() == said["force"]
    assert lines.points_m.shape == (6, 3)
    assert lines.tension_n.shape == (3, 2)
    assert not lines.stiffness.flags.writeable
    assert lines.data == said


def test_three_equal_lines_pull_straight_down() -> None:
    lines = tm.solve_mooring(SPAR)
    # The positions of the file have eight digits.
    np.testing.assert_allclose(lines.force[:2], 0.0, atol=1.0)
    assert lines.force[2] == pytest.approx(-1.607e6, abs=1e3)
    assert (lines.on_seabed_m > 0.0).all()


def test_files_of_towers_are_refused() -> None:
    with pytest.raises(ValueError, match="no file of MoorDyn"):
        tm.solve_mooring("examples/nrel-5mw.toml")
    with pytest.raises(ValueError, match="solve_mooring"):
        tm.read(SPAR)
