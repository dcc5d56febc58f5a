"""A running graph as a Plastron program."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.model.program_text import Variables, endpoint_statements, parameter_statement
from plastron_tui.model.unique_names import numbered
from plastron_tui.ros.names import check_node_name

from .action_topics import Endpoint
from .describe import DescribedNode

_HEAD = """\
// The graph does not show what messages, requests and goals hold, nor how often they are sent:
// `input none` and the rate of 10 hz stand for what is not known.
"""
_LIBRARY = "// Nor does it show which client library nodes use: `{}` stands for it.\n"
_LIBRARY_ALONE = "// The graph does not show which client library nodes use: `{}` stands for it.\n"
_TYPE = re.compile(r"[A-Za-z]\w*/[A-Za-z]\w*", re.ASCII)


def to_program(
    nodes: Iterable[DescribedNode], library: str | None = None, ros_version: int = 1
) -> str:
    """Return a program whose nodes make the same graph.

    What no statement can say is a comment: a node without endpoints, an endpoint without a
    known type, a name that is none (a ROS 1 master takes any text). A node's name has no
    namespace in Plastron, so that `/arm/talker` becomes a node `talker`, or `arm_talker` where
    that name is taken; its topics and services have their full names, so that they stay where
    they are.

    Args:
        nodes: the graph.
        library: the client library for `using`; None leaves it to the one who generates.
        ros_version: the generation of ROS, which tells what a name is.
    """
    found = list(nodes)
    listed = [_named(node, ros_version) for node in found]
    odd = [_odd(node, kept) for node, kept in zip(found, listed, strict=True)]
    variables = Variables()
    blocks = [
        _unnamed(node)
        if check_node_name(name, ros_version) is not None
        else _node(node, name, variables, library, comments, ros_version)
        for node, name, comments in zip(listed, _names(listed), odd, strict=True)
    ]
    if not blocks:
        return "// no node is running\n"
    head = _HEAD if any(map(_sends, listed)) else ""
    if library is not None:
        head += (_LIBRARY if head else _LIBRARY_ALONE).format(library)
    return "\n".join([head, *blocks] if head else blocks)


def _sends(node: DescribedNode) -> bool:
    return any(
        type_ is not None
        for kind, found in node.by_kind.items()
        if kind.facts.sends
        for _, type_ in found
    )


def _named(node: DescribedNode, ros_version: int) -> DescribedNode:
    """Return a node without the endpoints whose names no program can say."""

    def kept(kind: EndpointKind, endpoints: Iterable[Endpoint]) -> tuple[Endpoint, ...]:
        return tuple(
            (name, type_ if type_ is not None and _TYPE.fullmatch(str(type_)) else None)
            for name, type_ in endpoints
            if kind.facts.check_name(name, ros_version) is None
        )

    return replace(node, by_kind={kind: kept(kind, found) for kind, found in node.by_kind.items()})


def _odd(node: DescribedNode, kept: DescribedNode) -> list[str]:
    names = {name for name, _ in kept.endpoints}
    odd = dict.fromkeys(name for name, _ in node.endpoints if name not in names)
    return [f"// {visible(name)}: no program can name it" for name in odd]


def _unnamed(node: DescribedNode) -> str:
    return f"// {visible(node.name)}: no program can name this node\n"


def _node(
    node: DescribedNode,
    name: str,
    variables: Variables,
    library: str | None,
    odd: list[str],
    ros_version: int,
) -> str:
    shown = visible(node.name)
    lines = [] if node.name == f"/{name}" else [f"// {shown}"]
    if not any(type_ is not None for _, type_ in node.endpoints) and not node.parameters:
        lines.append(f"// {shown} has no topic or service that a program can name")
        return "\n".join([*lines[-1:], *_unknown(node), *odd]) + "\n"
    variable = variables.new(name)
    using = f" using {library}" if library else ""
    lines.append(f"create_node '{name}' as {variable}{using}")
    for written, details in node.parameters.items():
        made = parameter_statement(variable, written, details, ros_version)
        lines += made or (f"// {visible(written)}: no statement gives a node this parameter",)
    for kind, endpoints in node.by_kind.items():
        for full, type_ in endpoints:
            message = partial(variables.new, f"{variable}_{_last(full)}")
            if type_ is not None:
                lines += endpoint_statements(kind, variable, full, type_, message) or ()
    lines += [*_unknown(node), *odd, f"generate_node {variable}"]
    return "\n".join(lines) + "\n"


def _unknown(node: DescribedNode) -> list[str]:
    return [f"// {name}: its type is not known" for name, type_ in node.endpoints if not type_]


def _names(nodes: Sequence[DescribedNode]) -> list[str]:
    """Return a name without a namespace for each node, all different."""
    used: set[str] = {node.name[1:] for node in nodes if "/" not in node.name[1:]}
    names = []
    for node in nodes:
        if "/" not in node.name[1:]:
            names.append(node.name[1:])
            continue
        choices = chain([_last(node.name)], numbered(node.name[1:].replace("/", "_")))
        names.append(next(name for name in choices if name not in used))
        used.add(names[-1])
    return names


def _last(name: str) -> str:
    return name.rsplit("/", 1)[-1]
