"""Which Python packages a setup.py installs, and the folder that they are in.

From the page "Package Discovery and Namespace Packages" of the setuptools documentation: what
`find_packages` finds has an `__init__.py`, as has each package that it is in, and `package_dir`
names the folder of the packages by the key `""`.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from fnmatch import fnmatchcase
from typing import NamedTuple

from tree_sitter import Node

from .syntax import Setup
from .values import evaluate, items_of

_FINDERS = frozenset({"find_packages", "setuptools.find_packages"})
_PARAMETERS = ("where", "exclude", "include")


class Finder(NamedTuple):
    """A call of `find_packages`.

    Attributes:
        where: the folder that is searched, "" for that of the setup.py.
        exclude: the patterns of what is not taken.
        include: the patterns of what is.
    """

    where: str = ""
    exclude: tuple[str, ...] = ()
    include: tuple[str, ...] = ("*",)

    def find(self, names: Collection[str]) -> Iterator[str]:
        """Yield the packages among the files of a folder, in a steady order."""
        prefix = f"{self.where}/" if self.where else ""
        ending = "/__init__.py"
        folders = {
            each[len(prefix) : -len(ending)]
            for each in names
            if each.startswith(prefix) and each.endswith(ending)
        }
        for folder in sorted(each for each in folders if each):
            parts = folder.split("/")
            name = ".".join(parts)
            is_whole = all("/".join(parts[:end]) in folders for end in range(1, len(parts)))
            is_wanted = any(fnmatchcase(name, each) for each in self.include)
            if is_whole and is_wanted and not any(fnmatchcase(name, each) for each in self.exclude):
                yield name


def read_finder(setup: Setup, node: Node | None) -> Finder | None:
    """Return the call of `find_packages` that an expression is, as far as that is sure."""
    call = setup.resolve(node) if node is not None else None
    function = call.child_by_field_name("function") if call is not None else None
    arguments = call.child_by_field_name("arguments") if call is not None else None
    if function is None or arguments is None or setup.source(function) not in _FINDERS:
        return None
    given: dict[str, tuple[str, ...]] = {}
    for at, each in enumerate(items_of(arguments)):
        name: str | None = _PARAMETERS[at] if at < len(_PARAMETERS) else None
        value: Node | None = each
        if each.type == "keyword_argument":
            key = each.child_by_field_name("name")
            name = setup.source(key) if key is not None else None
            value = each.child_by_field_name("value")
        texts = _texts(setup, value)
        if name not in _PARAMETERS or texts is None:
            return None
        given[name] = texts
    where = given.get("where", ("",))
    if len(where) != 1:
        return None
    return Finder(_plain(where[0]), given.get("exclude", ()), given.get("include", ("*",)))


def read_root(setup: Setup, node: Node | None) -> str | None:
    """Return the folder that `package_dir` has for all packages, None where it names none."""
    found = setup.resolve(node) if node is not None else None
    if found is None or found.type != "dictionary":
        return None
    for each in items_of(found):
        key, value = each.child_by_field_name("key"), each.child_by_field_name("value")
        if key is None or value is None or evaluate(setup, key) != "":
            continue
        folder = evaluate(setup, value)
        return _plain(folder) if isinstance(folder, str) else None
    return None


def _texts(setup: Setup, node: Node | None) -> tuple[str, ...] | None:
    value = evaluate(setup, node) if node is not None else None
    values = value if isinstance(value, tuple) else (value,)
    texts = tuple(each for each in values if isinstance(each, str))
    return texts if len(texts) == len(values) else None


def _plain(folder: str) -> str:
    return folder.removeprefix("./").strip("/").removeprefix(".")
