"""From the call sites of a file to its nodes."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.source import SourceFile, SourceNode
from plastron_tui.targets.base import ReadResult

from .analysis import Analysis, NodeSite, Site
from .calls import LIBRARIES, ClientLibrary
from .extent import MOST_CLASSES, comment_run
from .scopes import Scope
from .sites import analyze
from .syntax import parse

MOST_BYTES = 4_000_000
"""Beyond this size a file is data, not a node that a person wrote."""

_IMPORT = re.compile(rb"\b(?:import|from)\b")
_ROSPY_ONLY = rb"^[ \t]*(import|from)[ \t]+(message_filters|actionlib)\b"
# Part of a node whose class another file brings together may not import the library.
_CREATION = re.compile(rb"\.create_(lifecycle_)?(publisher|subscription|service|client)\s*\(")


def read_python(path: Path, text: bytes, library: str | None = None) -> ReadResult:
    """Read the nodes of a Python file.

    Without a `library` the imports of the file decide. A file that uses no client library is
    a diagnostic, not an exception.
    """
    if len(text) > MOST_BYTES:
        return _refuse(path, "file-too-large", "the file is larger than 4 MB and is not read")
    if b"\x00" in text:
        return _refuse(path, "no-node", "the file is not a text")
    candidates = [LIBRARIES[library]] if library in LIBRARIES else _imported(text)
    is_guess = not candidates and _CREATION.search(text) is not None
    if not candidates and not is_guess:
        return _refuse(path, "no-node", "the file imports neither rospy nor rclpy")
    long_run = comment_run(text)
    if long_run is not None:
        problem = f"the comments from line {long_run} on are too many to be read"
        return _refuse(path, "file-too-large", problem)
    syntax = parse(text)
    if len(syntax.captures("structure").get("class", [])) > MOST_CLASSES:
        problem = f"the file has more than {MOST_CLASSES} classes, and is not read"
        return _refuse(path, "file-too-large", problem)
    analyses = [analyze(syntax, candidate) for candidate in candidates or [LIBRARIES["rclpy"]]]
    if is_guess and all(site.endpoint.type is None for site in analyses[0].sites):
        return _refuse(path, "no-node", "the file imports neither rospy nor rclpy")
    best = max(analyses, key=lambda analysis: (len(analysis.sites), len(analysis.nodes)))
    source = SourceFile(path, text, best.library.module, group(best))
    return ReadResult(source)


def _refuse(path: Path, code: str, message: str) -> ReadResult:
    return ReadResult(None, (Diagnostic(code, message, file=path),))


def _imported(text: bytes) -> list[ClientLibrary]:
    """Return the client libraries that a file imports."""
    found = [library for name, library in LIBRARIES.items() if _imports(text, name.encode())]
    if not found and re.search(rb"^[ \t]*from[ \t]+[\w.]+[ \t]+import[ \t]+\*", text, re.M):
        # A module of one's own may bring the library along.
        found = [
            library
            for name, library in LIBRARIES.items()
            if re.search(rb"^[^#\n]*\b" + name.encode() + rb"\.\w", text, re.M)
        ]
    if not found and re.search(_ROSPY_ONLY, text, re.M):
        found = [LIBRARIES["rospy"]]
    return found


def _imports(text: bytes, name: bytes) -> bool:
    """Tell whether a line imports a module, or from it; what follows a `#` does not count."""
    if name not in text:
        return False
    word = re.compile(rb"\b" + name + rb"\b")
    for line in text.split(b"\n"):
        if name in line:
            code = line.partition(b"#")[0]
            start = _IMPORT.search(code)
            # One search after the other takes no more than the line's length.
            if start is not None and word.search(code, start.end()):
                return True
    return False


def group(analysis: Analysis) -> tuple[SourceNode, ...]:
    """Sort the call sites into the nodes of the file."""
    makers = _merge(analysis.nodes, analysis.library)
    if not makers:
        return (_source_node(None, analysis.sites),) if analysis.sites else ()
    owned: list[list[Site]] = [[] for _ in makers]
    for site in analysis.sites:
        owned[_owner(site, makers, analysis)].append(site)
    return tuple(_source_node(maker, sites) for maker, sites in zip(makers, owned, strict=True))


def _merge(nodes: list[NodeSite], library: ClientLibrary) -> list[NodeSite]:
    """Make the one node of a rospy file of the calls that name it; they may disagree."""
    if library.node_classes or len(nodes) < 2:
        return nodes
    first = nodes[0]
    if all(node.name == first.name for node in nodes):
        return [first]
    return [replace(first, name=None)]


def _owner(site: Site, makers: list[NodeSite], analysis: Analysis) -> int:
    """Return which node a call site belongs to."""
    if len(makers) == 1:
        return 0
    best, best_rank = 0, -1
    for index, maker in enumerate(makers):
        rank = _closeness(site, maker, analysis)
        if rank > best_rank:
            best, best_rank = index, rank
    return best


def _closeness(site: Site, maker: NodeSite, analysis: Analysis) -> int:
    """Rank how near a call site is to what makes a node; the first of the nearest wins."""
    if maker.owner is not None:
        if site.owner is maker.owner:
            return 100
        if site.owner is None and site.scope.is_within(maker.owner):
            return 60
        return 0
    if maker.call is not None and site.receiver:
        assigned = maker.call.parent
        if assigned is not None and assigned.type == "assignment":
            target = assigned.child_by_field_name("left")
            is_target = target is not None and analysis.syntax.slice(target) == site.receiver
            if is_target and site.scope.is_within(maker.scope):
                return 90
    shared = _shared_depth(site.scope, maker.scope)
    owner = site.scope.enclosing("class")
    if owner is not None and _makes(maker.scope, owner, analysis):
        return 50 + shared
    return shared


def _shared_depth(one: Scope, other: Scope) -> int:
    depth = 0
    scope: Scope | None = one
    while scope is not None:
        if other.is_within(scope):
            depth += 1
        scope = scope.parent
    return depth


def _makes(scope: Scope, owner: Scope, analysis: Analysis) -> bool:
    """Whether a function makes an instance of a class of the file."""
    return any(
        analysis.syntax.slice(call.child_by_field_name("function") or call) == owner.name
        for call in analysis.captures.get("call", [])
        if scope.start <= call.start_byte < scope.end
        and analysis.scopes.at(call.start_byte) is scope
    )


def _source_node(maker: NodeSite | None, sites: list[Site]) -> SourceNode:
    endpoints = tuple(site.endpoint for site in sites)
    if maker is None:
        return SourceNode(None, "", endpoints)
    place = maker.call if maker.call is not None else maker.scope.node
    span = Span(place.start_byte, place.end_byte)
    return SourceNode(maker.name, maker.expression, endpoints, span)
