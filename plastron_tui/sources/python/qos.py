"""The quality of service that a call gives an endpoint, as far as the file says it for sure.

Source: `rospy.topics` of Noetic; for rclpy see `qos_profiles.py`.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce

from tree_sitter import Node

from plastron_tui.ros.qos import Qos
from plastron_tui.sources.grammars import is_inside

from .analysis import Analysis, QosChange, QosChanges
from .arguments import Arguments
from .calls import CallShape, QosArguments
from .origins import Origin, constant, integer, origins
from .qos_profiles import FIELDS, copied, made_by, policy
from .runs import EVERYWHERE
from .scopes import Scope
from .syntax import FUNCTIONS, REPEATING

_MOST_COPIES = 4
_MOST_CHANGES = 32
_BLOCKS = frozenset({"block", "module"})


def qos_of(
    analysis: Analysis, call: Node, shape: CallShape, scope: Scope, arguments: Arguments
) -> Qos | None:
    """Return the quality of service that a call gives what it creates; None for none known."""
    places = shape.qos
    if places is None:
        return None
    if places.profile is None:
        found = _ros1(analysis, places, scope, arguments)
    elif "qos_overriding_options" in arguments.keywords:
        # Parameters may then change it when the node starts.
        return None
    elif (given := arguments.get(places.profile)) is not None:
        found = _profile(analysis, given, scope, call) or Qos()
    elif places.default is not None and not arguments.is_open:
        found = places.default
    else:
        return None
    found = found.over(Qos())
    return found if found.known else None


def _ros1(analysis: Analysis, places: QosArguments, scope: Scope, arguments: Arguments) -> Qos:
    """Return what ROS 1 has of it: it is reliable, keeps so many messages, and may be latched."""
    found = Qos()
    if places.queue_size is not None:
        depth = integer(analysis, arguments.get(places.queue_size), scope)
        if depth is not None:
            # Without an end.
            found = Qos(history="keep_last", depth=depth) if depth else Qos(history="keep_all")
    if places.latch is not None:
        given = arguments.get(places.latch)
        is_latched = constant(analysis, given, scope)
        if given is None and not arguments.is_open:
            is_latched = False
        found = found._replace(reliability="reliable")
        if isinstance(is_latched, bool):
            found = found._replace(durability="transient_local" if is_latched else "volatile")
    return found


def _profile(analysis: Analysis, node: Node, scope: Scope, at: Node, copies: int = 0) -> Qos | None:
    """Return the profile that an expression is when a call is made, None for no profile."""
    found: list[Qos] = []
    for origin in origins(analysis, node, scope) or ():
        original = copied(origin)
        if original is not None and origin.node is not None and copies < _MOST_COPIES:
            made = _profile(origin.analysis, original, origin.scope, origin.node, copies + 1)
        else:
            made = made_by(origin)
        if made is None:
            return None
        found.append(_changed(made, origin, analysis, at))
    return reduce(Qos.common, found) if found else None


def _changed(qos: Qos, origin: Origin, analysis: Analysis, at: Node) -> Qos:
    """Return a profile as it is when a call is made, after what the files assign to its policies.

    What may run before the call and may not leaves a policy known only where it changes nothing.

    Args:
        qos: the profile as it was made.
        origin: what made it.
        analysis: the file of the call.
        at: the call.
    """
    modules = (
        [analysis] if origin.analysis.scopes is analysis.scopes else [origin.analysis, analysis]
    )
    of_each = [(module, _changes(module).get(origin.key, [])) for module in modules]
    if sum(len(changes) for _, changes in of_each) > _MOST_CHANGES:
        return Qos()
    found = [(change, module) for module, changes in of_each for change in changes]
    if not found:
        return qos
    behind = set(_directly_behind(origin))
    steps = []
    for change, module in found:
        is_here = module.scopes is analysis.scopes and _function(change.node) == _function(at)
        order = 0 if change.node.id in behind else 2 if is_here else 1
        is_sure = len(change.of) == 1 and order != 1
        if is_here and order:
            is_later = change.node.start_byte >= at.end_byte
            if is_later and _is_made_anew(origin, change.node, at):
                continue
            is_sure = is_sure and not is_later and is_inside(at, _block(change.node))
        steps.append((order, change.node.start_byte, is_sure, change, module))
    for *_, is_sure, change, module in sorted(steps, key=lambda step: step[:2]):
        value = None
        if change.value is not None:
            value = policy(change.policy, module, change.value, change.scope)
        if is_sure or value != getattr(qos, change.policy):
            qos = qos.with_policy(change.policy, value if is_sure else None)
    return qos


def _changes(analysis: Analysis) -> QosChanges:
    """Return the assignments of a file to policies of profiles, by what made these."""
    answers = analysis.answers
    if answers.qos_changes is None:
        answers.qos_changes = {}
        with analysis.resolver.during(EVERYWHERE):
            for change in _find_changes(analysis):
                for key in change.of:
                    answers.qos_changes.setdefault(key, []).append(change)
    return answers.qos_changes


def _find_changes(analysis: Analysis) -> Iterator[QosChange]:
    captures = analysis.captures
    for node in (*captures.get("assignment", ()), *captures.get("augmented", ())):
        target = node.child_by_field_name("left")
        field = FIELDS.get(_attribute(target)) if target is not None else None
        holder = target.child_by_field_name("object") if target is not None else None
        if field is None or holder is None:
            continue
        scope = analysis.scopes.at(node.start_byte)
        found = origins(analysis, holder, scope) or ()
        keys = frozenset(each.key for each in found if copied(each) or made_by(each))
        is_plain = node.type == "assignment"
        value = node.child_by_field_name("right") if is_plain else None
        if keys:
            yield QosChange(field, value, scope, node, keys)


def _attribute(target: Node) -> str:
    """Return the last name of `a.b`, "" for what is no attribute."""
    name = target.child_by_field_name("attribute") if target.type == "attribute" else None
    return (name.text or b"").decode("utf-8", "replace") if name is not None else ""


def _directly_behind(origin: Origin) -> Iterator[int]:
    """Yield the assignments to policies that come right behind what made a profile."""
    made = origin.node.parent if origin.node is not None else None
    statement = made.parent if made is not None and made.type == "assignment" else None
    while statement is not None and (statement := statement.next_named_sibling) is not None:
        inner = statement.named_children[0] if statement.named_child_count else None
        if statement.type == "comment":
            continue
        target = inner.child_by_field_name("left") if inner is not None else None
        if inner is None or inner.type != "assignment" or target is None:
            return
        if _attribute(target) not in FIELDS:
            return
        yield inner.id


def _is_made_anew(origin: Origin, change: Node, at: Node) -> bool:
    """Whether a change behind a call is one of a profile that the next such call does not see."""
    if origin.node is None or _function(origin.node) != _function(at):
        return False
    loop = at.parent
    while loop is not None and loop.type not in FUNCTIONS:
        if loop.type in REPEATING and is_inside(change, loop):
            return is_inside(origin.node, loop)
        loop = loop.parent
    return True


def _function(node: Node) -> int:
    """Return the function that a node is in, 0 for none."""
    current = node.parent
    while current is not None and current.type not in FUNCTIONS:
        current = current.parent
    return 0 if current is None else current.id


def _block(node: Node) -> Node:
    """Return the block of statements that a node is in."""
    while node.type not in _BLOCKS and node.parent is not None:
        node = node.parent
    return node
