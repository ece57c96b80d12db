"""Results in notebooks."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from towermodes import _towermodes as _rust

_NUMBER = ' style="text-align: right; font-variant-numeric: tabular-nums"'
_TEXT = ' style="text-align: left"'


def solution_html(core: _rust.Solution) -> str:
    """The table of modes, what is below it, warnings, and the picture of the shapes."""
    header, rows, below = core.cells()
    head = "".join(_cell("th", number, text) for number, text in enumerate(header))
    body = "".join(
        "<tr>" + "".join(_cell("td", n, text) for n, text in enumerate(row)) + "</tr>"
        for row in rows
    )
    lines = "<br>".join(_escaped(line) for line in below.splitlines())
    warnings = "".join(f"<p>warning: {_escaped(text)}</p>" for text in core.warnings)
    return (
        f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
        f"<p>{lines}</p>{warnings}<div>{core.svg()}</div>"
    )


def text_html(text: str, picture: str = "") -> str:
    """A table of the program as it is, and a picture."""
    return f"<pre>{_escaped(text)}</pre><div>{picture}</div>"


def _cell(tag: str, column: int, text: str) -> str:
    # The second column has the names of the modes.
    style = _TEXT if column == 1 else _NUMBER
    return f"<{tag}{style}>{_escaped(text)}</{tag}>"


def _escaped(text: str) -> str:
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
