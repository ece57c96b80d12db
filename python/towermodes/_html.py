"""Results in notebooks."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from towermodes import _towermodes as _rust

_NUMBER = ' style="text-align: right; font-variant-numeric: tabular-nums"'
_TEXT = ' style="text-align: left"'


def solution_html(core: _rust.Solution) -> str:
    """The table of modes with the lines below it, warnings, and the picture of the shapes."""
    header, rows, below = core.cells()
    # The second column has the names of the modes.
    table = table_html(header, rows, texts=(1,))
    lines = "<br>".join(_escaped(line) for line in below.splitlines())
    warnings = "".join(f"<p>warning: {_escaped(text)}</p>" for text in core.warnings)
    return (
        f"{table}<p>{lines}</p>{warnings}<div>{core.svg()}</div>"
    )


def table_html(header: list[str], rows: list[list[str]], texts: tuple[int, ...]) -> str:
    """A table with columns of numbers, and some columns of texts."""
    head = _row("th", header, texts)
    body = "".join(_row("td", row, texts) for row in rows)
    return f"<table><thead>{head}</thead><tbody>{body}</tbody></table>"


def text_html(text: str, picture: str = "") -> str:
    """A table as the program prints it, and a picture."""
    return f"<pre>{_escaped(text)}</pre><div>{picture}</div>"


def _row(tag: str, cells: list[str], texts: tuple[int, ...]) -> str:
    styles = [_TEXT if place in texts else _NUMBER for place in range(len(cells))]
    pairs = zip(styles, cells, strict=True)
    return "<tr>" + "".join(f"<{tag}{style}>{_escaped(c)}</{tag}>" for style, c in pairs) + "</tr>"


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
