"""Where in a file a new endpoint goes: beside the others, or behind what makes the node."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, NodeSite, Site
from .conventions import leading_space, target_name
from .references import STATEMENT_PARENTS, statement_of
from .removal import callback_scope
from .run_order import Starting, When
from .scopes import Scope
from .splices import before_comments, line_end, line_start
from .syntax import parts_of

KINDS = (
    EndpointKind.PUBLISHER,
    EndpointKind.SUBSCRIPTION,
    EndpointKind.SERVICE,
    EndpointKind.CLIENT,
    EndpointKind.ACTION_SERVER,
    EndpointKind.ACTION_CLIENT,
    EndpointKind.TIMER,
)
# Behind these nothing runs, or not while the node does.
_LAST = frozenset({"while_statement", "return_statement", "raise_statement"})
# What gets an endpoint, and does nothing with it yet.
_HOLDING = frozenset(
    {"add", "append", "dict", "extend", "insert", "list", "partial", "publish", "set", "setdefault"}
    | {"tuple", "update", "ApproximateTimeSynchronizer", "Cache", "TimeSynchronizer"}
)
# What is around an endpoint and yet runs exactly once.
_RUNS_ONCE = frozenset({"try_statement", "with_statement"})
_GOES_ON = re.compile(rb"\bis_shutdown\(|\brclpy\.ok\(|\bspin\(")
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


def find_place(analysis: Analysis, kind: EndpointKind) -> Place | None:
    """Return where an endpoint of a kind goes, None where the file makes no node."""
    callbacks = _callbacks(analysis)
    starting = Starting(analysis)
    last: dict[tuple[bool, When], Place] = {}
    for site in reversed(analysis.sites):
        if site.endpoint.kind not in KINDS or not _is_setup(analysis, site, callbacks):
            continue
        rank = (site.endpoint.kind is not kind, starting.when(site))
        if rank not in last and (place := beside(analysis, site)) is not None:
            last[rank] = place
    ready = [rank for rank in last if rank[1] <= When.SETTING_UP]
    if ready:
        return _once_named(analysis, last[min(ready)])
    later = sorted(last, key=lambda rank: (rank[1], rank[0]))
    for rank in later:
        made = _in_constructor(analysis, last[rank], starting)
        if made is not None:
            return made
    for node in analysis.nodes:
        behind = _behind_node(analysis, node)
        if behind is not None:
            return behind
    if later:
        return last[later[0]] if later[0][1] < When.ON_DEMAND else None
    for site in reversed(analysis.sites):
        if site.endpoint.kind in KINDS and not _is_in_callback(site, callbacks):
            place = beside(analysis, site)
            if place is not None:
                return place
    return None


def _in_constructor(analysis: Analysis, place: Place, starting: Starting) -> Place | None:
    """Return a place where the object is made that a method gives endpoints when it is called.

    What the method lets go of is not the object's.
    """
    target = target_name(analysis, place.beside) if place.beside is not None else None
    is_let_go = target is not None and "." not in target
    owner = None if is_let_go else place.owner
    found = owner.bindings.get("__init__", []) if owner is not None else []
    made = found[0].owner if len(found) == 1 else None
    if made is None or not made.self_name or not starting.is_starting(made):
        return None
    for node in analysis.nodes:
        if node.call is not None and node.scope.enclosing("function") is made:
            return _behind_node(analysis, node)
    holder, _, name = place.receiver.partition(".")
    if place.receiver and (holder != place.self_name or not _is_set_in(made, name)):
        return None
    statement = None
    for each in parts_of(made.node.child_by_field_name("body")):
        if _stays(each):
            break
        statement = each
        if each.type in _LAST:
            break
    if statement is None:
        return None
    receiver = place.receiver.replace(holder, made.self_name, 1)
    return _place(analysis, statement, made, receiver, None)


def _is_set_in(made: Scope, name: str) -> bool:
    """Whether a constructor sets an attribute that other methods use."""
    owner = made.parent
    found = owner.attributes.get(name, []) if owner is not None else []
    return any(each.scope is made for each in found)


def _once_named(analysis: Analysis, place: Place) -> Place:
    """Return a place behind `init_node`: before it, rospy starts no timer and no service."""
    if analysis.library.node_classes:
        return place
    for node in analysis.nodes:
        if (
            node.call is not None
            and (node.scope.enclosing("function") or node.scope) is place.scope
        ):
            behind = _behind_node(analysis, node)
            if behind is not None and place.offset < behind.offset:
                return replace(behind, beside=place.beside)
    return place


def running_place(analysis: Analysis, place: Place) -> Place:
    """Return a place for what starts a timer: a module runs before a function calls `init_node`."""
    if analysis.library.node_classes or place.scope.parent is not None:
        return place
    for node in analysis.nodes:
        if node.call is not None and node.scope.enclosing("function") is not None:
            return _behind_node(analysis, node) or place
    return place


def _callbacks(analysis: Analysis) -> set[int]:
    found = set()
    for site in analysis.sites:
        scope = callback_scope(analysis, site)
        if scope is not None:
            found.add(scope.node.id)
    return found


def _is_setup(analysis: Analysis, site: Site, callbacks: set[int]) -> bool:
    """Whether a call site may run when the node starts: not in a callback or a lambda.

    What a function creates to return it, it creates for others, whenever they call it.
    """
    if "wait_for_message" in "".join(site.shape.callees):
        return False
    if statement_of(site.call).type == "return_statement":
        return False
    return not _is_in_callback(site, callbacks)


def _is_in_callback(site: Site, callbacks: set[int]) -> bool:
    scope: Scope | None = site.scope
    while scope is not None:
        if scope.kind == "lambda" or scope.node.id in callbacks:
            return True
        scope = scope.parent
    return False


def beside(analysis: Analysis, site: Site) -> Place | None:
    """Return the place behind the statement of a call site, and behind what waits for it."""
    statement = climb(statement_of(site.call))
    if statement is None:
        return None
    name = target_name(analysis, site) or ""
    while (following := _last_of(statement, name)) is not None:
        statement = following
    place = _place(analysis, statement, site.scope, site.receiver, site)
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


def _last_of(statement: Node, name: str) -> Node | None:
    """Return the next statement of an endpoint, also behind one that says what it waits for."""
    following = statement.next_named_sibling
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
    return bool(name) and (text == name.encode() or text.startswith(f"{name}.wait_for_".encode()))


def place_behind(analysis: Analysis, place: Place, node: Node) -> Place | None:
    """Return a place behind a definition of the same block, None where the node runs before it."""
    block, later = place.statement.parent, statement_of(node)
    if block is None or later.parent is None or later.parent.id != block.id:
        return None
    between = [each for each in parts_of(block) if place.offset <= each.start_byte]
    before = [each for each in between if each.start_byte < later.start_byte]
    behind = [each for each in between if each.start_byte > later.start_byte]
    behind = [each for each in behind if not each.type.endswith("_definition")]
    if any(each.type in _LAST or _stays(each) for each in before):
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
        if is_around and is_compound and not _is_main_guard(current) and not _stays(current):
            found = current
        current = parent
    return found if found.parent is not None and found.parent.type in STATEMENT_PARENTS else None


def _stays(statement: Node) -> bool:
    """Whether a statement holds what the node does until it ends, so that nothing comes after."""
    is_loop = statement.type == "while_statement"
    return not is_loop and _GOES_ON.search(statement.text or b"") is not None


def _is_main_guard(statement: Node) -> bool:
    condition = statement.child_by_field_name("condition")
    return condition is not None and b"__name__" in (condition.text or b"")


def _behind_node(analysis: Analysis, node: NodeSite) -> Place | None:
    if node.call is not None:
        statement = statement_of(node.call)
        scope = analysis.scopes.at(node.call.start_byte)
        receiver = ""
        if analysis.library.node_classes:
            receiver = scope.self_name if node.owner is not None else _made(analysis, node.call)
            if not receiver:
                return None
        climbed = climb(statement)
        return _place(analysis, climbed, scope, receiver, None) if climbed is not None else None
    for call in analysis.captures.get("call", []):
        # A node class without a constructor: the variable that holds its instance.
        callee = call.child_by_field_name("function")
        if callee is not None and analysis.syntax.slice(callee) == node.scope.name:
            receiver = _made(analysis, call)
            climbed = climb(statement_of(call))
            if receiver and climbed is not None:
                scope = analysis.scopes.at(call.start_byte)
                return _place(analysis, climbed, scope, receiver, None)
    return None


def _made(analysis: Analysis, call: Node) -> str:
    parent = call.parent
    target = parent.child_by_field_name("left") if parent and parent.type == "assignment" else None
    if target is None or target.type not in ("identifier", "attribute"):
        return ""
    return analysis.syntax.slice(target)


def _place(
    analysis: Analysis, statement: Node, scope: Scope, receiver: str, site: Site | None
) -> Place | None:
    text = analysis.syntax.text
    ends = _ends_of_line(statement)
    if ends is None:
        return None
    first, last = ends
    start = line_start(text, first.start_byte)
    following = statement.next_named_sibling
    while following is not None and following.end_byte <= last.end_byte:
        if _stays(following) or following.type in _LAST:
            return None
        following = following.next_named_sibling
    statement = last
    if text[start : first.start_byte].strip():
        return None
    function = scope.enclosing("function")
    owner = function.parent if function is not None and function.self_name else None
    is_before = statement.type in _LAST
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
