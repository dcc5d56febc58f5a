"""A package.xml that the build tools refuse, or a launch file that is no XML, is told of."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, told, write_tree

from plastron_tui.lint.rules.package_examples import NODE_PACKAGE

XML = NODE_PACKAGE["demo/package.xml"]


_LAUNCH = '<launch>\n  <node pkg="demo" exec="talker" name="{}/>\n</launch>\n'
_FILLED = '<launch>\n  <param name="a" {}/>\n</launch>\n'


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [
        ("a.launch.xml", _LAUNCH.format("a"), [("broken-xml", 3)]),
        ("a.launch.xml", _LAUNCH.format('a"'), []),
        ("a.launch", "<launch>\n", [("broken-xml", 1)]),
        # A tool fills it in.
        ("templates/a.launch", _FILLED.format("[LOAD_ATTRIBUTE]"), []),
        ("arm_template/launch/a.launch", _FILLED.format("{{ more }}"), []),
        ("templates/a.launch", _FILLED.format("value=@VALUE@"), []),
        ("templates/a.launch", _FILLED.format("{% if more %}{% endif %}"), []),
        ("templates/a.launch", "<launch>\n  <%= node %>\n  <[GROUP]></[GROUP]>\n</launch>\n", []),
        ("a.launch", _FILLED.format("[LOAD_ATTRIBUTE]"), [("broken-xml", 2)]),
        ("templates/a.launch", _FILLED.format("[load]"), [("broken-xml", 2)]),
        ("templates/a.launch", _FILLED.format("[LOAD]><"), [("broken-xml", 2)]),
        ("templates/a.launch", _LAUNCH.format("[NAME]"), [("broken-xml", 3)]),
        # It is XML, and not for roslaunch.
        ("a.launch", '<!DOCTYPE a [<!ENTITY b "c">]>\n<a>&b;</a>\n', []),
    ],
)
def test_launch_file_that_is_no_xml_is_told(
    tmp_path: Path, name: str, text: str, expected: list[tuple[str, int]]
) -> None:
    including = '<launch>\n  <include file="$(dirname)/{}"/>\n</launch>\n'
    files = {f"demo/launch/{name}": text, "demo/launch/b.launch.xml": including.format(name)}
    root = write_tree(tmp_path, NODE_PACKAGE | files)
    for _ in ("read", "as it was read before"):
        found = told(run_over(root))
        assert [each for each in found if each[0] == "broken-xml"] == expected


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
