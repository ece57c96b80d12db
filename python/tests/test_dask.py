"""Sweeps by Dask: the parts of the program, each row once, whoever is killed."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pytest

import towermodes as tm

# Without types.
distributed: Any = pytest.importorskip("distributed")
dask: Any = pytest.importorskip("towermodes.dask")

# Dask closes sockets and threads when it likes, and warns when a port is taken.
pytestmark = pytest.mark.filterwarnings("default")

ROWS = 1 << 15
ROWS_PER_PART = 1 << 10
PARTS = ROWS // ROWS_PER_PART
NAMES = ["rna.mass", "scale(stations[*].wall)"]
LOCAL: dict[str, Any] = {"dashboard_address": None, "threads_per_worker": 1}


@pytest.fixture(scope="module")
def table(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A table with one row that is no tower."""
    masses = np.linspace(330e3, 370e3, ROWS)
    walls = 0.95 + 0.1 * (np.arange(ROWS) * 7919 % ROWS) / ROWS
    walls[ROWS // 2] = -1.0
    path = tmp_path_factory.mktemp("table") / "towers.parquet"
    pl.DataFrame({NAMES[0]: masses, NAMES[1]: walls}).write_parquet(path, compression="snappy")
    return path


@pytest.fixture(scope="module")
def program(table: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder that the program writes."""
    folder = tmp_path_factory.mktemp("program") / "results"
    arguments = ["sweep", "examples/nrel-5mw.toml", str(table), "--output", str(folder)]
    arguments += ["--format", "parquet", "--rows-per-part", str(ROWS_PER_PART), "--modes", "2"]
    subprocess.run([sys.executable, "-m", "towermodes", *arguments], check=True)
    return folder


@pytest.fixture
def cluster() -> Iterator[Any]:
    with distributed.LocalCluster(n_workers=2, processes=True, **LOCAL) as cluster:
        yield cluster


def parts(folder: Path) -> list[Path]:
    return sorted(folder.glob("part-*"))


def check(folder: Path, program: Path) -> None:
    """Every row once, and every part with the bytes of the program's."""
    assert (folder / "_SUCCESS").exists()
    rows = pl.read_parquet(parts(folder))["row"]
    assert rows.to_list() == list(range(ROWS))
    assert [part.name for part in parts(folder)] == [part.name for part in parts(program)]
    for ours, programs in zip(parts(folder), parts(program), strict=True):
        assert ours.read_bytes() == programs.read_bytes(), ours.name
    assert not list(folder.glob(".*")), "what killed workers left is removed"


def run(client: Any, table: Path, folder: Path, **options: object) -> Any:
    return dask.sweep(
        client,
        "examples/nrel-5mw.toml",
        table,
        output=folder,
        modes=2,
        rows_per_part=ROWS_PER_PART,
        **options,
    )


def test_a_killed_worker_loses_no_row(
    cluster: Any, table: Path, program: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "results"
    killed: list[int] = []
    with distributed.Client(cluster) as client:
        pids = list(client.run(os.getpid).values())
        assert os.getpid() not in pids

        def kill(done: int, rows: int) -> None:
            assert 0 < done <= rows == ROWS
            if not killed:
                killed.append(pids[0])
                os.kill(pids[0], signal.SIGKILL)

        outcome = run(client, table, folder, progress=kill)
    assert killed
    # A part that was written and not reported before its worker died is written once more.
    assert outcome.rows == ROWS <= outcome.computed_rows <= ROWS + 2 * ROWS_PER_PART
    assert outcome.failed_rows == 1
    check(folder, program)


def test_a_killed_client_is_started_again(table: Path, program: Path, tmp_path: Path) -> None:
    folder = tmp_path / "results"
    script = f"""
        import distributed
        import towermodes.dask
        if __name__ == "__main__":
            with distributed.LocalCluster(n_workers=2, **{LOCAL!r}) as cluster:
                with distributed.Client(cluster) as client:
                    towermodes.dask.sweep(
                        client, "examples/nrel-5mw.toml", {str(table)!r},
                        output={str(folder)!r}, modes=2, rows_per_part={ROWS_PER_PART},
                    )
    """
    path = tmp_path / "study.py"
    path.write_text(textwrap.dedent(script))
    # A session of its own, so that the signal reaches the client and its workers alone.
    client = subprocess.Popen(
        [sys.executable, str(path)], start_new_session=True, stderr=subprocess.DEVNULL
    )
    end = time.monotonic() + 120.0
    while len(parts(folder)) < 3:
        assert client.poll() is None and time.monotonic() < end, "no parts"
        time.sleep(0.01)
    os.killpg(client.pid, signal.SIGKILL)
    client.wait()
    before = {part.name: part.stat().st_mtime_ns for part in parts(folder)}
    assert len(before) < PARTS and not (folder / "_SUCCESS").exists()

    with distributed.Client(processes=False, **LOCAL) as again:
        outcome = run(again, table, folder)
    assert outcome.computed_rows == ROWS - len(before) * ROWS_PER_PART
    after = {part.name: part.stat().st_mtime_ns for part in parts(folder)}
    assert {name: after[name] for name in before} == before, "parts that were there are kept"
    check(folder, program)


def test_the_program_continues_what_dask_began(table: Path, program: Path, tmp_path: Path) -> None:
    """And the other way round: a complete folder of the program leaves nothing to do."""
    with distributed.Client(processes=False, **LOCAL) as client:
        outcome = run(client, table, program)
    # The row that failed is counted, whoever computed it.
    assert (outcome.rows, outcome.computed_rows, outcome.failed_rows) == (ROWS, 0, 1)


def test_the_frequencies_are_those_of_tower_sweep(
    nrel: tm.Tower, table: Path, program: Path
) -> None:
    result = nrel.sweep(pl.read_parquet(table), modes=2)
    solved = pl.read_parquet(parts(program))
    assert [row for row, _ in result.failures] == [ROWS // 2]
    for family in ("fore-aft", "side-side"):
        ours = solved[f"{family.replace('-', '_')}_1_hz"].to_numpy()
        np.testing.assert_array_equal(result.mode(family, 1), ours)


def test_a_study_is_that_of_the_program(tmp_path: Path) -> None:
    (tmp_path / "tower.toml").write_bytes(Path("examples/nrel-5mw.toml").read_bytes())
    study = tmp_path / "study.toml"
    study.write_text(
        """
        [sweep]
        base = "tower.toml"
        sampling = "sobol"
        rows = 2_000
        seed = 3
        [sweep.vary]
        "rna.mass" = { uniform = [3.3e5, 3.7e5] }
        "material.youngs_modulus" = { normal = [2.1e11, 3e9] }
        [sweep.results]
        modes = ["fore-aft 1", "torsion 1"]
        rows_per_part = 300
        """
    )
    arguments = ["sweep", str(study), "--output", str(tmp_path / "program"), "--format", "parquet"]
    subprocess.run([sys.executable, "-m", "towermodes", *arguments], check=True)
    with distributed.Client(processes=False, **LOCAL) as client:
        outcome = dask.sweep(client, study, output=tmp_path / "dask")
        assert (outcome.rows, outcome.failed_rows) == (2000, 0)
        with pytest.raises(TypeError, match="table"):
            dask.sweep(client, tm.read(tmp_path / "tower.toml"), output=tmp_path / "none")
    names = sorted(path.name for path in (tmp_path / "program").iterdir())
    assert names == sorted(path.name for path in (tmp_path / "dask").iterdir())
    for name in names:
        ours, programs = tmp_path / "dask" / name, tmp_path / "program" / name
        assert ours.read_bytes() == programs.read_bytes(), name


def test_another_sweep_is_refused(table: Path, program: Path) -> None:
    with (
        distributed.Client(processes=False, **LOCAL) as client,
        pytest.raises(ValueError, match="another sweep.*; force=True removes these results$"),
    ):
        run(client, table, program, segments=24)


def test_a_worker_that_reads_another_table_is_found(table: Path, tmp_path: Path) -> None:
    copy = tmp_path / "towers.parquet"
    copy.write_bytes(table.read_bytes())
    order = dask._Order(
        tm.read("examples/nrel-5mw.toml"),
        str(copy),
        str(tmp_path / "results"),
        dask.sweep_options(2, None, None, True, 1),
        {"format": "parquet", "rows_per_part": None, "force": False, "inputs": True, "ignore": []},
    )
    order = order.for_workers(order.open().key)
    pl.read_parquet(table).head(10).write_parquet(copy, compression="snappy")
    with pytest.raises((RuntimeError, ValueError), match="another sweep|other results"):
        dask._solve_part(0, order)


def test_mistakes_of_the_table_are_the_clients(table: Path, tmp_path: Path) -> None:
    wrong = tmp_path / "wrong.csv"
    wrong.write_text("rna.mas\n350e3\n")
    with (
        distributed.Client(processes=False, **LOCAL) as client,
        pytest.raises(ValueError, match=r"rna\.mas.*; ignore=\[\"rna.mas\"\] leaves the column out"),
    ):
        run(client, wrong, tmp_path / "results")
    with (
        distributed.Client(processes=False, **LOCAL) as client,
        pytest.raises(FileNotFoundError, match=r"No such file or directory: .*none\.csv"),
    ):
        run(client, tmp_path / "none.csv", tmp_path / "results")
    assert not (tmp_path / "results").exists()
