"""The parameters of ROS 1 as the studio's monitor tells them: what the master keeps, by its type.

The master takes whatever XML-RPC can say (wiki.ros.org/Parameter Server).
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

_TYPES: dict[type, str] = {bool: "bool", int: "int", float: "float", str: "string"}


def rows_of(tree: dict[str, Any], around: str = "") -> Iterable[dict[str, Any]]:
    """Yield the parameters below a name as the master keeps them."""
    for name, value in sorted(tree.items()):
        path = f"{around}/{name}" if around else name
        if isinstance(value, dict):
            yield from rows_of(value, path)
            continue
        kind = kind_of(value)
        yield {
            "name": path, "value": value if kind else str(value),
            "type": kind, "range": None, "about": "", "is_read_only": False,
        }  # fmt: skip


def kind_of(value: object) -> str:
    """Return the type of a value as programs name it, "" for one that no form can hold.

    A list of whole and other numbers is one of numbers.
    """
    if not isinstance(value, list):
        return _TYPES.get(type(value), "")
    kinds = {_TYPES.get(type(each), "") for each in value}
    if kinds == {"int", "float"}:
        return "float_list"
    kind = kinds.pop() if len(kinds) == 1 else ""
    return f"{kind}_list" if kind else ""
