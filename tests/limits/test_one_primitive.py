"""Every file is opened by the one function that refuses what is no regular file."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import plastron_tui

_PACKAGE = Path(plastron_tui.__file__).parent
_READERS = frozenset({"read_bytes", "read_text"})

_OTHERS = {
    "regular_files.py": "it is the one function, and reads what a shell hands over",
    "cli/streams.py": "it opens the null device",
    "runtime/console.py": "it opens the null device",
    "output/file_calls.py": "it makes files, and digests regular ones piece by piece",
    "output/locks.py": "it opens folders",
    "ros/catalog/data.py": "it reads Plastron's own data",
    "targets/templates.py": "it reads Plastron's own templates",
    "targets/python/syntax.py": "it reads Plastron's own queries",
    "studio/editor/finding.py": "it opens a bar",
    "private_files.py": "it makes files, and reads what the kernel says of a process",
}
"""The modules that open files otherwise, and why."""


def _openings(tree: ast.AST) -> Iterator[int]:
    """Yield the lines on which something is opened or read by its path."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call):
            continue
        match node.func:
            case ast.Name(id="open"):
                yield node.lineno
            case ast.Attribute(attr="open", value=ast.Name(id="os" | "io")):
                yield node.lineno
            case ast.Attribute(attr="open") if not node.keywords or node.args:
                yield node.lineno
            case ast.Attribute(attr=name) if name in _READERS:
                yield node.lineno


def test_no_module_opens_files_by_itself() -> None:
    found = {
        path.relative_to(_PACKAGE).as_posix(): lines
        for path in sorted(_PACKAGE.rglob("*.py"))
        if (lines := list(_openings(ast.parse(path.read_bytes()))))
    }
    assert found.keys() <= _OTHERS.keys(), found
    assert _OTHERS.keys() <= found.keys(), "an exception that is none any more"
