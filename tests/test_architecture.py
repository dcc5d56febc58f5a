"""What docs/architecture.md says of the house holds: paths, and how large its parts are."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "plastron_tui"
LONGEST_FILE = 400
LONGEST_CLASS = 500
"""In lines, with those of the classes of Plastron's own that it inherits from."""

PAGE = (ROOT / "docs" / "architecture.md").read_text()
MODULES = sorted(PACKAGE.rglob("*.py"))


def test_each_path_is_there() -> None:
    paths = set(re.findall(r"`(\w[\w./-]*(?:\.(?:py|md|js|toml)|/))`", PAGE))
    folders = (PACKAGE, ROOT, PACKAGE / "generating")
    assert [path for path in sorted(paths) if not any((at / path).exists() for at in folders)] == []
    assert len(paths) > 100


def test_no_file_is_long() -> None:
    lengths = {path: path.read_text().count("\n") for path in MODULES}
    assert {path: length for path, length in lengths.items() if length > LONGEST_FILE} == {}


def _statements(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield all statements, and not what they consist of."""
    for field in ("body", "orelse", "handlers", "finalbody", "cases"):
        inner = getattr(tree, field, ())
        for each in inner if isinstance(inner, list) else ():
            yield each
            yield from _statements(each)


def test_no_class_is_long() -> None:
    classes = {
        node.name: (node.end_lineno - node.lineno + 1, [ast.unparse(base) for base in node.bases])
        for path in MODULES
        if re.search(r"^\s*class ", text := path.read_text(), re.MULTILINE)
        for node in _statements(ast.parse(text))
        if isinstance(node, ast.ClassDef) and node.end_lineno is not None
    }

    def length(name: str) -> int:
        own, bases = classes.get(name.split("[")[0], (0, []))
        return own + sum(map(length, bases))

    assert {name: length(name) for name in classes if length(name) > LONGEST_CLASS} == {}


def test_each_package_is_in_the_wheel() -> None:
    settings = (ROOT / "pyproject.toml").read_text()
    # The contracts name packages too.
    _, _, listed = settings.partition("[tool.setuptools]\npackages = [\n")
    in_wheel = set(
        re.findall(r'^  "(plastron_tui[^"]*)",$', listed.partition("]")[0], re.MULTILINE)
    )
    packages = {".".join(path.parent.relative_to(ROOT).parts) for path in MODULES}
    assert packages - in_wheel == set()
