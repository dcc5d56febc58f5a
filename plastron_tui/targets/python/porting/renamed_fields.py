"""Fields of messages that the other ROS calls otherwise, or lacks.

A field of ROS 2 has small letters only: `K` of a `CameraInfo` of ROS 1 is `k` there.
"""

from __future__ import annotations

from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName, Section
from plastron_tui.sources.python.syntax import parts_of

from .message_types import constructed, known_messages, section_of
from .port_state import Work, walk
from .types import new_field, target_type

_ELSEWHERE = frozenset(
    {"std_msgs/Header", "builtin_interfaces/Time", "builtin_interfaces/Duration"}
)
"""Types whose fields are looked at wherever they stand, whatever is known of what holds them."""

_CENTER = "the center of a `BoundingBox2D`"
_OF_PACKAGES = {
    2: {
        "vision_msgs.msg": {
            "id": "`hypothesis.class_id` of a result, a text",
            "score": "`hypothesis.score` of a result",
            "source_img": "a detection of ROS 2 has no image",
            "source_cloud": "a detection of ROS 2 has no cloud",
            "center.x": f"{_CENTER} has `position.x`",
            "center.y": f"{_CENTER} has `position.y`",
        },
        "gazebo_msgs.srv": {
            "model_name": "`name` of the entity",
            "model_xml": "`xml` of the entity",
            "model_state": "`state` of the entity",
            "relative_entity_name": "`reference_frame`",
        },
    },
    1: {
        "vision_msgs.msg": {
            "hypothesis": "a result of ROS 1 has `id` and `score` itself",
            "class_id": "`id` of a result, a number",
            "center.position": f"{_CENTER} has `x` and `y` itself",
        },
    },
}
"""Fields by the modules of packages that the catalog has not; sources as in `moved`."""


@dataclass(frozen=True, slots=True)
class _Field:
    """A field of a message that the other ROS has by another name, or, with None, has not."""

    message: InterfaceName
    section: Section
    new: str | None


def port_fields(work: Work) -> None:
    """Rename fields where the message is known; mark those that are gone, or may be meant."""
    fields, known = _changed_fields(work), _of_packages(work)
    for node in walk(work.analysis.syntax.root) if fields or known else ():
        if work.is_gone(node) or node.id in work.done:
            continue
        if node.type == "attribute":
            _port_attribute(work, node, fields)
            _mark_known(work, node, known)
        elif node.type == "call":
            _port_keywords(work, node, fields)


def _of_packages(work: Work) -> dict[str, str]:
    """Return the fields of packages outside of the catalog that the file imports from."""
    return {
        name: remedy
        for module, fields in _OF_PACKAGES[work.catalog.ros_version].items()
        if module.encode() in work.analysis.syntax.text
        for name, remedy in fields.items()
    }


def _mark_known(work: Work, node: Node, known: dict[str, str]) -> None:
    holder, part = node.child_by_field_name("object"), node.child_by_field_name("attribute")
    if holder is None or part is None:
        return
    outer = holder.child_by_field_name("attribute")
    names = (work.slice(part), f"{work.slice(outer or holder)}.{work.slice(part)}")
    found = next((name for name in names if name in known), None)
    if found and section_of(work, holder) is None and _may_be_message(work, node, holder):
        work.mark(node, f".{found}", known[found])


def _changed_fields(work: Work) -> dict[str, list[_Field]]:
    """Return the fields of the messages that a file may handle, by their old names."""
    found: dict[str, list[_Field]] = {}
    for message, section in known_messages(work).items():
        target = target_type(work, message, InterfaceKind.MESSAGE)[0]
        there = work.catalog.find(target, InterfaceKind.MESSAGE) if target is not None else None
        if there is None or str(message) in _ELSEWHERE:
            continue
        for each in section.fields:
            new = new_field(each.name, there.sections[0])
            if new != each.name:
                found.setdefault(each.name, []).append(_Field(message, section, new))
    return found


def _port_attribute(work: Work, node: Node, fields: dict[str, list[_Field]]) -> None:
    holder, part = node.child_by_field_name("object"), node.child_by_field_name("attribute")
    name = work.slice(part) if part is not None else ""
    if holder is None or part is None or name not in fields or part.id in work.done:
        return
    section = section_of(work, holder)
    for each in fields[name]:
        if section == each.section and each.new is not None:
            work.replace(part, each.new)
            return
        if section == each.section or (section is None and _may_be_message(work, node, holder)):
            known = f"`{each.message}` of ROS {work.catalog.ros_version} has "
            work.mark(node, f".{name}", known + (f"`{each.new}`" if each.new else "no such field"))
            return


def _may_be_message(work: Work, node: Node, holder: Node) -> bool:
    """Tell whether nothing says what an expression is: it is no module, nor has it the field."""
    return not work.qualified(holder) and not work.bindings(node)


def _port_keywords(work: Work, call: Node, fields: dict[str, list[_Field]]) -> None:
    callee = call.child_by_field_name("function")
    made = constructed(work, callee) if callee is not None else None
    if made is None:
        return
    for each in parts_of(call.child_by_field_name("arguments")):
        key = each.child_by_field_name("name") if each.type == "keyword_argument" else None
        for field in fields.get(work.slice(key), ()) if key is not None else ():
            if key is not None and field.message == made[0] and field.new is not None:
                work.replace(key, field.new)
