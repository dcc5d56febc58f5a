"""Files with macros, read by their XML alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.ros.robots.description import Box
from plastron_tui.ros.robots.macros import (
    Definition,
    Include,
    Macro,
    MacroCall,
    Macros,
    Parameter,
)
from plastron_tui.sources.urdf.macros import has_macros, read_macros
from plastron_tui.sources.urdf.reader import read_urdf

ROVER = b"""\
<robot name="rover" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find parts)/urdf/materials.xacro"/>
  <xacro:include filename="camera.xacro" ns="eyes" optional="true"/>
  <xacro:arg name="sim" default="false"/>
  <xacro:property name="width" value="0.3"/>
  <xacro:property name="reach" default="${width * 2}"/>
  <xacro:property name="place"><origin xyz="0 0 1"/></xacro:property>
  <link name="base"><visual><geometry><box size="${width} 0.2 0.1"/></geometry></visual></link>
  <link name="mast"><visual><geometry><box size="0.1 0.1 1"/></geometry></visual></link>
  <joint name="hold" type="fixed">
    <parent link="base"/><child link="mast"/><xacro:insert_block name="place"/>
  </joint>
  <xacro:macro name="wheel" params="prefix radius:=0.1 *origin">
    <link name="${prefix}_wheel"/>
    <joint name="${prefix}_turn" type="continuous">
      <parent link="base"/><child link="${prefix}_wheel"/><xacro:insert_block name="origin"/>
    </joint>
  </xacro:macro>
  <xacro:macro name="axle" params="name">
    <link name="${name}_axle"/>
    <xacro:wheel prefix="${name}_left"><origin/></xacro:wheel>
    <xacro:wheel prefix="${name}_right"><origin/></xacro:wheel>
  </xacro:macro>
  <xacro:axle name="front"/>
  <xacro:if value="$(arg sim)">
    <xacro:include filename="gazebo.xacro"/>
    <xacro:call macro="${which}" name="rear"/>
  </xacro:if>
  <transmission name="t"><joint name="hold"/></transmission>
</robot>
"""


def macros_of(text: bytes) -> Macros:
    document = read_urdf(text).document
    assert document is not None
    return read_macros(document)


def test_what_stands_outright_is_read_and_nothing_is_guessed() -> None:
    read = read_urdf(ROVER)
    robot = read.description
    assert robot is not None
    assert not read.diagnostics
    assert list(robot.links) == ["base", "mast"]
    assert list(robot.joints) == ["hold"]
    # A size that is computed is none; the others are as they are written.
    assert robot.links["base"].visuals[0].shape is None
    assert robot.links["mast"].visuals[0].shape == Box((0.1, 0.1, 1.0))


def test_what_is_left_to_macros_is_told() -> None:
    wheel = Macro(
        "wheel", (Parameter("prefix"), Parameter("radius", "0.1"), Parameter("origin", None, True)),
        1, 1, (), 13,
    )  # fmt: skip
    found = macros_of(ROVER)
    assert found.includes == (
        Include("$(find parts)/urdf/materials.xacro", 2),
        Include("camera.xacro", 3, True, "eyes"),
        Include("gazebo.xacro", 26, is_certain=False),
    )
    assert found.macros[0] == wheel
    assert [each.name for each in found.macros] == ["wheel", "axle"]
    assert [call.macro for call in found.macros[1].calls] == ["wheel", "wheel"]
    assert found.calls == (
        MacroCall("axle", (("name", "front"),), 24),
        MacroCall("${which}", (("name", "rear"),), 27),
    )
    assert found.properties == (
        Definition("width", "0.3", 5),
        Definition("reach", "${width * 2}", 6),
        Definition("place", None, 7),
    )
    assert found.arguments == (Definition("sim", "false", 4),)
    assert found.conditions == 1
    assert found.words == "3 includes, 2 macros, 2 calls, 1 condition"


def in_robot(text: str) -> Macros:
    return macros_of(f'<robot xmlns:xacro="http://wiki/xacro">{text}</robot>'.encode())


@pytest.mark.parametrize(
    ("text", "name", "made"),
    [
        (ROVER.decode(), "wheel", (1, 1)),
        (ROVER.decode(), "axle", (3, 2)),
        (ROVER.decode(), "tail", None),
        ('<xacro:macro name="a"><xacro:a/></xacro:macro>', "a", None),
        ('<xacro:macro name="a"><xacro:b/></xacro:macro>'
         '<xacro:macro name="b"><xacro:a/></xacro:macro>', "a", None),
        ('<xacro:macro name="a"><link name="x"/><xacro:if value="1"/></xacro:macro>', "a", None),
        # The last of a name counts; a macro in a macro is its own.
        ('<xacro:macro name="a"><link name="x"/></xacro:macro><xacro:macro name="a"/>',
         "a", (0, 0)),
        ('<xacro:macro name="a"><xacro:macro name="b"><link name="x"/></xacro:macro></xacro:macro>',
         "a", (0, 0)),
        ("".join(f'<xacro:macro name="m{i}"><xacro:m{i + 1}/><xacro:m{i + 1}/></xacro:macro>'
                 for i in range(40)) + '<xacro:macro name="m40"><link name="x"/></xacro:macro>',
         "m0", (2**40, 0)),
    ],
)  # fmt: skip
def test_what_a_call_makes_is_counted_where_it_can_be(
    text: str, name: str, made: tuple[int, int] | None
) -> None:
    found = macros_of(text.encode()) if text.startswith("<robot") else in_robot(text)
    assert found.made_by(name) == made


@pytest.mark.parametrize(
    ("params", "parameters"),
    [
        ("a b", [("a", None, False), ("b", None, False)]),
        ("a:=1 b='x y' c:=^ d:=^|2", [("a", "1", False), ("b", "'x y'", False),
                                      ("c", "^", False), ("d", "2", False)]),
        ("a:=${1 + 2} *origin **content", [("a", "${1 + 2}", False), ("origin", None, True),
                                           ("content", None, True)]),
        ("  a\n\tb := 2 ", [("a", None, False), ("b", "2", False)]),
        ("a:=", [("a", "", False)]),
        ("", []),
    ],
)  # fmt: skip
def test_parameters_are_read_as_xacro_reads_them(
    params: str, parameters: list[tuple[str, str | None, bool]]
) -> None:
    macro = in_robot(f'<xacro:macro name="m" params="{params}"/>').macros[0]
    assert list(macro.parameters) == parameters


@pytest.mark.parametrize("params", ["a:=" + "b" * 9000 + "&apos;", "a" * 20000, "a=${" * 5000])
def test_parameters_that_no_person_writes_end(params: str) -> None:
    assert len(in_robot(f'<xacro:macro name="m" params="{params}"/>').macros[0].parameters) <= 200


@pytest.mark.parametrize(
    ("text", "is_there"),
    [
        (ROVER, True),
        (b'<robot xmlns:xacro="http://x"><link name="${a}"/></robot>', True),
        (b'<robot><xacro:macro name="m"/></robot>', True),
        # As xacro leaves it, and as no xacro is.
        (b'<robot xmlns:xacro="http://x"><link name="a"/></robot>', False),
        (b'<robot><link name="${a}"/></robot>', False),
    ],
)
def test_what_is_expanded_has_no_macros_any_more(text: bytes, is_there: bool) -> None:
    document = read_urdf(text).document
    assert document is not None
    assert has_macros(document) is is_there


def test_what_is_only_included_need_not_name_the_namespace() -> None:
    text = b'<robot><material name="blue"><color rgba="${a}"/></material></robot>'
    assert not read_urdf(text, Path("materials.urdf.xacro")).diagnostics
    # In others that is no colour, and a robot has a name.
    assert len(read_urdf(text, Path("materials.urdf")).diagnostics) == 2
