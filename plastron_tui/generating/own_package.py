"""The package that a program's nodes are in where they have to be built, and no statement has one.

The output folder is that package; where the program writes other packages besides, it is a folder
beside them, for neither catkin nor colcon looks for packages in a package.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.model.packages import SCRIPTS_FOLDER
from plastron_tui.model.workspace import Generation, Home, Workspace
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.package_keys import is_ros_package
from plastron_tui.ros.packages import (
    check_package_name,
    mended_package_name,
    taken_package_name,
)
from plastron_tui.targets.packages.spec import PackageSpec

from .package_spec import packaged_node

if TYPE_CHECKING:
    from collections.abc import Callable

    from plastron_tui.model.launches import Launch
    from plastron_tui.targets.base import Target

    from .apply_changes import Library
    from .generation import Generated

_USUAL_NAME = "robot_nodes"
"""What the package of a program is called whose own name cannot be a package's."""


def package_name(program: str, is_other: Callable[[str], bool] = lambda _: False) -> str:
    """Return the name of a program's own package, by that of the program's file.

    Args:
        program: the name of the file, "" where it has none.
        is_other: tells whether another package has a name.
    """
    stem = PurePath(program).stem
    name = stem if check_package_name(stem) is None else mended_package_name(stem) or _USUAL_NAME
    is_taken = taken_package_name(name) is not None
    is_taken = (
        is_taken or is_other(name) or any(is_ros_package(name, version, ()) for version in (1, 2))
    )
    return f"{name}_nodes" if is_taken else name


class Around(NamedTuple):
    """A package that the output folder is, or is in.

    Attributes:
        name: its name.
        above: where it is from the output folder: `.`, `..`.
    """

    name: str
    above: str


class OwnPackages:
    """Where the nodes of a program are that are in none of the packages that it names."""

    def __init__(
        self,
        program: str,
        generations: Iterable[Generation],
        workspace: Workspace | None,
        target_of: Callable[[str], Target | None],
        *,
        in_place: bool,
        around: Callable[[], Around | None] = lambda: None,
        is_other: Callable[[str], bool] = lambda _: False,
    ) -> None:
        """Set what it follows from.

        Args:
            program: the name of the program's file, "" where it has none.
            generations: all that the program generates.
            workspace: what the program built, None while it is interpreted.
            target_of: gives the target of a client library.
            in_place: whether a loaded node is written over the file that it came from.
            around: finds the package that the output folder is, or is in, unless the program has
                made it.
            is_other: tells whether another package has a name.
        """
        self._target_of = target_of
        self._in_place = in_place
        self._name = package_name(program, is_other)
        # There may be thousands of nodes, and few libraries.
        targets = {name: target_of(name) for name in {each.library for each in generations}}
        built = {
            name: target.ros_version
            for name, target in targets.items()
            if target is not None and target.language.is_built
        }
        free = (each for each in generations if each.library in built and self._is_free(each))
        versions = {built[each.library] for each in free}
        self._versions = frozenset(versions)
        is_alone = workspace is None or not (workspace.written_packages or workspace.types)
        self._is_output = len(versions) < 2 and is_alone
        self._around = around() if versions else None

    def _is_free(self, generation: Generation) -> bool:
        """Tell whether a node is in no package, and is not written where it comes from."""
        node = generation.node
        return node.home is None and not (self._in_place and node.source is not None)

    @property
    def are_any(self) -> bool:
        """Whether a node has to be in one."""
        return bool(self._versions)

    def placed(self, generation: Generation) -> Generation:
        """Return what is asked for, with the package that the node has to be in."""
        target = self._target_of(generation.library)
        if target is None or not self._is_free(generation):
            return generation
        version, is_built = target.ros_version, target.language.is_built
        if not is_built and version not in self._versions:
            return generation
        node = generation.node.snapshot()
        around = self._around
        if around is not None and is_built:
            node.home = Home(
                around.name, node.name, is_own=True, is_output=True, above=around.above
            )
            return generation._replace(node=node)
        if around is not None:
            return generation
        name = self._name if len(self._versions) < 2 else f"{self._name}_ros{version}"
        folder = None if is_built else SCRIPTS_FOLDER
        node.home = Home(name, node.name, folder, is_own=True, is_output=self._is_output)
        return generation._replace(node=node)


def own_specs(
    made: Sequence[Generated],
    generations: Iterable[Generation],
    libraries: Mapping[str, Library],
) -> Iterator[tuple[str, PackageSpec]]:
    """Yield a program's own packages, each with the way to it from the output folder.

    One of which a node is not made, or cannot be written, is left out.

    Args:
        made: the files of the nodes that the program generates.
        generations: all that it generates, each with its place.
        libraries: the client libraries, by name.
    """
    by_variable = {
        (asked.node.variable, asked.library): each
        for each in made
        for asked in (*each.earlier, each.generation)
    }
    packages: dict[tuple[str, str], dict[tuple[str, str], Generation]] = {}
    for each in generations:
        if (place := _place(each)) is not None:
            packages.setdefault(place, {})[each.node.variable, each.library] = each
    for (folder, name), asked in packages.items():
        found = [by_variable.get(key) for key in asked]
        whole = [each for each in found if each is not None and each.files is not None]
        if len(whole) == len(found):
            # What the program creates, loads and generates again is one node.
            nodes = {id(each): each for each in whole}
            yield folder, _spec(name, list(nodes.values()), libraries)


def own_places(
    generations: Iterable[Generation], libraries: Mapping[str, Library]
) -> dict[int, str]:
    """Return the way to a program's own package from the output folder, by generation of ROS.

    It ends in a slash where it leads anywhere.
    """
    return {
        libraries[each.library].target.ros_version: place[0]
        for each in generations
        if each.library in libraries and (place := _place(each)) is not None
    }


def _place(generation: Generation) -> tuple[str, str] | None:
    """Return the way to the program's own package that a node is in, and its name."""
    home = generation.node.home
    if home is None or not home.is_own or home.above is not None:
        return None
    return "" if home.is_output else f"{home.package}/", home.package


def homes_of(made: Sequence[Generated], generations: Iterable[Generation]) -> dict[str, Home]:
    """Return where the nodes of a program's own packages are, by variable.

    Args:
        made: the files of the nodes that the program generates.
        generations: all that it generates, each with its place.
    """
    placed = {(x.node.variable, x.library): x.node.home for x in generations}
    found = {}
    for each in made:
        home = placed.get((each.generation.node.variable, each.generation.library))
        if home is not None and home.is_own and each.files is not None:
            executable = PurePath(each.files.name).stem
            found[each.generation.node.variable] = home._replace(executable=executable)
    return found


def with_homes(launch: Launch, homes: Mapping[str, Home]) -> Launch:
    """Return a launch file whose nodes are where the program's own packages have them."""
    starts = {}
    for name, start in launch.starts.items():
        node = start.node
        if node is not None and node.home is None and node.variable in homes:
            node = node.snapshot()
            node.home = homes[node.variable]
        starts[name] = start._replace(node=node)
    return replace(launch, starts=starts)


def _spec(name: str, made: Sequence[Generated], libraries: Mapping[str, Library]) -> PackageSpec:
    nodes = []
    for each in made:
        assert each.files is not None, "it can be written"
        stem = PurePath(each.files.name).stem
        nodes.append(packaged_node(stem, each, libraries, each.generation.span))
    target, catalog = libraries[nodes[0].library]
    return PackageSpec(
        name,
        target.ros_version,
        distribution=catalog.distribution,
        nodes=tuple(nodes),
        packages=frozenset(each for kind in InterfaceKind for each in catalog.packages(kind)),
        is_bare=True,
    )
