"""Which of the files that were read no build takes: what they say is no part of the robot."""

from __future__ import annotations

import os
from collections import defaultdict
from collections.abc import Callable, Collection, Mapping
from contextlib import suppress
from itertools import chain
from pathlib import Path

from plastron_tui.lint.tree import PackageFacts
from plastron_tui.regular_files import read_regular
from plastron_tui.sources.build_files import LARGEST
from plastron_tui.sources.packages.taken import SOURCES, unbuilt_sources

from .units import UnitRead

HEADERS = (".hpp", ".h", ".hh", ".hxx")
_LISTS = ("CMakeLists.txt", ".cmake")


def unbuilt_units(
    found: Mapping[str, UnitRead],
    package_of: Callable[[str], str],
    *,
    inner: Collection[str],
    has_packages: bool,
    read: Callable[[str, frozenset[str]], frozenset[str]],
) -> frozenset[str]:
    """Return the files of nodes that no build takes.

    These are all those of a package in another one, and files of C++ that are in no package of a
    workspace which has some, or sources that the CMakeLists.txt of their package does not mean,
    and headers whose sources are all such.

    Args:
        found: the files of nodes.
        package_of: returns the folder of the package that a file is in, "" for none.
        inner: the folders of packages that are in another one.
        has_packages: whether the workspace has packages at all.
        read: returns which sources of a package its files of CMake do not mean.
    """
    folders = tuple(f"{each}{os.sep}" for each in inner)
    left = {path for path in found if path.startswith(folders)} if folders else set()
    # A header that is read by itself is read with the source that defines what it declares.
    defined = {
        path: [part for part in each.parts if part.endswith(SOURCES)]
        for path, each in found.items()
        if path not in left and path.endswith(HEADERS)
    }
    sources: dict[str, set[str]] = defaultdict(set)
    for path in chain(found, *defined.values()):
        package = package_of(path)
        if path not in left and path.endswith(SOURCES):
            sources[package].add(path[len(package) + 1 :] if package else path)
    sources.pop("", None)
    if has_packages:
        left |= {path for path in found if not is_script(path) and not package_of(path)}
    for package, names in sources.items():
        left.update(f"{package}{os.sep}{each}" for each in read(package, frozenset(names)))
    left |= {path for path, parts in defined.items() if parts and left.issuperset(parts)}
    # One that is read with another one, which is built, may be included there.
    parts = {part for path, each in found.items() if path not in left for part in each.parts}
    return frozenset(left - parts)


_OF_ROS1 = frozenset({"catkin", "roscpp", "rospy"})


def is_ported(package: PackageFacts) -> bool:
    """Tell whether a package is for ROS 2 alone: what it has of ROS 1 was left when it was ported.

    One that depends on a client library of ROS 1 may be built for that as well.
    """
    if package.build is None or 1 in package.ros_versions:
        return False
    return _OF_ROS1.isdisjoint(each.name for each in package.build.dependencies)


def is_script(path: str) -> bool:
    """Tell whether a file of a node is one that no compiler takes: it may have no suffix."""
    return path.endswith(".py") or "." not in os.path.basename(path)


def read_unbuilt(
    folder: str, names: Collection[str], sources: frozenset[str]
) -> frozenset[str] | None:
    """Return which sources of a package its files of CMake do not mean, None for unknown ones."""
    texts = {}
    for name in sorted(names):
        if name.endswith(_LISTS):
            with suppress(OSError, ValueError):
                texts[name] = read_regular(Path(folder, name), LARGEST)
            if name not in texts:
                return None
    found = unbuilt_sources(texts, sources)
    return frozenset(each for each in found if not _is_included(folder, names, each))


def _is_included(folder: str, names: Collection[str], source: str) -> bool:
    """Tell whether a header that is called as a source includes it, as those of templates do."""
    base = source.rpartition("/")[2]
    stem = base.rpartition(".")[0]
    headers = {f"{stem}{ending}" for ending in HEADERS}
    for name in names:
        if name.rpartition("/")[2] in headers:
            with suppress(OSError, ValueError):
                if base.encode() in read_regular(Path(folder, name), LARGEST):
                    return True
    return False
