"""What holds for every node that is brought from one ROS to the other."""

from __future__ import annotations

import ast
import re
from collections import Counter
from pathlib import Path

import pytest
from file_sets import one
from ported_nodes import (
    CATALOGS,
    MARK,
    OTHER,
    PORTED,
    endpoints,
)

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.model.source import EndpointKind, SourceUnit
from plastron_tui.sources.python import read_python
from plastron_tui.sources.python.syntax import parse
from plastron_tui.targets import find_target

NODES = Path(__file__).parent.parent / "nodes"
FILES = sorted(
    path
    for path in NODES.glob("r*py/*")
    if path.is_file() and path.suffix != ".json" and path.parent.name in OTHER
)


def callbacks(read: SourceUnit) -> set[str]:
    return {
        each.callback
        for each in read.endpoints
        if each.callback is not None and each.kind in (*PORTED, EndpointKind.TIMER)
    }


@pytest.mark.parametrize("path", FILES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_every_node_of_the_collection(path: Path) -> None:
    read = read_python(path, one(path.read_bytes()), None).source
    if read is None or read.library not in OTHER:
        return
    target = find_target(OTHER[read.library])
    assert target is not None
    result = target.port(None, read, CATALOGS[target.name])  # type: ignore[arg-type]
    if result.files is None:
        assert [found.code for found in result.diagnostics] == ["edit-refused"]
        with pytest.raises((SyntaxError, ValueError)):
            ast.parse(read.files.main)
        return
    assert all(
        found.code == "port-by-hand" and found.severity is Severity.WARNING and found.file == path
        for found in result.diagnostics
    )
    check_endpoints(read, result.files.main, result.diagnostics, target.name)
    check_marks(read, result.files.main, result.diagnostics)
    check_bodies(read, result.files.main)


def check_endpoints(
    read: SourceUnit, text: bytes, diagnostics: tuple[Diagnostic, ...], library: str
) -> None:
    """What the file shows is what it showed, apart from what is said to be missing."""
    after = read_python(read.path, one(text), library).source
    assert after is not None
    missing = Counter(
        match[1].replace("~/", "~")
        for found in diagnostics
        if (match := re.search(r"`(.*)` in line \d+ is not carried over", found.message))
    )
    before = Counter(name for _, name in endpoints(read).elements())
    assert Counter(name for _, name in endpoints(after).elements()) >= before - missing


def check_marks(read: SourceUnit, text: bytes, diagnostics: tuple[Diagnostic, ...]) -> None:
    """Every statement that still names the old library stands below a comment."""
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError):
        return
    lines = text.decode(parse(text).encoding, "replace").split("\n")
    statements = [node for node in ast.walk(tree) if isinstance(node, ast.stmt)]
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and node.id == read.library:
            around = {
                s.lineno for s in statements if s.lineno <= node.lineno <= (s.end_lineno or 0)
            }
            above = {lines[row - 2] for row in (*around, node.lineno)}
            assert any(MARK in line for line in above), lines[node.lineno - 1]
    named = {
        what
        for line in lines
        if MARK in line
        for what in line.partition(MARK)[2].strip().split("; ")
    }
    told = {found.message.split("`")[1] for found in diagnostics if "`" in found.message}
    assert named - told == set() or MARK.encode() in read.files.main


# What is rewritten in a callback as well, where it is sure what becomes of it.
REWRITTEN = re.compile(
    r"Publisher\(|Subscriber\(|Service\(|ServiceProxy\(|Timer\(|create_|wait_for_m|import"
    r"|timer\.(cancel|shutdown)\(|(_throttle|_once|_param|sleep|get_caller_id|unregister|wait_for_service)\(|\.publish\(|log(debug|info|warn|err|fatal)\(|\.get_logger\(|\.get_clock\(|Time\.now\("
    r"|^\w+(\.\w+)+ = |is_shutdown\(|\.ok\(|get_name\(|get_time\(|^return |\b[A-Z]\w+\(."
)


def check_bodies(read: SourceUnit, text: bytes) -> None:
    """Every other line of a callback is as it was."""
    try:
        before, after = ast.parse(read.files.main), ast.parse(text)
    except (SyntaxError, ValueError):
        return
    for name in callbacks(read):
        new = {line for function in functions(after, name) for line in lines_of(function)}
        for function in functions(before, name):
            for line in lines_of(function):
                assert line in new or REWRITTEN.search(line)


def lines_of(function: ast.AST) -> list[str]:
    """Return the statements in a function that hold no others, and what those depend on."""
    return [
        ast.unparse(getattr(node, "test", node))
        for node in ast.walk(function)
        if isinstance(node, ast.stmt) and (hasattr(node, "test") or not hasattr(node, "body"))
    ]


def functions(tree: ast.AST, name: str) -> list[ast.FunctionDef | ast.AsyncFunctionDef]:
    return [
        node
        for node in ast.walk(tree)
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and node.name == name
    ]
