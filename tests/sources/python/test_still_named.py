"""A name that is gone, and that lines of code go on saying, is told."""

from __future__ import annotations

import pytest
from edits import AT, SUB, edit

from plastron_tui.model.source import Remove, Rename

FILE = (
    "import rospy\nfrom std_msgs.msg import String\n\n\ndef hear(msg):\n    print(msg)\n\n\n"
    "rospy.init_node('n')\nrospy.Subscriber('/robot/words', String, hear)\n{}\nrospy.spin()\n"
)
SAYING = {
    "rospy.loginfo('listening on /robot/words')": True,
    "print('robot/words is there')": True,
    "warn_no_remap('/robot/words')": True,
    "x = {'robot/words': 1}": True,
    "rospy.loginfo('listening on /robot/words/more')": False,
    "rospy.loginfo('my/robot/words')": False,
    "x = 'what /robot/words are'": False,
    "# listening on /robot/words": False,
    "'''About /robot/words.'''": False,
    "rospy.Publisher('/robot/words', String)": False,
}


@pytest.mark.parametrize("change", [Remove(SUB, "/robot/words", AT),
                                    Rename(SUB, "/robot/words", "/words", AT)])  # fmt: skip
@pytest.mark.parametrize("line", SAYING)
def test_lines_that_say_the_old_name(line: str, change: Remove | Rename) -> None:
    found = edit(FILE.format(line), change).diagnostics
    told = [each.message for each in found if each.code == "still-named"]
    assert len(told) == SAYING[line]
    assert all(each.endswith("still says `/robot/words`") for each in told)
