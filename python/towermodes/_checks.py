"""Checks of arguments for which messages of the module in Rust would be unclear."""

from __future__ import annotations

from operator import index

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import SupportsFloat, SupportsIndex

#: The largest number that the module in Rust takes.
MOST = 2**63 - 1


def whole(name: str, value: SupportsIndex, least: int) -> int:
    """An argument as a whole number."""
    try:
        number = index(value)
    except TypeError:
        message = f"{name} is {value!r}; it must be a whole number"
        raise TypeError(message) from None
    if number < least:
        message = f"{name} is {number}; it must be at least {least}"
        raise ValueError(message)
    if number > MOST:
        message = f"{name} is {number}; it must be at most {MOST}"
        raise ValueError(message)
    return number


def whole_or_none(name: str, value: SupportsIndex | None, least: int) -> int | None:
    """An optional argument as a whole number."""
    return None if value is None else whole(name, value, least)


def number(name: str, value: SupportsFloat) -> float:
    """An argument as a number."""
    if is_complex(value):
        message = f"{name} is {value!r}; it must be a real number, without an imaginary part"
        raise TypeError(message)
    if not isinstance(value, (str, bytes)):
        try:
            return float(value)
        except (TypeError, ValueError):
            pass
    message = f"{name} is {value!r}; it must be a number"
    raise TypeError(message)


def is_complex(value: object) -> bool:
    """Whether a value has an imaginary part, which `float` of NumPy would drop with a warning."""
    kind = getattr(getattr(value, "dtype", None), "kind", None)
    return kind == "c" or isinstance(value, complex)


def number_or_none(name: str, value: SupportsFloat | None) -> float | None:
    """An optional argument as a number."""
    return None if value is None else number(name, value)


def word(name: str, value: str) -> str:
    """An argument as a text."""
    if isinstance(value, str):
        return value
    message = f"{name} is {value!r}; it must be a text"
    raise TypeError(message)


def words(name: str, values: Iterable[str]) -> list[str]:
    """An argument as a list of texts; one text is a list of one."""
    several = [values] if isinstance(values, str) else values
    return [word(name, value) for value in several]


def word_or_none(name: str, value: str | None) -> str | None:
    """An optional argument as a text."""
    return None if value is None else word(name, value)


def heights_inside(heights_m: Iterable[float], base_m: float, top_m: float) -> list[float]:
    """Heights of a tower; a shape has no value outside of it."""
    heights = [number("a height", height) for height in heights_m]
    for height in heights:
        if not base_m <= height <= top_m:
            message = (
                f"heights_m has {height:g} m; the tower reaches from {base_m:g} m to {top_m:g} m"
            )
            raise ValueError(message)
    return heights
