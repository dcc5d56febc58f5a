"""Messages that a variable's annotation says, where nothing else does."""

from __future__ import annotations

import pytest
from message_programs import marked, tick, told

ANNOTATED = {
    "what a call gives": tick("""
        msg: PoseStamped = self.buffer.transform('map')
        print(msg.position.x)  # wrong
        print(msg.pose.position.x)
    """),
    "what is asked": tick("""
        msg: PoseStamped = self.buffer.transform('map')
        if isinstance(msg, Pose):
            print(msg.position.x)
    """),
    "what something else gives": tick("""
        msg: PoseStamped = self.poses[0]
        print(msg.position.x)
    """),
    "what is known better": tick("""
        msg: PoseStamped = Pose()
        print(msg.position.x)
        print(msg.pose)  # wrong
    """),
}


@pytest.mark.parametrize("text", ANNOTATED.values(), ids=ANNOTATED)
def test_named_are_fields_that_the_annotation_does_not_have(text: str) -> None:
    assert told(text, "RM201") == marked(text)
