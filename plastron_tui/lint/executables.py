"""Which files of nodes an executable, a component or a nodelet of a launch file is made of."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from functools import cached_property
from pathlib import Path

from plastron_tui.ros.launch import loaded_nodelet
from plastron_tui.ros.launch_started import Started

from .joined import joined
from .tree import PackageFacts, SourceTree, UnitFacts, once_a_tree


class Executables:
    """Finds the files of nodes that launch files start."""

    def __init__(self, tree: SourceTree) -> None:
        """Remember the files of each package by their names, and by the classes of their nodes."""
        self._tree = tree
        self._by_file: dict[tuple[Path, str], list[UnitFacts]] = defaultdict(list)
        self._by_class: dict[tuple[Path, str], list[UnitFacts]] = defaultdict(list)
        for unit in tree.built:
            package = tree.package_of(unit)
            if package is None:
                continue
            self._by_file[package.folder, unit.path.name].append(unit)
            for class_name in {node.class_name for node in unit.nodes if node.class_name}:
                self._by_class[package.folder, class_name].append(unit)

    def is_alone(self, started: Started, unit: UnitFacts) -> bool:
        """Tell whether nothing else is built into what a launch file starts than these files.

        What a program of C++ is linked with may create endpoints of its nodes as well, which is
        likely where its own source has none.
        """
        if unit.is_python:
            return True
        package = self._tree.package_of(unit)
        executables = {} if package is None else package.executables
        known = executables.get(started.executable) or next(
            (each for each in executables.values() if each.loaded == started.executable), None
        )
        has_endpoints = any(
            endpoint.kind.facts.interface is not None
            for node in unit.nodes
            for endpoint in node.endpoints
        )
        if known is None or package is None or not has_endpoints:
            return False
        read = {package.folder / each for each in known.sources} & self._tree.by_path.keys()
        return len(known.sources) == 1 or (
            unit.path in self.programs and len(read) == len(known.sources)
        )

    def started(self, started: Started) -> UnitFacts | None:
        """Return the files of what a launch file starts, None where that is not known."""
        name, file = started.executable, started.file
        package = self._tree.package(started.package, file)
        nodelet = loaded_nodelet(started.package, dict(started.others).get("args", ""))
        if nodelet is not None:
            name = nodelet
            package = self._tree.package(nodelet.partition("/")[0], file)
        return None if package is None else self.find(package, name)

    def find(self, package: PackageFacts, name: str) -> UnitFacts | None:
        """Return the files that an executable of a package is made of, None for unknown ones.

        Args:
            package: the package.
            name: what starts it, or the class of a component (`demo::Talker`) or a nodelet
                (`demo/Talker`).
        """
        if "::" in name or "/" in name:
            return self._of_class(package, name)
        known = package.executables.get(name)
        if known is None:
            # `rosrun` starts any file of a package that may be executed, installed or not.
            is_found = 1 in package.ros_versions
            return _only(self._by_file[package.folder, name]) if is_found else None
        return self._made_of(package, [known.file] if known.file is not None else known.sources)

    def _of_class(self, package: PackageFacts, name: str) -> UnitFacts | None:
        for each in package.executables.values():
            if each.loaded == name:
                return self._made_of(package, each.sources)
        return _only(self._by_class[package.folder, re.split("::|/", name)[-1]])

    def sources(self, started: Started) -> list[UnitFacts]:
        """Return the files of nodes among the sources of what a launch file starts."""
        package = self._tree.package(started.package, started.file)
        if package is None:
            return []
        name, known = started.executable, package.executables
        found = known.get(name) or next((x for x in known.values() if x.loaded == name), None)
        return [] if found is None else self._units(package, found.sources)

    def _made_of(self, package: PackageFacts, files: Iterable[str]) -> UnitFacts | None:
        units = self._units(package, files)
        return _only(units) or joined(units)

    def _units(self, package: PackageFacts, files: Iterable[str]) -> list[UnitFacts]:
        by_path = self._tree.by_path
        paths = {package.folder / each for each in files}
        return [by_path[path] for path in sorted(paths) if path in by_path]

    @cached_property
    def programs(self) -> dict[Path, UnitFacts]:
        """The programs of several sources that are one node, by the source with their `main`."""
        packages = self._tree.packages.values()
        executables = ((each, one) for each in packages for one in each.executables.values())
        found = (
            self._made_of(package, one.sources)
            for package, one in executables
            if len(one.sources) > 1
        )
        by_path = self._tree.by_path
        return {
            each.path: each for each in found if each is not None and each is not by_path[each.path]
        }

    @cached_property
    def parts(self) -> frozenset[Path]:
        """The sources of those programs that only add to the node which another one starts."""
        return (
            frozenset(
                unit.path_of(endpoint)
                for unit in self.programs.values()
                for node in unit.nodes
                for endpoint in node.endpoints
            )
            - self.programs.keys()
        )


@once_a_tree
def executables_of(tree: SourceTree) -> Executables:
    """Return what finds the files of nodes of a workspace, the same for all who ask."""
    return Executables(tree)


def _only(units: list[UnitFacts]) -> UnitFacts | None:
    return units[0] if len(units) == 1 else None
