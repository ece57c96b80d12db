"""Names of modes: family and order."""

from __future__ import annotations

from towermodes import _towermodes as _rust
from towermodes._checks import whole

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Literal, SupportsIndex

    Family = Literal[
        "fore-aft",
        "side-side",
        "torsion",
        "axial",
        "surge",
        "sway",
        "heave",
        "roll",
        "pitch",
        "yaw",
        "substructure",
    ]
    #: Selection of modes: the number of lowest modes, or names.
    Modes = SupportsIndex | str | Sequence[tuple[str, int] | str]

FAMILIES = (
    "fore-aft",
    "side-side",
    "torsion",
    "axial",
    "surge",
    "sway",
    "heave",
    "roll",
    "pitch",
    "yaw",
    "substructure",
)

#: Example of a list of modes.
EXAMPLE = '[("fore-aft", 1), "torsion 1"]'


def mode_name(mode: object) -> tuple[Family, int, str]:
    """Family, order and column of a mode: of `("fore-aft", 1)` or of `"fore-aft 1"`.

    Raises:
        TypeError: It is neither a text nor a pair.
        ValueError: There is no such family or order.
    """
    if isinstance(mode, str):
        written = mode
    elif isinstance(mode, (tuple, list)) and len(mode) == 2 and isinstance(mode[0], str):
        written = f"{mode[0]} {whole('the order of a mode', mode[1], 1)}"
    else:
        message = f'{mode!r} is not the name of a mode; write ("fore-aft", 1) or "fore-aft 1"'
        raise TypeError(message)
    try:
        return _rust.mode_named(written)  # type: ignore[return-value]
    except ValueError as error:
        raise ValueError(f"{error}{_suggestion(written)}") from None


def _suggestion(written: str) -> str:
    from difflib import get_close_matches

    family = written.rstrip(" 0123456789").lower().replace("_", "-")
    close = [] if family in FAMILIES else get_close_matches(family, FAMILIES, 1)
    return f"; did you mean {close[0]!r}?" if close else ""


def modes_chosen(modes: Modes | None) -> tuple[int | None, list[str]]:
    """An argument `modes` as a number or as names; neither if it is not given."""
    if modes is None:
        return None, []
    if hasattr(modes, "__index__"):
        return whole("modes", modes, 1), []
    if isinstance(modes, str):
        modes = [modes]
    if isinstance(modes, tuple) and len(modes) == 2 and hasattr(modes[1], "__index__"):
        message = f"modes is {modes!r}, one mode; give a list of modes: [{modes!r}]"
        raise TypeError(message)
    try:
        several = list(modes)
    except TypeError:
        message = f"modes is {modes!r}; it must be a whole number or a list of names: {EXAMPLE}"
        raise TypeError(message) from None
    if not several:
        message = f"modes is empty; give a number of modes or their names: {EXAMPLE}"
        raise ValueError(message)
    names = [mode_name(mode) for mode in several]
    return None, [f"{family} {order}" for family, order, _ in names]


def place_of(
    names: list[tuple[Family, int]], family: str, order: int | None, among: str = ""
) -> int:
    """The index of a mode in a list of names; the family may contain the order: `fore-aft 1`.

    Raises:
        KeyError: The list has no such mode.
        ValueError: There is no such family.
    """
    if order is None:
        order = 1
        words = family.split() if isinstance(family, str) else []
        if len(words) == 2:
            family, order, _ = mode_name(family)
    if (family, order) in names:
        return names.index((family, order))  # type: ignore[arg-type]
    mode_name((family, order))
    there = ", ".join(f"{family} {order}" for family, order in names)
    message = f"no mode {family} {order} among {among or f'the {len(names)} modes'}: {there}"
    raise KeyError(message)
