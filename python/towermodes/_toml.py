"""Python values as the text of a tower file."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping


def tower_file(tables: Mapping[str, object]) -> str:
    """The text of a tower file; tables without a value are left out."""
    given = ((str(key), value) for key, value in tables.items() if value is not None)
    lines = [f"{_text(key)} = {_value(key, value)}" for key, value in given]
    return "\n".join(lines) + "\n"


def table(key: str, value: object) -> object:
    """A table as given; a number becomes a table with this key."""
    is_number = hasattr(value, "__float__") and not isinstance(value, bool)
    return {key: value} if is_number else value


def _value(entry: str, value: object) -> str:
    """The value of an entry; messages contain its name."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        # Also for the scalars of NumPy, whose text has their type.
        return repr(int(value)) if isinstance(value, int) else repr(float(value))
    if isinstance(value, str):
        return _text(value)
    items = getattr(value, "items", None)
    if items is not None:
        pairs = ((_key(key), item) for key, item in items())
        written = (f"{_text(key)} = {_value(_of(entry, key), item)}" for key, item in pairs)
        return "{ " + ", ".join(written) + " }"
    if _is_name_of_mode(value):
        return _text(_key(value))
    if isinstance(value, (list, tuple)):
        entries = (_value(f"{entry}[{place}]", item) for place, item in enumerate(value))
        return "[" + ", ".join(entries) + "]"
    plain = getattr(value, "tolist", None)
    if plain is not None and not isinstance(value, complex):
        return _value(entry, plain())
    message = f"{entry} is {value!r}; it must be a number, a text, a list, an array or a dict"
    if value is None:
        message += "; leave the entry out if it has no value"
    raise TypeError(message)


def _is_name_of_mode(value: object) -> bool:
    """Whether a value is the name of a mode in two parts: `("fore-aft", 1)`."""
    if not isinstance(value, tuple) or len(value) != 2:
        return False
    return isinstance(value[0], str) and hasattr(value[1], "__index__")


def _key(key: object) -> str:
    if isinstance(key, tuple) and _is_name_of_mode(key):
        return f"{key[0]} {int(key[1])}"
    return str(key)


def _of(entry: str, key: str) -> str:
    """The name of an entry of a table, as in messages of the module in Rust."""
    is_word = key.replace("_", "").replace("-", "").isalnum() and key.isascii()
    return f"{entry}.{key}" if is_word else f'{entry}["{key}"]'


def _text(text: str) -> str:
    import json

    return json.dumps(text, ensure_ascii=False)
