"""Python values as the text of a tower file."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping


def tower_file(tables: Mapping[str, object]) -> str:
    """The text of a tower file; tables without a value are left out."""
    lines = [f"{key} = {_value(value)}" for key, value in tables.items() if value is not None]
    return "\n".join(lines) + "\n"


def table(key: str, value: object) -> object:
    """A table that may be given as its first number."""
    is_number = hasattr(value, "__float__") and not isinstance(value, bool)
    return {key: value} if is_number else value


def _value(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        # Also for the scalars of NumPy, whose text has their type.
        return repr(int(value)) if isinstance(value, int) else repr(float(value))
    if isinstance(value, str):
        return _text(value)
    items = getattr(value, "items", None)
    if items is not None:
        pairs = (f"{_text(str(key))} = {_value(item)}" for key, item in items())
        return "{ " + ", ".join(pairs) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(item) for item in value) + "]"
    plain = getattr(value, "tolist", None)
    if plain is not None:
        return _value(plain())
    message = f"{value!r} is neither a number, a text, a list, an array nor a dict"
    raise TypeError(message)


def _text(text: str) -> str:
    import json

    return json.dumps(text, ensure_ascii=False)
