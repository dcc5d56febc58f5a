"""Where in a file a new function or method goes, and what is around it."""

from __future__ import annotations

import pytest
from edits import edited, subscribe


@pytest.mark.parametrize("blank", range(4))
def test_two_blank_lines_are_around_a_function_that_is_written(blank):
    head = "import rospy\nfrom std_msgs.msg import String\n" + "\n" * blank
    main = "if __name__ == '__main__':\n    rospy.init_node('n')\n    rospy.spin()\n"
    text = edited(f"{head}{main}", subscribe("text"))
    written, _, _ = text.partition("if __name__")
    before, _, _ = written.partition("def ")
    assert written.endswith(")\n\n\n")
    assert before.endswith("String\n" + "\n" * max(blank, 2))


SCRIPT = "import rospy\nfrom std_msgs.msg import String\n{0}if __name__ == '__main__':\n{1}"
RUN = "    rospy.init_node('n')\n"


def test_a_function_stands_behind_the_constants():
    text = edited(SCRIPT.format("\nSPEED = 5\n\n", RUN + "    rospy.spin()\n"), subscribe("text"))
    assert "SPEED = 5\n\n\ndef on_text" in text


def test_a_function_stands_behind_the_imports():
    load = (
        "import roslib\nroslib.load_manifest('a')\nimport rospy\nfrom std_msgs.msg import String\n"
    )
    text = edited(f"{load}rospy.init_node('n')\nrospy.spin()\n", subscribe("text"))
    assert text.startswith(f"{load}\n\ndef on_text")


def test_a_method_stands_behind_what_tells_the_end_of_another():
    text = edited(
        "import rospy\nfrom std_msgs.msg import String\n\n\nclass A:\n    def __init__(self):\n"
        "        rospy.init_node('a')\n        rospy.Subscriber('a', String, self.on_a)\n\n"
        "    def on_a(self, data):\n        print(data)\n    # end def\n    # other things\n",
        subscribe("b"),
    )
    assert "    # end def\n\n    def on_b(self, data):\n        rospy.loginfo" in text


DEEP = (
    "import rospy\nfrom std_msgs.msg import String\n\n\nclass A:\n    def __init__(self):\n"
    "        rospy.init_node('a')\n        rospy.Subscriber('a', String, self.on_a)\n\n"
    "    def on_a(self, data):\n        print(data)\n{}    def stop(self):\n        pass\n"
)
NEW = "    def on_b(self, data):\n        rospy.loginfo('b: %s', data)\n"


def test_a_comment_that_stands_too_deep_stays_with_the_method_below():
    below = "\n        # stops it\n"
    assert f"(data)\n\n{NEW}{below}    def stop" in edited(DEEP.format(below), subscribe("b"))


def test_a_method_without_a_blank_line_below_gets_one():
    text = DEEP.format("\n    def on_c(self):\n        pass\n").replace(
        "pass\n    def", "pass\n\n    def", 1
    )
    tight = text.replace("(data)\n\n    def on_c", "(data)\n    def on_c")
    assert f"(data)\n\n{NEW}\n    def on_c" in edited(tight, subscribe("b"))


def test_lines_that_go_on_with_others_do_not_tell_the_indent():
    script = "import rospy\nfrom std_msgs.msg import (Bool,\n" + " " * 26 + "String)\n\n\n"
    text = edited(f"{script}if 1:\n  rospy.init_node('n')\n  rospy.spin()\n", subscribe("b"))
    assert "def on_b(message):\n  rospy.loginfo(" in text
