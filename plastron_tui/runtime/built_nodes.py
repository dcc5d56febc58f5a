"""Nodes that packages build: their processes, and those that load them.

Sources: the wiki page "nodelet"; the guide "Composing multiple nodes in a single process" of ROS 2,
and the documentation of rclcpp_components.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from plastron_tui.regular_files import read_regular
from plastron_tui.ros.installations import Origin
from plastron_tui.sources.packages.files import package_files

from .build_needs import prefixes_of
from .build_output import Spans
from .builds import BuiltPackage
from .environment import Environment
from .launch import Loaded, NodeFile

LOADERS = {1: "nodelet", 2: "rclcpp_components"}
"""The package that loads nodes into a process of its own, in each generation of ROS."""

_LOADER = {1: "nodelet", 2: "component_container"}
_LARGEST = 4_000_000


class BuiltNode(NamedTuple):
    """A node that a package builds.

    Attributes:
        name: its name.
        package: the package.
        executable: what one starts it by.
        plugin: the class that it is loaded as, None for a program.
        arguments: what it is started with.
        namespace: the namespace that they put it in, "" for the root.
    """

    name: str
    package: str
    executable: str
    plugin: str | None = None
    arguments: tuple[str, ...] = ()
    namespace: str = ""


def read_package(name: str, folder: Path, spans: Mapping[str, Spans]) -> BuiltPackage:
    """Return a package as its folder has it, to be built.

    Args:
        name: its name.
        folder: where it is.
        spans: where the program says what its files say.
    """
    files: dict[str, bytes] = {}
    executables = set()
    for each in package_files(folder):
        path = folder / each
        if path.is_symlink():
            continue
        with suppress(OSError, ValueError):
            files[each] = read_regular(path, _LARGEST)
            if os.access(path, os.X_OK):
                executables.add(each)
    return BuiltPackage(name, files, frozenset(executables), spans, is_compiled=True)


def find_loader(environment: Environment, environ: Mapping[str, str] = os.environ) -> Path | None:
    """Return the program that loads nodes into its process, None where it is not installed."""
    version = environment.ros_version
    for prefix in (*environment.overlays, *prefixes_of(environment, environ)):
        path = prefix / "lib" / LOADERS[version] / _LOADER[version]
        if path.is_file() and os.access(path, os.X_OK):
            return path
    return None


def node_files(
    nodes: Iterable[BuiltNode], environment: Environment, loader: Path | None, name: str
) -> Iterator[NodeFile]:
    """Yield the processes of nodes; those that are loaded share one, which comes first.

    Args:
        nodes: the nodes.
        environment: the ROS that they run with; their packages are in its last overlay.
        loader: the program that loads nodes, needed where one is loaded.
        name: what that is called as a node.
    """
    listed = list(nodes)
    overlay = environment.overlays[-1]
    libraries = (("LD_LIBRARY_PATH", each) for each in _libraries(environment))
    folders = (*_folders(overlay, environment.ros_version), *libraries)
    plugins = [each for each in listed if each.plugin is not None]
    if plugins and loader is not None:
        yield from _loading(plugins, environment, loader, name, folders)
    for each in listed:
        if each.plugin is None:
            program = overlay / "lib" / each.package / each.executable
            yield NodeFile(
                each.name,
                (str(program),),
                environment,
                arguments=each.arguments,
                namespace=each.namespace,
                folders=folders,
            )


def _libraries(environment: Environment) -> Iterator[Path]:
    """Yield where programs find libraries that the Python packages bring: each sets up its own.

    They need that of Python itself, too.
    """
    if environment.origin is not Origin.EXTRA:
        return
    prefix = environment.python.parent.parent
    for each in prefixes_of(environment):
        yield each / "lib"
    yield from sorted(prefix.glob("lib/python3*/site-packages/*.libs"))
    yield environment.python.resolve().parent.parent / "lib"


def _folders(overlay: Path, version: int) -> tuple[tuple[str, Path], ...]:
    """Return what a process finds the packages of an overlay by."""
    if version == 2:
        return (("AMENT_PREFIX_PATH", overlay),)
    return ("ROS_PACKAGE_PATH", overlay / "share"), ("CMAKE_PREFIX_PATH", overlay)


def _loading(
    plugins: list[BuiltNode],
    environment: Environment,
    loader: Path,
    name: str,
    folders: tuple[tuple[str, Path], ...],
) -> Iterator[NodeFile]:
    if environment.ros_version == 2:
        words = ("--ros-args", "-r", f"__node:={name}")
        loaded = tuple(
            Loaded(each.name, each.package, each.plugin or "", each.arguments) for each in plugins
        )
        yield NodeFile(
            name, (str(loader),), environment, arguments=words, folders=folders, loads=loaded
        )
        return
    manager = (str(loader), "manager", f"__name:={name}")
    yield NodeFile(name, manager, environment, folders=folders, is_host=True)
    for each in plugins:
        plugin = f"{each.package}/{(each.plugin or '').rpartition('::')[2]}"
        # The manager is in no namespace, whatever that of the node is. It unloads by way of what
        # it has not any more where it ends while a bond breaks, and the run ends both anyway.
        load = (str(loader), "load", plugin, f"/{name}", "--no-bond", f"__name:={each.name}")
        yield NodeFile(
            each.name,
            load,
            environment,
            arguments=each.arguments,
            namespace=each.namespace,
            folders=folders,
        )
