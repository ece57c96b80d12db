"""The Python of the how-to pages runs and prints what the pages show."""

from __future__ import annotations

import os
from pathlib import Path

import pages
import pytest

ROOT = Path(__file__).resolve().parents[2]
HOW_TO = [
    path
    for path in sorted((ROOT / "book/src").rglob("*.md"))
    if "import towermodes" in path.read_text("utf-8") and pages.blocks(path.read_text("utf-8"))
]
# OpenMDAO sets NumPy's print options for the whole process, and libraries have warnings of their own.
pytestmark = pytest.mark.filterwarnings("default")


@pytest.mark.parametrize("page", HOW_TO, ids=lambda path: path.stem)
def test_page(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    monkeypatch.chdir(tmp_path)
    text = page.read_text("utf-8")
    done = pages.run(page, text)
    if os.environ.get("TOWERMODES_BLESS"):
        page.write_text(pages.filled(text, done), "utf-8")
        return
    for block, printed in done:
        differs = pages.difference(block.printed, printed)
        assert differs is None, f"{page.name}, line {block.line}: {differs}"


def test_the_pages_are_found() -> None:
    stems = {page.stem for page in HOW_TO}
    assert {"dataframes", "optimize", "uncertainty", "openmdao", "jax", "cluster"} <= stems


def test_a_wrong_digit_is_found() -> None:
    assert pages.difference("f 0.3300 Hz", "f 0.3301 Hz") is None
    assert pages.difference("f 0.3300 Hz", "f 0.3302 Hz")
    assert pages.difference("p 2.9e-03", "p 3.1e-03")
    assert pages.difference("20 towers", "21 towers")
    assert pages.difference("a\nb\n", "a\n")
