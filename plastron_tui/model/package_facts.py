"""What the files of a package say of each other, as plain data: `lint`'s rules look at it.

All paths are from the package's folder, with slashes. What is computed, or hangs on a condition, is
left out, or said to be not known.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from enum import Enum
from types import MappingProxyType
from typing import NamedTuple

from plastron_tui.diagnostics import Span


class Place(NamedTuple):
    """Where something stands: a file of the package, and the bytes there."""

    file: str
    span: Span


class Declared(NamedTuple):
    """A dependency that a package.xml declares.

    Attributes:
        name: of a package, or a key of rosdep.
        tag: the tag that declares it.
        covers: what it is there for: `build`, `exec`, `test`, ….
        versions: the generations of ROS that it may hold for.
        is_plain: whether it has no condition.
        span: its name.
        line: the line of it, where that has nothing else, with its end; None else.
    """

    name: str
    tag: str
    covers: frozenset[str]
    versions: tuple[int, ...]
    is_plain: bool
    span: Span
    line: Span | None


class Used(NamedTuple):
    """What code that is run or built from a package needs of another one.

    Attributes:
        what: the full name of a module, or the path of a header as it is included.
        package: the package, where that is said itself: in a definition of a type; "" else.
        need: `exec` for a module, `build` for a header or a definition.
        place: the first place that names it.
        others: the first place in each further file that does.
        is_idle: whether nothing has what is imported or included of it by its name, so that these
            lines may be there for nothing.
    """

    what: str
    package: str
    need: str
    place: Place
    others: tuple[Place, ...] = ()
    is_idle: bool = False


class How(Enum):
    """How a script gets to where it is started from."""

    NOT = "not at all"
    PROGRAM = "as a program"
    PYTHON = "by `catkin_install_python`"
    PLAIN = "as a file that nobody may run"
    KEPT = "with the permissions that it has"
    SCRIPT = "as a console script"
    ELSEWHERE = "where no node is looked for"
    UNKNOWN = "in a way that is not followed"


INSTALLED = (How.PROGRAM, How.PYTHON, How.KEPT, How.PLAIN)
"""How a script gets to where people start it from, by itself."""


class Shebang(Enum):
    """What the first line of a script says about who runs it."""

    MISSING = "there is none"
    CARRIAGE_RETURN = "it ends with a carriage return"
    GOOD = "it names a program"


class Script(NamedTuple):
    """A file of Python that does something when it is started.

    Attributes:
        file: the file.
        main: what is done when it is started: `if __name__ == …`, or the function `main`.
        is_program: whether it asks for `__main__`, so that it can be started as a file.
        how: how it is installed.
        installed: what installs it.
        first: its first line.
        shebang: what that says.
        is_executable: whether the file's mode lets somebody run it.
        is_mentioned: whether another file of the package imports it, or names it.
        has_main: whether it has a function `main` that an entry point can name.
    """

    file: str
    main: Span
    is_program: bool
    how: How
    installed: Place | None
    first: Span
    shebang: Shebang
    is_executable: bool
    is_mentioned: bool
    has_main: bool = True


class Target(NamedTuple):
    """A program that CMake builds.

    Attributes:
        name: what CMake calls it.
        sources: what it is built from.
        place: what says so.
        is_installed: whether `ros2 run` finds it once it is installed, None where that is not sure.
        where: what installs it elsewhere, None where nothing does.
    """

    name: str
    sources: tuple[str, ...]
    place: Place
    is_installed: bool | None
    where: Place | None = None


class Entry(NamedTuple):
    """A console script that leads nowhere.

    Attributes:
        name: what it is started by.
        target: what it says, `MODULE:FUNCTION`.
        message: what is wrong.
        place: the part of it that is wrong, or all of it.
        remedy: what it should be, "" where that is not known.
        is_sure: whether the remedy is the only thing that can be meant.
        help: what to do about it, where no other name is meant.
    """

    name: str
    target: str
    message: str
    place: Place
    remedy: str = ""
    is_sure: bool = False
    help: str = ""


class ScriptFolder(NamedTuple):
    """Why `ros2 run` finds no console script, where that is said, and how it is mended."""

    message: str
    place: Place
    help: str


class DefinitionMistake(NamedTuple):
    """Something that keeps types from being built.

    Attributes:
        message: what is wrong.
        place: where.
        help: how it is mended.
        remedy: what is to be written there, "" where that is not known.
        other: the place that should say it, None for none.
        type: the name of the type that is not built, "" where it is something else.
        package: the package whose types the build is not told of, "" where it is something else.
        named: the packages that it is told of, which may bring that one along.
        is_taken_out: whether a comment among what is built has its name.
    """

    message: str
    place: Place
    help: str
    remedy: str = ""
    other: Place | None = None
    type: str = ""
    package: str = ""
    named: tuple[str, ...] = ()
    is_taken_out: bool = False


class BuildFacts(NamedTuple):
    """All of it.

    Attributes:
        build_type: `catkin`, `ament_python` or `ament_cmake`.
        name_span: the name in package.xml.
        format: that of package.xml: 1, 2 or 3.
        dependencies: what package.xml declares.
        has_groups: whether it depends on a group of packages as well.
        used: what its code needs of other packages and is not declared for that.
        mentioned: the dependencies that a file names besides those that build the package.
        near: the packages that code or a definition seems to name, each one slip from a dependency.
        found: the packages that CMake looks for, and where it is told to.
        finds_declared: whether CMake looks for whatever package.xml declares.
        linked: the dependencies that other commands of CMake name.
        exported: those that CMake hands on to whoever uses the package, `*` for all.
        has_code: whether the package has code at all.
        modules: the names that other packages import of it.
        has_headers: whether it has headers in a folder of its name.
        folders: the folders that it hands headers on from.
        scripts: files of Python that can be started.
        targets: programs that CMake builds.
        is_settled: whether the executables are known to be all.
        words: where they are not, the words that may be the name of another one, or a part of it;
            None where any name may be.
        files: the names of the package's files, and of links to programs, without their folders.
        components: the classes that a container finds in it, None where that is not known.
        registered_again: the classes that are registered once more, each with its place.
        placed: the names of the files that are installed where nodes are looked for, however.
        installs_nodes: whether nodes are installed at all.
        entries: console scripts that lead nowhere.
        script_folder: why `ros2 run` finds no console script, None where nothing speaks against it.
        definitions: what keeps types from being built.
    """

    build_type: str
    name_span: Span
    format: int = 3
    dependencies: tuple[Declared, ...] = ()
    has_groups: bool = False
    used: tuple[Used, ...] = ()
    mentioned: frozenset[str] = frozenset()
    near: frozenset[str] = frozenset()
    found: Mapping[str, Place] = MappingProxyType({})
    finds_declared: bool = False
    linked: frozenset[str] = frozenset()
    exported: frozenset[str] = frozenset()
    has_code: bool = False
    modules: frozenset[str] = frozenset()
    has_headers: bool = False
    folders: frozenset[str] = frozenset()
    scripts: tuple[Script, ...] = ()
    targets: tuple[Target, ...] = ()
    is_settled: bool = False
    words: frozenset[str] | None = frozenset()
    files: frozenset[str] = frozenset()
    components: frozenset[str] | None = None
    registered_again: tuple[tuple[str, Place], ...] = ()
    placed: frozenset[str] = frozenset()
    installs_nodes: bool = False
    entries: tuple[Entry, ...] = ()
    script_folder: ScriptFolder | None = None
    definitions: tuple[DefinitionMistake, ...] = ()

    def folders_installed(self, ways: Collection[How] = INSTALLED) -> frozenset[str]:
        """Return the folders from which something is installed for people to start.

        Args:
            ways: how a script is installed for that.
        """
        files = [each.file for each in self.scripts if each.how in ways]
        files += [file for each in self.targets if each.is_installed for file in each.sources]
        return frozenset(file.rpartition("/")[0] for file in files)
