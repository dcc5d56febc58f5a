"""From rclpy to rospy: what only arguments used that the new calls have not."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.references import identifiers, is_member, statement_of
from plastron_tui.sources.python.scopes import Scope

from .port_state import Work, is_imported, walk

_OPTIONS = ("rclpy.qos.", "rclpy.callback_groups.", "rclpy.executors.")
_USUAL = (".RELIABLE", ".VOLATILE", ".KEEP_LAST")
"""What ROS 1 has anyway."""


def leave_options(work: Work) -> None:
    """Take away variables of qualities of service and the like that nothing reads any more."""
    for assignment in work.analysis.captures.get("assignment", []):
        left, right = (assignment.child_by_field_name(each) for each in ("left", "right"))
        statement = statement_of(assignment)
        if left is None or right is None or statement.type != "expression_statement":
            continue
        if not _is_option(work, right) or work.is_gone(statement):
            continue
        uses = _uses(work, left)
        setting = [each for each in uses if _sets_part(each)]
        others = [each for each in uses if each not in setting and work.is_written(each)]
        if not others and len(uses) > len(setting):
            for each in (statement, *map(statement_of, setting)):
                work.delete(each)


def depth_alone(work: Work, given: Node) -> Node | None:
    """Return the depth of a quality of service that has nothing else that ROS 1 lacks."""
    value = given
    if given.type in ("identifier", "attribute"):
        bindings = work.bindings(given)
        if len(bindings) != 1 or any(map(_sets_part, _uses(work, given))):
            return None
        value = bindings[0].value or given
    callee = value.child_by_field_name("function")
    if callee is None or set(work.qualified(callee)) != {f"{_OPTIONS[0]}QoSProfile"}:
        return None
    arguments = Arguments.of(value, work.analysis.syntax)
    depth = arguments.keywords.get("depth")
    others = [each for name, each in arguments.keywords.items() if name != "depth"]
    is_usual = all(work.slice(each).endswith(_USUAL) for each in others)
    is_alone = is_usual and not arguments.positional
    is_own = value is given or (depth is not None and depth.type == "integer")
    return depth if is_alone and is_own else None


def free_names(work: Work) -> None:
    """Note the names in what is taken away: an import that was for it alone goes as well."""
    for node in walk(work.analysis.syntax.root):
        if node.type == "identifier" and work.is_gone(node) and not is_imported(node):
            work.freed.add(work.slice(node))


def _is_option(work: Work, value: Node) -> bool:
    """Tell whether a value is one that the endpoints of rospy do not take."""
    callee = value.child_by_field_name("function") or value
    names = work.qualified(callee) if callee.type in ("identifier", "attribute") else ()
    return bool(names) and all(name.startswith(_OPTIONS) for name in names)


def _uses(work: Work, target: Node) -> list[Node]:
    """Return what may be the variable elsewhere: what has its name in the file."""
    part = target.child_by_field_name("attribute") or target
    nodes = identifiers(work.slice(part), work.analysis)
    own = [each for each in nodes if each.id != part.id]
    if target.type != "attribute":
        scope = _scope(work, target)
        return [each for each in own if not is_member(each) and _scope(work, each) is scope]
    holders = (each.parent for each in own if is_member(each))
    return [each for each in holders if each is not None and each.type == "attribute"]


def _scope(work: Work, name: Node) -> Scope | None:
    found = work.scope(name).lookup(work.slice(name))
    return found[0] if found is not None else None


def _sets_part(use: Node) -> bool:
    """Tell whether a variable is there only to set a part of its value: `qos.depth = 1`."""
    part = use.parent
    assignment = part.parent if part is not None and part.type == "attribute" else None
    if assignment is None or assignment.type != "assignment":
        return False
    return assignment.child_by_field_name("left") == part
