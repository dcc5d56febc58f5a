"""A package.xml that the build tools refuse is told of: nothing of its package is looked at."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, told, write_tree

from plastron_tui.lint.rules.package_examples import NODE_PACKAGE

XML = NODE_PACKAGE["demo/package.xml"]


@pytest.mark.parametrize(
    ("right", "wrong", "code"),
    [
        ("ada@example.com", "ada", "broken-package"),
        ("<version>0.1.0", "<version>one", "broken-package"),
        ("</name>", "", "broken-xml"),
        ("ament_python", "ament_cargo", ""),
    ],
)
def test_what_the_build_tools_refuse(tmp_path: Path, right: str, wrong: str, code: str) -> None:
    assert right in XML
    files = {**NODE_PACKAGE, "demo/package.xml": XML.replace(right, wrong)}
    root = write_tree(tmp_path, files)
    for _ in ("read", "as it was read before"):
        assert [found for found, _ in told(run_over(root))] == ([code] if code else [])
    assert told(run_over(root, "RK")) == []
