"""What is read off the nodes of a syntax tree of Python."""

from __future__ import annotations

from collections.abc import Iterator

from tree_sitter import Node


def field(node: Node, name: str) -> str:
    """Return the text of a field of a node, "" where it has none."""
    child = node.child_by_field_name(name)
    return "" if child is None else source_of(child)


def source_of(node: Node) -> str:
    """Return the text of a node."""
    return (node.text or b"").decode("utf-8", "replace")


def callee(node: Node) -> str:
    """Return the last word of what is called: `join` for `os.path.join`.

    `FindPackageShare(…).find(package)` gives what `FindPackageShare(package)` stands for.
    """
    function = node.child_by_field_name("function")
    if function is None:
        return ""
    if function.type == "attribute":
        of = function.child_by_field_name("object")
        is_share = of is not None and of.type == "call" and callee(of) == "FindPackageShare"
        word = field(function, "attribute")
        return "FindPackageShare" if is_share and word == "find" else word
    return source_of(function) if function.type == "identifier" else ""


def arguments_of(node: Node) -> list[Node]:
    """Return the arguments of a call."""
    arguments = node.child_by_field_name("arguments")
    if arguments is None or arguments.type != "argument_list":
        return []
    return [child for child in arguments.named_children if child.type != "comment"]


def positional_of(node: Node) -> list[Node]:
    """Return the arguments of a call that have no names."""
    return [each for each in arguments_of(node) if each.type != "keyword_argument"]


def short(node: Node) -> str:
    """Return the first line of a node, cut where it is long."""
    first = source_of(node).split("\n", 1)[0]
    return first if len(first) <= 40 else f"{first[:40]}…"


def names_in(node: Node) -> set[str]:
    """Return the names that something stands for, without those in what selects a part of it."""
    found, stack = set(), [node]
    while stack:
        each = stack.pop()
        if each.type == "identifier":
            found.add(source_of(each))
        elif each.type in ("attribute", "subscript"):
            of = each.child_by_field_name("object") or each.child_by_field_name("value")
            stack += [] if of is None else [of]
        elif each.type != "call":
            stack += each.named_children
    return found


def clauses(node: Node) -> Iterator[tuple[Node | None, Node | None]]:
    """Yield the branches of an `if`: the condition, None for `else`, and the statements."""
    yield node.child_by_field_name("condition"), node.child_by_field_name("consequence")
    for each in node.children_by_field_name("alternative"):
        block = each.child_by_field_name("consequence") or each.child_by_field_name("body")
        yield each.child_by_field_name("condition"), block
