"""The failed rows of a sweep."""

from __future__ import annotations

from collections.abc import Sequence

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, overload

    import numpy as np
    from numpy.typing import NDArray


class Failures(Sequence["tuple[int, str]"]):
    """A list of rows and messages that cannot be changed.

    Ten million failed rows as Python objects need 3 GB; here they are made when they are read.

    >>> import towermodes as tm
    >>> tower = tm.read("examples/nrel-5mw.toml")
    >>> failures = tower.sweep({"rna.mass": [-1.0, 3e5, float("nan")]}).failures
    >>> [row for row, message in failures]
    [0, 2]
    """

    __slots__ = ("_ends", "_rows", "_text")

    def __init__(
        self, rows: NDArray[np.uint64], ends: NDArray[np.uint64], text: NDArray[np.uint8]
    ) -> None:
        self._rows = rows
        self._ends = ends
        self._text = text

    @property
    def _columns(self) -> tuple[Any, Any, Any]:
        return self._rows, self._ends, self._text

    def __len__(self) -> int:
        return len(self._rows)

    if TYPE_CHECKING:

        @overload
        def __getitem__(self, place: int) -> tuple[int, str]: ...
        @overload
        def __getitem__(self, place: slice) -> list[tuple[int, str]]: ...

    def __getitem__(self, place: Any) -> Any:
        """A failure, or a list of several."""
        places = range(len(self))[place]
        if isinstance(places, range):
            return [self._at(one) for one in places]
        return self._at(places)

    def _at(self, place: int) -> tuple[int, str]:
        begin = int(self._ends[place - 1]) if place else 0
        text = self._text[begin : int(self._ends[place])]
        return int(self._rows[place]), text.tobytes().decode()

    def __eq__(self, other: object) -> bool:
        """Whether both have the same rows and messages; the other one may be a list."""
        if not isinstance(other, (Failures, list)):
            return NotImplemented
        return len(self) == len(other) and all(a == b for a, b in zip(self, other, strict=True))

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        """The list; if it has more than ten entries, the first ones and their number."""
        if len(self) <= 10:
            return repr(self[:])
        first = ", ".join(repr(one) for one in self[:10])
        return f"[{first}, ... {len(self) - 10} more]"
