"""What all results of computations have in common."""

from __future__ import annotations

from towermodes._html import text_html

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any, ClassVar

    from typing_extensions import Self

    from towermodes._tower import Tower


class Computed:
    """A result of towers. It never changes.

    A pickle has the towers and the arguments; reading it computes the result again, to the same
    digits. So results go from process to process, and copies are the result itself.
    """

    __slots__ = ("_arguments", "_core", "_towers")

    _compute: ClassVar[Callable[..., Any]]
    """Computes the result of towers and arguments in the module in Rust."""
    _maker: ClassVar[str]
    """The method of `Tower` that makes it."""
    _core: Any
    _towers: tuple[Tower, ...]
    _arguments: tuple[Any, ...]

    def __init__(self, *_: object, **__: object) -> None:
        message = f"a {type(self).__name__} is made by {self._maker}"
        raise TypeError(message)

    @classmethod
    def _of(cls, towers: tuple[Tower, ...], *arguments: Any) -> Self:
        result = cls.__new__(cls)
        result._core = cls._compute(*(tower._core for tower in towers), *arguments)
        result._towers = towers
        result._arguments = arguments
        return result

    def __reduce__(self) -> tuple[object, ...]:
        return (_computed, (type(self), self._towers, self._arguments))

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, _: object) -> Self:
        return self


def _computed(cls: type[Computed], towers: tuple[Tower, ...], arguments: tuple[Any, ...]) -> object:
    return cls._of(towers, *arguments)


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
