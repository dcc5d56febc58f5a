"""Where in a file a new endpoint goes: beside the others, or behind what makes the node."""

from __future__ import annotations

from dataclasses import replace

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, NodeSite, Site
from .conventions import target_name
from .functions import callback_scope
from .place import LAST, Place, beside, climb, is_guarded, place_at, stays
from .references import statement_of
from .run_order import Starting, When
from .scopes import Scope
from .syntax import is_main_guard, parts_of
from .waits import Waits

KINDS = (
    EndpointKind.PUBLISHER,
    EndpointKind.SUBSCRIPTION,
    EndpointKind.SERVICE,
    EndpointKind.CLIENT,
    EndpointKind.ACTION_SERVER,
    EndpointKind.ACTION_CLIENT,
    EndpointKind.TIMER,
)


def find_place(
    analysis: Analysis, kind: EndpointKind, *, needs_function: bool = False
) -> Place | None:
    """Return where an endpoint of a kind goes, None where the file makes no node.

    Args:
        analysis: what is known of the node.
        kind: the kind of the endpoint.
        needs_function: whether a function comes with it, which is rather a class's method than
            one in another function.
    """
    callbacks = _callbacks(analysis)
    starting, waits = Starting(analysis), Waits(analysis)
    last: dict[tuple[bool, bool, bool, bool, When], Place] = {}
    has_class = any(node.owner and behind_node(analysis, node) for node in analysis.nodes)
    for site in reversed(analysis.sites):
        if site.endpoint.kind not in KINDS or not _is_setup(analysis, site, callbacks):
            continue
        if has_class and _is_in_helper(analysis, site):
            continue
        if (place := beside(analysis, site)) is not None:
            is_other = site.endpoint.kind is not kind
            is_nested = needs_function and not place.owner and place.scope.parent is not None
            is_behind = is_other and waits.is_behind(place)
            is_tried = is_guarded(place.statement)
            rank = (is_nested, is_tried, is_behind, is_other, starting.when(site))
            last.setdefault(rank, place)
    ready = [rank for rank in last if rank[-1] <= When.SETTING_UP]
    if ready:
        found = once_named(analysis, last[min(ready)])
        is_tried = is_guarded(found.statement)
        nodes = (behind_node(analysis, node) for node in analysis.nodes if is_tried)
        safe = (each for each in nodes if each is not None and each.scope is found.scope)
        return next((each for each in safe if not is_guarded(each.statement)), found)
    later = sorted(last, key=lambda rank: (rank[-1], *rank[:-1]))
    for rank in later:
        made = _in_constructor(analysis, last[rank], starting)
        if made is not None:
            return made
    for node in analysis.nodes:
        behind = behind_node(analysis, node)
        if behind is not None:
            return behind
    return last[later[0]] if later and later[0][-1] < When.ON_DEMAND else None


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
            return behind_node(analysis, node)
    holder, _, name = place.receiver.partition(".")
    if place.receiver and (holder != place.self_name or not _is_set_in(made, name)):
        return None
    statement = None
    for each in parts_of(made.node.child_by_field_name("body")):
        if stays(each):
            break
        statement = each
        if each.type in LAST:
            break
    if statement is None:
        return None
    receiver = place.receiver.replace(holder, made.self_name, 1)
    return place_at(analysis, statement, made, receiver, None)


def _is_set_in(made: Scope, name: str) -> bool:
    """Whether a constructor sets an attribute that other methods use."""
    owner = made.parent
    found = owner.attributes.get(name, []) if owner is not None else []
    return any(each.scope is made for each in found)


def once_named(analysis: Analysis, place: Place) -> Place:
    """Return a place behind `init_node`: before it, rospy starts no timer and no service."""
    if analysis.library.node_classes:
        return place
    for node in analysis.nodes:
        if (
            node.call is not None
            and (node.scope.enclosing("function") or node.scope) is place.scope
        ):
            behind = behind_node(analysis, node)
            if behind is not None and place.offset < behind.offset:
                return replace(behind, beside=place.beside)
    return place


def running_place(analysis: Analysis, place: Place) -> Place:
    """Return a place for what starts a timer: a module runs before a function calls `init_node`."""
    if analysis.library.node_classes or place.scope.parent is not None:
        return place
    for node in analysis.nodes:
        if node.call is not None and node.scope.enclosing("function") is not None:
            return behind_node(analysis, node) or place
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
    if site.shape.gives_message:
        return False
    if statement_of(site.call).type == "return_statement":
        return False
    return not _is_in_callback(site, callbacks)


def _is_in_helper(analysis: Analysis, site: Site) -> bool:
    """Whether a call site is in a class that is no node, nor a part of one, but gets one."""
    owner = site.scope.enclosing("class")
    if owner is None or analysis.resolver.derives_from(owner, analysis.library.node_classes):
        return False
    kin = {
        owner,
        *analysis.resolver.classes.bases(owner),
        *analysis.resolver.classes.derived(owner),
    }
    return all(node.owner not in kin for node in analysis.nodes)


def _is_in_callback(site: Site, callbacks: set[int]) -> bool:
    scope: Scope | None = site.scope
    while scope is not None:
        if scope.kind == "lambda" or scope.node.id in callbacks:
            return True
        scope = scope.parent
    return False


def behind_node(analysis: Analysis, node: NodeSite) -> Place | None:
    """Return the place behind what makes a node, None where there is none."""
    if node.call is not None:
        statement = statement_of(node.call)
        scope = analysis.scopes.at(node.call.start_byte)
        receiver = ""
        if analysis.library.node_classes:
            receiver = scope.self_name if node.owner is not None else _made(analysis, node.call)
            if not receiver:
                return None
        climbed = climb(statement) if receiver else _started(analysis, statement)
        if climbed is None:
            return None
        if scope.self_name:
            climbed = _behind_bases(analysis, climbed)
        return place_at(analysis, climbed, scope, receiver, None)
    for call in analysis.captures.get("call", []):
        # A node class without a constructor: the variable that holds its instance.
        callee = call.child_by_field_name("function")
        if callee is not None and analysis.syntax.slice(callee) == node.scope.name:
            receiver = _made(analysis, call)
            climbed = climb(statement_of(call))
            if receiver and climbed is not None:
                scope = analysis.scopes.at(call.start_byte)
                return place_at(analysis, climbed, scope, receiver, None)
    return None


def _behind_bases(analysis: Analysis, statement: Node) -> Node:
    """Return the last statement of a block that sets up a base class, or the one given."""
    found, current = statement, statement.next_named_sibling
    while current is not None and current.type not in LAST and not stays(current):
        called = next(iter(current.named_children), None)
        is_call = current.type == "expression_statement" and called is not None
        if is_call and analysis.syntax.called_name(called) == "__init__":
            found = current
        current = current.next_named_sibling
    return found


def _started(analysis: Analysis, statement: Node) -> Node | None:
    """Return the statement behind which a call of `init_node` has run, if it does at all.

    It may be all that a `try` does, or one branch of an `if`: one that goes on with what the file
    is for is the only one in which there is a node.
    """
    block = statement.parent
    around = block.parent if block is not None else None
    if around is None:
        return climb(statement)
    rest = [each for each in parts_of(block) if each.start_byte > statement.start_byte]
    if around.type == "try_statement" and not rest:
        return climb(around)
    is_branch = around.type in ("else_clause", "elif_clause")
    whole = around.parent if is_branch else around
    if whole is None or whole.type != "if_statement" or is_main_guard(whole):
        return climb(statement)
    branches = [whole.child_by_field_name("consequence")]
    branches += whole.children_by_field_name("alternative")
    is_alone = any(b"init_node(" not in (each.text or b"") for each in branches if each)
    goes_on = any(_calls_file(analysis, each) for each in rest)
    return statement if is_alone or goes_on else climb(statement)


def _calls_file(analysis: Analysis, statement: Node) -> bool:
    """Whether a statement calls a function or a class of the file."""
    names = {scope.name for scope in analysis.scopes.all if scope.kind in ("function", "class")}
    return any(
        statement.start_byte <= call.start_byte < statement.end_byte
        and analysis.syntax.called_name(call) in names
        for call in analysis.captures.get("call", [])
    )


def _made(analysis: Analysis, call: Node) -> str:
    parent = call.parent
    target = parent.child_by_field_name("left") if parent and parent.type == "assignment" else None
    if target is None or target.type not in ("identifier", "attribute"):
        return ""
    return analysis.syntax.slice(target)
