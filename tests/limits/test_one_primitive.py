"""What is done in many places is done by one function: opening files, counting words, cutting."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

import plastron_tui

_PACKAGE = Path(plastron_tui.__file__).parent
_READERS = frozenset({"read_bytes", "read_text"})

_OTHERS = {
    "regular_files.py": "it is the one function, and reads what a shell hands over",
    "cli/streams.py": "it opens the null device",
    "runtime/console.py": "it opens the null device",
    "runtime/mesh_process.py": "it opens the null device",
    "runtime/xacro_process.py": "it opens the null device",
    "output/file_calls.py": "it makes files, and digests regular ones piece by piece",
    "output/locks.py": "it opens folders",
    "ros/catalog/data.py": "it reads Plastron's own data",
    "targets/templates.py": "it reads Plastron's own templates",
    "studio/app.py": "it reads the studio's own style sheets",
    "sources/grammars.py": "it reads Plastron's own queries",
    "studio/main/screen.py": "it opens the wizard",
    "studio/editor/hover.py": "it opens a card",
    "studio/editor/state.py": "it opens a session",
    "studio/editor/widget.py": "it opens a bar, and a session",
    "studio/running.py": "it reads a pipe of its own",
    "runtime/launch.py": "it writes to a pipe of the studio",
    "runtime/builds.py": "it makes locks and logs in the user's cache",
    "runtime/launch_of_graph.py": "it reads what the kernel says of a process",
    "private_files.py": "it makes files, and reads what the kernel says of a process",
}
"""The modules that open files otherwise, and why."""


def _openings(tree: ast.AST) -> Iterator[int]:
    """Yield the lines on which something is opened or read by its path."""
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module in ("os", "io"):
            yield from (node.lineno for each in node.names if each.name in ("open", "fdopen"))
        if not isinstance(node, ast.Call):
            continue
        match node.func:
            case ast.Name(id="open"):
                yield node.lineno
            case ast.Attribute(attr="open" | "fdopen") | ast.Name(id="fdopen"):
                yield node.lineno
            case ast.Attribute(attr=name) if name in _READERS:
                yield node.lineno


_PRIMITIVES: dict[str, set[str]] = {
    r"""(''|"") if [^\n]+ == 1 else ('s'|"s")""": set(),
    r"set_cell_size\([^\n]+ - 1\)": {"studio/cells.py"},
    r"""= " \| \"""": {"runtime/labels.py"},
}
"""What looks like a plural, a text that is cut to cells, or the sign behind a node's name, by where
that is done."""


@pytest.fixture(scope="module")
def sources() -> dict[str, bytes]:
    """Return the modules of the package, by their paths in it."""
    return {
        path.relative_to(_PACKAGE).as_posix(): path.read_bytes()
        for path in sorted(_PACKAGE.rglob("*.py"))
    }


@pytest.mark.parametrize("pattern", _PRIMITIVES)
def test_one_module_has_what_many_need(pattern: str, sources: dict[str, bytes]) -> None:
    found = {name for name, text in sources.items() if re.search(pattern.encode(), text)}
    assert found == _PRIMITIVES[pattern]


def test_no_module_opens_files_by_itself(sources: dict[str, bytes]) -> None:
    # Without one of these words there is nothing to find, and to parse takes seconds.
    words = re.compile(b"open|" + "|".join(_READERS).encode())
    found = {
        name: lines
        for name, text in sources.items()
        if words.search(text) and (lines := list(_openings(ast.parse(text))))
    }
    assert found.keys() <= _OTHERS.keys(), found
    assert _OTHERS.keys() <= found.keys(), "an exception that is none any more"


@pytest.mark.parametrize(
    "line",
    [
        "open('a')",
        "os.open('a', 0)",
        "path.open(mode='rb')",
        "path.open(encoding='utf-8')",
        "os.fdopen(3)",
        "from os import open as begin",
        "path.read_text()",
    ],
)
def test_each_way_to_open_is_found(line: str) -> None:
    assert list(_openings(ast.parse(line))) == [1]
