"""Errors: their class, place and hint."""

from __future__ import annotations

import pickle
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import towermodes as tm

READ: Any = tm.read
INPUTS = Path("crates/towermodes-cli/tests/inputs")


def test_a_mistake_has_its_place_and_its_hint() -> None:
    with pytest.raises(tm.TowerError) as caught:
        tm.read(INPUTS / "misspelled.toml")
    error = caught.value
    assert error.path == str(INPUTS / "misspelled.toml")
    assert (error.line, error.column) == (2, 1)
    assert error.hint == "did you mean `density`?"
    assert str(error).startswith(f"{error.path}:2:1: `densty` is not a key of [material]")
    assert error.mistakes == [
        tm.Mistake(2, 1, "`densty` is not a key of [material]", "did you mean `density`?")
    ]
    assert hash(error.mistakes[0]) == hash(
        tm.Mistake(2, 1, "`densty` is not a key of [material]", "did you mean `density`?")
    )
    assert "line=2" in repr(error.mistakes[0])
    assert isinstance(error, ValueError)


def test_all_mistakes_are_listed() -> None:
    with pytest.raises(tm.TowerError) as caught:
        tm.read(INPUTS / "several.toml")
    lines = [mistake.line for mistake in caught.value.mistakes]
    assert len(lines) > 1
    assert all(line is not None for line in lines)
    assert caught.value.line == lines[0]


def test_text_has_lines_but_no_path() -> None:
    with pytest.raises(tm.TowerError) as caught:
        tm.Tower.from_toml((INPUTS / "misspelled.toml").read_text(encoding="utf-8"))
    assert (caught.value.path, caught.value.line, caught.value.column) == (None, 2, 1)
    assert str(caught.value).startswith("<string>.toml:2:1: `densty` is not a key")


def test_numbers_have_neither() -> None:
    with pytest.raises(tm.TowerError) as caught:
        tm.Tower(
            stations=[[0.0, 6.0, -1.0], [80.0, 4.0, 0.02]],
            material={"density": 8500.0, "youngs_modulus": 2.1e11, "shear_modulus": 8e10},
        )
    error = caught.value
    assert (error.path, error.line, error.column) == (None, None, None)
    assert str(error).startswith(
        "stations[0].wall: wall thickness is -1 m; it must be positive"
    )


def test_files_that_cannot_be_read_are_errors_of_the_system(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"no such file: .*missing\.toml") as missing:
        tm.read(tmp_path / "missing.toml")
    assert (missing.value.errno, missing.value.filename) == (2, str(tmp_path / "missing.toml"))
    with pytest.raises(IsADirectoryError):
        tm.read(tmp_path)
    binary = tmp_path / "binary.toml"
    binary.write_bytes(b"\x00\xff\x00")
    with pytest.raises(tm.TowerError, match="not a text file") as caught:
        tm.read(binary)
    assert caught.value.path == str(binary)


def test_a_blade_is_no_tower(tmp_path: Path) -> None:
    deck = Path("examples/nrel-5mw.bmi").read_text(encoding="utf-8").splitlines()
    deck = [re.sub("^2( +beam_type)", r"1\1", line) for line in deck]
    (tmp_path / "blade.bmi").write_text("\n".join(deck), encoding="utf-8")
    shutil.copy("examples/nrel-5mw_sections.dat", tmp_path)
    with pytest.raises(ValueError, match="rotating blade"):
        tm.read(tmp_path / "blade.bmi")


def test_a_tower_that_buckles_is_a_solve_error() -> None:
    tower = tm.read(INPUTS / "buckling.toml")
    with pytest.raises(tm.SolveError, match="the tower buckles under gravity") as caught:
        tower.solve()
    assert caught.value.hint is not None
    assert "reduce the mass" in caught.value.hint
    assert isinstance(caught.value, ArithmeticError)
    assert not isinstance(caught.value, ValueError)


@pytest.mark.parametrize(
    ("options", "kind", "message"),
    [
        ({"modes": 0}, ValueError, "modes is 0; it must be at least 1"),
        ({"modes": -3}, ValueError, "modes is -3; it must be at least 1"),
        ({"modes": 2.5}, TypeError, "modes is 2.5; it must be a whole number"),
        ({"modes": "four"}, ValueError, "`four` is not the name of a mode"),
        ({"modes": 50, "segments": 2}, tm.OptionError, "50 modes are requested"),
        ({"segments": 10**7}, tm.OptionError, "the number of segments is 10000000"),
        ({"points": 1}, ValueError, "points is 1; it must be at least 2"),
        ({"heights_m": [10.0, 90.0]}, ValueError, "heights_m has 90 m; the tower reaches from 0 m"),
        ({"heights_m": [float("nan")]}, ValueError, "heights_m has nan m"),
        ({"heights_m": ["top"]}, TypeError, "a height is 'top'; it must be a number"),
        ({"method": 3}, TypeError, "method is 3; it must be a text"),
        ({"method": "fem"}, ValueError, "'fem' is not a method; the methods are rmje-exact"),
        ({"degree": 5}, ValueError, "degree applies only to the method spectral"),
        ({"hinge_position": 0.2}, ValueError, "hinge_position applies only"),
        ({"method": "cardanic", "hinge_position": 0.7}, tm.OptionError, "the hinge position is"),
        ({"method": "spectral", "degree": 99}, tm.OptionError, "the polynomial degree is 99"),
    ],
)
def test_impossible_options_say_what_would_be_right(
    nrel: tm.Tower, options: dict[str, object], kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        nrel.solve(**options)  # type: ignore[arg-type]


def test_errors_survive_a_pickle() -> None:
    errors: list[tm.TowerError | tm.SolveError] = [
        tm.TowerError("m", "p", "h", [(1, 2, "a", "b")]),
        tm.SolveError("m", "h"),
        tm.OptionError("m"),
    ]
    for error in errors:
        again = pickle.loads(pickle.dumps(error))
        assert (type(again), str(again)) == (type(error), str(error))
        assert again.__dict__.keys() == error.__dict__.keys()
        assert again.hint == error.hint
    assert pickle.loads(pickle.dumps(errors[0])).column == 2


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda tower: tower.campbell(rpm=(6.9, 9.0, 12.1)), "must be one speed or"),
        (lambda tower: tower.campbell(rpm="fast"), "rpm is 'fast'; it must be one speed or"),
        (lambda tower: tower.campbell(margin="5 %"), "margin is '5 %'; it must be a number"),
        (lambda tower: tower.with_({"rna.mass": "heavy"}), "rna.mass is 'heavy'; it must be a"),
        (lambda tower: tower.with_([("rna.mass", 1.0)]), "it must be a dict of names and values"),
        (lambda tower: tower.check("other.toml"), "other is 'other.toml'; it must be a Tower"),
        (lambda _: READ("examples/nrel-5mw.toml", part=1), "part is 1; it must be a text"),
    ],
)
def test_arguments_of_a_wrong_kind_are_named(
    nrel: tm.Tower, call: Callable[[Any], object], message: str
) -> None:
    with pytest.raises((TypeError, ValueError), match=message):
        call(nrel)
