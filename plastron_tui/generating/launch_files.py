"""Launch files that a program loads, with what it changes in them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.launches import Launch, LaunchSource
from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.launch import Include, StartedNode, items_of
from plastron_tui.ros.launch_text import Kind, Substitution
from plastron_tui.sources.launch.edits import add, remove
from plastron_tui.sources.launch.xml_reader import read_launch_xml
from plastron_tui.targets.launch.program import FindExecutable, request_of

from .file_names import is_same_path


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


def launch_output(source: LaunchSource, text: bytes, output: Path, *, in_place: bool) -> OutputFile:
    """Return a changed launch file as it is to be written.

    Args:
        source: what it was loaded from.
        text: what it shall hold.
        output: the output folder.
        in_place: whether it is written over the file that it came from.
    """
    name = source.path.name
    is_over = in_place or is_same_path(output / name, source.path)
    return OutputFile(
        name,
        text,
        is_executable=False,
        merged_from=source.text if is_over else None,
        path=source.path if is_over else None,
    )


def packages_of(source: LaunchSource) -> Iterator[str]:
    """Yield the packages that a loaded launch file starts nodes of, or includes files of."""
    for node in items_of(source.launch.items, StartedNode):
        if node.package.literal:
            yield node.package.literal
    for each in items_of(source.launch.items, Include):
        for part in each.file.parts:
            if isinstance(part, Substitution) and part.kind is Kind.PACKAGE:
                yield from filter(None, (part.argument.literal,))
