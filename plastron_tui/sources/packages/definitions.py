"""Letting a package that exists build types, from definition files.

Sources: for catkin the wiki pages "catkin/CMakeLists.txt" and "ROS/Tutorials/CreatingMsgAndSrv",
for ament_cmake the ROS 2 tutorial "Creating custom msg and srv files".
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.package_source import PackageSource
from plastron_tui.sources.build_files import Edited

from .changing import Changed
from .reading import CMAKE_LISTS, PACKAGE_XML

_Edit = Callable[[bytes, Path], Edited]

_MEMBER = "rosidl_interface_packages"
_GENERATORS = {1: "message_generation", 2: "rosidl_default_generators"}
_RUNTIMES = {1: "message_runtime", 2: "rosidl_default_runtime"}


def add_definition(
    source: PackageSource, texts: Mapping[str, bytes], file: str, needs: Iterable[str]
) -> Changed:
    """Let a package build the types of a definition file.

    What every package with types needs is added to one that builds none yet.

    Args:
        source: the package.
        texts: what its files hold by now.
        file: the definition, by its path in the package, such as `msg/Speed.msg`.
        needs: the packages whose types it is made of.
    """
    path = source.folder / CMAKE_LISTS
    if source.build_type == "ament_python":
        message = f"`{source.name}` is a package of `ament_python`, which builds no types"
        return Changed(None, (Diagnostic(codes.TYPE_NOT_WRITTEN, message),))
    from plastron_tui.sources.cmake.interfaces import builds_types

    needs = [each for each in needs if each != source.name]
    text = texts[CMAKE_LISTS]
    is_first = not builds_types(text, path)
    edits = (
        _catkin(file, needs, is_first) if source.ros_version == 1 else _ament(file, needs, is_first)
    )
    for edit in edits:
        edited = edit(text, path)
        if edited.text is None:
            # The lines that are told are those of the file as it is.
            before = edit(source.texts[CMAKE_LISTS], path)
            return Changed(None, before.diagnostics or edited.diagnostics)
        text = edited.text
    return _declare(source, {**texts, CMAKE_LISTS: text}, needs, is_first)


def _catkin(file: str, needs: list[str], is_first: bool) -> list[_Edit]:
    from plastron_tui.sources.cmake.dependencies import add_dependency, add_exported
    from plastron_tui.sources.cmake.interfaces import (
        add_generating,
        add_interface,
        add_interface_dependency,
    )

    found = [*needs, _GENERATORS[1]] if is_first else needs
    exported = [*needs, _RUNTIMES[1]] if is_first else needs
    return [
        *(partial(add_dependency, name=each) for each in found),
        partial(add_interface, file=file),
        *(partial(add_interface_dependency, name=each) for each in needs),
        add_generating,
        *(partial(add_exported, name=each) for each in exported),
    ]


def _ament(file: str, needs: list[str], is_first: bool) -> list[_Edit]:
    from plastron_tui.sources.cmake.dependencies import add_dependency
    from plastron_tui.sources.cmake.interfaces import (
        add_interface,
        add_interface_dependency,
        check_module,
        export_runtime,
    )

    found = [*needs, _GENERATORS[2]] if is_first else needs
    return [
        check_module,
        *(partial(add_dependency, name=each) for each in found),
        partial(add_interface, file=file),
        *(partial(add_interface_dependency, name=each) for each in needs),
        *((export_runtime,) if is_first else ()),
    ]


def _declare(
    source: PackageSource, texts: dict[str, bytes], needs: list[str], is_first: bool
) -> Changed:
    """Declare in package.xml what a package with types depends on."""
    from plastron_tui.sources.xml.dependencies import add_dependency, add_group
    from plastron_tui.sources.xml.package_xml import read_package

    package, found = read_package(texts[PACKAGE_XML], source.folder / PACKAGE_XML)
    if package is None:
        return Changed(None, found)
    version = source.ros_version
    wanted = [(each, {"build", "exec"}) for each in needs]
    if is_first:
        wanted.append((_GENERATORS[version], {"build" if version == 1 else "buildtool"}))
        wanted.append((_RUNTIMES[version], {"exec"}))
    added: dict[str, tuple[str, ...]] = {}
    for key, uses in wanted:
        edit = add_dependency(package, key, uses, version)
        if edit.package is None:
            return Changed(None, edit.diagnostics)
        package = edit.package
        if edit.tags:
            added[key] = edit.tags
    if is_first and version == 2:
        edit = add_group(package, _MEMBER)
        if edit.package is None:
            return Changed(None, edit.diagnostics)
        package = edit.package
    return Changed({**texts, PACKAGE_XML: package.document.text}, (), added)
