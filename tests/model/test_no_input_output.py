"""The model asks no disk: what it knows of files is handed in, by a reader."""

from __future__ import annotations

import ast
from pathlib import Path, PurePath

import pytest

import plastron_tui.model

MODULES = sorted(Path(plastron_tui.model.__file__).parent.glob("*.py"))
# What else has an attribute of the name: dataclasses, strings, nodes, what resolves types.
OTHERS = {"home", "owner", "rename", "replace", "resolve"}
ASKS_THE_DISK = {name for name in dir(Path) if not hasattr(PurePath, name)} - OTHERS
FUNCTIONS = {"input", "open", "print"}


@pytest.mark.parametrize("module", MODULES, ids=lambda module: module.stem)
def test_a_path_is_a_name_only(module: Path) -> None:
    found = [
        f"{module.name}:{node.lineno}: {ast.unparse(node)}"
        for node in ast.walk(ast.parse(module.read_bytes()))
        if (isinstance(node, ast.Attribute) and node.attr in ASKS_THE_DISK)
        or (isinstance(node, ast.Name) and node.id in FUNCTIONS)
    ]
    assert found == []
