"""The files of a program as a whole, which belong to no single node."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.workspace import Generation, Node

from .node_files import NodeFiles

if TYPE_CHECKING:
    from plastron_tui.output.manifest import Manifest

    from .apply_changes import Library
    from .file_names import FileNames


class ProgramFiles(NamedTuple):
    """A set of files for each client library that has any, and why others have none."""

    files: tuple[NodeFiles, ...] = ()
    diagnostics: tuple[Diagnostic, ...] = ()


def program_files(
    generations: Sequence[Generation],
    library_of: Callable[[str], Library | None],
    names: FileNames,
    manifest: Manifest,
) -> ProgramFiles:
    """Write the files of a program as a whole, for each client library of its nodes.

    Args:
        generations: all that the program generates.
        library_of: gives a client library by its name, None for one that nothing writes.
        names: how the files of created nodes are called.
        manifest: what is remembered of its files.
    """
    nodes: dict[str, dict[str, Node]] = {}
    for each in generations:
        # Of two `generate_node` of one variable the last counts.
        nodes.setdefault(each.library, {})[each.node.variable] = each.node
    files: list[NodeFiles] = []
    diagnostics: list[Diagnostic] = []
    for name, used in nodes.items():
        library = library_of(name)
        if library is None:
            continue
        found = tuple(_with_file(node, names.of(node, library.target)) for node in used.values())
        made = library.target.render_program(found, library.catalog)
        diagnostics += made.diagnostics
        if made.files is not None:
            main = made.files.names[0]
            seen = ((names.output, manifest),)
            files.append(NodeFiles(main, made.files, is_executable=False, seen=seen))
    return ProgramFiles(tuple(files), tuple(diagnostics))


def _with_file(node: Node, name: str) -> Node:
    """Let a created node know its file, for a target to name it."""
    return replace(node, file=name) if node.source is None else node
