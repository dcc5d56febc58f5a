"""The components of a package, as a container finds them (documentation of rclcpp_components)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.model.package_facts import Place
from plastron_tui.model.package_source import InstalledExecutable, PackageSource
from plastron_tui.sources.cmake.reader import Call, CMakeLists
from plastron_tui.sources.cmake.shared_reading import read_shared
from plastron_tui.sources.cmake.variables import Item
from plastron_tui.sources.packages.reading import CMAKE_LISTS
from plastron_tui.sources.splices import line_number

from .built_sources import BuiltSources

_WORDS = frozenset({"PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX"})


def component_classes(lists: CMakeLists) -> frozenset[str] | None:
    """Return the classes that are registered, None where one of them is computed."""
    found = {each.value for _, each in _registered(lists)}
    return None if any("$" in each for each in found) else frozenset(found)


def registered_again(lists: CMakeLists) -> Iterator[tuple[str, Place]]:
    """Yield the classes that are registered once more, where another one may be meant."""
    seen: set[str] = set()
    for each in sorted((each for _, each in _registered(lists)), key=lambda x: x.argument.start):
        if each.value in seen:
            yield each.value, Place(CMAKE_LISTS, Span(each.argument.start, each.argument.end))
        seen.add(each.value)


class Programs(NamedTuple):
    """What a package has for people to start, and for containers and managers to load.

    Attributes:
        executables: what is started, by its name, with the sources of each.
        loaded: what is loaded, by its class.
    """

    executables: Mapping[str, InstalledExecutable]
    loaded: Mapping[str, InstalledExecutable]


def programs_of(source: PackageSource) -> Programs:
    """Return the programs and classes of a package, each with the files that it is built from.

    A class that is registered for two libraries is left out: which one is loaded is not known.
    """
    text = source.texts.get(CMAKE_LISTS)
    lists = None if text is None else read_shared(text, source.folder / CMAKE_LISTS).lists
    if text is None or lists is None or source.build_type == "ament_python":
        return Programs(dict(source.executables), dict(source.plugins))
    sources = BuiltSources(lists, source.names)
    executables = {
        name: each._replace(sources=sources.of(each.built) or each.sources)
        for name, each in source.executables.items()
    }
    registered = [(call.items[0].value, each) for call, each in _registered(lists)]
    counts = Counter(item.value for _, item in registered)
    loaded = dict(source.plugins)
    for library, item in registered:
        if counts[item.value] == 1 and "$" not in item.value:
            line, files = line_number(text, item.argument.start), sources.of(library)
            loaded[item.value] = InstalledExecutable(
                None, CMAKE_LISTS, line, sources=files, built=library, loaded=item.value
            )
    return Programs(executables, loaded)


def _registered(lists: CMakeLists) -> Iterator[tuple[Call, Item]]:
    for call in lists.named("rclcpp_components_register_node"):
        for item in call.section("PLUGIN", _WORDS):
            yield call, item
    for call in lists.named("rclcpp_components_register_nodes"):
        for item in call.section("", _WORDS)[1:]:
            yield call, item
