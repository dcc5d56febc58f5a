"""Where a unit creates an endpoint that is added, and what it is created on."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.source import Add, EndpointKind

from ..analysis import Analysis, NodeSite, Site
from ..nodes import group, main_class
from ..receivers import HANDLE, MANAGED_CLASSES, NODE_CLASSES
from ..scopes import CppFile, Function, Scope, Variable
from ..shapes import TRANSFORMS
from .manner import held_by
from .refusals import RefusedError
from .statements import above, is_endless
from .units import labels_of
from .uses import is_static

_STARTING = re.compile(r"(?:on_?)?(?:init|set_?up|start|config|activate|create|advertise)", re.I)


@dataclass(frozen=True, slots=True)
class Place:
    """Where an endpoint is created.

    Attributes:
        file: the file.
        function: the function that creates it.
        body: the block that it goes into.
        after: the statement behind which it goes, None for the start of the block, or its end.
        is_end: whether it goes to the end of the block, where there is no statement.
        owner: the class whose method the function is, None for none.
        node: what stands before a method of the node: ``, `this->`, `node->`; "" in ROS 1.
        beside: the call beside which it goes, None for none.
    """

    file: CppFile
    function: Function
    body: Node
    after: Node | None
    owner: Scope | None
    node: str = ""
    beside: Site | None = None
    is_end: bool = False

    @property
    def offset(self) -> int:
        """Where it goes, in bytes."""
        if self.after is not None:
            return self.after.end_byte
        return self.body.end_byte - 1 if self.is_end else self.body.start_byte + 1

    @property
    def is_conditional(self) -> bool:
        """Whether a condition decides if anything is created there."""
        outer = self.body.parent
        return outer is not None and outer.type in ("if_statement", "else_clause")

    @property
    def scope(self) -> Scope:
        """The names that are seen there."""
        assert self.function.scope is not None, "the place is in a body"
        return self.function.scope

    @property
    def node_argument(self) -> str:
        """What a function gets that takes the node."""
        if self.node.endswith("."):
            return f"&{self.node[:-1]}"
        return self.node.removesuffix("->") or "this"


def sites_of_node(analysis: Analysis, label: str | None) -> list[Site]:
    """Return the call sites of a node."""
    if label is None:
        return list(analysis.sites)
    labels = labels_of(analysis)
    return [site for site in analysis.sites if labels.get(site) == label]


def find_place(analysis: Analysis, change: Add, kind: EndpointKind) -> Place:
    """Return where an endpoint of a kind is created.

    Raises:
        RefusedError: there is no such place.
    """
    ranked = []
    callbacks = {
        id(each.node) for site in analysis.sites for each in site.callback.functions if each.scope
    }
    group(analysis)
    owners = {id(each.owner) for each in analysis.nodes if each.owner is not None}
    if change.node is not None:
        named = [each for each in analysis.nodes if _label(each) == change.node]
        owners = {id(each.owner) for each in named if each.owner is not None} or owners
    for at, site in enumerate(sites_of_node(analysis, change.node)):
        place = beside(analysis, site)
        if place is None or id(place.function.node) in callbacks or site.bindings:
            continue
        if place.owner is None and place.file.name:
            # A variable of a header is one of each source that includes it.
            continue
        if any(place.function.node.id == each.node.id for each in _called_back(analysis)):
            continue
        if is_static(analysis, place.function):
            # What makes the object has no member at hand.
            continue
        rank = start_rank(analysis, place.function)
        if rank is None:
            continue
        is_parameter = site.endpoint.kind is EndpointKind.PARAMETER
        is_wanted = kind is EndpointKind.PARAMETER
        # What creates something under a name that it gets does so for others.
        is_helper = site.endpoint.name is None and site.endpoint.kind is not EndpointKind.TIMER
        is_helper = is_helper and bool(place.function.parameters) and rank > 0
        is_foreign = bool(owners) and place.owner is not None and id(place.owner) not in owners
        key = (
            is_foreign,
            bool(place.file.name) and not place.owner,
            is_helper,
            is_parameter != is_wanted,
            rank,
            site.endpoint.kind is not kind,
            place.after is None,
            -at,
        )
        ranked.append((key, place))
    if ranked:
        return min(ranked, key=lambda each: each[0])[1]
    place = _of_node(analysis, change)
    if place is None:
        message = f"the file has no place where it could create `{change.endpoint.name}` once, as"
        message = f"{message} it starts"
        others = [each.call for each in analysis.sites if not each.call.scope.file.is_beside]
        if others:
            lines = ", ".join(dict.fromkeys(str(each.node.start_point.row + 1) for each in others))
            message += f": what stands in line {lines} may run again, or not at all"
        remedy = "add it to the file that makes the node"
        raise RefusedError(message, change.endpoint.span, remedy)
    return place


def _called_back(analysis: Analysis) -> Iterator[Function]:
    for site in analysis.sites:
        yield from site.callback.functions


def is_model(site: Site) -> bool:
    """Tell whether a call creates an endpoint as the client library does, and not a part of it."""
    shape = site.shape
    is_own = shape.on in ("handle", "node", "function", "maybe")
    is_own = is_own and shape.fixed is None and site.options is None
    is_listener = site.endpoint.type == TRANSFORMS
    return is_own and not is_listener and "message_filters" not in site.call.qualifier


def start_rank(analysis: Analysis, function: Function, depth: int = 0) -> int | None:
    """Tell how sure a function runs once as the node starts: 0 is sure, None is not at all."""
    owner = analysis.unit.class_of_function(function)
    if function.name in ("main", "onInit") or (owner is not None and owner.name == function.name):
        return 0
    if depth > 4:
        return None
    # `Base::onInitialize()` in an `onInitialize` is that of the base class.
    found = analysis.callers.of(function)
    calls = [each for each in found if analysis.unit.function_of(each.scope) is not function]
    if len(calls) > 1:
        # Of several constructors one runs.
        outers = [analysis.unit.function_of(each.scope) for each in calls]
        names = {"" if each is None else each.name for each in outers}
        is_each_once = len({id(each) for each in outers}) == len(outers)
        is_made_so = owner is not None and names == {owner.name}
        return 0 if is_made_so and is_each_once else None
    if not calls:
        return 1 if _STARTING.match(function.name) else 2
    (call,) = calls
    inner: Node | None = call.node
    while inner is not None and inner.type not in ("function_definition", "lambda_expression"):
        if inner.type in ("while_statement", "for_statement", "do_statement"):
            return None
        inner = inner.parent
    outer = analysis.unit.function_of(call.scope)
    if outer is None or inner is None or inner.type == "lambda_expression":
        return None
    return start_rank(analysis, outer, depth + 1)


def beside(analysis: Analysis, site: Site) -> Place | None:
    """Return the place behind the statement of a call, None where that is none to add at."""
    if site.shape.on in ("", "filter", "lazy") or site.endpoint.type == TRANSFORMS:
        return None
    scope = site.call.scope
    outer = scope.enclosing("function", "lambda", "class")
    if outer is None or outer.kind != "function" or outer.function is None:
        return None
    function = outer.function
    body = function.body
    if body is None:
        return None
    after, block = _statement(site.call.node, body)
    if after is not None and leaves(after):
        return None
    if after is not None and is_endless(site.file, after):
        after = above(after)
    after = _with_uses(analysis, site, after)
    owner = analysis.unit.class_of_function(function)
    node = node_prefix(analysis, site) if analysis.ros_version == 2 else ""
    is_own_node = owner is None or node is not None
    if not is_own_node or (node is None):
        return None
    return Place(site.file, function, block, after, owner, node, site)


def _with_uses(analysis: Analysis, site: Site, after: Node | None) -> Node | None:
    """Return the last statement of a run that begins what was created: `server_->start();`."""
    variable = held_by(analysis, site)
    if after is None or variable is None:
        return after
    word = site.file.syntax.word
    begins = re.compile(rf"(?:this->)?{re.escape(variable.name)}(?:->|\.)")
    while (following := after.next_named_sibling) is not None:
        if following.type != "expression_statement" or not begins.match(word(following)):
            break
        after = following
    return after


def leaves(statement: Node) -> bool:
    """Tell whether nothing behind a statement is reached."""
    return statement.type in ("return_statement", "throw_statement")


def _statement(node: Node, body: Node) -> tuple[Node | None, Node]:
    """Return the statement of a body, or of a `try` in it, that a call stands in, and its block."""
    chain: list[Node] = []
    inner: Node | None = node
    while inner is not None and inner.id != body.id:
        chain.append(inner)
        inner = inner.parent
    if inner is None:
        return None, body
    if body.type == "try_statement":
        return None, body
    after, block = chain[-1], body
    for outer, each, deeper in zip(chain[::-1], chain[-2::-1], chain[-3::-1], strict=False):
        if outer.type == "try_statement" and each.type == "compound_statement":
            after, block = deeper, each
        break
    return after, block


def node_prefix(analysis: Analysis, site: Site) -> str | None:
    """Return what stands before the methods of a site's node, None where that is no name."""
    syntax = site.file.syntax
    call = site.call
    if site.shape.on == "node":
        if call.receiver is None:
            return ""
        assert call.name_node is not None, "a method has a name"
        text = syntax.between(call.receiver.start_byte, call.name_node.start_byte)
        text = text.removesuffix("template ").strip()
        return text if re.fullmatch(r"[\w.>()\s-]*(?:->|\.)", text) else None
    given = call.argument(0)
    text = "" if given is None else syntax.slice(given)
    if text in ("this", "*this"):
        return ""
    owner = analysis.unit.class_of(call.scope)
    if owner is not None and analysis.receivers.is_node_class(owner):
        type_ = analysis.receivers.type_of(given, call.scope)
        if not analysis.receivers.is_node(type_, call.scope):
            # A part of the node, or one of its interfaces.
            return ""
    if re.fullmatch(r"[\w.]+|this->\w+", text):
        return f"{text}->"
    return None


def _of_node(analysis: Analysis, change: Add) -> Place | None:
    """Return the place where a node is made that has nothing yet."""
    group(analysis)
    found = [each for each in analysis.nodes if change.node in (None, _label(each))]
    for maker in found:
        owner = maker.owner
        if analysis.ros_version == 1 and owner is None:
            place = _behind_handle(analysis, maker)
            if place is not None:
                return place
            owner = main_class(analysis)
        if owner is not None:
            place = _of_class(analysis, owner)
            if place is not None:
                return place
        elif maker.variable is not None and maker.variable.kind == "local":
            place = _behind(analysis, maker.variable, maker.file)
            if place is not None:
                return place
    return None


def _label(maker: NodeSite) -> str:
    return maker.name or (maker.owner.name if maker.owner is not None else "")


def _of_class(analysis: Analysis, owner: Scope) -> Place | None:
    """Return the end of the one constructor, or the `onInit`, of a class."""
    is_nodelet = bool(analysis.ros_version == 1 and _methods(analysis, owner, "onInit"))
    found = _methods(analysis, owner, "onInit" if is_nodelet else owner.name)
    if len(found) != 1:
        return None
    body = found[0].body
    if body is None or body.type != "compound_statement":
        return None
    node = _own_node(analysis, owner) if analysis.ros_version == 2 else ""
    if node is None:
        return None
    statements = body.named_children
    after = next((each for each in reversed(statements) if not leaves(each)), None)
    return Place(found[0].file, found[0], body, after, owner, node, is_end=after is None)


def _own_node(analysis: Analysis, owner: Scope) -> str | None:
    """Return what stands before the methods of the node that a class is, or has."""
    receivers = analysis.receivers
    if receivers.is_node_class(owner):
        return ""
    for base in analysis.unit.bases(owner):
        for name, variables in base.variables.items():
            variable = variables[0]
            type_ = receivers.type_of_variable(variable)
            if type_ in NODE_CLASSES and not variable.is_list:
                if re.search(r"\bWeakPtr\b|\bweak_ptr<", variable.type):
                    # Who calls a method of a node's own object still has the node.
                    return f"{name}.lock()->"
                return f"{name}->" if "Ptr" in variable.type or "ptr<" in variable.type else None
    return None


def node_in_methods(analysis: Analysis, place: Place) -> str | None:
    """Return what stands before the methods of the node of ROS 2 in any method of its class.

    None where only the function that creates the endpoint has it, as a parameter.
    """
    owner = place.owner
    first = re.split(r"->|\.", place.node.removeprefix("this->"))[0]
    if owner is None or not first or analysis.unit.member(owner, first) is not None:
        return place.node
    return _own_node(analysis, owner)


def _methods(analysis: Analysis, owner: Scope, name: str) -> list[Function]:
    return [
        each
        for each in analysis.unit.functions_of(owner, name)
        if each.scope is not None and not each.file.is_beside
    ]


def _behind(analysis: Analysis, variable: Variable, file: CppFile) -> Place | None:
    """Return the place behind the declaration of a node."""
    function = analysis.unit.function_of(variable.scope)
    body = function.body if function is not None else None
    if function is None or body is None or function.scope is None:
        return None
    after, block = _statement(variable.node, body)
    is_pointer = variable.is_pointer or "Ptr" in variable.type or "ptr" in variable.type
    is_pointer = is_pointer or (variable.type == "auto" and variable.value is not None)
    node = f"{variable.name}{'->' if is_pointer else '.'}" if analysis.ros_version == 2 else ""
    return Place(file, function, block, after, None, node)


def _behind_handle(analysis: Analysis, maker: NodeSite) -> Place | None:
    """Return the place behind the first node handle of the function that makes a node of ROS 1."""
    for scope in maker.file.scopes:
        for variables in scope.variables.values():
            for variable in variables:
                is_handle = analysis.receivers.type_of_variable(variable) == HANDLE
                outer = scope.enclosing("function")
                is_here = outer is not None and outer.start <= maker.place.start_byte < outer.end
                if is_handle and is_here and variable.kind == "local":
                    return _behind(analysis, variable, maker.file)
    return None


def is_managed(analysis: Analysis, owner: Scope | None) -> bool:
    """Tell whether a class is a managed node of ROS 2."""
    return owner is not None and analysis.receivers.derives_from(owner, MANAGED_CLASSES)
