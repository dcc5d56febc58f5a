"""Names that a file uses and that mean nothing in it."""

from __future__ import annotations

import builtins

from tree_sitter import Node

from plastron_tui.sources.text_memo import remembered

from .analysis import Analysis, Meanings
from .calls import RCLPY, ROSPY
from .references import is_member
from .sites import outline
from .stars import is_starred
from .syntax import parse

_MODULE = frozenset({"__file__", "__name__", "__doc__", "__path__", "__package__", "__class__"})
_PYTHON_2 = frozenset(
    {"basestring", "cmp", "execfile", "file", "long", "raw_input", "reduce", "reload", "unichr"}
    | {"unicode", "xrange"}
)
_KNOWN = frozenset(dir(builtins)) | _MODULE | _PYTHON_2


def meanings(analysis: Analysis) -> Meanings:
    """Find out what the names of a file mean."""
    if analysis.answers.meanings is None:
        analysis.answers.meanings = _meanings(analysis)
    return analysis.answers.meanings


@remembered
def meanings_in(text: bytes) -> Meanings:
    """Find out what the names of a text mean."""
    library = ROSPY if ROSPY.module.encode() in text else RCLPY
    return _meanings(outline(parse(text), library))


def _meanings(analysis: Analysis) -> Meanings:
    unresolved, unbound = set(), set()
    for node in analysis.syntax.captures("words").get("identifier", []):
        name = analysis.syntax.slice(node)
        if is_member(node):
            if name not in unbound and not _is_attribute_bound(analysis, node, name):
                unbound.add(name)
        elif name not in _KNOWN and name not in unresolved and _is_unresolved(analysis, node, name):
            unresolved.add(name)
    classes = analysis.scopes.classes()
    bound = {name for each in classes for name in (*each.attributes, *each.bindings)}
    return Meanings(frozenset(unresolved), frozenset(unbound), frozenset(bound))


def lost_names(after: Meanings, *before: Meanings) -> list[str]:
    """Return the names that mean nothing any more, though in each of the earlier files they did."""
    known = frozenset[str]().union(*(each.unresolved for each in before))
    bound = frozenset[str]().union(*(each.bound for each in before))
    unbound = frozenset[str]().union(*(each.unbound for each in before))
    return sorted((after.unresolved - known) | ((after.unbound & bound) - unbound))


def _is_unresolved(analysis: Analysis, node: Node, name: str) -> bool:
    if _is_declared(node) or _is_parameter(node):
        return False
    is_bound = analysis.scopes.at(node.start_byte).lookup(name) is not None
    stars = analysis.scopes.module.star_imports
    return not is_bound and not is_starred(name, stars, analysis.library.distribution)


def _is_attribute_bound(analysis: Analysis, node: Node, name: str) -> bool:
    """Whether the file gives an attribute to what it is one of, as far as that can be told."""
    attribute = node.parent
    holder = attribute.child_by_field_name("object") if attribute is not None else None
    if holder is None or holder.type != "identifier":
        return True
    owner = analysis.resolver.class_scope(holder, analysis.scopes.at(node.start_byte))
    return owner is None or analysis.resolver.classes.attribute(owner, name) != []


def _is_declared(node: Node) -> bool:
    """Whether an identifier is part of the name of a module, or of what a `global` announces."""
    parent = node.parent
    return parent is not None and parent.type in (
        "dotted_name",
        "global_statement",
        "nonlocal_statement",
    )


_IN_PARAMETER = frozenset(
    {"default_parameter", "typed_default_parameter", "typed_parameter"}
    | {"list_splat_pattern", "dictionary_splat_pattern", "tuple_pattern"}
)


def _is_parameter(node: Node) -> bool:
    """Whether an identifier is the name of a parameter, which its function's body alone sees."""
    parent = node.parent
    while parent is not None and parent.type in _IN_PARAMETER:
        if parent.named_children[0].id != node.id and parent.type != "tuple_pattern":
            return False
        node, parent = parent, parent.parent
    return parent is not None and parent.type in ("parameters", "lambda_parameters")
