"""Which definitions count for what a message has: only those of which there are no others."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, told, write_tree

NODE = """\
import rclpy
from {package}.msg import {name}
rclpy.init()
node = rclpy.create_node('n')
pub = node.create_publisher({name}, 'a', 1)
msg = {name}()
msg.wrong = 1
pub.publish(msg)
"""
MANIFEST = "<package format='3'><name>{}</name><version>0.0.0</version></package>\n"
OWN = NODE.format(package="own_msgs", name="Thing")
HEADER = NODE.format(package="std_msgs", name="Header")

CASES = {
    "a type of the workspace": ({"a/msg/Thing.msg": "int32 right\n"}, OWN, True),
    "a type that two packages of a name define": (
        {"a/msg/Thing.msg": "int32 right\n", "b/msg/Thing.msg": "int32 wrong\n"},
        OWN,
        False,
    ),
    "a type that nobody defines": ({"a/msg/Other.msg": "int32 right\n"}, OWN, False),
    "a type that does not parse": ({"a/msg/Thing.msg": "int32 right right\n"}, OWN, False),
    "a type of the distribution": ({}, HEADER, True),
    "a type of the distribution that the workspace has anew": (
        {"std_msgs/msg/Header.msg": "int32 wrong\n"},
        HEADER,
        False,
    ),
}


@pytest.mark.parametrize(("definitions", "text", "is_told"), CASES.values(), ids=CASES)
def test_only_sure_definitions_count(
    tmp_path: Path, definitions: dict[str, str], text: str, is_told: bool
) -> None:
    files: dict[str, str | bytes] = {"node.py": text, **definitions}
    for path in definitions:
        folder = path.partition("/")[0]
        name = folder if folder == "std_msgs" else "own_msgs"
        files[f"{folder}/package.xml"] = MANIFEST.format(name)
    run = run_over(write_tree(tmp_path, files), "RM201")
    assert told(run) == ([("RM201", 7)] if is_told else [])
