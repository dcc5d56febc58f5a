"""What packages are built upon: the definitions that theirs are made of, libraries and tools."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path

from plastron_tui.regular_files import read_regular
from plastron_tui.ros.catalog.folders import TypeFolders, installed_folders
from plastron_tui.ros.installations import Origin
from plastron_tui.ros.interfaces import InterfaceKind

from .environment import Environment

DEBIAN_SHARE = Path("/usr/share")
"""Where Debian's ROS has its definitions."""

PREFIX_PATHS = ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH")

_LARGEST_DEFINITION = 1 << 20

# What each definition can be made of without naming it: `Header` alone is that of std_msgs
# (the wiki page "msg"), and tools add messages to services and actions.
_UNNAMED = ("std_msgs", "actionlib_msgs", "action_msgs", "service_msgs")

# What makes code of definitions; the files say which version it is.
_GENERATORS = ("genpy", "rosidl_generator_c", "rosidl_generator_py")

_TOOLS = ("colcon", "catkin_make", "cmake", "make", "cc", "c++")
_SETTINGS = ("CC", "CXX", "CFLAGS", "CXXFLAGS", "LDFLAGS")


def named_packages(definitions: Iterable[bytes]) -> set[str]:
    """Return the packages of which definitions name types, as `PACKAGE/TYPE`."""
    words = {
        line.split(maxsplit=1)[0].partition(b"/")
        for text in definitions
        for line in text.splitlines()
        if line.strip()
    }
    return {
        package.decode("utf-8", "replace")
        for package, slash, _ in words
        if slash and not package.startswith(b"#")
    }


def definitions_in(files: Mapping[str, bytes]) -> list[bytes]:
    """Return the definitions among the files of a package, which are given by their paths."""
    return [text for path, text in files.items() if path.startswith(("msg/", "srv/", "action/"))]


def tools(environment: Environment, environ: Mapping[str, str]) -> list[object]:
    """Return what changes with the ROS, the Python and the tools that packages are built with."""
    python = environment.python
    path = os.pathsep.join((environ.get("PATH", os.defpath), str(python.parent)))
    commands = [*_TOOLS, *(environ.get(name, "").partition(" ")[0] for name in ("CC", "CXX"))]
    found = {name: shutil.which(name, path=path) for name in commands if name}
    return [
        *(environment.words, str(python), _stamp(python)),
        {name: (place, _stamp(Path(place))) for name, place in found.items() if place is not None},
        {name: environ[name] for name in _SETTINGS if name in environ},
    ]


def built_upon(
    environment: Environment, packages: Iterable[Mapping[str, bytes]], environ: Mapping[str, str]
) -> list[object]:
    """Return what changes with the packages that others are made of, wherever those are found.

    Args:
        environment: what is to run the nodes.
        packages: the files of those that are built, by their paths.
        environ: the environment variables.
    """
    prefixes = [
        *map(str, environment.overlays),
        *(each for name in PREFIX_PATHS for each in environ.get(name, "").split(os.pathsep)),
        str(environment.python.parent.parent) if environment.origin is Origin.EXTRA else "",
    ]
    prefixes = list(dict.fromkeys(filter(None, prefixes)))
    shares = [Path(each, "share") for each in prefixes]
    if environment.origin is Origin.DEBIAN:
        shares.append(DEBIAN_SHARE)
    files: dict[str, list[Path]] = {}
    folders = TypeFolders((*shares, *installed_folders(environ, environment.ros_version)))
    for kind in InterfaceKind:
        for name in folders.names(kind):
            path = folders.file(name, kind)
            if path is not None:
                files.setdefault(name.package, []).append(path)
    texts: dict[str, dict[str, str]] = {}
    waiting = {*_UNNAMED}.union(*(named_packages(definitions_in(each)) for each in packages))
    while waiting:
        package = waiting.pop()
        read = {str(path): _read(path) for path in files.get(package, ())}
        texts[package] = {path: text.decode("utf-8", "replace") for path, text in read.items()}
        waiting |= named_packages(read.values()) - texts.keys()
    # A definition may be newer than what was built of it, which is not changed before it is.
    libraries = [
        (str(path), _stamp(path))
        for package in sorted(texts)
        for prefix in prefixes
        for path in [Path(prefix, "lib", f"lib{package}__rosidl_generator_c.so")]
        if path.exists()
    ]
    versions = [
        (str(path), _read(path).decode("utf-8", "replace"))
        for share in shares
        for package in _GENERATORS
        for path in [share / package / "package.xml"]
        if path.exists()
    ]
    definitions = sorted((each, sorted(texts[each].items())) for each in texts)
    return [prefixes, definitions, libraries, versions]


def _read(path: Path) -> bytes:
    with suppress(OSError, ValueError):
        return read_regular(path, _LARGEST_DEFINITION)
    return b""


def _stamp(path: Path) -> list[object]:
    """Return what changes with a file that is too large to be read, links resolved."""
    with suppress(OSError):
        status = path.stat()
        return [str(path.resolve()), status.st_mtime_ns, status.st_size]
    return []
