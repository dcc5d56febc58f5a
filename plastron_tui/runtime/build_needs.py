"""What nodes that are built need of an environment besides the tools: packages that CMake finds."""

from __future__ import annotations

import os
from collections.abc import Container, Iterable, Iterator, Mapping
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.ros.installations import Origin
from plastron_tui.ros.package_keys import is_ros_package
from plastron_tui.sources.xml.document import read_xml

from . import installing
from .build_inputs import PREFIX_PATHS
from .environment import Environment

_BUILT_WITH = frozenset(("depend", "build_depend", "build_export_depend"))


def built_with(package_xml: bytes) -> list[str]:
    """Return the packages and rosdep keys that a package is built with (REP 149)."""
    document = read_xml(package_xml).document
    children = () if document is None else document.root.children
    return [each.value.strip() for each in children if each.name in _BUILT_WITH]


def missing_for_build(
    environment: Environment,
    names: Iterable[str],
    packages: Container[str],
    environ: Mapping[str, str] = os.environ,
) -> list[str]:
    """Return the packages of ROS that no build would find; rosdep keys of others are not judged.

    Args:
        environment: what is to run the nodes.
        names: packages and rosdep keys.
        packages: the packages with interface types that are known.
        environ: the environment variables.
    """
    version = environment.ros_version
    wanted = [each for each in dict.fromkeys(names) if is_ros_package(each, version, packages)]
    prefixes = [*environment.overlays, *prefixes_of(environment, environ)]
    return [each for each in wanted if not any(_has(prefix, each) for prefix in prefixes)]


def prefixes_of(
    environment: Environment, environ: Mapping[str, str] = os.environ
) -> Iterator[Path]:
    """Yield the folders that packages of an environment are installed in."""
    for variable in PREFIX_PATHS:
        for each in environ.get(variable, "").split(os.pathsep):
            if Path(each).is_absolute():
                yield Path(each)
    if environment.origin is Origin.DEBIAN:
        yield Path("/usr")
    elif environment.origin is Origin.EXTRA:
        yield environment.python.parent.parent


def not_found(environment: Environment, names: Iterable[str]) -> Diagnostic:
    """Say that packages are missing which nodes are built with, and how they get there."""
    listed = list(names)
    what = " and ".join(f"`{each}`" for each in listed)
    verb = "is" if len(listed) == 1 else "are"
    message = f"{what} {verb} not installed in {environment.words}, and nodes are built with it"
    if len(listed) > 1:
        message = message.removesuffix("it") + "them"
    return Diagnostic(codes.MISSING_ROS_PACKAGE, message, help=_remedy(environment, listed))


def _remedy(environment: Environment, names: list[str]) -> str:
    match environment.origin:
        case Origin.DEBIAN:
            known = [word for each in names for word in installing.debian_headers(each)]
            return f"install it with `sudo apt install {' '.join(known)}`"
        case Origin.EXTRA:
            return "the Python packages have none: source a whole ROS 2, or one built from source"
    found = [installing.of_distribution(each, environment.distribution) for each in names]
    known = [each for each in found if each is not None]
    if len(known) != len(names):
        return "build it from source, and source the result"
    words = (each.removeprefix("sudo apt install ") for each in known)
    return f"install it with `sudo apt install {' '.join(words)}`"


def _has(prefix: Path, name: str) -> bool:
    places = (prefix / "share" / name / "cmake", prefix / "lib" / "cmake" / name)
    return any(each.is_dir() for each in places) or any(prefix.glob(f"lib/*/cmake/{name}"))
