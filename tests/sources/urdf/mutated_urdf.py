"""Robots' files with random damage."""

from __future__ import annotations

import random
import re

ROBOT = b"""\
<?xml version="1.0"?>
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <material name="m"><color rgba="1 0 0 1"/></material>
  <link name="a"><visual><geometry><sphere radius="0.5"/></geometry><material name="m"/></visual>
    <collision><origin xyz="0 0 1"/><geometry><box size="1 2 3"/></geometry></collision></link>
  <!-- note -->
  <joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/><mimic joint="k"/></joint>
  <link name="b"><inertial><mass value="2"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>

  <joint name="k" type="fixed"><origin rpy="0 0 1"/><parent link="b"/><child link="c"/></joint>
  <link name="c"><visual name="v"><geometry><mesh filename="package://a/b.stl" scale="1 1 2"/>
    </geometry><material name="n"><texture filename="t"/></material></visual></link>
</robot>
"""

_VALUES = re.compile(rb'"[^"<]*"|[^"]+|"')
_EMPTY = re.compile(rb"<[^<>]*/>|(?:(?!<[^<>]*/>).)+", re.DOTALL)
_TOKENS = re.compile(rb"<[^>]*>|[^<]+")
_WORDS = re.compile(rb"[\w.-]+|\W")
_ODD = (
    *(b"<", b">", b'"', b"&", b"&#0;", b"&amp;", b"--", b"\x00", b"\xff", b"\xef\xbb\xbf"),
    *(b"\r\n", b"\t", b"-", b"", b"<!-- x -->", b"<![CDATA[ x ]]>", b"<?go on?>"),
)
_NUMBERS = (
    *(b"", b" ", b"0", b"1", b"-1 ", b"1e999", b"nan", b"0x1", b"1,5", b"${x}", b"$(find a)"),
    *(b"1 2 3", b"1  2\t3", b"1 2", b"1 1 1 1", b"a", b"b", b"j", b"m", b"fixed", b"revolute"),
    *(b"prismatic", b"&lt;&#10;&quot;", b"\xc3\xa9"),
)
_ELEMENTS = (
    *(b"<link/>", b'<link name="d"/>', b"<joint/>", b'<xacro:if value="1"/>', b"<origin/>"),
    *(b'<origin xyz="1 1 1"/>', b"<axis/>", b"<limit/>", b'<mass value="0"/>', b"<dynamics/>"),
    *(b"<geometry/>", b'<sphere radius="1"/>', b'<material name="m"/>', b"<visual/>"),
)


def mutated(choice: random.Random) -> bytes:
    """Return a file with one to four changes: of bytes, of words, or of tags."""
    text = ROBOT
    for _ in range(choice.randint(1, 4)):
        kind = choice.random()
        if kind < 0.08:
            start = choice.randrange(len(text) + 1)
            end = min(len(text), start + choice.randrange(4))
            text = text[:start] + choice.choice(_ODD) + text[end:]
            continue
        cut = _TOKENS if kind < 0.12 else _WORDS if kind < 0.2 else _VALUES
        parts = (_EMPTY if kind > 0.6 else cut).findall(text)
        at, other = choice.randrange(len(parts)), choice.randrange(len(parts))
        if kind > 0.2:
            # What is left is well-formed for the most part.
            first, last = (b'"', b'"') if kind <= 0.6 else (b"<", b"/>")
            alike = [
                each
                for each, part in enumerate(parts)
                if part.startswith(first) and part.endswith(last)
            ]
            at, other = choice.choice(alike), choice.choice(alike)
            if kind <= 0.6:
                parts[at] = b'"' + choice.choice(_NUMBERS) + b'"'
                text = b"".join(parts)
                continue
        match choice.randrange(4):
            case 0:
                del parts[at]
            case 1:
                parts.insert(other, parts[at])
            case 2:
                parts[at], parts[other] = parts[other], parts[at]
            case _:
                parts[at] = choice.choice(_ODD if kind < 0.2 else _ELEMENTS)
        text = b"".join(parts)
    return text
