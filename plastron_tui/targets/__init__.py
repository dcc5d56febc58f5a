"""The client libraries that Plastron writes, and the languages that node files are in.

A target is loaded when it is first asked for. Those of other distributions register under the
entry point group `plastron.targets`, which is looked at only for names that are not Plastron's
own, since listing entry points is slow.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.model.libraries import ClientLibrary, Libraries
from plastron_tui.model.source import FileSet
from plastron_tui.sources import find_language, own_languages

if TYPE_CHECKING:
    from plastron_tui.sources.base import Language, ReadResult

    from .base import Target


class _Own(NamedTuple):
    """A client library of Plastron's own, and where its target is.

    Attributes:
        ros_version: the generation of ROS that it is for.
        language: the language of its nodes.
        target: the module and the class that write them.
        is_loaded: whether another process loads its nodes.
        purpose: what its nodes are and when to take it, in a phrase.
        built_with: the packages without which its nodes cannot be built and started.
    """

    ros_version: int
    language: str
    target: str
    is_loaded: bool = False
    purpose: str = ""
    built_with: tuple[str, ...] = ()


_SCRIPT = "a script: quick to write and to change, and started without a build"
_PROGRAM = "a program that is built: for images, point clouds, fast loops"
_SHARED = "several in one process pass large messages without a copy"

_INTERPRETER = re.compile(rb"#![^\r\n]*\bpython")

_CPP = "plastron_tui.targets.cpp"

_OWN = {
    "rospy": _Own(1, "python", "plastron_tui.targets.python.rospy:RospyTarget", purpose=_SCRIPT),
    "rclpy": _Own(2, "python", "plastron_tui.targets.python.rclpy:RclpyTarget", purpose=_SCRIPT),
    "roscpp": _Own(
        1,
        "cpp",
        f"{_CPP}.roscpp:RoscppTarget",
        purpose=_PROGRAM,
        built_with=("roscpp",),
    ),
    "nodelet": _Own(
        1,
        "cpp",
        f"{_CPP}.nodelet:NodeletTarget",
        is_loaded=True,
        purpose=f"a class that a manager loads: {_SHARED}",
        built_with=("roscpp", "nodelet"),
    ),
    "rclcpp": _Own(
        2,
        "cpp",
        f"{_CPP}.rclcpp:RclcppTarget",
        purpose=_PROGRAM,
        built_with=("rclcpp",),
    ),
    "component": _Own(
        2,
        "cpp",
        f"{_CPP}.component:ComponentTarget",
        is_loaded=True,
        purpose=f"a class that a container loads, or a program of its own: {_SHARED}",
        built_with=("rclcpp", "rclcpp_components"),
    ),
}


class _Libraries(Libraries):
    """The names that are known to Plastron, then those of other distributions."""

    def __getitem__(self, name: str) -> ClientLibrary:
        own = _OWN.get(name)
        if own is not None:
            language = find_language(own.language)
            return ClientLibrary(
                name,
                own.ros_version,
                language.title,
                language.is_keyword,
                language.is_built,
                own.is_loaded,
                own.purpose,
                own.built_with,
            )
        target = find_target(name)
        if target is None:
            raise KeyError(name)
        language = target.language
        return ClientLibrary(
            name,
            target.ros_version,
            language.title,
            language.is_keyword,
            language.is_built,
        )

    def __contains__(self, name: object) -> bool:
        return name in _OWN or (isinstance(name, str) and has_target(name))

    def __iter__(self) -> Iterator[str]:
        yield from _OWN
        from .plugins import registered

        yield from (name for name in registered() if name not in _OWN)

    def __len__(self) -> int:
        return sum(1 for _ in self)


LIBRARIES: Libraries = _Libraries()
"""The client libraries that a program may name.

To ask for one of Plastron's own costs little. To list them, or to ask whether there is another,
goes on to what is installed; to ask for another loads it.
"""


def find_target(name: str, template_folder: Path | None = None) -> Target | None:
    """Return the target of a client library, None when there is none of that name.

    A target of another distribution that cannot be loaded, or that fails, says so.

    Args:
        name: the client library, such as `rospy`.
        template_folder: a folder of the user's own templates, with a folder for each library.
    """
    own = _OWN.get(name)
    if own is None:
        from .plugins import make_target

        return make_target(name, template_folder)
    module, attribute = own.target.split(":")
    target: Target = getattr(import_module(module), attribute)(template_folder)
    return target


def ros_version(name: str) -> int:
    """Return the generation of ROS of a client library; 1 for a name that means none."""
    return LIBRARIES[name].ros_version if name in LIBRARIES else 1


def has_target(name: str) -> bool:
    """Tell whether there is a target of a client library, without loading it."""
    if name in _OWN:
        return True
    from .plugins import registered

    return name in registered()


def languages() -> Iterator[Language]:
    """Yield the languages that node files are in: Plastron's own, then those of other targets.

    Which others there are is looked for only where one goes on.
    """
    yield from own_languages()
    from .plugins import registered

    seen: set[tuple[str, ...]] = {()}
    for name in registered():
        target = None if name in _OWN else find_target(name)
        if target is not None and target.language.suffixes not in seen:
            seen.add(target.language.suffixes)
            yield target.language


def language_of(path: Path, text: bytes = b"") -> Language | None:
    """Return the language of a file, None for no language of a node.

    Its suffix tells it, or, of a file without one, its first line, where the text is given.
    """
    if not path.suffix and _INTERPRETER.match(text):
        return _script()
    return next((each for each in languages() if path.suffix in each.suffixes), None)


def read_source(path: Path, files: FileSet) -> ReadResult:
    """Read a node's source files, whichever client library they use."""
    return _reading(path).read(path, files)


def files_of(path: Path, text: bytes, read: Callable[[Path], bytes | None]) -> FileSet:
    """Return a file's text with those of the files that are read and changed together with it.

    Args:
        path: the file.
        text: what it holds.
        read: returns another file's text, None where there is no such file.
    """
    return FileSet.gather(path, text, _reading(path).others(path, text), read)


def _reading(path: Path) -> Language:
    """Return what reads a file; one whose suffix tells nothing counts as a script."""
    return language_of(path) or _script()


def _script() -> Language:
    return next(each for each in own_languages() if each.is_script)
