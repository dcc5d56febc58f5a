"""How the endpoints around a place are held, and whether they are a section of their own."""

from __future__ import annotations

import re
from itertools import takewhile

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis
from .conventions import target_name
from .insertion_point import KINDS
from .place import Place, beside
from .references import statement_of
from .syntax import is_in_loop
from .waits import Waits

# What has no use unless something holds it.
_HELD = (EndpointKind.PUBLISHER, EndpointKind.CLIENT, EndpointKind.ACTION_CLIENT)
_HEADING = re.compile(rb"publish|subscri|service|client|server|action|timer", re.IGNORECASE)
# What the heading of a section says of its endpoints.
_SECTIONS = {
    EndpointKind.PUBLISHER: b"publish",
    EndpointKind.SUBSCRIPTION: b"subscri",
    EndpointKind.SERVICE: b"service",
    EndpointKind.CLIENT: b"client",
    EndpointKind.ACTION_SERVER: b"action",
    EndpointKind.ACTION_CLIENT: b"action",
    EndpointKind.TIMER: b"timer",
}
_QUOTES = (b'"""', b"'''")
# The lines of a section that are looked at.
_MOST_OF_SECTION = 20


def is_attribute_style(analysis: Analysis, place: Place, kind: EndpointKind) -> bool:
    """Whether an endpoint at a place is an attribute of the object, rather than a plain name.

    That is as the method holds others of its kind, or what else it has to hold to use it: a client
    that a constructor asks for itself says nothing of what stays.
    """
    if not place.self_name:
        return False
    names = [
        (site.endpoint.kind, name)
        for site in analysis.sites
        if site.endpoint.kind in (kind, *_HELD)
        and site.scope.enclosing("function") is place.scope
        and b"message_filters" not in (site.call.text or b"")
        and not is_in_loop(site.call)
        and (name := target_name(analysis, site)) is not None
    ]
    own = [name for found, name in names if found is kind or place.scope.name != "__init__"]
    return not own or any("." in name for name in own)


def holds_handles(analysis: Analysis, place: Place, kind: EndpointKind) -> bool:
    """Whether a function's endpoints of a kind, or else all, are attributes, used or not."""
    beside = [
        site
        for site in analysis.sites
        if site.endpoint.kind in KINDS and site.scope.enclosing("function") is place.scope
    ]
    for kinds in ((kind,), set(KINDS) - set(_HELD)):
        sites = [site for site in beside if site.endpoint.kind in kinds]
        if sites:
            names = [target_name(analysis, site) for site in sites]
            return all(name is not None and "." in name for name in names)
    return False


def starts_section(analysis: Analysis, place: Place, kind: EndpointKind) -> bool:
    """Whether a blank line parts an endpoint from the statements above it.

    They are under a comment that speaks of endpoints or of the last one, or under one of several,
    or a block of their own.
    """
    if place.beside is not None and place.beside.endpoint.kind is kind:
        return False
    above = analysis.syntax.text[: place.offset].splitlines()[-_MOST_OF_SECTION:]
    indent = place.indent.encode()
    for number, line in enumerate(reversed(above)):
        own = line.lstrip()
        if own.startswith((b"#!", b"def ", b"class ", b"import ", b"from ")):
            return False
        depth = len(line) - len(own)
        row = analysis.syntax.text.count(b"\n", 0, place.offset) - 1 - number
        if not own:
            return number > 0 and _is_headed(analysis, above[: -number - 1], row, place, kind)
        if depth < len(indent) or not line.startswith(indent):
            return False
        if depth == len(indent) and _is_heading(analysis, own, row, depth):
            is_of_last = row == place.statement.start_point.row - 1
            is_ended = analysis.syntax.text[place.offset :].startswith(indent + b"#")
            return number > 0 and (is_of_last or is_ended or _HEADING.search(own) is not None)
        if number == 0 and depth > len(indent) and place.statement.type != "expression_statement":
            return True
    return False


def _is_headed(
    analysis: Analysis, above: list[bytes], row: int, place: Place, kind: EndpointKind
) -> bool:
    """Whether the last heading above a blank line speaks of a place's endpoints, of no others."""
    indent = place.indent.encode()
    block = takewhile(lambda line: not line.strip() or line.startswith(indent), reversed(above))
    heading = b""
    for number, line in enumerate(block, 1):
        if _is_heading(analysis, line[len(indent) :], row - number, len(indent)):
            heading = line.lower()
            break
    beside = place.beside.endpoint.kind if place.beside is not None else kind
    word, other = _SECTIONS.get(beside), _SECTIONS.get(kind)
    return word is not None and other is not None and word in heading and other not in heading


def _is_heading(analysis: Analysis, line: bytes, row: int, column: int) -> bool:
    """Whether a line is a comment, or a string that is no docstring."""
    if line.startswith(b"#") or not line.startswith(_QUOTES):
        return line.startswith(b"#")
    start = sum(map(len, analysis.syntax.text.splitlines(keepends=True)[:row])) + column
    node = analysis.syntax.root.descendant_for_byte_range(start, start + 1)
    statement = statement_of(node) if node is not None else None
    return statement is not None and statement.prev_named_sibling is not None


def is_followed(analysis: Analysis, place: Place) -> bool:
    """Whether a statement of the same block is on the line below a place."""
    below = analysis.syntax.text[place.offset :].partition(b"\n")[0]
    indent = place.indent.encode()
    return below.startswith(indent) and bool(below[len(indent) :].rstrip())


def timers_below(analysis: Analysis, place: Place) -> Place | None:
    """Return the place behind a function's timers, where they are a section below another place."""
    timers = [
        site
        for site in analysis.sites
        if site.endpoint.kind is EndpointKind.TIMER
        and site.scope.enclosing("function") is place.scope
    ]
    found = beside(analysis, timers[-1]) if timers else None
    block = place.statement.parent
    if found is None or block is None or Waits(analysis).is_behind(found):
        return None
    is_same_block = found.statement.parent is not None and found.statement.parent.id == block.id
    between = analysis.syntax.text[place.offset : found.offset].splitlines()
    return found if is_same_block and not all(map(bytes.strip, between)) else None
