"""How a call is laid out: one that has an argument a line keeps it so."""

from __future__ import annotations

from tree_sitter import Node

from plastron_tui.sources.python.syntax import Syntax, parse, parts_of

from .port_state import Work


def laid_out(work: Work, call: Node, wanted: str) -> str:
    """Write what takes the place of a call with an argument a line, where the call has that.

    Args:
        work: the file.
        call: the call, as it was.
        wanted: the new call, in a line.
    """
    listed = call.child_by_field_name("arguments")
    given = parts_of(listed)
    rows = [each.start_point.row for each in given]
    if listed is None or len(given) < 2 or len(set(rows)) < len(rows) or "\n" in wanted:
        return wanted
    new = parse(wanted.encode())
    made = _call(new)
    items = parts_of(made.child_by_field_name("arguments")) if made is not None else []
    if made is None or not items:
        return wanted
    head = new.slice(made).partition("(")[0] + "("
    if rows[0] > listed.start_point.row:
        indent, opening = _indent(work, given[0]), "\n" + _indent(work, given[0])
    else:
        # The arguments stand below the first, behind the bracket.
        indent, opening = " " * (call.start_point.column + len(head)), ""
    closing = ")"
    if listed.end_point.row > given[-1].end_point.row:
        is_listed = work.slice(listed)[:-1].rstrip().endswith(",")
        closing = ("," if is_listed else "") + "\n" + _indent(work, listed, at_end=True) + ")"
    return head + opening + f",\n{indent}".join(map(new.slice, items)) + closing


def _call(syntax: Syntax) -> Node | None:
    """Return the call that a text is, None where it is anything else."""
    statements = syntax.root.named_children
    parts = statements[0].named_children if len(statements) == 1 else []
    return parts[0] if len(parts) == 1 and parts[0].type == "call" else None


def _indent(work: Work, node: Node, *, at_end: bool = False) -> str:
    """Return what stands before the line that a node begins or ends in."""
    row = node.end_point.row if at_end else node.start_point.row
    line = work.analysis.syntax.text.split(b"\n")[row].decode("ascii", "replace")
    return line[: len(line) - len(line.lstrip(" \t"))]
