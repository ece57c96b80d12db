"""The notebooks run, and their text is what they show.

`TOWERMODES_BLESS=1` writes the outputs into the notebooks.
"""

from __future__ import annotations

import importlib
import os
import re
from pathlib import Path
from typing import Any

import pages
import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")

ROOT = Path(__file__).resolve().parents[2]
NOTEBOOKS = sorted((ROOT / "examples").glob("*.ipynb"))
# The kernel is another process, whose client closes its sockets late.
pytestmark = pytest.mark.filterwarnings("default")

# Addresses of objects, and the drawings of matplotlib.
CHANGES = re.compile(r"<Figure size .*>|0x[0-9a-f]+")


def texts(cell: Any) -> list[str]:
    """What a cell shows as text. On a busy machine one stream arrives in several pieces."""
    shown: list[str] = []
    stream = None
    for output in cell.get("outputs", []):
        text = CHANGES.sub("", output.get("text") or output.get("data", {}).get("text/plain", ""))
        name = output.get("name")
        if name is not None and name == stream:
            shown[-1] += text
        else:
            shown.append(text)
        stream = name
    return shown


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook(path: Path, tmp_path: Path) -> None:
    # The first import on a machine builds a cache of fonts, and says so in the notebook when slow.
    importlib.import_module("matplotlib.font_manager")
    shown = nbformat.read(path, as_version=4)
    fresh = nbformat.read(path, as_version=4)
    client = nbclient.NotebookClient(
        fresh,
        kernel_name="python3",
        timeout=120,
        record_timing=False,
        resources={"metadata": {"path": str(tmp_path)}},
    )
    client.execute()
    if os.environ.get("TOWERMODES_BLESS"):
        nbformat.write(fresh, path)
        return
    for place, (before, now) in enumerate(zip(shown.cells, fresh.cells, strict=True)):
        assert before.get("execution_count") == now.get("execution_count"), f"cell {place}"
        for expected, printed in zip(texts(before), texts(now), strict=True):
            differs = pages.difference(expected, printed)
            assert differs is None, f"cell {place}: {differs}"


def test_there_is_a_notebook() -> None:
    assert [path.name for path in NOTEBOOKS] == ["first-tower.ipynb"]
