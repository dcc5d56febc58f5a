"""The statements that make nodes, load them, and write them to files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Label, codes, either, write
from plastron_tui.language import statements as st

from .context import LoadRequest
from .mistake import Mistake
from .run import Run
from .workspace import Generation, Node

if TYPE_CHECKING:
    from .source import SourceUnit


def create_node(run: Run, statement: st.CreateNode) -> None:
    """Make a node."""
    run.checks.new_variable(statement, statement.variable)
    library = run.checks.library(statement)
    check_node_name(run, statement, run.checks.version(library))
    check_managed(run, statement, library or run.setting.library)
    run.node_names[statement.name] = statement.span
    run.workspace.nodes[statement.variable] = Node(
        statement.name,
        statement.variable,
        statement.span,
        library,
        is_managed=statement.managed,
    )


def check_managed(run: Run, statement: st.CreateNode, library: str) -> None:
    """Check that a client library has managed nodes."""
    if not statement.managed or run.checks.version(library) == 2:
        return
    others = [name for name in run.setting.libraries if run.checks.version(name) == 2]
    raise Mistake(
        Diagnostic(
            codes.NOT_IN_ROS_1,
            f"`{library}` has no managed nodes: they are nodes of ROS 2",
            statement.span_of("managed"),
            help=f"use {either(others)}, or leave `managed` out",
        )
    )


_SAME_NAME = {
    1: "ROS 1 stops the first of two nodes of one name; choose another",
    2: "ROS 2 runs both, and tools mix them up; choose another",
}
"""What comes of two nodes of one name, by the generation of ROS."""


def check_node_name(run: Run, statement: st.CreateNode, version: int) -> None:
    """Check that a node may have its name in a generation of ROS, and that no other has it."""
    run.checks.name(statement, "name", statement.name, version)
    earlier = run.node_names.get(statement.name)
    if earlier is not None:
        raise Mistake(
            Diagnostic(
                codes.NODE_EXISTS,
                f"a node `{statement.name}` exists already",
                statement.span_of("name"),
                help=_SAME_NAME[version],
                labels=(Label(earlier, "first created here"),),
            )
        )


def load(run: Run, statement: st.Load) -> None:
    """Read a node from a file."""
    from .loading import loaded_node  # most programs load nothing

    source = _read(run, statement)
    run.checks.new_variable(statement, statement.variable)
    node = loaded_node(source, statement)
    run.agreements.adopt(node, run.checks.version_of(node), statement)
    run.workspace.nodes[statement.variable] = node


def _read(run: Run, statement: st.Load) -> SourceUnit:
    """Return the file that a statement loads, with the node that it means."""
    from .loading import node_in

    generated = tuple(run.workspace.generations)
    loaded = run.setting.read(LoadRequest(statement.source, statement.is_path, generated))
    if loaded.source is None and run.consequences.may_name(statement.source, run.workspace.nodes):
        raise Mistake
    where = statement.span_of("source")
    for found in loaded.diagnostics:
        fix = None if loaded.right is None else write(loaded.right, where)
        placed = found if found.file is not None else found._replace(span=where, fix=fix)
        run.report(statement, placed)
    if loaded.source is None:
        raise Mistake
    source = node_in(loaded.source, statement)
    if isinstance(source, Diagnostic):
        raise Mistake(source)
    return source


def generate_node(run: Run, statement: st.GenerateNode) -> None:
    """Note that a node is to be written as it is now."""
    node = run.checks.node(statement)
    library = run.checks.library(statement) or node.library or run.setting.library
    check_work(run, statement, node)
    check_library(run, statement, node, library)
    run.workspace.generations.append(Generation(node.snapshot(), library, statement.span))


def check_library(run: Run, statement: st.GenerateNode, node: Node, library: str) -> None:
    """Check that a managed node is written for a client library that has such."""
    if node.is_managed and run.checks.version(library) == 1:
        raise Mistake(
            Diagnostic(
                codes.NOT_IN_ROS_1,
                f"`{node.variable}` is managed, and `{library}` has no managed nodes",
                statement.span_of("library"),
                labels=(Label(node.span, "loaded here" if node.source else "created here"),),
            )
        )


def check_work(run: Run, statement: st.GenerateNode, node: Node) -> None:
    """Check that a node does anything."""
    if node.is_idle and node.source is None:
        if run.consequences.is_unfinished(node):
            raise Mistake
        raise Mistake(
            Diagnostic(
                codes.IDLE_NODE,
                f"`{node.variable}` does nothing yet",
                statement.span_of("node"),
                help="let it publish, subscribe, provide a service or request one first",
                labels=(Label(node.span, "created here"),),
            )
        )
