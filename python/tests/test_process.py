"""The package in a process: import, threads, forks, signals, the program."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time

import pytest
from conftest import Ticking

import towermodes as tm


def python(code: str, *, check: bool = True) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", code]
    return subprocess.run(command, capture_output=True, text=True, check=check)


def test_the_import_needs_no_numpy() -> None:
    code = "import sys, towermodes; print('numpy' in sys.modules)"
    assert python(code).stdout == "False\n"


def test_the_import_loads_no_other_module_that_takes_time() -> None:
    code = "import sys; old = set(sys.modules); import towermodes; print(*(set(sys.modules) - old))"
    loaded = python(code).stdout.split()
    assert "towermodes._sweep" in loaded
    assert not {"collections", "dataclasses", "inspect", "json", "typing"} & set(loaded)


def test_every_public_name_is_documented_and_there() -> None:
    for name in tm.__all__:
        assert getattr(tm, name).__doc__
    assert tm.__version__.count(".") == 2


def first_frequency(tower: tm.Tower) -> float:
    return tower.solve(modes=2).mode("fore-aft", 1).frequency_hz


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
def test_children_of_a_fork_solve_too(nrel: tm.Tower) -> None:
    expected = first_frequency(nrel)
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map(first_frequency, [nrel] * 4) == [expected] * 4


def test_spawned_processes_get_towers_by_pickles(nrel: tm.Tower) -> None:
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.map(first_frequency, [nrel]) == [first_frequency(nrel)]


def test_threads_solve_at_the_same_time(nrel: tm.Tower) -> None:
    expected = first_frequency(nrel)
    results: list[float] = []
    threads = [
        threading.Thread(target=lambda: results.append(first_frequency(nrel))) for _ in range(8)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results == [expected] * 8


def test_other_threads_run_during_a_solve(nrel: tm.Tower) -> None:
    with Ticking() as other:
        start = time.perf_counter()
        nrel.solve(segments=20_000)
        seconds = time.perf_counter() - start
    # With the interpreter lock held there would be one tick or two.
    assert other.ticks > 5, f"{other.ticks} ticks in {seconds} s"


LONG_SOLVE = """
import towermodes as tm
tower = tm.read("examples/nrel-5mw.toml")
print("begin", flush=True)
try:
    tower.solve(modes=20, segments=500_000)
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_ctrl_c_ends_a_long_solve() -> None:
    command = [sys.executable, "-c", LONG_SOLVE]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "begin\n"
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "interrupted\n"
        assert process.wait(timeout=60) == 0


@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_ctrl_c_ends_the_program() -> None:
    words = ["solve", "examples/nrel-5mw.toml", "--segments", "500000", "--modes", "20"]
    with subprocess.Popen([sys.executable, "-m", "towermodes", *words]) as process:
        time.sleep(1.0)
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=60) == -signal.SIGINT


MEMORY = """
import resource
import numpy, towermodes as tm
tower = tm.read("examples/nrel-5mw.toml")
rows = {"rna.mass": -1e-9 - numpy.arange(3_000_000.0)}
with open("/proc/self/statm") as pages:
    used = int(pages.read().split()[0]) * resource.getpagesize()
for more_mb in (50, 250):
    limit = used + more_mb * 1_000_000
    resource.setrlimit(resource.RLIMIT_AS, (limit, resource.RLIM_INFINITY))
    try:
        tower.sweep(rows, modes=1, threads=THREADS)
    except MemoryError as error:
        print(error)
"""


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="limits of Linux")
@pytest.mark.parametrize("threads", [1, 2])
def test_rows_and_messages_that_do_not_fit_into_memory_are_an_exception(threads: int) -> None:
    result = python(MEMORY.replace("THREADS", str(threads)), check=False)
    lines = result.stdout.splitlines()
    assert (result.returncode, len(lines)) == (0, 2), result.stderr
    assert all("3000000 rows do not fit into memory" in line for line in lines), lines


EXIT = """
import threading, time
import numpy, towermodes as tm
tower = tm.read("examples/nrel-5mw.toml")
rows = {"rna.mass": numpy.full(3_000_000, 3e5)}
work = {
    "sweep": lambda: tower.sweep(rows),
    "sweep on one thread": lambda: tower.sweep(rows, threads=1),
    "solve": lambda: tower.solve(segments=1_000_000),
    "compare": lambda: tower.compare(segments=200_000),
    "short solves": lambda: [tower.solve() for _ in range(1_000_000)],
    "errors": lambda: [failed() for _ in range(10_000_000)],
}
def failed():
    try:
        tower.with_({"rna.mass": -1.0})
    except tm.TowerError:
        pass
for _ in range(2):
    threading.Thread(target=work[WORK], daemon=True).start()
time.sleep(0.3)
"""


@pytest.mark.parametrize(
    "work", ["sweep", "sweep on one thread", "solve", "compare", "short solves", "errors"]
)
def test_the_interpreter_ends_while_other_threads_compute(work: str) -> None:
    # CPython before 3.14 ends a thread that comes back by unwinding its stack.
    done = python(EXIT.replace("WORK", repr(work)), check=False)
    assert (done.returncode, done.stderr) == (0, "")


def test_a_function_at_the_exit_may_solve() -> None:
    code = """
import atexit
@atexit.register
def last():
    print(tower.solve(modes=1).certified, len(tower.sweep({"rna.mass": [3e5] * 300})))
import towermodes as tm
tower = tm.read("examples/nrel-5mw.toml")
"""
    assert python(code).stdout == "True 300\n"


def run(*words: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "towermodes", *words]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_the_program_is_in_the_package() -> None:
    done = run("solve", "examples/nrel-5mw.toml", "--modes", "2")
    assert done.returncode == 0
    assert "1st fore-aft bending" in done.stdout
    assert run("--version").stdout == f"towermodes {tm.__version__}\n"
    wrong = run("solve", "missing.toml")
    assert (wrong.returncode, wrong.stdout) == (2, "")
    assert "missing.toml" in wrong.stderr
    # A file without a command: the program's name in the message is its own.
    alone = run("examples/nrel-5mw.toml")
    assert "to solve it: towermodes solve examples/nrel-5mw.toml" in alone.stderr
    assert "Usage: towermodes" in alone.stderr


@pytest.mark.skipif(sys.platform == "win32", reason="a shell of POSIX")
def test_a_reader_that_stops_is_no_error_and_a_closed_output_is() -> None:
    shell = f"{sys.executable} -m towermodes reference | head -n 1; echo ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", shell], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "0"
    assert done.stderr == ""
    shell = f"{sys.executable} -m towermodes solve examples/nrel-5mw.toml >&-; echo $? >&2"
    done = subprocess.run(["bash", "-c", shell], capture_output=True, text=True, check=True)
    assert done.stderr.splitlines()[-1] == "1"
    assert "standard output" in done.stderr
