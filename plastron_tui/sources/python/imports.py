"""Taking imports out of a file that nothing uses any more."""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Container, Iterable

from tree_sitter import Node

from .analysis import Analysis
from .import_block import member_key
from .references import identifiers, is_member
from .scopes import Binding, BindingKind, Scope
from .splices import Splice, delete_item
from .syntax import parts_of

_INTERFACES = ("msg", "srv", "action")
# To import these only defines names; another module may do anything when it is imported.
_DEFINING = (sys.stdlib_module_names - {"__future__", "readline"}) | {
    *("cv2", "cv_bridge", "numpy", "scipy", "PIL", "yaml", "angles", "transforms3d"),
    *("actionlib", "tf", "tf2_ros", "tf_transformations", "sensor_msgs", "sensor_msgs_py"),
}
# Of the client libraries the names go, but not what the node is made with.
_LIBRARIES = ("rclpy.", "rospy.")


def is_interface_module(target: str) -> bool:
    """Whether a qualified name is an interface type, or a module of such types."""
    parts = target.split(".")
    # `rclpy.action` is a part of the client library.
    return len(parts) >= 2 and parts[1] in _INTERFACES and not target.startswith(_LIBRARIES)


def unused_imports(
    analysis: Analysis, gone: list[Splice], freed: Container[str] = ()
) -> tuple[list[Node], list[Splice]]:
    """Find the imports that only define names and whose every use lies in what is deleted.

    Args:
        analysis: the file.
        gone: what is deleted.
        freed: names that were used in what is deleted already.

    Returns:
        The statements that go, and what takes names out of others.
    """
    removed: dict[int, tuple[Node, list[Node]]] = {}
    others: dict[int, tuple[Node, list[Node]]] = {}
    every = ((scope, *entry) for scope in analysis.scopes.all for entry in scope.bindings.items())
    for scope, name, bindings in every:
        if len(bindings) != 1 or bindings[0].kind is not BindingKind.IMPORT:
            continue
        binding = bindings[0]
        is_sure = _is_removable(binding, analysis)
        if not is_sure and not _is_one_of_several(binding):
            continue
        uses = [
            node
            for node in identifiers(name, analysis)
            if not is_member(node)
            and not _is_in_import(node)
            and _means_import(node, name, scope, analysis)
        ]
        is_freed = name in freed or any(_is_deleted(node, gone) for node in uses)
        if not is_freed or not all(_is_deleted(node, gone) for node in uses):
            continue
        if _is_named_in_strings(name, analysis):
            continue
        item = _item(binding.node, name, analysis)
        if item is not None and not is_sure:
            others.setdefault(binding.node.id, (binding.node, []))[1].append(item)
        elif item is not None:
            removed.setdefault(binding.node.id, (binding.node, []))[1].append(item)
    # What else a module does as it is imported is done as long as one name is left.
    for key, (statement, items) in others.items():
        more = removed.get(key, (statement, []))[1]
        if len(items) + len(more) < len(statement.children_by_field_name("name")):
            removed[key] = statement, [*more, *items]
    statements: list[Node] = []
    splices: list[Splice] = []
    for statement, items in removed.values():
        if len(items) == len(statement.children_by_field_name("name")):
            statements.append(statement)
        else:
            splices += _delete_names(statement, items, analysis)
    return statements, splices


def _is_removable(binding: Binding, analysis: Analysis) -> bool:
    parent = binding.node.parent
    is_module = binding.scope.parent is None
    if parent is None or (is_module and parent.type != "module" and not _is_one_tried(parent)):
        return False
    if is_interface_module(binding.target) or binding.target.startswith(_LIBRARIES):
        return True
    if binding.target.partition(".")[0] in _DEFINING:
        return True
    # `import std_msgs.msg` binds `std_msgs`.
    names = binding.node.children_by_field_name("name")
    return binding.node.type == "import_statement" and any(
        is_interface_module(analysis.syntax.slice(name)) for name in names
    )


def _is_one_of_several(binding: Binding) -> bool:
    """Whether a name is one that the module takes out of another one, with others."""
    parent, names = binding.node.parent, binding.node.children_by_field_name("name")
    is_module = parent is not None and parent.type == "module"
    return is_module and binding.node.type == "import_from_statement" and len(names) > 1


def _is_one_tried(block: Node) -> bool:
    """Whether a block is what a `try` does, of which something is left without one import."""
    tried = block.parent.child_by_field_name("body") if block.parent is not None else None
    is_tried = block.parent is not None and block.parent.type == "try_statement"
    return is_tried and tried is not None and tried.id == block.id and len(parts_of(block)) > 1


def _means_import(node: Node, name: str, scope: Scope, analysis: Analysis) -> bool:
    found = analysis.scopes.at(node.start_byte).lookup(name)
    return scope.parent is None if found is None else found[0] is scope


def _is_in_import(node: Node) -> bool:
    """Whether a name is a part of an import statement; a pattern has dotted names as well."""
    parent = node.parent
    while parent is not None and parent.type in ("dotted_name", "aliased_import"):
        parent = parent.parent
    return parent is not None and parent.type.startswith("import_")


def _is_deleted(node: Node, gone: Iterable[Splice]) -> bool:
    return any(splice.start <= node.start_byte < splice.end for splice in gone)


def _is_named_in_strings(name: str, analysis: Analysis) -> bool:
    """Whether the name is a whole string somewhere: an annotation, or an item of `__all__`."""
    quoted = re.compile(rb"""["']%s["']""" % re.escape(analysis.syntax.encode(name)))
    root = analysis.syntax.root
    for found in quoted.finditer(analysis.syntax.text):
        node = root.descendant_for_byte_range(found.start() + 1, found.end() - 1)
        while node is not None:
            if node.type == "type":
                return True
            if node.type in ("assignment", "augmented_assignment"):
                left = node.child_by_field_name("left")
                if left is not None and analysis.syntax.slice(left) == "__all__":
                    return True
            node = node.parent
    return False


def _item(statement: Node, name: str, analysis: Analysis) -> Node | None:
    for item in statement.children_by_field_name("name"):
        alias = item.child_by_field_name("alias")
        bound = analysis.syntax.slice(alias if alias is not None else item)
        if bound == name or (
            statement.type == "import_statement" and alias is None and bound.split(".")[0] == name
        ):
            return item
    return None


def _delete_names(statement: Node, items: list[Node], analysis: Analysis) -> list[Splice]:
    text = analysis.syntax.text
    splices = []
    remaining = list(statement.children_by_field_name("name"))
    for item in items:
        splices.append(delete_item(text, remaining, item))
        remaining = [other for other in remaining if other.id != item.id]
    return splices


def restore_imports(before: Analysis, after: Analysis) -> list[Splice]:
    """Write the imports as they were, where an edit took names out that it needed again.

    Where the edit needed other names too, they stand where they sort, or else behind those that
    were there, and a line that it moved stays where it is.
    """
    old, new = _top_imports(before), _top_imports(after)
    old_meanings = [_meaning(each, before) for each in old]
    new_meanings = [_meaning(each, after) for each in new]
    if sorted(old_meanings) == sorted(new_meanings):
        return [_rewritten(now, was, []) for was, now in zip(old, new, strict=True)]
    splices = []
    count = Counter(module for module, _ in old_meanings)
    by_module: dict[str, list[Node]] = {}
    for each, (module, _) in zip(new, new_meanings, strict=True):
        by_module.setdefault(module, []).append(each)
    for was, (module, names) in zip(old, old_meanings, strict=True):
        alike = by_module.get(module, [])
        if not names or not module or not len(alike) == 1 == count[module]:
            continue
        found = [after.syntax.slice(each) for each in alike[0].children_by_field_name("name")]
        more = [each for each in found if each not in names]
        is_line = b"(" not in (was.text or b"") and b"\\" not in (was.text or b"")
        if len(found) == len(names) + len(more) and (is_line or not more):
            splices.append(_rewritten(alike[0], was, [after.syntax.encode(each) for each in more]))
    return splices


def _rewritten(now: Node, was: Node, more: list[bytes]) -> Splice:
    names = [each.text or b"" for each in was.children_by_field_name("name")]
    written = was.text or b""
    if more and names == _sorted(names):
        start = was.children_by_field_name("name")[0].start_byte - was.start_byte
        return Splice(
            now.start_byte, now.end_byte, written[:start] + b", ".join(_sorted([*names, *more]))
        )
    return Splice(now.start_byte, now.end_byte, b", ".join([written, *more]))


def _sorted(names: list[bytes]) -> list[bytes]:
    return sorted(names, key=lambda name: member_key(name.decode("utf-8", "replace")))


def _top_imports(analysis: Analysis) -> list[Node]:
    kinds = ("import_statement", "import_from_statement")
    return [each for each in analysis.syntax.root.named_children if each.type in kinds]


def _meaning(statement: Node, analysis: Analysis) -> tuple[str, list[str]]:
    """Return the module of an import statement, and the names that it brings in."""
    module = statement.child_by_field_name("module_name")
    names = statement.children_by_field_name("name")
    listed = sorted(analysis.syntax.slice(each) for each in names)
    return analysis.syntax.slice(module) if module is not None else "", listed
