"""What a docstring lists of an endpoint goes with it."""

from __future__ import annotations

import pytest
from edits import AT, PUB, SUB, edit, edited

from plastron_tui.model.source import Remove

MODULE = '"""A node.\n\n{}\n"""\n'
FILE = """\
import rospy
from std_msgs.msg import String

rospy.init_node('n')
rospy.Publisher('/map', String)
rospy.Publisher('/tick', String){}
"""
GONE = "\nrospy.Publisher('/scan', String)"
# What a docstring says, and what is left of that when `/scan` is published no more.
LISTS = {
    "with bullets": (
        "Publishers:\n - /scan (String): what\n - /map: it",
        "Publishers:\n - /map: it",
    ),
    "with types": (
        "Publishers:\n    ~scan (:obj:`String`): what\n    ~map (:obj:`String`): it",
        "Publishers:\n    ~map (:obj:`String`): it",
    ),
    "over several lines": (
        "Publishers:\n    scan: what\n      is there\n    map: it\n      is\nIt is a node.",
        "Publishers:\n    map: it\n      is\nIt is a node.",
    ),
    "over several lines with no indent": (
        "Publishers:\n    map: it\n    /scan (String): what\n    is there\n    /tick: x",
        "Publishers:\n    map: it\n    /tick: x",
    ),
    "over several paragraphs": (
        "Publishers:\n    * **/scan** (String)\n\n      * what\n\n    * **/map** (String)",
        "Publishers:\n    * **/map** (String)",
    ),
    "beside its heading": ("> *Publishers*\n* `scan`\n* `map`: it", "> *Publishers*\n* `map`: it"),
    "with bullets over several lines with no indent": (
        "> *Publishers*\n\n* `map`: it\nis\n* `scan`: what\nis\nthere\n* `tick`: x",
        "> *Publishers*\n\n* `map`: it\nis\n* `tick`: x",
    ),
    "a name alone": ("Topics:\n  - 'scan'\n  - map", "Topics:\n  - map"),
    "alone": (
        "Publishers:\n - /scan: what\n\nSubscribers:\n - /map: it",
        "Subscribers:\n - /map: it",
    ),
    "alone at the end": (
        "Subscribers:\n - /map: it\n\nPublishers:\n\n    /scan: what",
        "Subscribers:\n - /map: it",
    ),
    "of other things": ("Parameters:\n - /scan (String): what", None),
    "of the other side": ("Subscribers:\n - /scan (String): what", None),
    "of no endpoints": ("Words:\n - scan: what", None),
    "of more than the name": ("Publishers:\n - /scan and /map: them", None),
    "of what is in it": ("Publishers:\n - /scan/front: it", None),
    "of a text in the line": ("Publishers:\n  /scan is there\n  too: it", None),
    "that may go on": ("Publishers:\n- /scan: what\nis there", None),
}


@pytest.mark.parametrize("case", LISTS)
def test_an_entry_of_a_docstring_goes_with_its_endpoint(case):
    before, after = LISTS[case]
    text = edited(MODULE.format(before) + FILE.format(GONE), Remove(PUB, "/scan", AT))
    assert text == MODULE.format(before if after is None else after) + FILE.format("")


def test_an_entry_of_a_class_goes_and_that_of_a_function_stays():
    listed = '    """A.\n\n    Publishers:\n        /scan: {}\n        /map: it\n    """\n'
    classes = f"\n\nclass A:\n{listed}\n\ndef f():\n{listed}"
    after = edited(FILE.format(GONE) + classes.format(1, 2), Remove(PUB, "/scan", AT))
    assert "/scan: 1" not in after
    assert "/scan: 2" in after
    assert after.count("/map: it") == 2


def test_an_entry_stays_where_another_endpoint_has_the_name():
    text = MODULE.format(LISTS["with bullets"][0])
    text += FILE.format(GONE + "\nrospy.Subscriber('scan', String)")
    assert "- /scan" in edited(text, Remove(PUB, "/scan", AT))
    assert "- /scan" in edited(text, Remove(SUB, "scan", AT))


def test_what_else_a_docstring_says_of_the_name_is_told():
    text = MODULE.format("Publishers:\n - /scan: what\n - /map: it, as /scan is")
    (found,) = edit(text + FILE.format(GONE), Remove(PUB, "/scan", AT)).diagnostics
    assert found.message == "line 4 still says `/scan`"
