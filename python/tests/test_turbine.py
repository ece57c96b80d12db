"""Turbines with turning rotors."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest
from conftest import ROOT
from test_solution import program

import towermodes as tm


@pytest.fixture(scope="module")
def turbine() -> tm.Turbine:
    made = tm.read(ROOT / "examples/nrel-5mw-turbine.toml").turbine
    assert made is not None
    return made


def test_modes_are_between_their_bounds(turbine: tm.Turbine) -> None:
    for rpm in (0.0, 12.1):
        modes = turbine.modes(rpm, 2.0)
        assert modes.certified
        assert modes.rotor_speed_rpm == pytest.approx(rpm, rel=1e-15)
        assert modes.negative_energy == (0, 0)
        assert modes.frequency_hz.shape == (len(modes),)
        assert np.all(np.diff(modes.frequency_hz) > 0)
        assert modes.frequency_hz.max() <= modes.limit_hz == 2.0
        lower, upper = modes.bounds_hz.T
        assert np.all((lower <= modes.frequency_hz) & (modes.frequency_hz <= upper))
        assert np.all(upper - lower < 1e-8)
        assert np.all(modes.error_hz < 1e-4)
        assert sum(modes.energy.values()) == pytest.approx(np.ones(len(modes)), abs=1e-12)
        assert not modes.frequency_hz.flags.writeable


def test_rotation_splits_the_flapwise_pair(turbine: tm.Turbine) -> None:
    """At standstill a pair at 0.63 and 0.67 Hz; the backward whirl is about the rotor speed lower.

    Flapwise modes in the turning frame are stiffer at speed, so it falls by less than 12.1/60 Hz.
    """
    rest, speed = turbine.modes(0.0, 1.0), turbine.modes(12.1, 1.0)
    ways = [f"1st flapwise {way} whirl" for way in ("backward", "forward")]
    pair = [rest.frequency_hz[rest.names.index(name)] for name in ways]
    assert [rest.nodding[rest.names.index(name)] for name in ways] == ["yaw", "tilt"]
    backward = speed.frequency_hz[speed.names.index("1st flapwise backward whirl")]
    fall = np.mean(pair) - backward
    assert 0.5 * 12.1 / 60 < fall < 12.1 / 60


def test_names_are_those_of_each_speed(turbine: tm.Turbine) -> None:
    """Each name is that of one mode at a speed, in the diagram and in the modes at this speed."""
    speeds = [0.0, 6.9, 12.1]
    campbell = turbine.campbell(speeds, limit_hz=1.0)
    for rpm in speeds:
        column = int(np.argmin(np.abs(campbell.rpm - rpm)))
        modes = turbine.modes(rpm, 1.0)
        hz, names = campbell.frequency_hz[:, column], [row[column] for row in campbell.names_at]
        shown = {n: f for n, f in zip(names, hz, strict=True) if n is not None and f <= 1.0}
        assert sorted(shown) == sorted(modes.names)
        assert [shown[name] for name in modes.names] == pytest.approx(modes.frequency_hz, rel=1e-9)
        assert modes.share.shape == (len(modes),)


def test_a_limit_below_cuts_the_list(turbine: tm.Turbine) -> None:
    all_modes, lower = turbine.modes(9.0, 2.0), turbine.modes(9.0, 1.0)
    count = int(np.sum(all_modes.frequency_hz <= 1.0))
    assert len(lower) == count
    assert lower.frequency_hz == pytest.approx(all_modes.frequency_hz[:count], rel=1e-9)


def test_copies_and_pickles_compute_the_same(turbine: tm.Turbine) -> None:
    again = pickle.loads(pickle.dumps(turbine))
    assert again == turbine == copy.deepcopy(turbine)
    assert hash(again) == hash(turbine)
    modes = turbine.modes(12.1, 1.0)
    restored = pickle.loads(pickle.dumps(modes))
    assert np.array_equal(restored.frequency_hz, modes.frequency_hz)
    assert restored.turbine == turbine
    assert again.tower.turbine == turbine


def test_curves_are_the_modes_at_each_speed(turbine: tm.Turbine) -> None:
    campbell = turbine.campbell(np.linspace(0.0, 12.1, 5), limit_hz=1.0)
    assert campbell.certified and campbell.certified_at.all()
    assert campbell.frequency_hz.shape == (len(campbell.names), len(campbell.rpm))
    assert set(np.linspace(0.0, 12.1, 5)) <= set(campbell.rpm)
    assert 6.9 in campbell.rpm
    for rpm in (0.0, 6.9, 12.1):
        column = campbell.frequency_hz[:, list(campbell.rpm).index(rpm)]
        below = np.sort(column[column <= 1.0])
        assert below == pytest.approx(turbine.modes(rpm, 1.0).frequency_hz, rel=1e-8)
    is_there = np.isfinite(campbell.frequency_hz)
    assert np.all((campbell.lower_hz <= campbell.upper_hz)[is_there])
    total = sum(campbell.energy.values())[is_there]  # type: ignore[index]
    assert total == pytest.approx(np.ones(is_there.sum()), abs=1e-12)
    for index, partner in enumerate(campbell.partners):
        assert partner is None or campbell.partners[partner] == index


def test_a_diagram_is_that_of_the_program(turbine: tm.Turbine) -> None:
    campbell = turbine.campbell(limit_hz=1.0)
    given = ["campbell", "examples/nrel-5mw-turbine.toml", "--limit", "1"]
    assert campbell.to_csv() == program(*given, "--format", "csv")
    assert campbell.verdict == campbell.data["verdict"]
    assert campbell.margins[0]["multiple"] == 1
    assert campbell.conclusion in " ".join(repr(campbell).split())
    assert campbell.plot().startswith("<svg")
    table = campbell.to_dict()
    count = int(np.isfinite(campbell.frequency_hz).sum())
    assert all(len(column) == count for column in table.values())  # type: ignore[arg-type]
    again = pickle.loads(pickle.dumps(campbell))
    assert again.to_csv() == campbell.to_csv()
    assert again.turbine == turbine


def test_impossible_diagrams_are_refused(turbine: tm.Turbine) -> None:
    with pytest.raises(ValueError, match="a rotor speed is -1 rpm"):
        turbine.campbell([-1.0, 12.1])
    with pytest.raises(ValueError, match=r"operating_rpm is \(7.0,\)"):
        turbine.campbell(operating_rpm=(7.0,))
    with pytest.raises(TypeError, match="rpm"):
        turbine.campbell(["fast"])


def test_a_table_has_a_row_for_each_mode(turbine: tm.Turbine) -> None:
    modes = turbine.modes(12.1, 1.0)
    table = modes.to_dict()
    assert list(table)[:3] == ["name", "share", "frequency_hz"]
    assert all(len(column) == len(modes) for column in table.values())  # type: ignore[arg-type]
    lines = repr(modes).splitlines()
    assert len(lines) == len(modes) + 2
    assert "1st flapwise collective" in repr(modes)


def test_towers_without_a_turbine_say_why(nrel: tm.Tower, turbine: tm.Turbine) -> None:
    assert nrel.turbine is None
    assert nrel.turbine_missing == "the tower has no turbine with flexible blades"
    assert turbine.tower.turbine_missing is None
    heavier = turbine.tower.with_({"rna.mass": 4e5})
    assert heavier.turbine is None
    assert "rotor-nacelle assembly is changed" in str(heavier.turbine_missing)


def test_impossible_speeds_and_limits_are_refused(turbine: tm.Turbine) -> None:
    with pytest.raises(ValueError, match="rpm"):
        turbine.modes(float("nan"), 1.0)
    with pytest.raises(ValueError, match="the limit of the frequencies is -1 Hz"):
        turbine.modes(12.1, -1.0)
    with pytest.raises(TypeError, match="rpm"):
        turbine.modes("fast", 1.0)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="made by Tower"):
        tm.Turbine()
