"""Towers of the tests. They run in the root of the repository, as its examples do."""

from __future__ import annotations

import os
import threading
import time
from pathlib import Path

import pytest

import towermodes as tm

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(autouse=True, scope="session")
def in_the_root() -> None:
    os.chdir(ROOT)


@pytest.fixture(scope="session")
def nrel() -> tm.Tower:
    return tm.read(ROOT / "examples/nrel-5mw.toml")


@pytest.fixture(scope="session")
def monopile() -> tm.Tower:
    return tm.read(ROOT / "examples/monopile.toml")


def examples() -> list[Path]:
    folder = ROOT / "examples"
    kinds = ("*.toml", "*.bmi", "*.yaml", "*/ElastoDyn.dat")
    return sorted(path for kind in kinds for path in folder.glob(kind))


class Ticking:
    """Counts the ticks of another thread while a block runs."""

    def __init__(self) -> None:
        self.ticks = 0
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._tick)

    def _tick(self) -> None:
        while not self._ended.is_set():
            self.ticks += 1
            time.sleep(0.001)

    def __enter__(self) -> Ticking:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()
