"""Runs the Python of the pages of the book.

The blocks of a page run one after the other in one namespace, in a folder that has the examples.
What a `python` block prints must be the `text` block that follows it directly. A number may differ
by one in its last printed digit: other processors and libraries round differently.

`TOWERMODES_BLESS=1` writes what the blocks print into the page.
"""

from __future__ import annotations

import contextlib
import io
import linecache
import re
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

FENCED = re.compile(
    r"^```python\n(?P<code>.*?)^```\n(?:\n```text\n(?P<printed>.*?)^```\n)?", re.MULTILINE | re.DOTALL
)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


@dataclass
class Block:
    """A block of code, and what it must print."""

    line: int
    code: str
    printed: str
    printed_span: tuple[int, int] | None


def blocks(text: str) -> list[Block]:
    """The Python blocks of a page that are no doctests."""
    found = []
    for match in FENCED.finditer(text):
        if ">>>" in match["code"]:
            continue
        span = match.span("printed") if match["printed"] is not None else None
        line = text.count("\n", 0, match.start("code"))
        found.append(Block(line, match["code"], match["printed"] or "", span))
    return found


def run(page: Path, text: str) -> list[tuple[Block, str]]:
    """Runs the blocks of a page in the current folder: each with what it printed."""
    module = ModuleType("__main__")
    done = []
    for block in blocks(text):
        # Lines of the code are the lines of the page, so that a traceback shows the place.
        code = "\n" * block.line + block.code
        linecache.cache[str(page)] = (len(code), None, code.splitlines(keepends=True), str(page))
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, str(page), "exec"), module.__dict__)
        done.append((block, printed.getvalue()))
    return done


def filled(text: str, done: list[tuple[Block, str]]) -> str:
    """The page with what its blocks printed."""
    for block, printed in reversed(done):
        if block.printed_span:
            start, end = block.printed_span
            text = text[:start] + printed + text[end:]
    return text


def difference(expected: str, printed: str) -> str | None:
    """The first lines that differ in more than the last digits of numbers."""
    for number, (left, right) in enumerate(zip_lines(expected, printed), 1):
        if not same_line(left, right):
            return f"line {number} of the output:\n  page    {left}\n  printed {right}"
    return None


def zip_lines(expected: str, printed: str) -> list[tuple[str, str]]:
    """Lines side by side; a missing line is `(nothing)`."""
    pages, prints = expected.splitlines(), printed.splitlines()
    rows = max(len(pages), len(prints))
    pages += ["(nothing)"] * (rows - len(pages))
    prints += ["(nothing)"] * (rows - len(prints))
    return list(zip(pages, prints, strict=True))


def same_line(expected: str, printed: str) -> bool:
    """Whether the words are equal and the numbers differ by at most one in the last digit."""
    if NUMBER.sub("#", expected).split() != NUMBER.sub("#", printed).split():
        return False
    pairs = zip(NUMBER.findall(expected), NUMBER.findall(printed), strict=True)
    return all(abs(float(a) - float(b)) <= 1.001 * max(unit(a), unit(b)) for a, b in pairs)


def unit(number: str) -> float:
    """One in the last printed digit of a number with a fraction or an exponent; 0 for a count."""
    mantissa, _, exponent = number.partition("e")
    decimals = len(mantissa.partition(".")[2])
    if not decimals and not exponent:
        return 0.0
    return float(10.0 ** (int(exponent or 0) - decimals))
