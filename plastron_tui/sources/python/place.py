"""A line of a file at which statements go, behind one that is there or before it."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .conventions import leading_space, target_name
from .references import STATEMENT_PARENTS, statement_of
from .scopes import Scope
from .splices import before_comments, line_end, line_start
from .syntax import is_main_guard, parts_of

# Behind these nothing runs, or not while the node does.
LAST = frozenset({"while_statement", "return_statement", "raise_statement"})
# What gets an endpoint, and does nothing with it yet.
_HOLDING = frozenset(
    {"add", "append", "dict", "extend", "insert", "list", "partial", "publish", "set", "setdefault"}
    | {"tuple", "update", "ApproximateTimeSynchronizer", "Cache", "TimeSynchronizer"}
)
# What is around an endpoint and yet runs exactly once.
_RUNS_ONCE = frozenset({"try_statement", "with_statement"})
_GOES_ON = re.compile(rb"\bis_shutdown\(|\brclpy\.ok\(|\bspin\(")
_CALLED = re.compile(rb"([\w.]+)(\(\)\.\w+)?\(")
# How a log speaks of one endpoint of a kind.
_TELLING = {
    EndpointKind.PUBLISHER: rb"publish(er|ing|es)?\b|advertis",
    EndpointKind.SUBSCRIPTION: rb"subscri(ber|bed|bing|ption)\b",
    EndpointKind.SERVICE: rb"service\b|server\b",
    EndpointKind.CLIENT: rb"client\b|service\b",
    EndpointKind.ACTION_SERVER: rb"server\b",
    EndpointKind.ACTION_CLIENT: rb"client\b|server\b",
    EndpointKind.TIMER: rb"timer\b",
}
# More statements on one line than anybody writes; looking for the next takes the number of all.
_MOST_ON_LINE = 100


@dataclass(frozen=True, slots=True)
class Place:
    """Where new statements go.

    Attributes:
        offset: the start of a line, or the end of the text.
        indent: the white space before the statements there.
        scope: the scope of the statements.
        owner: the class whose method they are in, None in a function or the module.
        self_name: what the method calls its object, "" outside of methods.
        receiver: the node whose methods create endpoints (rclpy), "" in rospy.
        beside: the call site that the new one follows, None behind the node's creation.
        statement: the statement that they follow, or come before.
    """

    offset: int
    indent: str
    scope: Scope
    owner: Scope | None
    self_name: str
    receiver: str
    beside: Site | None
    statement: Node


def beside(analysis: Analysis, site: Site) -> Place | None:
    """Return the place behind the statement of a call site, and behind what waits for it."""
    statement = climb(statement_of(site.call))
    if statement is None:
        return None
    while (following := _last_of(analysis, statement, site)) is not None:
        statement = following
    place = place_at(analysis, statement, site.scope, site.receiver, site)
    if place is None or not _is_handed_on(analysis, site):
        return place
    # What gets the endpoint may go on for as long as the node does.
    return replace(place, offset=line_start(analysis.syntax.text, statement.start_byte))


def _is_handed_on(analysis: Analysis, site: Site) -> bool:
    """Whether a call is part of one that does more than to hold what it is given."""
    statement = statement_of(site.call)
    node = site.call.parent
    while node is not None and node.id != statement.id:
        if node.type == "call" and analysis.syntax.called_name(node) not in _HOLDING:
            return True
        node = node.parent
    return False


def _last_of(analysis: Analysis, statement: Node, site: Site) -> Node | None:
    """Return the next statement of an endpoint, also behind one that says what it waits for."""
    following = statement.next_named_sibling
    if following is not None and _tells_of(statement, following, site):
        return following
    name = target_name(analysis, site) or ""
    for _ in range(2):
        if following is None or _goes_with(following, name):
            return following
        if b"log" not in (following.text or b"") and b"print" not in (following.text or b""):
            return None
        following = following.next_named_sibling
    return None


def _goes_with(statement: Node, name: str) -> bool:
    """Whether a statement waits for an endpoint, or only names it to have it used."""
    text = statement.text or b""
    waiting = rb"((while|if) not )?" + re.escape(name.encode()) + rb"\.wait_for_"
    return bool(name) and (text == name.encode() or re.match(waiting, text) is not None)


def _tells_of(above: Node, statement: Node, site: Site) -> bool:
    """Whether a statement right below that of an endpoint logs that this one is there.

    What tells of several, or of the node, comes when all of them are there.
    """
    text = statement.text or b""
    called = _CALLED.match(text)
    is_log = called is not None and (called[1] == b"print" or b"log" in called[1])
    is_below = statement.start_point.row == above.end_point.row + 1
    if not (is_log and is_below) or b"node" in text.lower():
        return False
    topic = re.escape((site.endpoint.name or "").strip("/~").encode())
    words = _TELLING.get(site.endpoint.kind, rb"(?!)") + (
        rb"|\b" + topic + rb"\b" if topic else b""
    )
    return re.search(words, text, re.IGNORECASE) is not None


def place_behind(analysis: Analysis, place: Place, node: Node) -> Place | None:
    """Return a place behind a definition of the same block, None where the node runs before it."""
    block, later = place.statement.parent, statement_of(node)
    if block is None or later.parent is None or later.parent.id != block.id:
        return None
    between = [each for each in parts_of(block) if place.offset <= each.start_byte]
    before = [each for each in between if each.start_byte < later.start_byte]
    behind = [each for each in between if each.start_byte > later.start_byte]
    behind = [each for each in behind if not each.type.endswith("_definition")]
    if any(each.type in LAST or stays(each) for each in before):
        return None
    text = analysis.syntax.text
    offset = line_end(text, later.end_byte)
    if behind:
        offset = before_comments(text, line_start(text, behind[0].start_byte))
    return replace(place, offset=offset, statement=next(iter(behind), later))


def climb(statement: Node) -> Node | None:
    """Return the statement, or what is around it and may run never or more than once."""
    found = statement
    current: Node | None = statement
    while current is not None and current.type not in ("module", "ERROR"):
        parent = current.parent
        if parent is None or current.type in ("function_definition", "class_definition"):
            break
        is_around = parent.type in STATEMENT_PARENTS and current is not statement
        is_compound = current.type.endswith("_statement") and current.type not in _RUNS_ONCE
        if is_around and is_compound and not is_main_guard(current) and not stays(current):
            found = current
        current = parent
    return found if found.parent is not None and found.parent.type in STATEMENT_PARENTS else None


def is_guarded(statement: Node) -> bool:
    """Whether a statement is tried, and what is behind the `try` runs also where it failed."""
    current: Node | None = statement
    while current is not None and not current.type.endswith("_definition"):
        parent = current.parent
        if parent is not None and parent.type == "try_statement":
            handlers = [each for each in parent.named_children if each.type == "except_clause"]
            is_body = current.id == parent.named_children[0].id
            goes_on = parent.next_named_sibling is not None
            if is_body and goes_on and any(map(_is_passed, handlers)):
                return True
        current = parent
    return False


def _is_passed(handler: Node) -> bool:
    """Whether a handler lets the function go on."""
    body = parts_of(handler)[-1]
    last = next(iter(parts_of(body)[-1:]), body)
    return last.type not in LAST and b"exit(" not in (last.text or b"")


def place_before(analysis: Analysis, place: Place, statement: Node) -> Place:
    """Return a place before a statement of the same function, and before its comments."""
    text = analysis.syntax.text
    offset = before_comments(text, line_start(text, statement.start_byte))
    indent = leading_space(analysis, statement)
    return replace(place, offset=offset, indent=indent, statement=statement)


def stays(statement: Node) -> bool:
    """Whether a statement holds what the node does until it ends, so that nothing comes after."""
    is_loop = statement.type == "while_statement"
    return not is_loop and _GOES_ON.search(statement.text or b"") is not None


def place_at(
    analysis: Analysis, statement: Node, scope: Scope, receiver: str, site: Site | None
) -> Place | None:
    """Return the place behind a statement, None where its line leaves no room for one."""
    text = analysis.syntax.text
    ends = _ends_of_line(statement)
    if ends is None:
        return None
    first, last = ends
    start = line_start(text, first.start_byte)
    following = statement.next_named_sibling
    while following is not None and following.end_byte <= last.end_byte:
        if stays(following) or following.type in LAST:
            return None
        following = following.next_named_sibling
    statement = last
    if text[start : first.start_byte].strip():
        return None
    function = scope.enclosing("function")
    owner = function.parent if function is not None and function.self_name else None
    is_before = statement.type in LAST and not _ends_soon(statement)
    offset = start if is_before else line_end(text, statement.end_byte)
    return Place(
        offset,
        leading_space(analysis, first),
        function or analysis.scopes.module,
        owner,
        function.self_name if function is not None else "",
        receiver,
        site,
        statement,
    )


def _ends_soon(statement: Node) -> bool:
    """Whether a loop is there to wait for a service or a server."""
    condition = statement.child_by_field_name("condition")
    return condition is not None and b".wait_for_" in (condition.text or b"")


def _ends_of_line(statement: Node) -> tuple[Node, Node] | None:
    """Return the first and the last statement of a line; None for more than anybody writes."""
    first = last = statement
    for _ in range(_MOST_ON_LINE):
        after = last.next_named_sibling
        if after is None or after.start_point.row != last.end_point.row or after.type == "comment":
            break
        last = after
    else:
        return None
    for _ in range(_MOST_ON_LINE):
        before = first.prev_named_sibling
        if before is None or before.end_point.row != first.start_point.row:
            return first, last
        first = before
    return None
