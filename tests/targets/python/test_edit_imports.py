"""The imports of a file that gives up a type and needs it again stay as they were."""

from __future__ import annotations

import pytest
from edits import AT, SUB, edited, publish, subscribe

from plastron_tui.model.source import Remove

BODY = """
rospy.init_node('n')
rospy.Subscriber('old', Bool, print)
rospy.Publisher('other', Float32, queue_size=1)
"""
IMPORTS = [
    "import rospy\nfrom std_msgs.msg import Bool, Float32\n",
    "import rospy\nfrom std_msgs.msg import (\n    Bool,\n    Float32,\n)\n",
    "import rospy\nfrom std_msgs.msg import Float32, Bool  # what it hears\n",
    "import rospy\nfrom std_msgs.msg import Bool\nfrom geometry_msgs.msg import Point as Float32\n",
]


@pytest.mark.parametrize("imports", IMPORTS)
def test_the_imports_stay(imports: str) -> None:
    changes = (Remove(SUB, "old", AT), subscribe("new", "std_msgs/Bool", "print"))
    text = edited(imports + BODY, *changes)
    assert text.startswith(imports + "\n")


def test_names_that_are_new_come_behind() -> None:
    changes = (
        Remove(SUB, "old", AT),
        subscribe("new", "std_msgs/Bool", "print"),
        publish("said", "std_msgs/String"),
    )
    text = edited(IMPORTS[0] + BODY, *changes)
    assert text.startswith("import rospy\nfrom std_msgs.msg import Bool, Float32, String\n\n")


def test_two_lines_of_one_module_may_become_one() -> None:
    imports = "import rospy\nfrom std_msgs.msg import Bool\nfrom std_msgs.msg import Float32\n"
    changes = (Remove(SUB, "old", AT), subscribe("new", "std_msgs/Bool", "print"))
    text = edited(imports + BODY, *changes)
    assert text.startswith("import rospy\nfrom std_msgs.msg import Float32, Bool\n\n")


def test_a_name_that_is_not_needed_again_goes() -> None:
    text = edited(IMPORTS[0] + BODY, Remove(SUB, "old", AT))
    assert text.startswith("import rospy\nfrom std_msgs.msg import Float32\n\n")
