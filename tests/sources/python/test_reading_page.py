"""What docs/reading.md says cannot be read: it must be true, and go when it is not."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.sources.python import read_python

PAGE = (Path(__file__).parents[3] / "docs" / "reading.md").read_text(encoding="utf-8")
IMPORTS = """\
import rospy
import rclpy
from std_msgs.msg import String
from sensor_msgs.msg import LaserScan
node = rclpy.create_node('n')
"""
FOUND = {
    "A library that is chosen as the file runs": [],
    "Both libraries in one file": ["state"],
    "What a file of another package decides": [None],
    "What the run decides": [None],
}


@pytest.mark.parametrize("title", FOUND)
def test_what_the_page_says_of_its_examples_is_so(title: str) -> None:
    example = re.search(rf"\*\*{title}\.?\*\*.*?```python\n(.*?)```", PAGE, re.DOTALL)
    assert example is not None
    library = None if title == "Both libraries in one file" else "rospy"
    text = (IMPORTS + example[1]).encode()
    source = read_python(Path("node.py"), one(text), library).source
    assert source is not None
    assert [found.name for node in source.nodes for found in node.endpoints] == FOUND[title]


def test_an_object_that_is_not_known_to_be_a_node_creates_nothing_of_an_unknown_type() -> None:
    imports = f"{IMPORTS}from other.config import session, KIND\n"
    text = f"{imports}session.create_publisher(KIND, 'a', 10)\n"
    source = read_python(Path("node.py"), one(text.encode()), "rclpy").source
    assert source is not None
    assert not any(node.endpoints for node in source.nodes)
