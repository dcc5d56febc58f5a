"""The components of a package, as a container finds them (documentation of rclcpp_components)."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Span
from plastron_tui.model.package_facts import Place
from plastron_tui.sources.cmake.reader import CMakeLists
from plastron_tui.sources.cmake.variables import Item
from plastron_tui.sources.packages.reading import CMAKE_LISTS

_WORDS = frozenset({"PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX"})


def component_classes(lists: CMakeLists) -> frozenset[str] | None:
    """Return the classes that are registered, None where one of them is computed."""
    found = {each.value for each in _registered(lists)}
    return None if any("$" in each for each in found) else frozenset(found)


def registered_again(lists: CMakeLists) -> Iterator[tuple[str, Place]]:
    """Yield the classes that are registered once more, where another one may be meant."""
    seen: set[str] = set()
    for each in sorted(_registered(lists), key=lambda each: each.argument.start):
        if each.value in seen:
            yield each.value, Place(CMAKE_LISTS, Span(each.argument.start, each.argument.end))
        seen.add(each.value)


def _registered(lists: CMakeLists) -> Iterator[Item]:
    for call in lists.named("rclcpp_components_register_node"):
        yield from call.section("PLUGIN", _WORDS)
    for call in lists.named("rclcpp_components_register_nodes"):
        yield from call.section("", _WORDS)[1:]
