"""What is known of a file: the calls that create endpoints, and the nodes that they belong to."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import SourceEndpoint

from .arguments import Arguments
from .calls import CallShape, ClientLibrary
from .names import Resolver
from .runs import World
from .scopes import Scope, ScopeTree
from .syntax import Syntax

if TYPE_CHECKING:
    from .package import PackageNames


@dataclass(frozen=True, slots=True, eq=False)
class Site:
    """A call that creates an endpoint.

    Attributes:
        endpoint: what it creates, as data.
        call: the call in the tree.
        scope: the scope that the call is in.
        receiver: the source of the object whose method is called, "" for a plain function.
        owner: the class of the file whose instance the receiver is, None for any other.
        arguments: the call's arguments.
        shape: the shape that the call matched.
        passes: the passes through its function or loop in which the call creates it, among others;
            none where it creates nothing else.
    """

    endpoint: SourceEndpoint
    call: Node
    scope: Scope
    receiver: str
    owner: Scope | None
    arguments: Arguments
    shape: CallShape
    passes: tuple[World, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class NodeSite:
    """A place that makes a node, or names one.

    Attributes:
        name: the name where the source says it literally.
        expression: the source text that decides the name.
        call: the call, None for a node class whose name comes from elsewhere.
        scope: the scope of the call, or that of the class.
        owner: the node class of the file, None for a node that a function makes.
    """

    name: str | None
    expression: str
    call: Node | None
    scope: Scope
    owner: Scope | None = None


class QosChange(NamedTuple):
    """An assignment to a policy of a quality of service.

    Attributes:
        policy: the policy.
        value: what it becomes, None where that is worked out from what it was.
        scope: the scope of the assignment.
        node: the assignment.
        of: what makes the profiles that it may be one of (`Origin.key`).
    """

    policy: str
    value: Node | None
    scope: Scope
    node: Node
    of: frozenset[tuple[int, int, str]]


QosChanges = dict[tuple[int, int, str], list[QosChange]]
"""Assignments to policies, by what makes the profile."""


class Meanings(NamedTuple):
    """What the names of a file mean.

    Attributes:
        unresolved: names that are read where nothing binds them; a star import may do so.
        unbound: attributes of the file's own objects that are read, and that it gives to none; a
            base class of another file may do so.
        bound: attributes that it gives to its own objects.
    """

    unresolved: frozenset[str]
    unbound: frozenset[str]
    bound: frozenset[str]


@dataclass(slots=True)
class Answers:
    """What is found out of a file when somebody asks for it first, whatever its call sites are.

    Attributes:
        qos_changes: its assignments to policies of quality of service, None before.
        meanings: what its names mean, None before.
        identifiers: where a name is an identifier, by the name.
    """

    qos_changes: QosChanges | None = None
    meanings: Meanings | None = None
    identifiers: dict[str, tuple[Node, ...]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Analysis:
    """All that the reader and the editor know of a file; who asks about the same text shares it.

    Attributes:
        syntax: the text and its tree.
        library: the client library that it is read for.
        scopes: the scopes of its names.
        resolver: what its names stand for.
        captures: what the query of the structure has found.
        sites: the calls that create endpoints.
        disguised: the objects of other libraries that do so as well, which no edit takes apart.
        nodes: what makes the nodes.
        package: what its names stand for that other files of its package have.
        answers: what was asked about it.
    """

    syntax: Syntax
    library: ClientLibrary
    scopes: ScopeTree
    resolver: Resolver
    captures: Mapping[str, list[Node]]
    sites: Sequence[Site] = ()
    disguised: Sequence[Site] = ()
    nodes: Sequence[NodeSite] = ()
    package: PackageNames | None = None
    answers: Answers = field(default_factory=Answers)

    def first_sites(self) -> list[Site]:
        """Return a call site for each call, the first where it creates several endpoints."""
        return list({site.call.id: site for site in reversed(self.sites)}.values())[::-1]
