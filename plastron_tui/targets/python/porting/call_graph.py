"""Which functions of a file come to certain calls, by themselves or through others of the file."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.grammars import is_inside
from plastron_tui.sources.python.scopes import Scope

from .port_state import Work, walk


def functions_that_reach(work: Work, calls: list[Node]) -> set[str]:
    """Return the names of the functions that make one of some calls, or call such a function."""
    scopes: list[Scope] = [each for each in work.analysis.scopes.all if each.kind == "function"]
    names: set[str] = set()
    count = -1
    while count != len(names):
        count = len(names)
        found = [each for each in scopes if reaches(work, each.node, calls, names)]
        names |= {each.name for each in found}
        # What an `__init__` does, the call of its class does.
        names |= {each.parent.name for each in found if each.parent and each.name == "__init__"}
    return names


def reaches(work: Work, place: Node, calls: list[Node], functions: set[str]) -> bool:
    """Tell whether one of some calls is in a place, or in a function that it calls."""
    if any(is_inside(each, place) for each in calls):
        return True
    callees = (node.child_by_field_name("function") for node in walk(place) if node.type == "call")
    return any(
        work.slice(each).rpartition(".")[2] in functions for each in callees if each is not None
    )
