"""What one call creates again and again: it is shown, and one gets another name at most."""

from __future__ import annotations

import pytest
from edits import AT, PUB, SUB, edit, edited, publish

from plastron_tui.model.kinds import Publisher, Subscription
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


RENAMED = [
    *TEXTS,
    TEXTS[0].replace("('left', 'right')", "SIDES").replace("for", "SIDES = ['left', 'right']\nfor"),
    f"{HEAD}all = [rospy.Publisher(side, String) for side in ('left', 'right')]\n",
    f"{HEAD}for side, rate in (('left', 1), ('right', 2)):\n    rospy.Publisher(side, String)\n",
    TEXTS[0] + "    rospy.loginfo('to %s', side)\n",
    TEXTS[1] + "make('left')\n",
]


@pytest.mark.parametrize("text", RENAMED)
def test_one_of_several_endpoints_of_a_call_gets_another_name(text):
    assert edited(text, Rename(PUB, "left", "up", AT)) == text.replace("'left'", "'up'")


@pytest.mark.parametrize(
    "line",
    ["    work(side)", "    rospy.Publisher(side + '/out', String)", "    sides.append(side)"],
)
def test_what_serves_others_in_a_pass_gives_no_other_name(line):
    (found,) = edit(f"{TEXTS[0]}{line}\n", Rename(PUB, "left", "up", AT)).diagnostics
    assert found.message.endswith("creates the publisher `left` among others")


@pytest.mark.parametrize("text", TEXTS)
def test_what_is_added_leaves_them_alone(text):
    after = edited(text, publish("more"))
    assert all(line in after for line in text.splitlines())


@pytest.mark.parametrize(
    ("change", "help_"),
    [
        (Remove(SUB, "/tf", AT), "change the line by hand"),
        (Update(SUB, "/tf", Subscription("/tf", BOOL, None, AT), AT), "change the line by hand"),
        (
            Rename(SUB, "/tf", "/tg", AT),
            "remap it where the node is started: `starts … remapping '/tf' to '/tg'`",
        ),
    ],
)
def test_what_an_object_of_a_library_creates_is_not_taken_out(change, help_):
    rendered = edit(f"{HEAD}import tf\nlistener = tf.TransformListener()\n", change)
    assert rendered.files is None
    (found,) = rendered.diagnostics
    message = "the subscription `/tf` is a part of `tf.TransformListener` in line 6"
    assert (found.code, found.message, found.help) == ("edit-refused", message, help_)
