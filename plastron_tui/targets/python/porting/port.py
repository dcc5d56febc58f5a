"""Porting a whole file, and what is said about it."""

from __future__ import annotations

import re
from collections import Counter

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.source import EndpointKind, SourceUnit
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.sources.base import Rendered
from plastron_tui.sources.python.analysis import Analysis, Site
from plastron_tui.sources.python.calls import LIBRARIES
from plastron_tui.sources.python.compiling import NotPython, syntax_error
from plastron_tui.sources.python.editor import not_encodable
from plastron_tui.sources.python.line_limit import LineLimit, line_limit
from plastron_tui.sources.python.shared_analysis import analyze, package_names
from plastron_tui.sources.python.syntax import parse
from plastron_tui.sources.python.wrapping import wrap_new_lines

from .contexts import without_contexts
from .other_modules import mark_importers, mark_own_modules
from .port_state import COMMENT, SEPARATOR, Mark, Work, walk
from .python_2 import without_tabs
from .to_rclpy import port_to_rclpy
from .to_rospy import port_to_rospy
from .types import target_type
from .unused_imports import without_unused
from .unused_nodes import without_unused_nodes

_PORTS = {"rclpy": port_to_rclpy, "rospy": port_to_rospy}
_LEFT = {"rospy": ("rospy", "roslib"), "rclpy": ("rclpy",)}
_KINDS = {
    EndpointKind.PUBLISHER: ("publisher of", InterfaceKind.MESSAGE),
    EndpointKind.SUBSCRIPTION: ("subscription to", InterfaceKind.MESSAGE),
    EndpointKind.SERVICE: ("service", InterfaceKind.SERVICE),
    EndpointKind.CLIENT: ("client of", InterfaceKind.SERVICE),
}

_Key = tuple[EndpointKind, str | None, str]


def port_python(
    source: SourceUnit, catalog: Catalog, library: str, line_length: int | None = None
) -> Rendered:
    """Bring a file to another client library.

    The result was read again: an endpoint that it does not show is a warning, and a file that
    compiled before and would not any more is refused.

    Args:
        source: the file.
        catalog: the types of the distribution that it goes to.
        library: the client library that it goes to.
        line_length: how long a line may be, None for what the file, or its ROS, keeps to.
    """
    known = LIBRARIES[source.library]
    before = analyze(source.files.main, known, package_names(source.path, known))
    if before.syntax.errors:
        message = f"`{source.path.name}` does not parse, and cannot be brought to {library}"
        return Rendered(
            None, (Diagnostic(codes.EDIT_REFUSED, message, help="mend the file first"),)
        )
    try:
        # One of both is rclpy's, which allows more than rospy's; the file keeps to its own.
        limit = line_limit(source.files.main, "rclpy", line_length)
        return _ported(source, Work(before, catalog), library, limit)
    except UnicodeEncodeError as error:
        return Rendered(None, (not_encodable(source, error),))


def _ported(source: SourceUnit, work: Work, library: str, limit: LineLimit) -> Rendered:
    """Rewrite the file, and read the result.

    Raises:
        UnicodeEncodeError: the file is in an encoding that lacks a character of the result.
    """
    before = work.analysis
    _PORTS[library](work)
    mark_own_modules(work, source.path)
    if library == "rclpy":
        mark_importers(work, source.path)
    for site in before.first_sites():
        endpoint = site.endpoint
        given = site.arguments.get(site.shape.name)
        is_open = endpoint.name is None and endpoint.kind in _KINDS and endpoint.expression
        if is_open and _may_be_private(work, given):
            work.mark(site.call, _name_of(endpoint.expression), _CHECK)
        _mark_type(work, site)
    made = without_contexts(work.result(limit.length))
    made = without_unused(made, _LEFT[source.library], work.freed)
    if library == "rospy":
        owners = {each.owner.name for each in before.nodes if each.owner is not None}
        made = without_unused_nodes(made, frozenset({*owners, "rospy.init_node"}))
    text = wrap_new_lines(source.files.main, parse(made), limit)
    if library == "rclpy":
        text = without_tabs(text)
    lines = _comment_lines(text.decode(before.syntax.encoding, "replace"))
    found = [_listed(mark, source, library, lines) for mark in _in_order(work.marks)]
    target = LIBRARIES[library]
    after = analyze(text, target, package_names(source.path, target))
    found += _missing(work, before, after, source)
    problem = syntax_error(text)
    was_python_3 = problem is not None and syntax_error(source.files.main) is None
    if problem is not None and (was_python_3 or library == "rclpy"):
        # The line is one of the new file, which nobody sees.
        reason = problem.reason.partition(" (line ")[0]
        message = f"`{source.path.name}` cannot be brought to {library}: {reason}"
        remedy = None if was_python_3 else _no_python_3(text, problem)
        return Rendered(None, (Diagnostic(codes.EDIT_REFUSED, message, help=remedy),))
    if problem is not None:
        found.append(_by_hand(source, f"the file is no Python 3: {problem.reason}", None, None))
    return Rendered(source.files.with_main(text), tuple(found))


def _no_python_3(text: bytes, problem: NotPython) -> str:
    """Return what to do about a line of Python 2 that is not brought over."""
    lines = text.decode("utf-8", "replace").split("\n")
    line = lines[problem.line - 1].strip() if problem.line else ""
    return f"write `{line[:_LONGEST]}` as Python 3 has it first" if line else "mend the file first"


def _mark_type(work: Work, site: Site) -> None:
    """Mark a type of a module that is imported whole, where the other ROS names it otherwise.

    One that is imported by its name is brought over with its import.
    """
    type_, kind = site.endpoint.type, site.endpoint.kind
    if type_ is None or kind not in _KINDS or "." not in site.endpoint.type_expression:
        return
    found, remedy = target_type(work, type_, _KINDS[kind][1])
    if found != type_:
        work.mark(site.call, str(type_), remedy if found is None else f"it is `{found}` there")


_LONGEST = 60
_CHECK = "the file decides the name as it runs: see that it is one of the other ROS"


def _name_of(expression: str) -> str:
    """Return what a mark calls a name: its expression, where that is short enough to be read."""
    text = " ".join(expression.split())
    return f"the name {text}" if len(text) <= _LONGEST else "the name that is made here"


def _may_be_private(work: Work, name: Node | None) -> bool:
    """Tell whether a name may begin with `~`, which each ROS reads its own way.

    All others are the same in both. A file without such names is taken to get none either.
    """
    while name is not None:
        if name.type == "string":
            content = work.slice(name).lstrip("rRbBuUfF").lstrip("\"'")
            return content.startswith("~")
        callee = name.child_by_field_name("function")
        holder = callee.child_by_field_name("object") if callee is not None else None
        if name.type == "parenthesized_expression":
            name = name.named_children[0]
        elif callee is not None and work.slice(callee).endswith(".format"):
            name = holder
        else:
            name = name.child_by_field_name("left") if name.type == "binary_operator" else None
    return any(
        re.match(r"\w*['\"]+~", work.slice(each)) and not _is_parameter(each)
        for each in walk(work.analysis.syntax.root)
        if each.type == "string"
    )


def _is_parameter(name: Node) -> bool:
    """Tell whether a string is the name of a parameter that a call asks for."""
    call = name.parent.parent if name.parent is not None else None
    callee = call.child_by_field_name("function") if call is not None else None
    return callee is not None and b"param" in (callee.text or b"")


def _in_order(marks: list[Mark]) -> list[Mark]:
    """Return the marks in the order of the file, each once a line."""
    seen: dict[tuple[int, str], Mark] = {}
    for mark in sorted(marks, key=lambda mark: mark.node.start_byte):
        seen.setdefault((mark.node.start_point.row, mark.what), mark)
    return list(seen.values())


def _comment_lines(text: str) -> dict[str, list[int]]:
    """Return the lines below the comments of a ported file, by what the comments name."""
    lines: dict[str, list[int]] = {}
    above: list[str] = []
    for row, line in enumerate(text.split("\n"), 1):
        _, comment, words = line.partition(COMMENT)
        if comment:
            above += words.rstrip().split(SEPARATOR)
            continue
        for what in above:
            lines.setdefault(what, []).append(row)
        above.clear()
    return lines


def _listed(
    mark: Mark, source: SourceUnit, library: str, lines: dict[str, list[int]]
) -> Diagnostic:
    """Return the warning for a mark, with its line in the new file, one after the other."""
    span = Span(mark.node.start_byte, mark.node.end_byte)
    rows = lines.get(mark.what)
    place = f" in line {rows[0]} of the new file" if rows else ""
    if rows is not None and len(rows) > 1:
        rows.pop(0)
    message = f"`{mark.what}`{place} has to be ported to {library} by hand"
    return _by_hand(source, message, span, mark.remedy)


def _by_hand(source: SourceUnit, message: str, span: Span | None, remedy: str | None) -> Diagnostic:
    return Diagnostic(
        codes.PORT_BY_HAND,
        message,
        span,
        file=source.path,
        help=remedy,
    )


def _missing(work: Work, before: Analysis, after: Analysis, source: SourceUnit) -> list[Diagnostic]:
    """Return a warning for each endpoint that the result does not show."""
    shown = Counter(_key(work, each) for each in (*after.sites, *after.disguised))
    found = []
    for site in (*before.sites, *before.disguised):
        if site.endpoint.kind not in _KINDS or site.endpoint.name is None:
            continue
        key = _key(work, site)
        if shown[key] > 0:
            shown[key] -= 1
            continue
        what = f"the {_KINDS[site.endpoint.kind][0]} `{site.endpoint.name}`"
        message = f"{what} in line {site.endpoint.line} is not carried over"
        found.append(_by_hand(source, message, site.endpoint.span, None))
    return found


def _key(work: Work, site: Site) -> _Key:
    endpoint = site.endpoint
    type_ = endpoint.type
    if type_ is not None and endpoint.kind in _KINDS:
        type_ = target_type(work, type_, _KINDS[endpoint.kind][1])[0] or type_
    return (endpoint.kind, endpoint.name, str(type_))
