"""Where in a file new imports and helpers go."""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import chain
from sys import stdlib_module_names

from tree_sitter import Node

from plastron_tui.sources.python.conventions import conventions_of
from plastron_tui.sources.python.scopes import BindingKind
from plastron_tui.sources.python.splices import line_end, line_start

from .port_state import IMPORTS, Work

_MODULE = re.compile(rb"(?:from|import)\s+(\w+)")
_DEFINITIONS = frozenset({"function_definition", "class_definition", "decorated_definition"})


def top_level(node: Node) -> Node:
    """Return the statement of the module that a node is in."""
    current = node
    while current.parent is not None and current.parent.type != "module":
        current = current.parent
    return current


def header_end(work: Work) -> int:
    """Return the offset behind the imports at the top of the file, 0 where it has none."""
    text = work.analysis.syntax.text
    end = 0
    for statement in work.analysis.syntax.root.named_children:
        if statement.type in _DEFINITIONS or any(
            statement.start_byte <= site.call.start_byte < statement.end_byte
            for site in work.analysis.sites
        ):
            break
        if _has_import(work, statement):
            end = line_end(text, max(statement.end_byte - 1, 0))
    return end


def add_header(work: Work) -> None:
    """Insert what the file needs at its top: imports that it does not have, and helpers."""
    syntax = work.analysis.syntax
    # An import in a function is of that function only.
    present = {line.rstrip() for line in syntax.text.decode("latin-1").splitlines()}
    present |= {
        f"import {name}"
        for name, bindings in work.analysis.scopes.module.bindings.items()
        if all(each.kind is BindingKind.IMPORT and each.target == name for each in bindings)
        and not all(work.is_gone(each.node) for each in bindings)
    }
    needed = _extend(work, work.imports - present)
    wanted = sorted(_joined(needed), key=lambda line: (line.startswith("from "), line))
    standard = [line for line in wanted if _is_standard(line.encode("ascii"))]
    others = [line for line in wanted if line not in standard]
    at = _first_import(work)
    end = header_end(work)
    places = _places(work, standard, end)
    standard = standard if not places else []
    replaced = _client_import(work)
    if replaced is not None and others:
        work.keep(replaced)
        work.replace(replaced, "\n".join(others))
        groups = [standard, [""]] if standard and _begins_group(work, at) else [standard]
    else:
        groups = [standard, [""], others] if standard and others else [standard, others]
    # What stands behind the last import stands before the helpers, which need it.
    last = "".join(f"{line}\n" for place, line in places if place >= end)
    for place, line in places:
        if place < end:
            work.insert(place, f"{line}\n")
    imports = "".join(f"{line}\n" for line in chain.from_iterable(groups))
    constants = "".join(f"{line}\n" for line in work.constants)
    helpers = [f"\n{constants}"] if constants else []
    indent = conventions_of(work.analysis).indent
    helpers += [f"\n\n{helper.replace('    ', indent)}" for helper in work.helpers]
    if end <= at:
        helpers = [*helpers, "\n\n"] if helpers else []
        work.insert(at, imports + "".join(helpers))
        return
    work.insert(at, imports)
    if not helpers:
        work.insert(end, last)
    if helpers:
        following = syntax.text[end:]
        lines = following[: len(following) - len(following.lstrip())].count(b"\n")
        wanted_lines = 2 if work.helpers else 1
        missing = wanted_lines - lines if following.strip() else 0
        work.insert_first(end, last + "".join(helpers) + "\n" * max(missing, 0))


def _places(work: Work, wanted: list[str], end: int) -> list[tuple[int, str]]:
    """Return where imports of Python's own modules go among those of the file, by name.

    Where the file does not sort its own, they go behind the last of them.
    """
    text = work.analysis.syntax.text
    own = [
        each
        for each in work.analysis.syntax.root.named_children
        if each.type in ("import_statement", "import_from_statement")
        and each.end_byte <= end
        and not work.is_gone(each)
        and _is_standard(text[each.start_byte : each.end_byte])
        and line_start(text, each.start_byte) == each.start_byte
    ]
    keys = [_order(work.slice(each)) for each in own]
    places = []
    for line in wanted if own else ():
        behind = [each for each, key in zip(own, keys, strict=True) if key > _order(line)]
        is_between = behind and keys == sorted(keys)
        places.append(
            (behind[0].start_byte if is_between else line_end(text, own[-1].end_byte - 1), line)
        )
    return places


def _order(line: str) -> tuple[bool, str]:
    return line.startswith("from "), line.lower()


def _extend(work: Work, imports: Iterable[str]) -> set[str]:
    """Write imports into those of the same modules at the top of the file; return the others."""
    left: set[str] = set()
    for line in sorted(imports):
        module, _, name = line.removeprefix("from ").partition(" import ")
        names = _names_of(work, module)
        if not names:
            left.add(line)
            continue
        is_below = len(names) > 1 and names[-1].start_point.row > names[-2].start_point.row
        gap = "\n" + " " * names[-1].start_point.column if is_below else " "
        statement = names[-1].parent
        if statement is not None and b"\\" in (statement.text or b""):
            # Without brackets each line says that it goes on.
            gap = " \\\n" + " " * names[-1].start_point.column
        work.insert(names[-1].end_byte, f",{gap}{name}")
    return left


def _names_of(work: Work, module: str) -> list[Node]:
    """Return the names that an import of a module at the top of the file takes from it."""
    for statement in work.analysis.syntax.root.named_children:
        source = statement.child_by_field_name("module_name")
        is_kept = statement.id not in work.done and not work.is_gone(statement)
        if source is not None and is_kept and work.slice(source) == module:
            return statement.children_by_field_name("name")
    return []


def _joined(imports: set[str]) -> list[str]:
    """Return import lines, those from one module in one."""
    names: dict[str, list[str]] = {}
    for line in sorted(imports):
        module, _, name = line.partition(" import ")
        names.setdefault(module, []).append(name)
    return [
        f"{module} import {', '.join(found)}" if module.startswith("from ") else module
        for module, found in names.items()
    ]


def _client_import(work: Work) -> Node | None:
    """Return the first import of the client library at the top of the file, which goes."""
    text = work.analysis.syntax.text
    for statement in work.analysis.syntax.root.named_children:
        if statement.type in IMPORTS and work.is_gone(statement):
            is_line = line_start(text, statement.start_byte) == statement.start_byte
            return statement if is_line else None
    return None


def _begins_group(work: Work, at: int) -> bool:
    """Tell whether the import at an offset is of no module that comes with Python."""
    text = work.analysis.syntax.text
    return _MODULE.match(text, at) is not None and not _is_standard(text[at : line_end(text, at)])


def _is_standard(line: bytes) -> bool:
    """Tell whether an import is of a module that comes with Python."""
    found = _MODULE.match(line)
    return found is not None and found[1].decode("ascii", "replace") in stdlib_module_names


def _first_import(work: Work) -> int:
    """Return where the first import of the module starts, or the first statement."""
    text = work.analysis.syntax.text
    statements = work.analysis.syntax.root.named_children
    for statement in statements:
        if statement.type != "future_import_statement" and _has_import(work, statement):
            return line_start(text, statement.start_byte)
    behind = [each for each in statements if each.type not in ("comment", *IMPORTS)]
    if behind and behind[0].type == "expression_statement" and len(behind) > 1:
        behind = behind[1:]
    return line_start(text, behind[0].start_byte) if behind else len(text)


def _has_import(work: Work, statement: Node) -> bool:
    """Tell whether a statement of the module imports: an import, or a `try` around one."""
    if statement.type in IMPORTS:
        return True
    if statement.type == "if_statement" and b"__name__" in (statement.text or b""):
        return False
    return statement.type in ("try_statement", "if_statement") and any(
        statement.start_byte <= node.start_byte < statement.end_byte
        for tag in ("import", "import_from")
        for node in work.analysis.captures.get(tag, [])
    )
