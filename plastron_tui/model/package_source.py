"""What was read of a package that exists."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.ros.launch_names import launch_stem


class InstalledExecutable(NamedTuple):
    """Something that a package installs for people to start.

    Attributes:
        file: what is started, by its path in the package with slashes; None where it is computed.
        where: the file of the package that says so.
        line: the line there, from 1.
        target: the function that is called, `MODULE:FUNCTION`; "" where a file is started.
        sources: what it is built from, by paths in the package.
        built: what the build calls it; "" for what is not built.
        loaded: the class that a container loads it as besides; "" where that is not known.
    """

    file: str | None
    where: str
    line: int
    target: str = ""
    sources: tuple[str, ...] = ()
    built: str = ""
    loaded: str = ""


@dataclass(frozen=True, slots=True)
class PackageSource:
    """The files of a package that exists.

    All paths are from its folder, with slashes.

    Attributes:
        folder: where it is.
        name: what its package.xml calls it.
        ros_version: the generation of ROS that it is for.
        build_type: `catkin`, `ament_python` or `ament_cmake`, as its package.xml says.
        texts: what its files hold: package.xml, setup.py, CMakeLists.txt, and the code.
        executables: what it installs for people to start, by what they start it by.
        node_folder: the folder that its nodes are in, or that a first one belongs in; None where
            a node in Python can be in none.
        python_root: the folder that its Python packages are in.
        launches: its launch files.
        is_whole: whether all files of the package are among `texts` that may name another.
        script_file: the file that has the console scripts of an ament_python package.
        names: all its files, those too that are not read.
        plugins: the nodes that it builds for another process to load, by what loads them.
    """

    folder: Path
    name: str
    ros_version: int
    build_type: str
    texts: Mapping[str, bytes] = field(default_factory=dict)
    executables: Mapping[str, InstalledExecutable] = field(default_factory=dict)
    node_folder: str | None = None
    python_root: str = ""
    launches: tuple[str, ...] = ()
    is_whole: bool = True
    script_file: str = "setup.py"
    names: frozenset[str] = frozenset()
    plugins: Mapping[str, InstalledExecutable] = field(default_factory=dict)

    def module_of(self, file: str) -> str:
        """Return what Python calls a file of the package."""
        inner = file.removeprefix(f"{self.python_root}/") if self.python_root else file
        return inner.removesuffix(".py").replace("/", ".")

    def executable(self, name: str) -> str | None:
        """Return what starts an executable, which a program may name without `.py`."""
        return next((each for each in (name, f"{name}.py") if each in self.executables), None)

    def node(self, name: str) -> str | None:
        """Return what starts or loads a node; one that is loaded is called as its source too."""
        for key, each in self.plugins.items():
            stems = {file.rpartition("/")[2].rpartition(".")[0] for file in each.sources}
            if self.executable(name) is None and name in (key, *stems):
                return key
        return self.executable(name)

    def installed(self, key: str) -> InstalledExecutable:
        """Return an executable, or a node that another process loads.

        Raises:
            KeyError: there is none.
        """
        return self.executables[key] if key in self.executables else self.plugins[key]

    def launch(self, name: str) -> str | None:
        """Return the launch file that a program may name without its ending."""
        for file in self.launches:
            base = file.rpartition("/")[2]
            if name in (base, launch_stem(base)):
                return file
        return None


class LoadedPackage(NamedTuple):
    """What a reader made of a folder; None with the reason."""

    source: PackageSource | None
    diagnostics: tuple[Diagnostic, ...] = ()


PackageReader = Callable[[str, int], LoadedPackage]
"""Reads a folder; one that is for both generations of ROS counts for the given one."""


def no_package(source: str, ros_version: int) -> LoadedPackage:
    """Find no package, where nothing reads files."""
    del ros_version
    found = Diagnostic(codes.FILE_NOT_FOUND, f"no folder `{source}` beside the program")
    return LoadedPackage(None, (found,))
