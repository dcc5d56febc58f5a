"""Which files the programs and libraries of a CMakeLists.txt are built from.

Sources: `add_library`, `target_sources` and `target_link_libraries` of CMake's manual, and the
macros of ament_cmake_auto, whose `DIRECTORY` takes the sources of folders.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from plastron_tui.sources.build_files import matches
from plastron_tui.sources.cmake.facts import Entry, sources_of, targets
from plastron_tui.sources.cmake.reader import Call, CMakeLists, in_package

_ENDINGS = (".c", ".cc", ".cpp", ".cxx")
_WORDS = frozenset({"INTERFACE", "LINK_PRIVATE", "LINK_PUBLIC", "PRIVATE", "PUBLIC", "SYSTEM"})


class BuiltSources:
    """Finds the sources of what a CMakeLists.txt builds."""

    def __init__(self, lists: CMakeLists, names: frozenset[str]) -> None:
        """Remember the sources of each target.

        Args:
            lists: the file.
            names: the files of the package, for patterns and folders.
        """
        self._names = names
        self._sources: dict[str, dict[str, None]] = defaultdict(dict)
        for target in targets(lists):
            self._add(target.what, target.call, sources_of(target))
        for call in lists.named("ament_auto_add_library"):
            if call.items:
                library = Entry(call.items[0].value, call.items[0], call)
                self._add(library.what, call, sources_of(library))
        for call in lists.named("target_sources"):
            if call.items:
                values = [in_package(x.value) for x in call.items[1:] if x.value not in _WORDS]
                self._add(call.items[0].value, call, values)

    def of(self, target: str) -> tuple[str, ...]:
        """Return the sources of a target, by their paths in the package; none of an unknown one."""
        return tuple(self._sources.get(target, ()))

    def _add(self, target: str, call: Call, values: list[str]) -> None:
        patterns = {in_package(each.value) for each in call.items if each.is_pattern}
        is_folder = call.command.name.startswith("ament_auto_") and "DIRECTORY" in values
        for value in values:
            if value in patterns:
                found = [each for each in self._names if matches(each, value)]
            elif is_folder:
                found = list(self._within(value))
            else:
                found = [value]
            self._sources[target].update(dict.fromkeys(sorted(found)))

    def _within(self, folder: str) -> Iterator[str]:
        inner = folder.removeprefix("./").rstrip("/")
        for each in self._names:
            if each.rpartition("/")[0] == inner and each.endswith(_ENDINGS):
                yield each
