"""Texts that patterns could be slow at, but for those of node files and programs."""

from __future__ import annotations

from pathlib import Path

import pytest
from limited import Attacker

_VALUES = """\
from plastron_tui.studio.wizard.values import pieces
text = 'x' + ' ' * 100_000 + 'y'
assert pieces(text) == [text]
"""
_FORMAT = """\
from pathlib import Path
from plastron_tui.model.source import FileSet
from plastron_tui.ros.catalog import Catalog
from plastron_tui.targets import find_target
from plastron_tui.sources.python.reader import read_python
text = "import rospy\\nrospy.init_node('x')\\nrospy.loginfo('%" + '0' * 100_000 + "!', 1)\\n"
source = read_python(Path('x.py'), FileSet.single('.py', text.encode())).source
assert find_target('rclpy').port(None, source, Catalog('kilted')).files
"""


@pytest.mark.parametrize("code", [_VALUES, _FORMAT], ids=["values", "format"])
def test_a_text_is_taken_apart(attacker: Attacker, tmp_path: Path, code: str) -> None:
    attacker.python(tmp_path, code).check(0)
