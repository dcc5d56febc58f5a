"""The messages that an action of ROS 1 is made of."""

from __future__ import annotations

import pytest

from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.definition import parse_definition
from plastron_tui.ros.definition_text import format_definition
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.runtime.action_messages import action_messages

NOETIC = Catalog("noetic")


@pytest.mark.parametrize("name", ["Test", "TestRequest", "TwoInts"])
def test_they_are_those_that_debian_has(name: str) -> None:
    action = NOETIC.find(InterfaceName("actionlib", name), InterfaceKind.ACTION)
    assert action is not None
    made = dict(action_messages(name, format_definition(action, 1)))
    assert len(made) == 7
    for each, text in made.items():
        message = InterfaceName("actionlib", each)
        wanted = NOETIC.find(message, InterfaceKind.MESSAGE)
        found = parse_definition(text, message, InterfaceKind.MESSAGE, 1).interface
        assert wanted is not None
        assert found is not None
        assert found.sections == wanted.sections
