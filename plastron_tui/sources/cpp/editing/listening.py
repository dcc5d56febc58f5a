"""What a node does only while somebody listens to a topic of its own."""

from __future__ import annotations

import re

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind

from ..analysis import Analysis
from ..scopes import CppFile, scope_at
from .creation import holder_of
from .uses import word

_COUNT = r"[\w.>-]+(?:\.|->)(?:getNumSubscribers|get_subscription_count)\(\)"
_LISTENS = re.compile(rf"\((?:{_COUNT}(?:(?:>|!=)0u?|>=1u?)?|0u?<{_COUNT})\)", re.IGNORECASE)


def block_for_listeners(analysis: Analysis, file: CppFile, node: Node) -> Node | None:
    """Return the `if` that a use of a publisher makes depend on whether somebody listens.

    There is none where more is asked, or where it sends through something else as well: without
    the publisher nobody can listen, and all that is in the `if` is never done.
    """
    inner: Node | None = node
    while inner is not None and inner.type != "condition_clause":
        if inner.type.endswith("statement") or inner.type == "declaration":
            return None
        inner = inner.parent
    block = None if inner is None else inner.parent
    if inner is None or block is None or block.type != "if_statement":
        return None
    body = block.child_by_field_name("consequence")
    if body is None or block.child_by_field_name("alternative") is not None:
        return None
    if _LISTENS.fullmatch("".join(file.syntax.word(inner).split())) is None:
        return None
    name = file.syntax.word(node)
    others = {
        holder.name
        for site in analysis.sites
        if site.endpoint.kind is not EndpointKind.PARAMETER
        and (holder := holder_of(analysis, site)) is not None
        and holder.name != name
    }
    code, scope = file.syntax.code, scope_at(file, body.start_byte)
    for other in others:
        for found in word(other).finditer(code, body.start_byte, body.end_byte):
            variable = analysis.unit.lookup(other, scope, found.start())
            if variable is None or variable.kind != "parameter":
                return None
    return block
