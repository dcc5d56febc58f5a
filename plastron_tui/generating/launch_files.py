"""Launch files that a program loads, with what it changes in them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.launches import Launch, LaunchSource
from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.launch import Argument, Include, StartedNode, items_of
from plastron_tui.ros.launch_text import Kind, Substitution
from plastron_tui.sources.launch.edits import add, remove
from plastron_tui.sources.launch.xml_reader import read_launch_xml
from plastron_tui.targets.launch.program import ExecutableName, FindExecutable, request_of
from plastron_tui.targets.packages.spec import PackageFile

from .destination import Writing
from .launch_layers import LAUNCH_FORM
from .text_files import Folder
from .text_layers import changed_file

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Node
    from plastron_tui.targets.base import Target


class EditedLaunch(NamedTuple):
    """The text of a launch file after its changes, or why there is none."""

    text: bytes | None
    diagnostics: tuple[Diagnostic, ...] = ()


def edited_launch(launch: Launch, find: FindExecutable) -> EditedLaunch:
    """Return the text of a loaded launch file, with what the program changes in it.

    Args:
        launch: the launch file.
        find: tells which package a node of the program is in.
    """
    source = launch.source
    assert source is not None, "a launch file that was loaded has a source"
    version = source.format.ros_version
    document = read_launch_xml(source.text, source.path, version).document
    assert document is not None, "a launch file that is changed was read from XML"
    request = request_of(launch, version, find)
    # What is new may bear the name of what goes.
    for kind, name in request.removed:
        edit = remove(document, kind, name, version)
        if edit.document is None:
            return EditedLaunch(None, edit.diagnostics)
        document = edit.document
    for item in request.added.items:
        edit = add(document, item, version)
        if edit.document is None:
            return EditedLaunch(None, edit.diagnostics)
        document = edit.document
    return EditedLaunch(document.text)


def launch_output(
    launch: Launch,
    named: tuple[str, PackageFile],
    find: FindExecutable,
    folder: Folder,
    writing: Writing,
) -> tuple[OutputFile, tuple[Diagnostic, ...]]:
    """Return a changed launch file as it is to be written, and what is to be said of it.

    Args:
        launch: the launch file, which was loaded.
        named: what it is called in the output folder, and what it shall hold.
        find: tells which package a node of the program is in.
        folder: the output folder.
        writing: whether it is written over the file that it came from, and what is known of that.
    """
    source = launch.source
    assert source is not None, "the launch file was loaded"

    def remade(original: bytes) -> bytes | None:
        return edited_launch(replace(launch, source=source._replace(text=original)), find).text

    return changed_file(source, named, remade, folder, writing, LAUNCH_FORM)


def packages_of(source: LaunchSource) -> Iterator[str]:
    """Yield the packages that a loaded launch file starts nodes of, or includes files of."""
    for node in items_of(source.launch.items, StartedNode):
        if node.package.literal:
            yield node.package.literal
    for each in items_of(source.launch.items, Include):
        for part in each.file.parts:
            if isinstance(part, Substitution) and part.kind is Kind.PACKAGE:
                yield from filter(None, (part.argument.literal,))


def executable_of(node: Node, target: Target | None) -> ExecutableName:
    """Return what starts a node of a package: in ROS 1 a script is the file itself."""
    assert node.home is not None, "it is in a package"
    package, name = node.home.package, node.home.executable
    plugin = None if target is None else target.plugin_class(node)
    if target is None or target.ros_version == 2:
        return ExecutableName(package, name, plugin or "")
    if plugin is not None:
        return ExecutableName(package, "", f"{package}/{plugin.rpartition('::')[2]}")
    is_built = target.language.is_built
    return ExecutableName(
        package, name if is_built else f"{node.home.stem}{target.language.suffix}"
    )


def needs_of_launch(launch: Launch, version: int) -> frozenset[str]:
    """Return the packages whose nodes or files a launch file starts."""
    starts = launch.starts.values()
    homes = (None if each.node is None else each.node.home for each in starts)
    loader = "nodelet" if version == 1 else "rclcpp_components"
    is_loading = any(
        each.container is not None or (version == 1 and each.is_loaded) for each in starts
    )
    return frozenset(
        {
            *(each.package for each in starts if each.package),
            *(each.package for each in homes if each is not None),
            *(each.package for each in launch.includes.values()),
            *(() if launch.source is None else packages_of(launch.source)),
            *((loader,) if is_loading else ()),
        }
    )


def is_open(launch: Launch) -> bool:
    """Tell whether who starts a launch file has to give it an argument."""
    there = () if launch.source is None else items_of(launch.source.launch.items, Argument)
    defaults = (each.default for each in (*launch.arguments.values(), *there))
    return any(default is None for default in defaults)
