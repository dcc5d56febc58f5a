"""Launch files in YAML: they say what the same words in XML say."""

from __future__ import annotations

from typing import Any

import pytest
import yaml
from hypothesis import HealthCheck, Phase, given, settings
from launch_files import launch_files
from machine import examples

from plastron_tui.diagnostics import codes
from plastron_tui.ros.launch import Format, LaunchFile, StartedNode, items_of
from plastron_tui.sources.launch.xml_reader import read_launch_xml
from plastron_tui.sources.launch.yaml_reader import read_launch_yaml
from plastron_tui.sources.xml.document import Element
from plastron_tui.targets.launch.xml import write_xml


def _body(element: Element) -> Any:
    """Return an element of XML as YAML has it."""
    if element.name in ("group", "launch"):
        children = [{each.name: _body(each)} for each in element.children]
        own = {each.name: each.value for each in element.attributes}
        return {**own, "children": children} if own else children
    found: dict[str, Any] = {each.name: each.value for each in element.attributes}
    for child in element.children:
        found.setdefault(child.name, []).append(_body(child))
    return found


@settings(
    max_examples=examples(60),
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=(Phase.explicit, Phase.reuse, Phase.generate),
)
@given(launch=launch_files(2))
def test_yaml_says_what_xml_says(launch: LaunchFile) -> None:
    read = read_launch_xml(write_xml(launch, 2).encode(), ros_version=2)
    assert read.document is not None
    text = yaml.safe_dump({"launch": _body(read.document.root)}, allow_unicode=True)
    found = read_launch_yaml(text.encode())
    assert found.diagnostics == ()
    assert found.format is Format.YAML
    assert found.launch == launch, text


def test_values_are_typed_and_places_told() -> None:
    source = """launch:
- node:
    pkg: démo
    exec: talker
    if: yes
    param:
    - {name: rates, value: [1, 2]}
    - {name: word, value: "é"}
""".encode()
    launch = read_launch_yaml(source).launch
    assert launch is not None
    (node,) = items_of(launch.items, StartedNode)
    assert [each.value for each in node.parameters] == [(1, 2), "é"]  # type: ignore[union-attr]
    assert node.condition is not None
    assert node.condition.value.literal == "true"
    assert node.place is not None
    assert node.place.line == 2
    assert source[node.place.start :].startswith(b"node:")


@pytest.mark.parametrize(
    "source",
    [
        b"",
        b"\xff\xfe",
        b"launch: [",
        b"launch: 3",
        b"- launch",
        b"lunch: []",
        b"launch: [node]",
        b"launch: [{node: {param: [[{}]]}}]",
        b"launch: " + b"[" * 5000,
        b"a: &a [{node: {}}]\nlaunch: *a",
        b"launch: &a [{group: *a}]",
        b"launch:\n" + b"- group: [{group: [{group: []}]}]\n" * 20_000,
        "\n".join(
            ["launch:", "- group: &a0 [{node: {}}]"]
            + [f"- group: &a{n} [{', '.join([f'{{group: *a{n - 1}}}'] * 9)}]" for n in range(1, 9)]
        ).encode(),
        b"launch: [{node: {a: !!python/object/apply:os.system [x]}}, 3]",
        b"launch: [{[a]: {}}]",
        b"launch: [{node: {[a]: b}}]",
        b"\t- x",
    ],
)
def test_what_is_no_launch_file_is_told(source: bytes) -> None:
    read = read_launch_yaml(source)
    assert read.launch is None
    assert [each.code for each in read.diagnostics] == [codes.BROKEN_LAUNCH]


def test_marks_and_line_ends_of_other_systems_are_read() -> None:
    read = read_launch_yaml(b"\xef\xbb\xbflaunch:\r\n- node: {pkg: demo, exec: talker}\r\n")
    assert read.launch is not None
    assert len(list(items_of(read.launch.items, StartedNode))) == 1
