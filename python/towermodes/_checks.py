"""Checks of arguments whose mistakes the module in Rust could not name."""

from __future__ import annotations

from operator import index

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import SupportsIndex


def whole(name: str, value: SupportsIndex, least: int) -> int:
    """An argument as a whole number."""
    try:
        number = index(value)
    except TypeError:
        message = f"{name} is {value!r}; it must be a whole number"
        raise TypeError(message) from None
    if not least <= number < 2**63:
        message = f"{name} is {number}; it must be at least {least}"
        raise ValueError(message)
    return number


def whole_or_none(name: str, value: SupportsIndex | None, least: int) -> int | None:
    """An optional argument as a whole number."""
    return None if value is None else whole(name, value, least)
