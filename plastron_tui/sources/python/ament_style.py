"""The style that packages of ROS 2 are checked for: that of ament_flake8 and ament_pep257.

Sources: `ament_flake8.ini` and the list of codes in ament_pep257's `main.py` (ament_lint), by which
quotes are single ones (flake8-quotes), imports are in Google's order (flake8-import-order), and the
summary of a docstring of several lines is on the second one (D213 of pydocstyle).
"""

from __future__ import annotations

import sys
from collections.abc import Iterator

from tree_sitter import Node

from .splices import Splice, apply
from .syntax import Syntax, parse

_IMPORTS = ("future_import_statement", "import_statement", "import_from_statement")
_ImportKey = tuple[int, int, tuple[str, str], list[tuple[str, str]]]


def ament_style(text: bytes) -> bytes:
    """Return a file in this style; what does not parse stays as it is."""
    syntax = parse(text)
    if syntax.errors:
        return text
    sorted_names = apply(text, _names(syntax))
    syntax = parse(sorted_names)
    return apply(sorted_names, [*_imports(syntax), *_quotes(syntax), *_summaries(syntax)])


def _names(syntax: Syntax) -> Iterator[Splice]:
    """Sort the names of each import; every name goes to the place of another."""
    for node in syntax.root.named_children:
        if node.type == "import_from_statement":
            names = node.children_by_field_name("name")
            texts = sorted((syntax.slice(name) for name in names), key=_name_key)
            for name, put in zip(names, texts, strict=True):
                yield Splice(name.start_byte, name.end_byte, syntax.encode(put))


def _imports(syntax: Syntax) -> Iterator[Splice]:
    """Sort the imports at the top of the file, Python's own apart from the others."""
    run: list[Node] = []
    for node in (*syntax.root.named_children, None):
        if node is not None and node.type in _IMPORTS:
            run.append(node)
            continue
        if len(run) > 1:
            yield Splice(run[0].start_byte, run[-1].end_byte, _sorted(syntax, run))
        run = []


def _sorted(syntax: Syntax, run: list[Node]) -> bytes:
    groups: dict[int, list[str]] = {}
    keys = {node.id: _import_key(syntax, node) for node in run}
    for node in sorted(run, key=lambda each: keys[each.id]):
        groups.setdefault(keys[node.id][0], []).append(syntax.slice(node))
    return syntax.encode("\n\n".join("\n".join(group) for group in groups.values()))


def _import_key(syntax: Syntax, node: Node) -> _ImportKey:
    """Return what an import is sorted by: its group, how relative it is, its module, its names."""
    names = [syntax.slice(name) for name in node.children_by_field_name("name")]
    if node.type == "future_import_statement":
        return (0, 0, ("", ""), [])
    source = node.child_by_field_name("module_name")
    module = names.pop(0).split()[0] if source is None else syntax.slice(source)
    package = module.partition(".")[0]
    group = 3 if not package else 1 if package in sys.stdlib_module_names else 2
    bare = module.lstrip(".")
    return (group, len(module) - len(bare), _name_key(bare), [_name_key(each) for each in names])


def _name_key(name: str) -> tuple[str, str]:
    return (name.lower(), name)


def _quotes(syntax: Syntax) -> Iterator[Splice]:
    """Set single quotes around each text that has no quotes in it."""
    left = [syntax.root]
    while left:
        node = left.pop()
        if node.type != "string":
            left += node.named_children
            continue
        start, end = node.children[0], node.children[-1]
        within = syntax.text[start.end_byte : end.start_byte]
        if syntax.text[end.start_byte : end.end_byte] != b'"' or b"'" in within or b'"' in within:
            continue
        yield Splice(start.end_byte - 1, start.end_byte, b"'")
        yield Splice(end.start_byte, end.end_byte, b"'")


def _summaries(syntax: Syntax) -> Iterator[Splice]:
    """Set the summary of each docstring of several lines on its second line."""
    left = [syntax.root]
    while left:
        node = left.pop()
        left += node.named_children
        body = node if node.type == "module" else node.child_by_field_name("body")
        if body is None or node.type not in ("module", "class_definition", "function_definition"):
            continue
        first = next(iter(body.named_children), None)
        if first is None or first.type != "expression_statement":
            continue
        text = first.named_children[0]
        opening = text.children[0] if text.type == "string" else None
        if opening is None or opening.end_byte - opening.start_byte < 3:
            continue
        within = syntax.text[opening.end_byte : text.children[-1].start_byte]
        summary, *others = within.split(b"\n")
        if others and summary.strip():
            margin = b" " * text.start_point.column
            yield Splice(opening.end_byte, opening.end_byte, b"\n" + margin)
