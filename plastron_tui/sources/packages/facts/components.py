"""The components of a package, as a container finds them (documentation of rclcpp_components)."""

from __future__ import annotations

from plastron_tui.sources.cmake.reader import CMakeLists

_WORDS = frozenset({"PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX"})


def component_classes(lists: CMakeLists) -> frozenset[str] | None:
    """Return the classes that are registered, None where one of them is computed."""
    found: set[str] = set()
    for call in lists.named("rclcpp_components_register_node"):
        found.update(each.value for each in call.section("PLUGIN", _WORDS))
    for call in lists.named("rclcpp_components_register_nodes"):
        found.update(each.value for each in call.section("", _WORDS)[1:])
    return None if any("$" in each for each in found) else frozenset(found)
