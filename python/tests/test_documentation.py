"""The examples in docstrings and in all pages of the book run; every method has a docstring."""

from __future__ import annotations

import doctest
import importlib
import inspect
import pkgutil
from pathlib import Path

import pytest

import towermodes as tm

OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE | doctest.IGNORE_EXCEPTION_DETAIL
MODULES = sorted(
    module.name
    for module in pkgutil.iter_modules(tm.__path__, "towermodes.")
    if module.name not in ("towermodes._towermodes", "towermodes.__main__")
)
PAGES = [
    path
    for path in [Path("README.md"), *sorted(Path("book/src").rglob("*.md"))]
    if "\n>>> " in path.read_text("utf-8")
]


@pytest.mark.parametrize("name", ["towermodes", *MODULES])
def test_examples_of_docstrings(name: str) -> None:
    module = importlib.import_module(name)
    results = doctest.testmod(module, optionflags=OPTIONS, verbose=False)
    assert results.failed == 0


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_examples_of_the_book(page: Path) -> None:
    results = doctest.testfile(
        str(page.resolve()), module_relative=False, optionflags=OPTIONS, encoding="utf-8"
    )
    assert results.attempted > 0
    assert results.failed == 0


def test_every_public_member_has_a_docstring() -> None:
    classes = [getattr(tm, name) for name in tm.__all__ if inspect.isclass(getattr(tm, name))]
    for cls in classes:
        assert cls.__doc__, cls
        for name, member in vars(cls).items():
            if not name.startswith("_") and (callable(member) or isinstance(member, property)):
                assert member.__doc__, f"{cls.__name__}.{name}"
