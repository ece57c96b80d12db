"""Towers in other formats."""

from __future__ import annotations

import os

from towermodes import _towermodes as _rust
from towermodes._computed import Computed


class Converted(Computed):
    """A tower in another format.

    >>> import towermodes as tm
    >>> converted = tm.read("examples/nrel-5mw.toml").convert("bmodes", sections_file="s.dat")
    >>> name, sections = converted.companion
    >>> name
    's.dat'
    """

    __slots__ = ()

    _compute = _rust.Converted
    _maker = "Tower.convert"
    _core: _rust.Converted

    @property
    def text(self) -> str:
        """The text of the file."""
        return self._core.text

    @property
    def companion(self) -> tuple[str, str] | None:
        """Name and text of the second file; only a BModes deck has one."""
        return self._core.companion

    @property
    def notes(self) -> list[str]:
        """Data that the format cannot store, and the notes of the tower."""
        return self._core.notes

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the file, and beside it the second file of a BModes deck."""
        if self.companion is not None:
            name, text = self.companion
            _write(os.path.join(os.path.dirname(os.fspath(path)), name), text)
        _write(path, self.text)

    def __repr__(self) -> str:
        lines = self.text.count("\n")
        notes = "".join(f"\nnote: {note}" for note in self.notes)
        return f"<Converted: {lines} lines>{notes}"


def _write(path: str | os.PathLike[str], text: str) -> None:
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
