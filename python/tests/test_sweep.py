"""Sweeps: results of single solves, tables of all kinds, failures, threads, signals."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import Ticking

import towermodes as tm

MASSES = np.linspace(300e3, 400e3, 7)
FACTORS = np.linspace(0.95, 1.05, 7)
TABLE = {"rna.mass": MASSES, "scale(stations[*].wall)": FACTORS}


def test_each_row_is_a_solve(nrel: tm.Tower) -> None:
    result = nrel.sweep(TABLE, modes=4)
    assert result.names == nrel.solve(modes=4, segments=20).names
    assert result.frequency_hz.shape == (7, 4)
    assert result.frequency_hz.dtype == np.float64
    assert (result.error_hz.shape, result.mass_kg.shape) == ((7, 4), (7,))
    assert result.certified.tolist() == [True] * 7
    assert len(result) == 7
    for row, (mass, factor) in enumerate(zip(MASSES, FACTORS, strict=True)):
        tower = nrel.with_({"rna.mass": mass, "scale(stations[*].wall)": factor})
        solution = tower.solve(modes=4, segments=20)
        assert result.mass_kg[row] == tower.mass_kg
        for family, order in result.names:
            mode = solution.mode(family, order)
            # A row starts from the modes of the base, a solve does not.
            hz = mode.extrapolated_hz
            assert result.mode(family, order)[row] == pytest.approx(hz, rel=1e-13)
            error_hz = result.error_of(family, order)[row]
            assert error_hz == pytest.approx(mode.error_hz, rel=0.0, abs=1e-13 * hz)
    assert result.inputs["rna.mass"].tolist() == MASSES.tolist()
    with pytest.raises(KeyError, match="no mode axial 1 among the modes of the sweep"):
        result.mode("axial", 1)


def test_results_do_not_depend_on_the_number_of_threads(nrel: tm.Tower) -> None:
    table = {"rna.mass": np.linspace(3e5, 4e5, 300)}
    one = nrel.sweep(table, threads=1)
    for threads in (2, 3, None):
        assert (nrel.sweep(table, threads=threads).frequency_hz == one.frequency_hz).all()


def test_some_rows_keep_their_numbers(nrel: tm.Tower, tmp_path: Path) -> None:
    pyarrow = pytest.importorskip("pyarrow")
    masses = [3e5, -1.0, 3.2e5, -1.0, 3.4e5]
    path = tmp_path / "towers.csv"
    path.write_text("rna.mass\n" + "\n".join(map(str, masses)) + "\n")
    whole = nrel.sweep({"rna.mass": masses}, modes=1)
    study = {"sweep": {"sampling": "grid", "vary": {"rna.mass": {"values": masses}}}}
    for table in ({"rna.mass": masses}, path, study):
        some = nrel.sweep(table, modes=1, rows=range(2, 4))
        assert (some.first_row, len(some)) == (2, 2)
        assert some.frequency_hz[0, 0] == whole.frequency_hz[2, 0]
        assert some.failures == [whole.failures[1]]
        assert some.to_dict()["row"].tolist() == [2, 3]
        assert some.to_dict()["error"] == whole.to_dict()["error"][2:4]
        arrow = pyarrow.table(some).to_pydict()
        assert (arrow["row"], arrow["error"]) == ([2, 3], some.to_dict()["error"])
        assert some.inputs["rna.mass"].tolist() == masses[2:4]
        # A range may end behind the last row.
        assert len(nrel.sweep(table, modes=1, rows=range(4, 100))) == 1
        with pytest.raises(ValueError, match="the sweep has 5 rows, numbered from 0"):
            nrel.sweep(table, modes=1, rows=range(5, 6))
    copy = pickle.loads(pickle.dumps(some))
    assert (copy.first_row, copy.to_dict()["row"].tolist()) == (2, [2, 3])
    for wrong in (range(3, 3), range(0, 4, 2), range(-1, 2)):
        with pytest.raises(ValueError, match="must be successive rows from 0"):
            nrel.sweep(study, rows=wrong)
    with pytest.raises(TypeError, match="must be a range"):
        nrel.sweep(study, rows=3)  # type: ignore[arg-type]


def test_modes_are_taken_by_name(nrel: tm.Tower) -> None:
    result = nrel.sweep(TABLE, modes=[("fore-aft", 2), "torsion 1"])
    assert result.names == [("fore-aft", 2), ("torsion", 1)]
    same = nrel.sweep(TABLE, modes="torsion 1")
    # The last bit of a frequency may depend on the number of modes that are computed.
    assert same.mode("torsion", 1) == pytest.approx(result.mode("torsion", 1), rel=1e-15)
    fine = nrel.sweep({"rna.mass": [350e3]}, modes=1, segments=60, method="cardanic-exact")
    solved = nrel.solve(modes=1, segments=60, method="cardanic-exact")
    assert fine.frequency_hz[0, 0] == pytest.approx(solved.extrapolated_hz[0], rel=1e-13)
    with pytest.raises(ValueError, match="sideways"):
        nrel.sweep(TABLE, modes=["sideways 1"])


@pytest.mark.parametrize(
    ("modes", "kind", "message"),
    [
        (("fore-aft", 1), TypeError, r"one mode; give a list of modes: \[\('fore-aft', 1\)\]"),
        (2.0, TypeError, "modes is 2.0; it must be a whole number or a list of names"),
        ([("fore-aft",)], TypeError, r"\('fore-aft',\) is not the name of a mode"),
        ([("fore-aft", 0)], ValueError, "the order of a mode is 0; it must be at least 1"),
        ([("fore-aff", 1)], ValueError, "did you mean 'fore-aft'"),
        ([], ValueError, "modes is empty"),
        (10**30, ValueError, "modes is 10+; it must be at most"),
    ],
)
def test_wrong_modes_say_what_is_wrong(
    nrel: tm.Tower, modes: Any, kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        nrel.sweep(TABLE, modes=modes)


def test_a_row_that_fails_is_a_row_with_its_sentence(nrel: tm.Tower) -> None:
    result = nrel.sweep({"stations[0].wall": [0.03, -1.0, float("nan")]}, modes=2)
    assert [row for row, _ in result.failures] == [1, 2]
    assert "stations[0].wall: wall thickness is -1 m; it must be positive" in result.failures[0][1]
    assert np.isnan(result.frequency_hz[1:]).all()
    assert np.isfinite(result.frequency_hz[0]).all()
    assert result.certified.tolist() == [True, False, False]
    assert "3 towers, 2 failed" in repr(result)
    assert "row 1: stations[0].wall: " in repr(result)


def test_failures_are_a_list(nrel: tm.Tower) -> None:
    masses = np.where(np.arange(400) % 3 == 1, -1.0 - np.arange(400), 350e3)
    failures = nrel.sweep({"rna.mass": masses}, modes=1, threads=3).failures
    expected = [
        (row, f"rna.mass: the mass is -{row + 1} kg; it must not be negative")
        for row in range(1, 400, 3)
    ]
    assert failures == expected
    assert failures != expected[1:]
    assert (failures[-1], failures[2:5]) == (expected[-1], expected[2:5])
    assert failures == nrel.sweep({"rna.mass": masses}, modes=1, threads=1).failures
    assert pickle.loads(pickle.dumps(failures)) == expected
    assert expected[4] in failures
    assert repr(failures[:2]) == repr(expected[:2])
    assert repr(failures).endswith("... 123 more]")
    with pytest.raises(IndexError):
        failures[133]


def test_unusual_input_is_a_warning(nrel: tm.Tower) -> None:
    result = nrel.sweep({"material.density": [7.85, 8500.0]}, modes=1)
    assert result.failures == []
    ((row, message),) = result.warnings
    assert row == 0
    assert "material.density" in message
    assert "7.85" in message
    assert f"warning: row 0: {message}" in repr(result)
    many = nrel.sweep({"material.density": [7.85] * 200}, modes=1, threads=2)
    assert many.warned_rows == 200
    assert [row for row, _ in many.warnings] == [0, 1, 2, 3, 4]
    assert "and 197 more rows with unusual input" in repr(many)
    # What is unusual about the tower itself is told by the tower.
    light = nrel.with_({"material.density": 7.85})
    assert light.warnings
    assert light.sweep({"rna.mass": [3e5]}, modes=1).warned_rows == 0


def test_a_buffer_that_is_used_again_does_not_change_results(nrel: tm.Tower) -> None:
    buffer = np.array([3e5, 4e5])
    result = nrel.sweep({"rna.mass": buffer}, modes=1)
    buffer[:] = 0.0
    assert result.inputs["rna.mass"].tolist() == [3e5, 4e5]
    with pytest.raises(ValueError, match="read-only"):
        result.inputs["rna.mass"][0] = 1.0
    strided = np.array([[3e5, 0.0], [4e5, 0.0]], dtype=np.float32)[:, 0]
    assert (nrel.sweep({"rna.mass": strided}, modes=1).frequency_hz == result.frequency_hz).all()


def test_columns_of_the_table_of_results(nrel: tm.Tower) -> None:
    result = nrel.sweep({"rna.mass": [3e5, -1.0]}, modes=1)
    columns = result.to_dict()
    assert list(columns) == [
        "row", "rna.mass", "mass_kg", "certified", "side_side_1_hz", "side_side_1_error_hz",
        "side_side_1_share", "error",
    ]  # fmt: skip
    assert columns["row"].tolist() == [0, 1]
    assert columns["error"] == [None, result.failures[0][1]]
    with pytest.raises(TypeError, match=r"take result\.frequency_hz"):
        np.asarray(result)


WRONG_COLUMNS = {
    "booleans": [True, False],
    "complex numbers": np.array([3e5 + 1j]),
    "dates": np.array(["2026-01-01"], dtype="datetime64[D]"),
    "time differences": np.array([3], dtype="timedelta64[s]"),
    "texts": ["3e5"],
    "has '3e5'": np.array([3e5, "3e5"], dtype=object),
    "1 of them are masked": np.ma.masked_array([3e5, 4e5], mask=[True, False]),
}


@pytest.mark.parametrize("what", WRONG_COLUMNS)
def test_columns_that_are_no_numbers_are_refused(nrel: tm.Tower, what: str) -> None:
    column = WRONG_COLUMNS[what]
    with pytest.raises(TypeError, match=f"column rna.mass must hold numbers.*{what}"):
        nrel.sweep({"rna.mass": column})
    pandas = pytest.importorskip("pandas")
    if not isinstance(column, np.ma.MaskedArray):
        with pytest.raises(TypeError, match="column rna.mass must hold numbers"):
            nrel.sweep(pandas.DataFrame({"rna.mass": column}))


def test_columns_of_many_types_of_numbers(nrel: tm.Tower) -> None:
    expected = nrel.sweep({"rna.mass": [300_000.0]}, modes=1).frequency_hz
    from decimal import Decimal

    for column in (
        np.float32(300_000.0),
        np.int64(300_000),
        np.array(300_000),
        [Decimal(300_000)],
        np.ma.masked_array([3e5], mask=[False]),
    ):
        assert (nrel.sweep({"rna.mass": column}, modes=1).frequency_hz == expected).all()
    missing = nrel.sweep({"rna.mass": [300_000.0, None]}, modes=1)
    assert [row for row, _ in missing.failures] == [1]
    with pytest.raises(OverflowError, match="column rna.mass has a number"):
        nrel.sweep({"rna.mass": [10**400]})


def test_numbers_stand_for_columns(nrel: tm.Tower) -> None:
    result = nrel.sweep({"rna.mass": MASSES, "material.density": 8400})
    assert (result.inputs["material.density"] == 8400.0).all()
    assert len(nrel.sweep({"rna.mass": 350e3})) == 1


@pytest.mark.parametrize(
    ("table", "kind", "message"),
    [
        ({"rna.mas": [1.0]}, ValueError, "did you mean `rna.mass`"),
        (
            {"rna.mass": [1.0, 2.0], "material.density": [1.0]},
            ValueError,
            "column rna.mass has 2 rows, but column material.density has 1",
        ),
        ({"rna.mass": ["heavy"]}, TypeError, "column rna.mass must hold numbers"),
        ({"rna.mass": [[1.0]]}, ValueError, "column rna.mass has 2 dimensions"),
        ({}, ValueError, "nothing is varied"),
        (3.0, TypeError, "the table is a float; it must be a dict"),
    ],
)
def test_wrong_tables_say_what_is_wrong(
    nrel: tm.Tower, table: Any, kind: type[Exception], message: str
) -> None:
    with pytest.raises(kind, match=message):
        nrel.sweep(table)


def test_tables_of_pandas(nrel: tm.Tower) -> None:
    pandas = pytest.importorskip("pandas")
    expected = nrel.sweep(TABLE)
    frame = pandas.DataFrame(TABLE, index=[f"t{n}" for n in range(7)])
    result = nrel.sweep(frame)
    assert (result.frequency_hz == expected.frequency_hz).all()
    back = pandas.DataFrame(result.to_dict())
    assert (back["fore_aft_1_hz"] == expected.mode("fore-aft", 1)).all()
    with pytest.raises(TypeError, match="column name must hold numbers"):
        nrel.sweep(frame.assign(name="x"))


def test_tables_of_arrow(nrel: tm.Tower) -> None:
    pyarrow = pytest.importorskip("pyarrow")
    expected = nrel.sweep(TABLE)
    table = pyarrow.table({name: pyarrow.array(values) for name, values in TABLE.items()})
    assert (nrel.sweep(table).frequency_hz == expected.frequency_hz).all()
    whole = pyarrow.table({"rna.mass": pyarrow.chunked_array([[300_000], [None, 400_000]])})
    result = nrel.sweep(whole)
    assert [row for row, _ in result.failures] == [1]
    back = pyarrow.table(result)
    assert back.column_names[:3] == ["row", "rna.mass", "mass_kg"]
    assert back["row"].to_pylist() == [0, 1, 2]
    assert back["rna.mass"].null_count == back["fore_aft_1_hz"].null_count == 1
    assert back["fore_aft_1_hz"].to_pylist()[2] == result.mode("fore-aft", 1)[2]
    assert back["error"].to_pylist()[1] == result.failures[0][1]
    with pytest.raises(TypeError, match="column name holds Utf8, but must hold numbers"):
        nrel.sweep(pyarrow.table({"name": ["a"]}))
    # A stream is read once.
    capsule = table.__arrow_c_stream__()
    from towermodes import _towermodes as core

    def every(names: list[str]) -> list[int]:
        return list(range(len(names)))

    assert len(core.columns_of_stream(capsule, every)) == 2
    with pytest.raises(ValueError, match="cannot be read"):
        core.columns_of_stream(capsule, every)


def test_tables_of_polars(nrel: tm.Tower) -> None:
    polars = pytest.importorskip("polars")
    expected = nrel.sweep(TABLE)
    result = nrel.sweep(polars.DataFrame(TABLE))
    assert (result.frequency_hz == expected.frequency_hz).all()
    back = polars.DataFrame(result)
    assert back.height == 7
    assert back["fore_aft_1_hz"].to_numpy().tolist() == expected.mode("fore-aft", 1).tolist()


def test_results_cannot_be_overwritten(nrel: tm.Tower) -> None:
    with pytest.raises(ValueError, match="read-only"):
        nrel.sweep(TABLE).frequency_hz[0, 0] = 0.0


def test_many_rows_are_many_results(nrel: tm.Tower) -> None:
    rows = 2000
    result = nrel.sweep({"rna.mass": np.linspace(3e5, 4e5, rows)}, modes=1)
    assert len(result) == rows
    frequencies = result.frequency_hz[:, 0]
    assert (np.diff(frequencies) < 0.0).all()


def sweep_first(tower: tm.Tower) -> list[float]:
    result = tower.sweep({"rna.mass": np.linspace(3e5, 4e5, 200)}, threads=2)
    values: list[float] = result.mode("fore-aft", 1).tolist()
    return values


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_children_of_a_fork_sweep_after_a_threaded_sweep(nrel: tm.Tower) -> None:
    expected = sweep_first(nrel)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map(sweep_first, [nrel] * 4) == [expected] * 4


def test_other_threads_run_during_a_sweep(nrel: tm.Tower) -> None:
    with Ticking() as other:
        nrel.sweep({"rna.mass": np.linspace(3e5, 4e5, 3000)}, threads=1)
    assert other.ticks > 5


LONG_SWEEP = """
import numpy, towermodes as tm
tower = tm.read("examples/nrel-5mw.toml")
table = {"rna.mass": numpy.linspace(3e5, 4e5, 5_000_000)}
print("begin", flush=True)
try:
    tower.sweep(table, threads=THREADS)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("threads", [1, 2])
def test_ctrl_c_ends_a_sweep(threads: int) -> None:
    code = LONG_SWEEP.replace("THREADS", str(threads))
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "begin\n"
        time.sleep(1.0)
        child.send_signal(signal.SIGINT)
        assert child.stdout.readline() == "interrupted\n"
        assert child.wait(timeout=60) == 0


def test_rows_in_which_modes_share_a_motion_are_named() -> None:
    tower = tm.read("examples/nrel-5mw.toml")
    factors = [0.9, 0.63, 0.629, 0.628]
    result = tower.sweep({"scale(rna.inertia.zz)": factors}, modes=["side-side 2", "torsion 1"])
    share = result.share_of("side-side 2")
    assert share[0] > 0.99 and share.min() < 0.6
    assert result.shared_rows == int((result.share < 0.6).any(axis=1).sum())
    assert " are coupled in modes 3 and 4: " in result.shared[0][1]
    assert result.mode("side-side", 2).max() < 1.98
    assert result.to_dict()["torsion_1_share"].tolist() == result.share[:, 1].tolist()
