"""Pictures."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os


class Picture(str):
    """A picture: the text of an SVG file, which notebooks show.

    >>> import towermodes as tm
    >>> picture = tm.read("examples/nrel-5mw.toml").plot()
    >>> picture[:4]
    '<svg'
    """

    __slots__ = ()

    def _repr_svg_(self) -> str:
        return str(self)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the picture to a file whose name ends with .svg.

        Raises:
            ValueError: The name ends with that of another format.
        """
        from os import fspath

        ending = fspath(path).rpartition(".")[2].lower()
        if ending in ("png", "pdf", "jpg", "jpeg", "eps", "ps", "gif"):
            message = f"a picture is SVG, but the name ends with .{ending}; save it with the \
ending .svg (the program writes PNG: towermodes plot)"
            raise ValueError(message)
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(self)
