"""Launch files that nobody wrote in good faith: read in part, or refused, and soon."""

from __future__ import annotations

import pytest

from plastron_tui.sources.launch.python_reader import read_launch_python
from plastron_tui.sources.launch.xml_reader import read_launch_xml


def _python(before: str, actions: str) -> bytes:
    lines = f"{before}    return LaunchDescription([{actions}])\n"
    return f"def generate_launch_description():\n{lines}".encode()


PYTHON = {
    "a list doubled": _python("    a = ['x']\n" + "    a = a + a\n" * 40, "a"),
    "a text doubled": _python("    a = 'xy'\n" + "    a = a + a\n" * 40, "GroupAction([a])"),
    "lists of lists": _python("    a = ['x']\n" + "    a = [a, a]\n" * 40, "Node(executable=a)"),
    "deep lists": _python("", "[" * 3000 + "]" * 3000),
    "wrong types": _python(
        "",
        "Node(package=1, executable=[None], remappings=3, parameters=[None, {1: 2}], condition=5),"
        "IncludeLaunchDescription('a', launch_arguments=5), IncludeLaunchDescription(),"
        "PushRosNamespace(), GroupAction(3), LaunchConfiguration(), SetRemap(1), Node()",
    ),
    "functions that call themselves": b"def f(x):\n    return [f(x), f(x)]\n" + _python("", "f(1)"),
    "functions doubled": b"".join(
        b"def f%d(x):\n    return [f%d(x), f%d(x)]\n" % (at, at - 1, at - 1) for at in range(40)
    )
    + _python("", "f39(1)"),
    "opaque functions doubled": b"".join(
        b"def f%d(c):\n    return [OpaqueFunction(function=f%d)] + [OpaqueFunction(function=f%d)] "
        b"+ [OpaqueFunction(function=f%d)]\n" % (at, at - 1, at - 1, at - 1)
        for at in range(40)
    )
    + _python("", "OpaqueFunction(function=f39)"),
    "branches": _python("".join(f"    if x:\n        a{at} = {at}\n" for at in range(20_000)), ""),
    "deep branches": _python(
        "".join(f"{' ' * (at + 4)}if x:\n" for at in range(90)) + " " * 94 + "a = 1\n", ""
    ),
    "no function": b"",
    "no Python": b"def (",
    "no UTF-8": _python("", "'x'").replace(b"x", b"\xe9"),
}
ALIASES = "".join(
    f"b{at}: &amp;b{at} {{p: *{of}, q: *{of}, r: *{of}}}\n"
    for at, of in enumerate(["a", *(f"b{at}" for at in range(17))])
)
XML = {
    "deep groups": "<launch>" + "<group>" * 3000 + "</group>" * 3000 + "</launch>",
    "substitutions": '<launch><arg name="a" default="' + "$(var " * 5000 + '"/></launch>',
    "aliases": f"<launch><rosparam param='q'>a: &amp;a [x]\n{ALIASES}</rosparam></launch>",
    "another element": "<robot/>",
    "nothing": "",
}


@pytest.mark.parametrize("source", PYTHON.values(), ids=PYTHON.keys())
def test_python_is_read_in_part_or_refused(source: bytes) -> None:
    read = read_launch_python(source)
    assert read.launch is not None or read.diagnostics


@pytest.mark.parametrize("source", XML.values(), ids=XML.keys())
def test_xml_is_read_in_part_or_refused(source: str) -> None:
    read = read_launch_xml(source.encode())
    assert read.launch is not None or read.diagnostics
