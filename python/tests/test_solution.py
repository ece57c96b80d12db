"""Solutions: digits of the program, arrays, names, pictures."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import examples

import towermodes as tm


def program(*words: str) -> str:
    """The standard output of the program in the same package."""
    command = [sys.executable, "-m", "towermodes", *words]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    return done.stdout


@pytest.mark.parametrize("path", examples(), ids=lambda path: path.name)
def test_digits_are_those_of_the_program(path: Path) -> None:
    solution = tm.read(path).solve()
    text = program("solve", str(path), "--format", "json")
    assert solution.to_json() == text
    modes = json.loads(text)["modes"]
    for mode, frequency_hz, extrapolated_hz in zip(
        modes, solution.frequency_hz, solution.extrapolated_hz, strict=True
    ):
        assert mode["frequency_hz"] == frequency_hz
        assert mode["extrapolated_hz"] == extrapolated_hz
    table = program("solve", str(path))
    # Only the program knows the command for the whole turbine.
    table = table.split("\nrotor and nacelle are one rigid body here")[0]
    assert solution.__repr__().startswith(table.rstrip("\n"))
    assert solution.to_csv() == program("solve", str(path), "--format", "csv")


def test_arrays_have_their_shapes_and_types(nrel: tm.Tower) -> None:
    solution = nrel.solve(modes=5, points=11, heights_m=[10.0, 20.0])
    vectors = [
        solution.frequency_hz,
        solution.error_hz,
        solution.algebraic_error_hz,
        solution.discretization_error_hz,
        solution.extrapolated_hz,
        solution.period_s,
        solution.modal_mass,
    ]
    for vector in vectors:
        assert vector.shape == (5,)
        assert vector.dtype == np.float64
    assert solution.shape.shape == (5, 11, 6)
    assert solution.height_m.tolist() == pytest.approx(np.linspace(0.0, 87.6, 11).tolist())
    assert solution.station_shape.shape == (5, 2, 6)
    assert solution.station_height_m.tolist() == [0.0, 87.6]
    assert solution.shape_at_heights.shape == (5, 2, 6)
    assert solution.effective_mass.shape == (5, 6)
    shares = solution.effective_mass_shares
    assert shares is not None
    assert shares.shape == (6,)
    assert solution.rigid_inertia.shape == (6, 6)
    # What they are: the errors add up, the shapes are 1 at the top, the sums are those of modes.
    total = solution.algebraic_error_hz + solution.discretization_error_hz
    assert solution.error_hz.tolist() == total.tolist()
    fore_aft = solution.mode("fore-aft", 1)
    assert fore_aft.shape[-1, 0] == 1.0
    assert fore_aft.shape[0].tolist() == [0.0] * 6
    shares = solution.effective_mass.sum(axis=0) / solution.rigid_inertia.diagonal()
    assert solution.effective_mass_shares == pytest.approx(shares, rel=1e-12)
    assert solution.period_s == pytest.approx(1.0 / solution.frequency_hz)
    # A result does not change.
    for array in (solution.frequency_hz, solution.shape, solution.rigid_inertia, fore_aft.shape):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0
    assert fore_aft.shape.tolist() == solution.shape[fore_aft.number - 1].tolist()


def test_a_solution_is_a_list_of_modes(nrel: tm.Tower) -> None:
    solution = nrel.solve(modes=3)
    assert [mode.label for mode in solution] == solution.labels
    assert solution[-1] == solution.mode("torsion 1") == solution.modes[2]
    assert [solution.mode(family, order).number for family, order in solution.names] == [1, 2, 3]
    with pytest.raises(IndexError):
        solution[3]
    with pytest.raises(TypeError, match="no slices"):
        solution[:2]  # type: ignore[index]
    with pytest.raises(ValueError, match="did you mean 'fore-aft'"):
        solution.mode("fore-aff", 1)
    assert solution == nrel.solve(modes=3)
    assert solution != nrel.solve(modes=2)
    assert solution != nrel.with_({"rna.mass": 3e5}).solve(modes=3)
    with pytest.raises(TypeError, match=r"a Solution is made by Tower\.solve"):
        tm.Solution()


def test_the_certificate_counts_the_mode_that_a_pair_lacks(nrel: tm.Tower) -> None:
    free = {name: 0.0 for name in nrel.parameters if name.startswith("rna.inertia")}
    symmetric = nrel.with_({**free, "rna.center[0]": 0.0})
    cut, whole = symmetric.solve(modes=1), symmetric.solve(modes=2)
    assert (len(cut), cut.count, cut.certified) == (1, 2, True)
    assert (len(whole), whole.count, whole.certified) == (2, 2, True)


def test_modes_have_names(nrel: tm.Tower) -> None:
    solution = nrel.solve()
    assert solution.names[:3] == [("side-side", 1), ("fore-aft", 1), ("torsion", 1)]
    assert solution.labels[1] == "1st fore-aft bending"
    mode = solution.mode("fore-aft", 2)
    assert (mode.family, mode.order, mode.label) == ("fore-aft", 2, "2nd fore-aft bending")
    assert mode.number == 5
    assert mode.frequency_hz == solution.frequency_hz[4]
    assert mode.error_hz == solution.error_hz[4]
    assert mode.extrapolated_hz == solution.extrapolated_hz[4]
    assert mode.period_s == solution.period_s[4]
    assert mode.modal_mass == solution.modal_mass[4]
    assert mode.effective_mass.tolist() == solution.effective_mass[4].tolist()
    assert [one.label for one in solution.modes] == solution.labels
    assert len(solution) == 8
    with pytest.raises(KeyError, match="no mode fore-aft 9 among the 8 modes"):
        solution.mode("fore-aft", 9)


def test_a_solution_knows_how_it_was_made(nrel: tm.Tower, monopile: tm.Tower) -> None:
    solution = nrel.solve(segments=np.int64(40))
    assert (solution.method, solution.segments, solution.degree) == ("rmje-exact", 40, None)
    assert solution.degrees_of_freedom > 40
    assert solution.certified is True
    assert solution.complete_below_hz > solution.frequency_hz[-1]
    assert solution.buckling_load_factor is None
    assert solution.tower is nrel
    factor = monopile.solve().buckling_load_factor
    assert factor is not None
    assert factor > 1.0
    spectral = nrel.solve(method="spectral", modes=2)
    assert spectral.degree is not None
    assert spectral.frequency_hz == pytest.approx(solution.extrapolated_hz[:2], rel=1e-6)
    euler = nrel.solve(rotary_inertia=False)
    assert (euler.extrapolated_hz > solution.extrapolated_hz)[3]


def test_a_clamped_beam_has_its_textbook_frequency() -> None:
    # f1 = 1.8751^2/(2 pi) sqrt(EI/(rho A L^4)) for a prismatic beam without rotary inertia
    tower = tm.Tower(
        stations=[[0.0, 4.0, 0.03], [90.0, 4.0, 0.03]],
        material={"density": 7850.0, "youngs_modulus": 2.1e11, "shear_modulus": 8.08e10},
    )
    outer, inner = 2.0, 1.97
    area = np.pi * (outer**2 - inner**2)
    bending = 2.1e11 * np.pi / 4.0 * (outer**4 - inner**4)
    exact = 1.875104068711961**2 / (2.0 * np.pi) * np.sqrt(bending / (7850.0 * area * 90.0**4))
    solution = tower.solve(rotary_inertia=False)
    assert solution.mode("fore-aft", 1).extrapolated_hz == pytest.approx(exact, rel=1e-8)


def test_free_motions_have_no_period() -> None:
    moored = tm.read("examples/floating.toml")
    afloat = moored.with_({name: 0.0 for name in moored.parameters if "mooring[" in name})
    solution = afloat.solve()
    assert [solution.mode(name).period_s for name in ("surge", "sway", "yaw")] == [np.inf] * 3
    assert solution.mode("surge").frequency_hz == 0.0
    assert solution.mode("heave").period_s == pytest.approx(31.59, abs=0.01)


def test_notebooks_show_table_and_shapes(nrel: tm.Tower) -> None:
    html = nrel.solve()._repr_html_()
    assert html.count("<tr>") == 9
    assert "1st fore-aft bending" in html
    assert "complete: exactly 8 modes" in html
    assert "<svg" in html
    millimetres = tm.read("crates/towermodes-cli/tests/inputs/millimetres.toml").solve()
    assert "warning: " in repr(millimetres)
    assert "lengths are in m, not mm" in millimetres._repr_html_()


def test_pictures_are_svg(nrel: tm.Tower, tmp_path: Path) -> None:
    picture = nrel.solve().plot()
    assert isinstance(picture, str)
    assert picture._repr_svg_() == picture
    picture.save(tmp_path / "shapes.svg")
    assert (tmp_path / "shapes.svg").read_text(encoding="utf-8") == picture
    assert "fore-aft" in picture


def test_notes_of_the_file_are_in_the_solution() -> None:
    tower = tm.read("examples/nrel-5mw.bmi")
    assert tower.solve().notes == tower.notes
