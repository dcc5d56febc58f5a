"""The imports of a file: those of the client library go, those of types change where ROS did."""

from __future__ import annotations

import re
from collections import defaultdict

from tree_sitter import Node

from plastron_tui.ros.catalog import moved
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName, Section
from plastron_tui.sources.python.references import statement_of

from .port_state import Work, is_imported, walk

# What `rosidl_adapter` takes for the name of a type.
_NAME = re.compile(r"[A-Z][A-Za-z0-9]*")
_CAPITALS = "the name of a type begins with a capital letter in ROS 2, and has no `_`"
_SIDES = ("Request", "Response")
_KINDS = {"msg": InterfaceKind.MESSAGE, "srv": InterfaceKind.SERVICE}
# Each ROS keeps a type in a file of its own, named its own way: `_PoseStamped`, `_pose_stamped`.
_PRIVATE = re.compile(r"(\w+\.(?:msg|srv))\._\w+")
_PUBLIC = "it is in `{}`, by its name"


def port_imports(work: Work, roots: frozenset[str]) -> None:
    """Rewrite the import statements.

    Args:
        work: the file.
        roots: the modules of the client library that the file leaves.
    """
    for node in work.analysis.captures.get("import", []):
        _port_plain(work, node, roots)
    for node in work.analysis.captures.get("import_from", []):
        module = node.child_by_field_name("module_name")
        name = work.slice(module) if module is not None else ""
        if name.partition(".")[0] in roots:
            work.delete(node)
            continue
        private = _PRIVATE.fullmatch(name)
        public = private[1] if private is not None else name
        if not public.endswith((".msg", ".srv")) or public.count(".") != 1:
            continue
        is_whole = any(each.type == "wildcard_import" for each in node.named_children)
        if is_whole and private is not None:
            work.mark(node, name, _PUBLIC.format(public))
        elif is_whole:
            _port_star(work, node, public)
        else:
            _port_types(work, node, public, is_changed=private is not None)


def leave_manifests(work: Work) -> None:
    """Take `roslib.load_manifest('package')` away, which finds the imports of old packages."""
    if b"load_manifest" not in work.analysis.syntax.text:
        return
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is not None and "roslib.load_manifest" in work.qualified(callee):
            work.delete(statement_of(call))


def keep_used_imports(work: Work, roots: frozenset[str]) -> None:
    """Keep the imports of the library that the file leaves, where a marked line still uses them.

    Such an import fails in the other ROS, and is marked as well.
    """
    used = {
        name
        for mark in work.marks
        if mark.node.id not in work.done  # else what is left in it has a mark of its own
        for node in walk(mark.node)
        if node.type == "identifier" and node.id not in work.done and work.is_written(node)
        if not is_imported(node)
        for name in work.qualified(node)
        if name.partition(".")[0] in roots
    }
    for node in [
        *work.analysis.captures.get("import", []),
        *work.analysis.captures.get("import_from", []),
    ]:
        module = node.child_by_field_name("module_name")
        names = [
            each.child_by_field_name("name") or each for each in node.children_by_field_name("name")
        ]
        prefix = f"{work.slice(module)}." if module is not None else ""
        given = {f"{prefix}{work.slice(each)}" for each in names}
        roots_given = {each.partition(".")[0] for each in given}
        if given & used or (module is None and roots_given & used):
            work.keep(node)
            lost = [work.slice(module)] if module is not None else sorted(roots_given & roots)
            work.mark(node, f"import {', '.join(lost)}", "it goes with the last line that uses it")


def _port_plain(work: Work, node: Node, roots: frozenset[str]) -> None:
    """Rewrite `import rospy, sys`."""
    kept = []
    for each in node.named_children:
        name = each.child_by_field_name("name") if each.type == "aliased_import" else each
        private = _PRIVATE.fullmatch(work.slice(name)) if name is not None else None
        if private is not None:
            work.mark(node, private[0], _PUBLIC.format(private[1]))
        if name is not None and work.slice(name).partition(".")[0] not in roots:
            kept.append(work.slice(each))
    if not kept:
        work.delete(node)
    elif len(kept) < node.named_child_count:
        work.replace(node, f"import {', '.join(kept)}")


def _port_types(work: Work, node: Node, module: str, *, is_changed: bool = False) -> None:
    """Rewrite `from package.msg import A, B as C`."""
    package, _, kind = module.partition(".")
    by_module: dict[str, list[str]] = defaultdict(list)
    aliases: list[str] = []
    for each in node.children_by_field_name("name"):
        is_aliased = each.type == "aliased_import"
        name_node = each.child_by_field_name("name") if is_aliased else each
        alias_node = each.child_by_field_name("alias") if is_aliased else None
        if name_node is None:
            continue
        name = work.slice(name_node)
        used = work.slice(alias_node) if alias_node is not None else name
        base, side = _split(name) if kind == "srv" else (name, "")
        type_ = _in_target(work, each, InterfaceName(package, base), _KINDS[kind])
        if side and work.catalog.ros_version == 2:
            alias = f"{used} = {type_.name}.{side}"
            is_top = node.parent is not None and node.parent.type == "module"
            if _is_used(work, used):
                (work.constants if is_top else aliases).append(alias)
            entry = type_.name
        else:
            entry = (
                type_.name + side if used == type_.name + side else f"{type_.name}{side} as {used}"
            )
        is_changed |= (type_.package, entry) != (package, work.slice(each))
        entries = by_module[f"{type_.package}.{kind}"]
        if entry not in entries:
            entries.append(entry)
    if is_changed:
        indent = " " * node.start_point.column
        lines = [f"from {each} import {', '.join(names)}" for each, names in by_module.items()]
        work.replace(node, f"\n{indent}".join([*lines, *aliases]))


def _port_star(work: Work, node: Node, module: str) -> None:
    """Rewrite `from package.srv import *`, where its types moved or their sides are named anew."""
    package, _, kind = module.partition(".")
    known = [each for each in work.before.names(_KINDS[kind]) if each.package == package]
    # A package of the tutorials, which no distribution has, is known by what the file uses.
    used = {site.endpoint.type for site in work.analysis.sites if site.endpoint.type is not None}
    known += sorted(
        each for each in used - set(known) if each.package == package and _is_moved(work, each)
    )
    pairs = [(each, target_type(work, each, _KINDS[kind])) for each in known]
    moves = {each: found for each, (found, _) in pairs if found is not None and found != each}
    if moves and len(moves) == len(known):
        lines = [f"from {new.package}.{kind} import {new.name}" for new in moves.values()]
        work.replace(node, f"\n{' ' * node.start_point.column}".join(lines))
    else:
        for each, (found, remedy) in pairs:
            if found is None and _is_used(work, each.name):
                work.mark(node, str(each), remedy)
    if kind == "srv" and work.catalog.ros_version == 2:
        for each in known:
            for side in _SIDES:
                if _is_used(work, each.name + side):
                    name = moves.get(each, each).name
                    work.constants.append(f"{each.name}{side} = {name}.{side}")


def _is_moved(work: Work, type_: InterfaceName) -> bool:
    return isinstance(moved(type_, work.catalog.ros_version), InterfaceName)


def _is_used(work: Work, name: str) -> bool:
    return any(
        node.type == "identifier" and work.slice(node) == name and not is_imported(node)
        for node in walk(work.analysis.syntax.root)
    )


def _split(name: str) -> tuple[str, str]:
    """Split rospy's `AddTwoIntsResponse` into the service and its side."""
    for side in _SIDES:
        if name.endswith(side) and name != side:
            return name[: -len(side)], side
    return name, ""


def _in_target(work: Work, node: Node, type_: InterfaceName, kind: InterfaceKind) -> InterfaceName:
    """Return a type as the other ROS names it; one that it lacks is marked."""
    found, remedy = target_type(work, type_, kind)
    if found is None:
        work.mark(node, str(type_), remedy)
    return found or type_


def new_field(name: str, there: Section) -> str | None:
    """Return what the other ROS calls a field of a message, None for one that it lacks."""
    names = [each.name for each in there.fields]
    alike = [each for each in names if each.lower() == name.lower()]
    return name if name in names else next(iter(alike), None)


def target_type(
    work: Work, type_: InterfaceName, kind: InterfaceKind
) -> tuple[InterfaceName | None, str | None]:
    """Return a type as the other ROS names it; None and a remedy where it has none.

    A type that neither ROS has is the user's own, and taken to be in both.
    """
    if work.catalog.find(type_, kind) is not None:
        return type_, None
    instead = moved(type_, work.catalog.ros_version)
    if isinstance(instead, InterfaceName) and work.catalog.find(instead, kind) is not None:
        return instead, None
    if work.before.find(type_, kind) is None and not isinstance(instead, str):
        is_named = work.catalog.ros_version == 1 or _NAME.fullmatch(type_.name) is not None
        return (type_, None) if is_named else (None, _CAPITALS)
    return None, instead if isinstance(
        instead, str
    ) else f"{work.catalog.distribution} has no such type"
