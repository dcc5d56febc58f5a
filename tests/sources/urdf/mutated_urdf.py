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

_TOKENS = re.compile(rb"<[^>]*>|[^<]+")
_WORDS = re.compile(rb"[\w.-]+|\W")
_ODD = (
    *(b"<", b">", b'"', b"&", b"&#0;", b"&amp;", b"--", b"\x00", b"\xff", b"\xef\xbb\xbf"),
    *(b"\r\n", b"\t", b"1e999", b"-", b"nan", b"${x}", b"$(find a)", b"", b"<!-- x -->"),
    *(b"<![CDATA[ x ]]>", b"<?go on?>", b"<link/>", b"<joint/>", b"<xacro:if value='1'/>"),
)


def mutated(choice: random.Random) -> bytes:
    """Return a file with one to four changes: of bytes, of words, or of tags."""
    text = ROBOT
    for _ in range(choice.randint(1, 4)):
        kind = choice.random()
        if kind < 0.2:
            start = choice.randrange(len(text) + 1)
            end = min(len(text), start + choice.randrange(4))
            text = text[:start] + choice.choice(_ODD) + text[end:]
            continue
        parts = (_TOKENS if kind < 0.6 else _WORDS).findall(text)
        at, other = choice.randrange(len(parts)), choice.randrange(len(parts))
        match choice.randrange(4):
            case 0:
                del parts[at]
            case 1:
                parts.insert(other, parts[at])
            case 2:
                parts[at], parts[other] = parts[other], parts[at]
            case _:
                parts[at] = choice.choice(_ODD)
        text = b"".join(parts)
    return text
