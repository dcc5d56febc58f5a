"""Where a function waits for another node: what is new does not have to wait with it."""

from __future__ import annotations

import re
from collections import defaultdict

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from .analysis import Analysis, Site
from .conventions import target_name
from .place import LAST, Place, place_at, place_before
from .references import STATEMENT_PARENTS, statement_of
from .scopes import Scope
from .syntax import is_main_guard

_WAITING = re.compile(r"wait_?for_?\w+$|get_topic_(class|type)$|spin_until_future_complete$", re.I)
# A look-up of a topic's type waits for its publisher only if it is told to.
_LOOKING_UP = re.compile(rb"get_topic_(?:class|type)\((?!.*True)", re.DOTALL)
# What a statement waits for, by its name or the variable of that.
_SERVICES = re.compile(rb"wait_for_(?:service|server)\(([^)]*)\)")
_TOKENS = re.compile(rb"[A-Za-z_][\w.]*|\"[^\"]*\"|'[^']*'")


class Waits:
    """The statements of a file that wait for other nodes, by the function that they are in."""

    def __init__(self, analysis: Analysis) -> None:
        self._analysis = analysis
        found: dict[Scope, dict[int, Node]] = defaultdict(dict)
        for call in analysis.captures.get("call", []):
            name = analysis.syntax.called_name(call)
            if name and _WAITING.match(name) and not _LOOKING_UP.search(call.text or b""):
                function = _function(analysis, call)
                statement = statement_of(call)
                found[function].setdefault(statement.id, statement)
        for site in analysis.sites:
            if site.endpoint.kind is EndpointKind.CLIENT and (asked := _asked(site)) is not None:
                found[_function(analysis, asked)].setdefault(asked.id, asked)
        self._of = {
            function: sorted(statements.values(), key=lambda each: int(each.start_byte))
            for function, statements in found.items()
        }

    def is_behind(self, place: Place) -> bool:
        """Whether a place comes when its function has waited."""
        return any(each.start_byte < place.offset for each in self._of.get(place.scope, ()))

    def step_before(self, place: Place, kind: EndpointKind) -> Place:
        """Return a place before the waits above another, if an endpoint of a kind may go there.

        It stays beside its like that waits for something else: that is how the file has them.
        """
        made = self._made(place)
        if made is None:
            return place
        waits = self._of.get(place.scope, [])
        waits = [each for each in waits if made <= each.start_byte < place.offset]
        site = place.beside
        is_like = site is not None and site.endpoint.kind is kind
        if not waits or (is_like and not any(self._is_for(each, site) for each in waits)):
            return place
        first = self._with_awaited(_outermost(waits[0], made), made)
        block = first.parent
        if block is None or not block.start_byte <= place.statement.start_byte < block.end_byte:
            return place
        above = first.prev_named_sibling
        while above is not None and above.type == "comment":
            above = above.prev_named_sibling
        if above is None or above.type in LAST or above.type.endswith("_definition"):
            return place_before(self._analysis, place, first)
        found = place_at(self._analysis, above, place.scope, place.receiver, site)
        return found or place

    def _made(self, place: Place) -> int | None:
        """Return where a function has what an endpoint needs; None where that is not sure."""
        analysis, function = self._analysis, place.scope
        makers = [node.call for node in analysis.nodes if node.call is not None]
        makers += [
            call
            for call in analysis.captures.get("call", [])
            if analysis.syntax.called_name(call) == "__init__"
        ]
        ends = [each.end_byte for each in makers if _function(analysis, each) is function]
        holder, dot, name = place.receiver.partition(".")
        bindings = function.bindings.get(holder, [])
        if dot and place.owner is not None and holder == place.self_name:
            bindings = place.owner.attributes.get(name, [])
        ends += [
            each.node.end_byte
            for each in bindings
            if each.scope is function and each.node.start_byte >= function.start
        ]
        before = [end for end in ends if end <= place.offset]
        return max(before, default=None if ends else 0)

    def _is_for(self, wait: Node, site: Site | None) -> bool:
        """Whether a statement waits for an endpoint, or for what that is made with."""
        if site is None:
            return False
        if wait.start_byte <= site.call.start_byte < wait.end_byte:
            return True
        target = (target_name(self._analysis, site) or "").encode()
        text = wait.text or b""
        if target and target + b"." in text:
            return True
        given = set(_TOKENS.findall(site.call.text or b""))
        made = set(_TOKENS.findall(_assigned(wait)))
        for_service = set(_TOKENS.findall(b" ".join(_SERVICES.findall(text))))
        return not given.isdisjoint(made | for_service)

    def _with_awaited(self, wait: Node, made: int) -> Node:
        """Return the first of the statements that make what a statement waits for, and tell it."""
        names = set(_TOKENS.findall(wait.text or b""))
        first, above = wait, wait.prev_named_sibling
        while above is not None and above.start_byte >= made:
            target = _assigned(above).strip()
            is_awaited = bool(target) and any(
                name == target or name.startswith(target + b".") for name in names
            )
            is_told = re.match(rb"[^(]*(log|print)", above.text or b"") is not None
            if is_awaited or (is_told and b"ait" in (above.text or b"")):
                first = above
            elif not is_told and above.type != "comment":
                break
            above = above.prev_named_sibling
        return first


def _function(analysis: Analysis, node: Node) -> Scope:
    scope = analysis.scopes.at(node.start_byte)
    return scope.enclosing("function") or analysis.scopes.module


def _asked(site: Site) -> Node | None:
    """Return the `try` around a client that takes it that its service may not answer."""
    node = site.call.parent
    while node is not None and not node.type.endswith("_definition"):
        if node.type == "try_statement":
            handlers = [each for each in node.children if each.type == "except_clause"]
            if any(b"ServiceException" in (each.text or b"") for each in handlers):
                return node
        node = node.parent
    return None


def _outermost(statement: Node, made: int) -> Node:
    """Return the statement of a function that one is in, behind what makes the node."""
    found, current = statement, statement.parent
    while current is not None and current.start_byte >= made:
        if current.type in ("function_definition", "module") or is_main_guard(current):
            break
        if current.parent is not None and current.parent.type in STATEMENT_PARENTS:
            found = current
        current = current.parent
    return found


def _assigned(statement: Node) -> bytes:
    """Return the targets of an assignment, "" of any other statement."""
    inner = statement.named_children[0] if statement.named_child_count else None
    target = inner.child_by_field_name("left") if inner and inner.type == "assignment" else None
    return (target.text or b"") if target is not None else b""
