"""Which files of nodes an executable, a component or a nodelet of a launch file is made of."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable
from functools import cached_property
from pathlib import Path

from plastron_tui.model.package_source import InstalledExecutable
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
        known = None if package is None else _known(package, _loaded_name(started))
        has_endpoints = any(
            endpoint.kind.facts.interface is not None
            for node in unit.nodes
            for endpoint in node.endpoints
        )
        if known is None or package is None or not has_endpoints:
            return False
        if unit.ros_version == 2 and [each.class_name for each in unit.nodes] == [
            _class_name(known.loaded)
        ]:
            # What else is in its library gets nothing of the node.
            return True
        read = {package.folder / each for each in known.sources} & self._tree.by_path.keys()
        return len(known.sources) == 1 or (
            unit.path in self.programs and len(read) == len(known.sources)
        )

    def started(self, started: Started) -> UnitFacts | None:
        """Return the files of what a launch file starts, None where that is not known."""
        name = _loaded_name(started)
        is_nodelet = name != started.executable
        of = name.partition("/")[0] if is_nodelet else started.package
        package = self._tree.package(of, started.file)
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
        if known.loaded:
            return self._of_class(package, known.loaded)
        return self._made_of(package, [known.file] if known.file is not None else known.sources)

    def _of_class(self, package: PackageFacts, name: str) -> UnitFacts | None:
        known, class_name = _known(package, name), _class_name(name)
        units = self._by_class[package.folder, class_name]
        if known is not None and known.sources:
            paths = {package.folder / each for each in known.sources}
            units = [unit for unit in units if unit.path in paths]
            if not units:
                made = self._made_of(package, known.sources)
                is_sure = made is not None and (len(paths) == 1 or _has_no_class(made))
                return made if is_sure else None
        # Others have the class from a header, or load it; its own source says what it is for.
        own = [unit for unit in units if unit.library == "component"] or units
        unit = _only(own) or _only([each for each in own if _creates(each, class_name)])
        return None if unit is None else _only_class(unit, class_name)

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


def _loaded_name(started: Started) -> str:
    """Return what a launch file starts, or the class of the nodelet that it lets a node load."""
    arguments = dict(started.others).get("args", "")
    return loaded_nodelet(started.package, arguments) or started.executable


def _known(package: PackageFacts, name: str) -> InstalledExecutable | None:
    """Return what the build says of an executable, or of a class that is loaded."""
    return package.executables.get(name) or package.loaded.get(name)


def _class_name(name: str) -> str:
    return re.split("::|/", name)[-1]


def _has_no_class(unit: UnitFacts) -> bool:
    return all(each.class_name is None for each in unit.nodes)


def _creates(unit: UnitFacts, class_name: str) -> bool:
    """Tell whether a file creates endpoints of the nodes of a class."""
    return any(
        endpoint.kind.facts.interface is not None
        for node in unit.nodes
        if node.class_name == class_name
        for endpoint in node.endpoints
    )


def _only_class(unit: UnitFacts, class_name: str) -> UnitFacts:
    """Return a file of several nodes with the one alone that is of a class."""
    at = [at for at, node in enumerate(unit.nodes) if node.class_name == class_name]
    if len(at) != 1 or len(unit.nodes) == 1:
        return unit
    parameters = unit.code.parameters[at[0] : at[0] + 1]
    return unit._replace(nodes=(unit.nodes[at[0]],), code=unit.code._replace(parameters=parameters))


def _only(units: list[UnitFacts]) -> UnitFacts | None:
    return units[0] if len(units) == 1 else None
