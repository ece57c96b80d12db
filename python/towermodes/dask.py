"""Sweeps on the workers of Dask: on this machine, or on a cluster.

This module needs `distributed`: `pip install ".[dask]"` in the root of the repository.
"""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, SupportsIndex

from distributed import Client, Future, as_completed

from towermodes import _towermodes as _rust
from towermodes._read import read
from towermodes._sweep import sweep_options
from towermodes._tower import Tower

if TYPE_CHECKING:
    from towermodes._tower import Method

#: Number of times that missing parts are computed, for folders that users have touched.
ROUNDS = 3


class Outcome(NamedTuple):
    """What a sweep has done."""

    folder: Path
    """The folder of the results, complete."""
    rows: int
    """Number of towers in the folder."""
    computed_rows: int
    """Number of towers that this call computed, with failed ones; others were there before."""
    failed_rows: int
    """Number of failed towers in the folder, whoever computed them; the column `error` has the
    reason."""


def sweep(
    client: Client,
    tower: Tower | str | os.PathLike[str],
    table: str | os.PathLike[str] | None = None,
    *,
    output: str | os.PathLike[str],
    modes: SupportsIndex | Sequence[tuple[str, int] | str] | None = None,
    segments: SupportsIndex | None = None,
    method: Method | None = None,
    rotary_inertia: bool = True,
    format: Literal["parquet", "csv"] = "parquet",
    rows_per_part: int | None = None,
    inputs: bool = True,
    ignore: Sequence[str] = (),
    force: bool = False,
    retries: int = 3,
    progress: Callable[[int, int], object] | None = None,
) -> Outcome:
    """Changes a tower by each row of a table and solves it, on the workers of Dask.

    The results are the folder that `towermodes sweep` writes, with the same bytes: parts (files)
    of a fixed number of rows, each written completely or not at all. The same call again solves the
    parts that are missing, also after the client, workers or the whole cluster were killed; the
    program and Dask can continue each other's work. `_SUCCESS` is written when all parts are
    complete.

    A task of Dask is one part and uses one thread. A worker with n threads solves n parts at a
    time, so give workers as many threads as they have processors.

    Args:
        client: The client of the cluster. Its workers must see table and output under the same
            paths as this process, and have the same version of this package.
        tower: The tower, or a file that `towermodes.read` reads. Without a table the file of a
            study, which names the tower and where the values come from; the arguments below have
            priority over the study.
        table: A table in Parquet or CSV whose columns are names of changes, as in `Tower.sweep`.
        output: The folder of the results.
        modes: As in `Tower.sweep`.
        segments: As in `Tower.sweep`.
        method: As in `Tower.sweep`.
        rotary_inertia: As in `Tower.sweep`.
        format: The format of the parts.
        rows_per_part: Number of rows of a part; 16 384 by default, about a second of work.
        inputs: Whether the columns of the table are columns of the results.
        ignore: Columns of the table that are not numbers of the tower.
        force: Removes results that are in the folder first, also those of another sweep.
        retries: Number of retries of a part that failed on a worker.
        progress: Called after each part with the number of rows in the folder and of all rows.

    Raises:
        ValueError: The table or the study has mistakes (`TowerError` with the line), or the folder
            has the results of another sweep.
        OSError: A file cannot be read or written.
        RuntimeError: The workers see another table or study, or have another version of this package.

    >>> import tempfile, pathlib
    >>> import polars as pl
    >>> from distributed import Client
    >>> import towermodes.dask
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> table = pl.DataFrame({"rna.mass": [340e3, 350e3, 360e3]})
    >>> table.write_parquet(folder / "towers.parquet", compression="snappy")
    >>> with Client(processes=False, dashboard_address=None) as client:
    ...     outcome = towermodes.dask.sweep(
    ...         client,
    ...         "examples/nrel-5mw.toml",
    ...         folder / "towers.parquet",
    ...         output=folder / "results",
    ...     )
    >>> outcome.rows, outcome.failed_rows
    (3, 0)
    >>> pl.read_parquet(outcome.folder / "part-*.parquet")["fore_aft_1_hz"].round(4).to_list()
    [0.3255, 0.3215, 0.3176]
    """
    if client.asynchronous:
        message = "the client is asynchronous; call this function with a Client(asynchronous=False)"
        raise TypeError(message)
    base, values = _values(tower, table)
    order = _Order(
        base,
        values,
        os.path.abspath(output),
        sweep_options(modes, segments, method, rotary_inertia, 1),
        {
            "format": format,
            "rows_per_part": rows_per_part,
            "force": force,
            "inputs": inputs,
            "ignore": list(ignore),
        },
    )
    folder = order.open()
    order = order.for_workers(folder.key)
    computed_rows, failed = 0, dict[int, int]()
    for _ in range(ROUNDS):
        missing = folder.missing()
        there = folder.rows - sum(len(range(*folder.rows_of(part))) for part in missing)
        for part, rows, failures in _done(client, _solve_part, order, missing, retries):
            there += rows
            computed_rows += rows
            failed[part] = failures
            if progress is not None:
                progress(there, folder.rows)
        if folder.finish():
            before = [part for part in range(folder.count) if part not in failed]
            for part, _, failures in _done(client, _count_part, order, before, retries):
                failed[part] = failures
            return Outcome(Path(order.folder), folder.rows, computed_rows, sum(failed.values()))
    message = f"{order.folder} still misses parts {folder.missing()[:5]} after {ROUNDS} rounds; \
do the workers write to the folder that this process sees?"
    raise OSError(message)


def _values(
    tower: Tower | str | os.PathLike[str], table: str | os.PathLike[str] | None
) -> tuple[Tower | None, str]:
    """The tower and its table; without a tower a study."""
    if table is not None:
        base = tower if isinstance(tower, Tower) else read(tower)
        return base, os.path.abspath(table)
    if isinstance(tower, Tower):
        message = "the table of values is missing; without one, give the file of a study"
        raise TypeError(message)
    return None, os.path.abspath(tower)


@dataclass(frozen=True)
class _Order:
    """All that a worker needs. Orders with the same key write the same parts."""

    tower: Tower | None = field(compare=False)
    values: str = field(compare=False)
    folder: str
    results: dict[str, object] = field(compare=False)
    parts: dict[str, object] = field(compare=False)
    key: str = ""

    def open(self) -> _rust.SweepFolder:
        core = None if self.tower is None else self.tower._core
        return _rust.SweepFolder(core, self.values, self.folder, self.results, self.parts)

    def for_workers(self, key: str) -> _Order:
        """The order with the key that workers must find; they remove nothing."""
        parts = {**self.parts, "force": False}
        return _Order(self.tower, self.values, self.folder, self.results, parts, key)


def _done(
    client: Client, task: Callable[..., object], order: _Order, parts: list[int], retries: int
) -> Any:
    """Number, rows and failed rows of each part as soon as its task is done."""
    # Not pure: a part that was solved before and is missing again is solved again.
    futures: list[Future] = client.map(
        task, parts, order=order, pure=False, retries=retries, key="towermodes-part"
    )
    try:
        for future in as_completed(futures):
            yield future.result()
    finally:
        client.cancel(futures)


def _solve_part(part: int, order: _Order) -> tuple[int, int, int]:
    """On a worker: solves a part and writes it; its rows and how many of them have failed."""
    return part, *_opened(order).solve(part, 1)


def _count_part(part: int, order: _Order) -> tuple[int, int, int]:
    """On a worker: how many rows have failed of a part that was there before."""
    folder = _opened(order)
    return part, len(range(*folder.rows_of(part))), folder.failures_of(part)


@functools.lru_cache(maxsize=4)
def _opened(order: _Order) -> _rust.SweepFolder:
    """The folder on this worker; the table is read through once, not for each part."""
    folder = order.open()
    if folder.key != order.key:
        message = f"this worker would compute other results than the client: is {order.values} \
the same file, and has it the same version of towermodes?"
        raise RuntimeError(message)
    return folder
