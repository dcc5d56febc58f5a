"""What one call creates again and again is shown, carried over, and not changed one by one."""

from __future__ import annotations

import pytest
from edits import AT, PUB, SUB, edit, edited, publish

from plastron_tui.model.kinds import Publisher
from plastron_tui.model.source import Remove, Rename, Update
from plastron_tui.ros.interfaces import InterfaceName

HEAD = "import rospy\nfrom std_msgs.msg import String\n\nrospy.init_node('n')\n"
TEXTS = [
    f"{HEAD}for side in ('left', 'right'):\n    rospy.Publisher(side, String, queue_size=1)\n",
    f"{HEAD}\n\ndef make(side):\n    rospy.Publisher(side, String, queue_size=1)\n\n\n"
    "make('left')\nmake('right')\n",
]
STRING, BOOL = InterfaceName("std_msgs", "String"), InterfaceName("std_msgs", "Bool")
CHANGES = [
    Remove(PUB, "left", AT),
    Rename(PUB, "left", "up", AT),
    Update(PUB, "left", Publisher("left", BOOL, [], AT), AT),
]


@pytest.mark.parametrize("text", TEXTS)
@pytest.mark.parametrize("change", CHANGES)
def test_one_of_several_endpoints_of_a_call_is_not_changed(text, change):
    rendered = edit(text, change)
    assert rendered.files is None
    (found,) = rendered.diagnostics
    assert found.code == "edit-refused"
    assert found.message.endswith("creates the publisher `left` among others")
    assert found.help == "change by hand what gives `side` its values"


@pytest.mark.parametrize("text", TEXTS)
def test_what_is_added_leaves_them_alone(text):
    after = edited(text, publish("more"))
    assert all(line in after for line in text.splitlines())


def test_what_an_object_of_a_library_creates_is_not_taken_out():
    rendered = edit(f"{HEAD}import tf\nlistener = tf.TransformListener()\n", Remove(SUB, "/tf", AT))
    assert rendered.files is None
    (found,) = rendered.diagnostics
    message = "the subscription `/tf` is a part of `tf.TransformListener` in line 6"
    assert (found.code, found.message) == ("edit-refused", message)
