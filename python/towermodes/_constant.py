"""Values that cannot be changed, like the results and towers that contain them."""

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any, NoReturn

    Base = dict[str, Any]
else:
    Base = dict


class Constant(Base):
    """A dict that cannot be changed, because a change would have no effect on the tower or result.

    `dict(...)`, `copy` and `pickle` make an ordinary dict from it.

    >>> import towermodes as tm
    >>> tower = tm.read("examples/nrel-5mw.toml")
    >>> tower.parameters["rna.mass"] = 360e3
    Traceback (most recent call last):
    TypeError: a tower does not change; tower.with_({"rna.mass": 360e3}) makes another one
    """

    __slots__ = ("_refusal",)

    def __init__(self, values: dict[str, Any], refusal: str) -> None:
        super().__init__(values)
        self._refusal = refusal

    def _refuse(self, *_: object, **__: object) -> NoReturn:
        raise TypeError(self._refusal)

    __setitem__ = __delitem__ = __ior__ = _refuse
    clear = pop = popitem = setdefault = update = _refuse

    def __reduce__(self) -> tuple[object, ...]:
        return (dict, (dict(self),))


def constant(value: Any) -> Any:
    """A value with its arrays as arrays that cannot be written; a pickle does not keep this."""
    if hasattr(value, "flags"):
        value.flags.writeable = False
    elif isinstance(value, dict):
        for one in value.values():
            constant(one)
    elif isinstance(value, (list, tuple)):
        for one in value:
            constant(one)
    return value
