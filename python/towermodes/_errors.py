"""The exceptions of the package. The module in Rust raises them."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence


class Mistake:
    """A mistake in a file.

    Attributes:
        line: The line, from 1; None if the value is not from a file.
        column: The column, from 1, in characters; None like `line`.
        message: What is wrong.
        hint: What would be right; None if the message says it.
    """

    __slots__ = ("column", "hint", "line", "message")

    def __init__(
        self, line: int | None, column: int | None, message: str, hint: str | None
    ) -> None:
        self.line = line
        self.column = column
        self.message = message
        self.hint = hint

    def __repr__(self) -> str:
        return (
            f"Mistake(line={self.line!r}, column={self.column!r}, "
            f"message={self.message!r}, hint={self.hint!r})"
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Mistake) and _fields(self) == _fields(other)

    def __hash__(self) -> int:
        return hash(_fields(self))


def _fields(mistake: Mistake) -> tuple[object, ...]:
    return (mistake.line, mistake.column, mistake.message, mistake.hint)


class TowerError(ValueError):
    """A file or numbers that do not describe a valid tower, or a tower that a format cannot store.

    Also the file of a study or of measurements with mistakes.

    Attributes:
        path: The file; None if the tower is not from a file.
        line: The line of the first mistake, from 1; None if it is not known.
        column: Its column, from 1, in characters; None if it is not known.
        hint: What would be right; None if the message says it.
        mistakes: All mistakes that were found in the file.

    >>> import towermodes as tm
    >>> try:
    ...     tm.read("crates/towermodes-cli/tests/inputs/misspelled.toml")
    ... except tm.TowerError as error:
    ...     print(error.line, error.column, error.hint)
    2 1 did you mean `density`?
    """

    def __init__(
        self,
        message: str,
        path: str | None = None,
        hint: str | None = None,
        mistakes: Sequence[tuple[int | None, int | None, str, str | None]] = (),
    ) -> None:
        super().__init__(message)
        self.path = path
        self.hint = hint
        self.mistakes = [Mistake(*mistake) for mistake in mistakes]
        first = self.mistakes[0] if self.mistakes else None
        self.line = first.line if first else None
        self.column = first.column if first else None

    def __reduce__(self) -> tuple[object, ...]:
        mistakes = [_fields(mistake) for mistake in self.mistakes]
        return (type(self), (str(self), self.path, self.hint, mistakes))


class SolveError(ArithmeticError):
    """A tower whose modes cannot be computed: it buckles, is unstable, or its values are extreme.

    Also a design or a calibration without a solution.

    Attributes:
        hint: What the user can do about it; None if the message says it.

    The warnings about the tower, which may explain the error, are notes of the exception
    (`__notes__`, from Python 3.11), and a traceback shows them.

    >>> import towermodes as tm
    >>> try:
    ...     tm.read("crates/towermodes-cli/tests/inputs/buckling.toml").solve()
    ... except tm.SolveError as error:
    ...     print(error)
    the tower buckles under gravity: the buckling load factor is ...
    """

    def __init__(self, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.hint = hint

    def __reduce__(self) -> tuple[object, ...]:
        return (type(self), (str(self), self.hint))


class OptionError(SolveError, ValueError):
    """Options that are impossible for this tower, as more modes than degrees of freedom.

    It is a `SolveError` and a `ValueError`; its attributes are those of `SolveError`.

    >>> import towermodes as tm
    >>> tm.read("examples/nrel-5mw.toml").solve(modes=50, segments=2)
    Traceback (most recent call last):
    towermodes._errors.OptionError: 50 modes are requested, but the model has only ...
    """
