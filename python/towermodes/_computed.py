"""Base classes of the results of computations."""

from __future__ import annotations

from towermodes._constant import constant
from towermodes._html import text_html
from towermodes._picture import Picture

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, ClassVar

    from typing_extensions import Self

    from towermodes import _towermodes as _rust
    from towermodes._tower import Tower


class Computed:
    """A result computed from towers. It never changes.

    A pickle has all numbers and texts of the result as data, so reading it computes nothing.
    Only a picture is drawn again, from the towers and the arguments, when it is requested.
    `copy` returns the result itself.
    """

    __slots__ = ("_arguments", "_core", "_towers")

    _compute: ClassVar[Callable[..., Any]]
    """Computes the result of towers and arguments in the module in Rust."""
    _maker: ClassVar[str]
    """The method of `Tower` that computes the result."""
    _core: Any
    _towers: tuple[Tower, ...]
    _arguments: tuple[Any, ...]

    def __init__(self, *_: object, **__: object) -> None:
        message = f"a {type(self).__name__} is made by {self._maker}"
        raise TypeError(message)

    @classmethod
    def _of(cls, towers: tuple[Tower, ...], *arguments: Any, **watched: Any) -> Self:
        cores = (tower._core for tower in towers)
        return cls._with(cls._compute(*cores, *arguments, **watched), towers, arguments)

    @classmethod
    def _with(cls, core: Any, towers: tuple[Tower, ...], arguments: tuple[Any, ...]) -> Self:
        result = cls.__new__(cls)
        result._core = core
        result._towers = towers
        result._arguments = arguments
        return result

    def __reduce__(self) -> tuple[object, ...]:
        core = self._core
        recorded = core if isinstance(core, Recorded) else Recorded(*_all_of(core))
        return (_restored, (type(self), recorded, self._towers, self._arguments))

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, _: object) -> Self:
        return self


#: Methods of the classes in Rust whose results are not in pickles, because they take long to make.
MADE_AGAIN = frozenset({"svg"})


class Recorded:
    """The numbers and texts of a result from a pickle, in place of the object in Rust."""

    __slots__ = ("_again", "_texts", "_values")

    def __init__(self, values: dict[str, Any], texts: dict[str, Any]) -> None:
        self._values = {name: constant(value) for name, value in values.items()}
        self._texts = texts
        self._again: Callable[[], Any] | None = None

    def __reduce__(self) -> tuple[object, ...]:
        return (type(self), (self._values, self._texts))

    def __getattr__(self, name: str) -> Any:
        if name in self._values:
            return self._values[name]
        if name in self._texts:
            return lambda: self._texts[name]
        if name == "column" and "columns" in self._values:
            return self._values["columns"].__getitem__
        if name in MADE_AGAIN and self._again is not None:
            return getattr(self._again(), name)
        raise AttributeError(name)


def _all_of(core: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    """The data of an object in Rust: values by their names, and the results of its methods."""
    values, texts = {}, {}
    for name in dir(type(core)):
        if name.startswith("_") or name in MADE_AGAIN or name == "column":
            continue
        value = getattr(core, name)
        if callable(value):
            texts[name] = value()
        else:
            values[name] = value
    return values, texts


def _restored(
    cls: type[Computed], core: Recorded, towers: tuple[Tower, ...], arguments: tuple[Any, ...]
) -> Computed:
    core._again = lambda: cls._compute(*(tower._core for tower in towers), *arguments)
    return cls._with(core, towers, arguments)


class Tabular(Computed):
    """A result that the program prints as a table and writes as JSON."""

    __slots__ = ()

    @property
    def data(self) -> dict[str, Any]:
        """All values with the keys of the program's JSON."""
        import json

        data: dict[str, Any] = json.loads(self.to_json())
        return data

    def to_json(self) -> str:
        """All values as JSON, as the program writes it."""
        text: str = self._core.json()
        return text

    def _said(self) -> list[str]:
        """Notes and warnings that are shown below the table."""
        return []

    def _picture(self) -> str:
        """The picture that is shown below the table."""
        return ""

    def __repr__(self) -> str:
        warnings = "".join(f"warning: {text}\n" for text in self._said())
        return (str(self._core.table()) + warnings).rstrip("\n")

    def _repr_html_(self) -> str:
        return text_html(repr(self), self._picture())


class Answer(Tabular):
    """A result with notes, warnings and lines of CSV."""

    __slots__ = ()

    _core: _rust.Answer

    @property
    def notes(self) -> list[str]:
        """Assumptions and omissions of the reader and of the computation."""
        return self._core.notes

    @property
    def warnings(self) -> list[str]:
        """Possible mistakes of the input and limits of the results."""
        return self._core.warnings

    def to_csv(self) -> str:
        """The values as CSV, as the program writes it."""
        return self._core.csv()

    def _said(self) -> list[str]:
        return [*self.notes, *self.warnings]


class Pictured(Answer):
    """A result with a picture."""

    __slots__ = ()

    def plot(self) -> Picture:
        """The picture of the result."""
        return Picture(self._core.svg())

    def _picture(self) -> str:
        return self._core.svg()
