"""Where in a file a new import goes: into the group of its like, in the order that this has."""

from __future__ import annotations

import sys
from itertools import pairwise
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.ros.catalog.data import index
from plastron_tui.ros.interfaces import InterfaceKind

from .analysis import Analysis
from .conventions import conventions_of
from .imports import is_interface_module
from .splices import Splice, line_end, line_start

Group = list[Node]


def imports_in(block: Node) -> list[Node]:
    """Return the import statements of a block."""
    return [
        child
        for child in block.named_children
        if child.type in ("import_statement", "import_from_statement")
    ]


def module_of(analysis: Analysis, statement: Node) -> str:
    """Return the module that a statement imports, or imports from."""
    node = statement.child_by_field_name("module_name")
    if node is None:
        node = next(iter(statement.children_by_field_name("name")), None)
    return analysis.syntax.slice(node) if node is not None else ""


def is_library(module: str) -> bool:
    """Whether a module is of the client library."""
    return _package(module) in ("rospy", "rclpy")


def place_import(
    analysis: Analysis, imports: list[Node], module: str, line: str, newline: str
) -> Splice:
    """Return what writes an import among those of a block that has some.

    Args:
        analysis: the file.
        imports: the imports of the block.
        module: the module that is imported, or imported from.
        line: the statement, with its indent.
        newline: how the file ends its lines.
    """
    text, encode = analysis.syntax.text, analysis.syntax.encode
    groups = _groups(_early(analysis, imports))
    across = _place_across(analysis, groups, module)
    if isinstance(across, Node):
        before = line_start(text, across.start_byte)
        return Splice(before, before, encode(line + newline * 2))
    if isinstance(across, int):
        return Splice(across, across, encode(newline + line + newline))
    group = across or _group_for(analysis, groups, module)
    anchor = _anchor(analysis, group, module, line)
    if anchor is None:
        at = line_start(text, group[0].start_byte)
        return Splice(at, at, encode(line + newline))
    at = line_end(text, anchor.end_byte)
    if at == len(text) and not text.endswith(b"\n"):
        return Splice(at, at, encode(newline + line))
    return Splice(at, at, encode(line + newline))


def _early(analysis: Analysis, imports: list[Node]) -> list[Node]:
    """Return the imports before the first definition of the file, or all that there are."""
    root = analysis.syntax.root
    starts = (each.start_byte for each in root.named_children if each.type.endswith("_definition"))
    definition = next(starts, len(analysis.syntax.text))
    return [node for node in imports if node.start_byte < definition] or imports


def _groups(imports: list[Node]) -> list[Group]:
    """Return the imports that stand together, with no blank line or comment between."""
    groups: list[Group] = []
    for node in imports:
        if groups and groups[-1][-1].end_point.row + 1 >= node.start_point.row:
            groups[-1].append(node)
        else:
            groups.append([node])
    return groups


def _place_across(
    analysis: Analysis, groups: list[Group], module: str
) -> Group | Node | int | None:
    """Find the place in an order that goes on from group to group, as ament_flake8 wants it.

    It wants what is not Python's own sorted by the module, whatever blank lines are between.

    Returns:
        The group that takes the import, the statement before which it is a group of its own, or
        the offset behind which it is one; None where a file has no such order.
    """
    parts = [(group, [module_of(analysis, node) for node in group]) for group in groups]
    parts = [part for part in parts if not all(map(_is_standard, part[1]))]
    flat = [each.lower() for _, modules in parts for each in modules]
    has_rclpy = "rclpy" in map(_package, flat)
    if len(parts) < 2 or not has_rclpy or flat != sorted(flat):
        return None
    is_parted = _are_parted_by_blank_lines(analysis, [group for group, _ in parts])
    has_library_apart = all(
        any(map(is_library, modules)) == all(map(is_library, modules)) for _, modules in parts
    )
    if not (is_parted and has_library_apart and is_interface_module(module)):
        return None
    above = [part for part in parts if part[1][0].lower() <= module.lower()]
    below = parts[len(above) :]
    if above and above[-1][1][-1].lower() > module.lower():
        return above[-1][0]
    taking = [modules for _, modules in parts if any(map(is_interface_module, modules))]
    is_for_one = len(parts) > 2 and all(len(set(map(_package, each))) == 1 for _, each in parts)
    for group, modules in (*above[-1:], *below[:1]):
        is_same = _package(module) in map(_package, modules)
        if is_same or (modules in taking and not is_for_one):
            return group
    if not above:
        return below[0][0][0]
    return line_end(analysis.syntax.text, above[-1][0][-1].end_byte)


def _are_parted_by_blank_lines(analysis: Analysis, groups: list[Group]) -> bool:
    text = analysis.syntax.text
    return not any(
        text[line_end(text, above[-1].end_byte) : below[0].start_byte].strip()
        for above, below in pairwise(groups)
    )


def _group_for(analysis: Analysis, groups: list[Group], module: str) -> Group:
    """Return the group for an import: that with most of its kind, or the client library's."""
    wanted = is_interface_module if is_interface_module(module) else is_library
    for is_wanted in (wanted, is_library, is_interface_module):
        found = [
            ((*_likeness(analysis, alike, module), number), group)
            for number, group in enumerate(groups)
            if (alike := [m for n in group if is_wanted(m := module_of(analysis, n))])
        ]
        if found:
            return max(found)[1]
    return groups[-1]


def _likeness(analysis: Analysis, modules: list[str], module: str) -> tuple[bool, bool, bool, int]:
    """Return how much some modules have in common with another: the first that differs counts."""
    known = _is_known(analysis, module)
    kind = module.rpartition(".")[2]
    return (
        _package(module) in map(_package, modules),
        any(_is_known(analysis, each) == known for each in modules),
        any(each.endswith(f".{kind}") for each in modules),
        len(modules),
    )


def _is_known(analysis: Analysis, module: str) -> bool:
    """Whether a package comes with ROS, and is not one of the project."""
    listed = index(analysis.library.distribution).packages
    return any((_package(module), kind) in listed for kind in InterfaceKind)


def _anchor(analysis: Analysis, group: Group, module: str, line: str) -> Node | None:
    """Return the statement of a group behind which an import goes, None for before all."""
    alike = group
    if is_interface_module(module):
        alike = [node for node in group if is_interface_module(module_of(analysis, node))] or group
    # Where both orders fit, the style of ROS 2 tells: single quotes, and modules in one order.
    is_ament = analysis.library.ros_version == 2 and conventions_of(analysis).quote == "'"
    for members, has_kinds in ((group, not is_ament), (group, is_ament), (alike, False)):
        # Names from one module have their own order where each has a line.
        for has_names in (True, False):
            order = _Order(has_kinds, has_names)
            keys = [order.key(analysis.syntax.slice(node)) for node in members]
            if keys == sorted(keys):
                place = sum(key <= order.key(line.strip()) for key in keys)
                behind = group.index(members[place - 1 if place else 0]) - (not place)
                return group[behind] if behind >= 0 else None
    same = [node for node in alike if _package(module_of(analysis, node)) == _package(module)]
    if is_interface_module(module):
        return (same or alike)[-1]
    libraries = [node for node in group if is_library(module_of(analysis, node))]
    return next(reversed(same or libraries), None)


class _Order(NamedTuple):
    """What imports are sorted by, besides their modules.

    Attributes:
        has_kinds: whether whole modules come first.
        has_names: whether what comes from one module is sorted by the first name.
    """

    has_kinds: bool
    has_names: bool

    def key(self, statement: str) -> tuple[bool, str, str]:
        """Return what a statement is sorted by."""
        kind, module, *rest = statement.split(None, 3)
        name = rest[-1].strip("( \r\n") if self.has_names and kind == "from" else ""
        return (self.has_kinds and kind == "from", module.rstrip(",").lower(), name.lower())


def _package(module: str) -> str:
    return module.partition(".")[0]


def _is_standard(module: str) -> bool:
    return _package(module) in sys.stdlib_module_names
