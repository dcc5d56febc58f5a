"""What is shown of macros that are not expanded."""

from __future__ import annotations

from plastron_tui.model.robot_macros import macro_rows, macros_json
from plastron_tui.ros.robots.macros import Macros
from plastron_tui.sources.urdf.macros import read_macros
from plastron_tui.sources.xml.document import read_xml

TEXT = """\
<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="a.xacro" optional="true" ns="eyes"/>
  <xacro:arg name="sim" default="false"/>
  <xacro:property name="width" value="{}"/>
  <xacro:property name="place"><origin/></xacro:property>
  <xacro:macro name="wheel" params="prefix
      radius:=0.1 *origin"><link name="w"/><xacro:if value="1"/></xacro:macro>
  <xacro:macro name="axle" params=""><link name="a"/><joint name="j" type="fixed"/></xacro:macro>
  <xacro:unless value="1"><xacro:wheel prefix="left" radius="${{x &lt; 1}}"/></xacro:unless>
</robot>
"""


def read(value: str) -> Macros:
    document = read_xml(TEXT.format(value).encode()).document
    assert document is not None
    return read_macros(document)


def test_macros_as_rows() -> None:
    assert list(macro_rows(read("0.3"))) == [
        ("include", "a.xacro", "if it is there, as eyes"),
        ("argument", "sim", "false"),
        ("property", "width", "0.3"),
        ("property", "place", "elements"),
        ("macro", "wheel prefix radius:=0.1 *origin", "1 link, no joints and more"),
        ("macro", "axle", "1 link, 1 joint"),
        ("call", "wheel", 'prefix="left" radius="${x < 1}"'),
    ]
    (_, _, said) = list(macro_rows(read("a\n" * 10_000)))[2]
    assert len(said.encode()) <= 200
    assert "\n" not in said


def test_macros_as_json() -> None:
    found = macros_json(read("0.3"))
    assert found["includes"] == [{"file": "a.xacro", "line": 2, "optional": True}]
    assert found["properties"][0] == {"name": "width", "value": "0.3", "line": 4}
    assert found["macros"][0]["parameters"][2] == {"name": "origin", "default": None, "block": True}
    assert found["macros"][1] == {
        "name": "axle", "parameters": [], "links": 1, "joints": 1, "calls": [], "line": 8,
    }  # fmt: skip
    assert found["calls"] == [
        {"macro": "wheel", "arguments": {"prefix": "left", "radius": "${x < 1}"}, "line": 9}
    ]
    assert found["conditions"] == 1
