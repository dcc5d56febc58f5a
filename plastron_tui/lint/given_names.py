"""Names of topics and services that are values of parameters: what gives them, and which.

A name is known where each launch file that starts the node says for sure what the parameter is,
or sets it in no way: then it has the default of the code. So it has in a node that none starts.
"""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path

from plastron_tui.model.source import OWN_NAME, SourceEndpoint, SourceNode
from plastron_tui.ros.launch_started import Started, Unresolved
from plastron_tui.ros.names import check_topic_name, spelled

from .tree import LaunchFacts, SourceTree, UnitFacts, once_a_tree

UNKNOWN = ""
"""The value of a parameter that may be set to something that is not known."""

Values = tuple[tuple[str, str | None], ...]
"""The parameters that name endpoints of a node, each with its value, None for the default."""


def asked_of(node: SourceNode) -> tuple[str, ...]:
    """Return the parameters that name endpoints of a node."""
    found = (each.given_by for each in node.endpoints if each.given_by not in (None, OWN_NAME))
    return tuple(dict.fromkeys(each for each in found if each is not None))


def named(
    endpoint: SourceEndpoint, values: Mapping[str, str | None], ros_version: int
) -> str | None:
    """Return the name of an endpoint that something gives it, None where it is not known."""
    if endpoint.given_by == OWN_NAME:
        return OWN_NAME
    value = UNKNOWN if endpoint.given_by is None else values.get(endpoint.given_by, UNKNOWN)
    name = endpoint.default if value is None else spelled(value)
    return name if name and check_topic_name(name, ros_version) is None else None


class GivenNames:
    """What launch files and parameter files of a workspace give for parameters."""

    def __init__(self, tree: SourceTree) -> None:
        """Look at each parameter file once."""
        self._tree = tree
        self._unresolved: dict[int, Mapping[object, list[Unresolved]]] = {}
        self._in_files: dict[str, set[str]] = defaultdict(set)
        for blocks in tree.parameter_files.values():
            for block in blocks:
                for key in block.keys:
                    self._in_files[key.name].add("*" if block.is_for_any else block.last)

    def by_hand(self, unit: UnitFacts, node: SourceNode) -> Values:
        """Return what parameters have in a node that no launch file starts."""
        asked = asked_of(node)
        if not asked or may_be_started_otherwise(self._tree, unit.package):
            return tuple((each, UNKNOWN) for each in asked)
        is_1 = unit.ros_version == 1
        return tuple((each, None if is_1 else self._may_have(node, each)) for each in asked)

    def _may_have(self, node: SourceNode, parameter: str) -> str | None:
        """Return None where no parameter file of the workspace may have a value for a node."""
        nodes = self._in_files.get(parameter, set())
        is_sure = not nodes or (node.name is not None and nodes.isdisjoint({"*", node.name}))
        return None if is_sure else UNKNOWN

    def launched(
        self, launch: LaunchFacts, started: Started, unit: UnitFacts, node: SourceNode
    ) -> Values:
        """Return what parameters have in a node that a launch file starts."""
        return tuple((each, self._value(launch, started, unit, each)) for each in asked_of(node))

    def _value(
        self, launch: LaunchFacts, started: Started, unit: UnitFacts, parameter: str
    ) -> str | None:
        name = parameter.removeprefix("~/")
        shared = {each.rpartition("/")[2] for each in launch.resolved.shared}
        is_open = not shared.isdisjoint({name, ""}) or self._is_open(launch, started, name)
        if is_open or _may_set(started, name, unit.ros_version):
            return UNKNOWN
        value: str | None = None
        for setting in started.settings:
            if isinstance(setting, str):
                value = UNKNOWN if self._may_be_in(setting, name, unit.ros_version) else value
            elif _plain(setting[0]) == name:
                value = setting[1] if isinstance(setting[1], str) else UNKNOWN
        for word in dict(started.others).get("args", "").split() if unit.ros_version == 1 else ():
            if word.startswith(f"_{name}:="):
                value = word.partition(":=")[2]
        return value

    def _is_open(self, launch: LaunchFacts, started: Started, parameter: str) -> bool:
        """Tell whether what is not known of a launch file may be a value of a parameter."""
        if id(launch) not in self._unresolved:
            found: dict[object, list[Unresolved]] = defaultdict(list)
            places = {(each.file, each.place) for each in launch.resolved.started}
            for each in launch.resolved.unresolved:
                place = each.file, each.place
                is_of_one = place in places
                if is_of_one or each.sets_parameters:
                    found[place if is_of_one else None].append(each)
            self._unresolved[id(launch)] = found
        unresolved = self._unresolved[id(launch)]
        own = unresolved.get((started.file, started.place), ())
        return any(
            not each.parameter or _plain(each.parameter) == parameter
            for each in (*own, *unresolved.get(None, ()))
        )

    def _may_be_in(self, file: str, parameter: str, ros_version: int) -> bool:
        blocks = self._tree.parameter_files.get(Path(os.path.normpath(file)))
        if blocks is None or ros_version == 1:
            return True
        return any(key.name == parameter for block in blocks for key in block.keys)


def _may_set(started: Started, parameter: str, ros_version: int) -> bool:
    """Tell whether what is said of a node and not taken apart may set a parameter."""
    if ros_version == 2:
        # Words of a list stand there without spaces between them.
        texts = (text for _, text in started.others)
        return any(f"{parameter}:=" in text or "--params-file" in text for text in texts)
    kinds = (key.partition(" ") for key, _ in started.others)
    return any(
        kind == "rosparam" or (kind == "param" and _plain(name) in ("", parameter))
        for kind, _, name in kinds
    )


def _plain(parameter: str) -> str:
    return parameter.removeprefix("~").removeprefix("/")


@once_a_tree
def given_names_of(tree: SourceTree) -> GivenNames:
    """Return what gives names in a workspace."""
    return GivenNames(tree)


def may_be_started_otherwise(tree: SourceTree, package: str) -> bool:
    """Tell whether what is not known of a launch file may start a node of a package.

    It is looked for in the launch files of the package, and in those that start any of it.
    """
    for launch in tree.launches:
        if all(each.is_value for each in launch.resolved.unresolved):
            continue
        if any(each.package == package for each in launch.resolved.started):
            return True
        found = tree.packages.get(package)
        if found is not None and launch.path.is_relative_to(found.folder):
            return True
    return False
