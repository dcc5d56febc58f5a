"""Where launch files say what they start, and which parameters they set."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_text import Scope
from plastron_tui.sources.launch.reader import read_launch

XML = '<launch><!-- ö -->{}<node pkg="a" exec="b">{}</node></launch>'
YAML = "launch:\n- let: {{name: ö, value: x}}\n- node:\n    pkg: {}\n    exec: b\n    param: [{}]\n"
PYTHON = (
    "from all_of_it import *\nTOP = 'a'  # ö\nMORE = {{'rate': 1.0}}\n"
    "def generate_launch_description():\n"
    "    return LaunchDescription([Node({}executable='b', parameters=[{}])])\n"
)
CASES = {
    "xml": ("x.launch.xml", XML.format("", '<param name="rate" value="1"/>'), "a", "rate"),
    "references": (
        "x.launch.xml",
        XML.format("", '<param name="r&#97;te" value="1"/>').replace('"a"', '"&#97;"'),
        None,
        None,
    ),
    "xml_of_a_substitution": (
        "x.launch.xml",
        XML.format('<let name="n" value="rate"/>', '<param name="$(var n)" value="1"/>'),
        "a",
        None,
    ),
    "xml_of_an_unknown_value": (
        "x.launch.xml",
        XML.format('<arg name="n"/>', '<param name="rate" value="$(var n)"/>'),
        "a",
        "rate",
    ),
    "nested": (
        "x.launch.xml",
        XML.format("", '<param name="top"><param name="rate" value="1"/></param>'),
        "a",
        "rate",
    ),
    "of_all_nodes": (
        "x.launch.xml",
        XML.format('<set_parameter name="rate" value="1"/>', ""),
        "a",
        None,
    ),
    "yaml": ("x.launch.yaml", YAML.format("a", "{name: rate, value: 1}"), "a", "rate"),
    "yaml_in_quotes": (
        "x.launch.yaml",
        YAML.format("'a'", '{name: "rate", value: 1}'),
        "a",
        "rate",
    ),
    "yaml_with_escapes": (
        "x.launch.yaml",
        YAML.format('"\\x61"', "{name: rate, value: 1}"),
        None,
        "rate",
    ),
    "python": ("x.launch.py", PYTHON.format("package='a', ", "{'rate': 1.0}"), "a", "rate"),
    "python_by_names": ("x.launch.py", PYTHON.format("package=TOP, ", "MORE"), None, "rate"),
    "python_with_escapes": (
        "x.launch.py",
        PYTHON.format("package='\\x61', ", "{r'rate': 1.0, 'a' 'b': 2}"),
        None,
        None,
    ),
    "python_nested": ("x.launch.py", PYTHON.format("", "{'top': {'rate': 1.0}}"), None, "rate"),
}


@pytest.mark.parametrize(("name", "text", "package", "parameter"), CASES.values(), ids=CASES)
def test_words_of_a_node_have_their_places(
    name: str, text: str, package: str | None, parameter: str | None
) -> None:
    source = text.encode()
    launch = read_launch(source, Path(name)).launch
    assert launch is not None
    (node,) = resolve(launch, 2, Scope({}, {}, "", lambda _: None), name).started

    def word(span: tuple[int, int] | None) -> str | None:
        return None if span is None else source[span[0] : span[1]].decode()

    assert word(node.package_span) == package
    assert word(node.executable_span) == "b"
    assert [word(span) for _, span in node.setting_spans] == ([parameter] if parameter else [])
