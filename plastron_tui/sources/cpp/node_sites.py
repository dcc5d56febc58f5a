"""What makes the nodes of a unit, and what they are called.

Source: `ros/init.h`, `nodelet/nodelet.h` of Noetic; `rclcpp/node.hpp` of Jazzy.
"""

from __future__ import annotations

from dataclasses import replace

from tree_sitter import Node

from .analysis import Analysis, NodeSite
from .arguments import Call
from .receivers import MANAGED_CLASSES, NODE_CLASSES, NODELET
from .scopes import Function, Scope, Variable

_NODELETS = frozenset({NODELET, "nodelet::Nodelet", "image_transport::Nodelet"})


def find_nodes(analysis: Analysis) -> None:
    """Find what makes nodes."""
    if analysis.ros_version == 1:
        analysis.nodes = _of_ros1(analysis)
    else:
        analysis.nodes = _of_ros2(analysis)


def is_nodelet(analysis: Analysis, owner: Scope) -> bool:
    """Whether a class of the files is a nodelet."""
    return any(
        name in _NODELETS or name.endswith(("nodelet_topic_tools::NodeletLazy", "::Nodelet"))
        for name in (
            analysis.types.expand(base, owner).partition("<")[0]
            for base in analysis.unit.foreign_bases(owner)
        )
    )


def nodelets(analysis: Analysis) -> list[Scope]:
    """Return the classes of the files that are nodelets."""
    found = [each for classes in analysis.unit.classes.values() for each in classes]
    return [each for each in found if is_nodelet(analysis, each)]


def _of_ros1(analysis: Analysis) -> list[NodeSite]:
    found: list[NodeSite] = []
    for call in analysis.unit.calls.get("init", ()):
        name = analysis.types.expand(call.qualified, call.scope)
        is_own = call.receiver is None and not call.scope.file.is_beside
        if is_own and name == "ros::init" and len(call.arguments) > 1:
            at = 2 if len(call.arguments) > 2 and call.arguments[0].type == "identifier" else 1
            given = call.argument(at)
            found.append(_named(analysis, call, given))
    if found:
        first = found[0]
        if any(each.name != first.name for each in found):
            first = NodeSite(None, first.expression, first.place, first.file)
        return [first]
    owners = sorted(nodelets(analysis), key=lambda each: each.start)
    return [
        NodeSite(None, "", each.node, each.file, each)
        for each in owners
        if not any(
            other is not each and analysis.unit.derives_from(other, each) for other in owners
        )
    ]


def _named(
    analysis: Analysis, call: Call, given: Node | None, owner: Scope | None = None
) -> NodeSite:
    value = analysis.evaluator.fold(given, call.scope) if given is not None else None
    is_known = value is not None and value.text is not None
    is_known = is_known and value is not None and not value.is_default
    syntax = call.scope.file.syntax
    return NodeSite(
        value.text if is_known and value is not None else None,
        syntax.slice(given) if given is not None else "",
        call.node,
        call.scope.file,
        owner,
    )


def _of_ros2(analysis: Analysis) -> list[NodeSite]:
    unit, receivers = analysis.unit, analysis.receivers
    owners: list[Scope] = []
    used = {id(site.owner) for site in analysis.sites if site.owner is not None}
    for classes in unit.classes.values():
        owners += [each for each in classes if receivers.is_node_class(each) or id(each) in used]
    # A class of a header is a part of those that derive from it.
    owners = [
        each
        for each in owners
        if not each.file.name
        or not any(other is not each and unit.derives_from(other, each) for other in owners)
    ]
    found = [_of_class(analysis, owner) for owner in owners]
    for call in _made_nodes(analysis):
        given = call.argument(0)
        site = _named(analysis, call, given)
        variable = _held_by(analysis, call)
        managed = analysis.receivers.plain(call.qualified, call.scope) in MANAGED_CLASSES
        found.append(
            NodeSite(site.name, site.expression, site.place, site.file, None, variable, managed)
        )
    order = {id(file): at for at, file in enumerate(unit.files)}
    found.sort(key=lambda each: (order[id(each.file)], each.place.start_byte))
    return found


def _made_nodes(analysis: Analysis) -> list[Call]:
    found = []
    seen = set()
    for calls in analysis.callers.made.values():
        for call in calls:
            if not analysis.types.may_be(call.name, ("Node", "LifecycleNode")):
                continue
            key = id(call.scope.file), call.node.start_byte
            if call.scope.file.is_beside:
                continue
            if not call.arguments or call.node.type == "field_initializer" or key in seen:
                continue
            if analysis.receivers.plain(call.qualified, call.scope) in NODE_CLASSES:
                seen.add(key)
                found.append(call)
    return found


def _held_by(analysis: Analysis, call: Call) -> Variable | None:
    """Return the variable that a node is made for."""
    for scope in call.scope.chain:
        for variables in scope.variables.values():
            for variable in variables:
                is_value = variable.value is not None and variable.value.id == call.node.id
                if is_value or variable.node.id == call.node.id:
                    return variable
    parent = call.node.parent
    if parent is not None and parent.type == "assignment_expression":
        left = parent.child_by_field_name("left")
        if left is not None:
            name = call.scope.file.syntax.word(left).removeprefix("this->")
            return analysis.unit.lookup(name, call.scope, left.start_byte)
    return None


def _of_class(analysis: Analysis, owner: Scope) -> NodeSite:
    """Return a node class under the name that its constructor gives it."""
    managed = analysis.receivers.derives_from(owner, MANAGED_CLASSES)
    unit = analysis.unit
    # What only heirs give a constructor is no name of the class itself.
    unit.bindings = {
        each: (None, {})
        for each in unit.functions_of(owner, owner.name)
        if _is_for_heirs(analysis, each)
    }
    named = _names(analysis, owner, 0)
    if not named and owner.name not in owner.functions:
        # `using rclcpp::Node::Node;`: who makes it gives the name.
        made = analysis.callers.makers(owner)
        named = [_named(analysis, call, call.argument(0), owner) for call in made if call.arguments]
    unit.bindings = {}
    name, expression = None, ""
    if named:
        first = named[0]
        expression = first.expression
        if all(each.name == first.name for each in named):
            name = first.name
    return NodeSite(name, expression, owner.node, owner.file, owner, None, managed)


def _is_for_heirs(analysis: Analysis, constructor: Function) -> bool:
    calls = analysis.callers.of(constructor)
    owner = analysis.unit.class_of_function(constructor)
    return bool(calls) and all(
        each.node.type == "field_initializer" and analysis.unit.class_of(each.scope) is not owner
        for each in calls
    )


def _names(analysis: Analysis, owner: Scope, depth: int) -> list[NodeSite]:
    """Return the names that the constructors of a class give to the node that it is."""
    unit = analysis.unit
    found: list[NodeSite] = []
    bases = {base.partition("<")[0].rpartition("::")[2]: base for base in owner.bases}
    for base in owner.bases:
        expanded = analysis.types.expand(base, owner).partition("<")[0]
        bases.setdefault(expanded.rpartition("::")[2], base)
    for last, base in bases.items():
        for node, given, scope in unit.initialized.get(last, ()):
            if unit.class_of(scope) is not owner:
                continue
            call = Call(node, last, "", None, None, given, scope, None)
            own = unit.find_class(base, owner)
            if own is None or own is owner:
                found.append(_named(analysis, call, call.argument(0), owner))
            elif depth < 8:
                # The base class of the files names the node, with what it gets.
                outer = unit.bindings
                made: dict[Function, tuple[Call | None, dict[Function, Call]]] = {
                    each: (call, {})
                    for each in unit.functions.get(own.name, ())
                    if unit.class_of_function(each) is own and analysis.callers.fits(call, each)
                }
                unit.bindings = {**outer, **made}
                inner = _names(analysis, own, depth + 1)
                unit.bindings = outer
                syntax = scope.file.syntax
                said = syntax.slice(given[0]) if given else ""
                found += [replace(each, expression=said or each.expression) for each in inner]
    return found


__all__ = ["Function", "find_nodes", "is_nodelet", "nodelets"]
