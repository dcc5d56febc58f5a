"""A name that is gone, and that lines of code go on saying, is told."""

from __future__ import annotations

import pytest
from edits import AT, SUB, edit, interface

from plastron_tui.model.kinds import Subscription
from plastron_tui.model.source import Remove, Rename, Update

FILE = (
    "import rospy\nfrom std_msgs.msg import String\n\n\ndef hear(msg):\n    print(msg)\n\n\n"
    "rospy.init_node('n')\nrospy.Subscriber('/robot/words', String, hear)\n{}\nrospy.spin()\n"
)
# What a rename changes, and what goes where nothing has the name any more.
TOLD = {
    "rospy.loginfo('listening on /robot/words')": "rospy.loginfo('listening on /words')",
    "print('robot/words is there')": "print('words is there')",
    "raise ValueError('no /robot/words, %s' % x)": "raise ValueError('no /words, %s' % x)",
    "rospy.loginfo('%s', rospy.resolve_name('/robot/words'))": (
        "rospy.loginfo('%s', rospy.resolve_name('/words'))"
    ),
    "def tell(topic):\n    print(topic)\n\n\ntell('/robot/words')": (
        "def tell(topic):\n    print(topic)\n\n\ntell('/words')"
    ),
}
DOCUMENTED = {
    "# listening on /robot/words": "# listening on /words",
    "x = 1  # from topic robot/words": "x = 1  # from topic words",
    "'''About /robot/words.'''": "'''About /words.'''",
    "'''/robot/words'''": "'''/words'''",
    "'''\nA transform of x.\nAbout /robot/words.\n'''": (
        "'''\nA transform of x.\nAbout /words.\n'''"
    ),
}
TOLD |= DOCUMENTED
SAYING = {
    "print('transform of /robot/words')": True,
    "msg.header.frame_id = '/robot/words'": False,
    "print(hasattr(node, 'robot/words'))": False,
    "warn_no_remap('/robot/words')": True,
    "x = {'robot/words': 1}": True,
    "rospy.loginfo('listening on /robot/words/more')": False,
    "rospy.loginfo('my/robot/words')": False,
    "rospy.loginfo('/robot/words.bag')": False,
    "x = 'what /robot/words are'": False,
    "print(x + ' transform of /robot/words now')": True,
    "print('transform of /robot/words now' + x)": True,
    "print(x + '/robot/words of the transform')": False,
    "print('transform of /robot/words' + x)": False,
    "rospy.wait_for_service(x + '/robot/words')": False,
    "rospy.loginfo('/robot/words' + x)": False,
    "rospy.loginfo(f'{x}/robot/words')": False,
    "rospy.loginfo('{}/robot/words'.format(x))": False,
    "rospy.loginfo('x' '/robot/words')": False,
    "# rospy.Publisher('/robot/words', String)": False,
    "# in the transform /robot/words": False,
    "# see my/robot/words, /robot/words.bag, /robot/words/more": False,
    "def f(topic='/robot/words'):\n    pass": False,
    "rospy.Subscriber('/robot/words', Int32)": False,
    "rospy.Publisher('/robot/words', String)": False,
}


NEW = Subscription("/words", interface("std_msgs/String"), None, AT)


@pytest.mark.parametrize("change", [Remove(SUB, "/robot/words", AT),
                                    Rename(SUB, "/robot/words", "/words", AT),
                                    Update(SUB, "/robot/words", NEW, AT)])  # fmt: skip
@pytest.mark.parametrize("line", SAYING)
def test_lines_that_say_the_old_name(line: str, change: Remove | Rename | Update) -> None:
    rendered = edit(FILE.replace("{}", line), change)
    assert rendered.files is not None
    assert "String" in line or "Int32" in line or f"\n{line}\n" in rendered.files.main.decode()
    told = [each.message for each in rendered.diagnostics if each.code == "still-named"]
    assert len(told) == SAYING[line]
    assert all(each.endswith("still says `/robot/words`") for each in told)


@pytest.mark.parametrize("line", TOLD)
def test_what_tells_a_name_tells_the_new_one(line: str) -> None:
    found = edit(FILE.format(line), Rename(SUB, "/robot/words", "/words", AT))
    assert found.files is not None
    expected = FILE.format(TOLD[line]).replace("'/robot/words', String", "'/words', String")
    assert (found.files.main.decode(), found.diagnostics) == (expected, ())


@pytest.mark.parametrize("line", TOLD)
def test_what_tells_a_name_that_is_gone_is_told(line: str) -> None:
    told = edit(FILE.format(line), Remove(SUB, "/robot/words", AT)).diagnostics
    assert [str(each.code) for each in told][-1] == "still-named"


# What is said of a word that may mean something else, and whether it is told.
WORDS = {
    "# to hear words": False,
    "# to hear the topic words": True,
    "# to hear 'words' topic": True,
    "# to hear /words": True,
    "# to hear ~words": True,
    "rospy.init_node('words')": False,
}
SNAKES = {
    "# to hear all_words": True,
    "# to hear all_words, and\nall_words = 1": False,
    "# to hear all_words, and\nx.all_words = 1": False,
    "# to hear /all_words, and\nall_words = 1": True,
}


@pytest.mark.parametrize(
    ("name", "line", "is_told"),
    [("words", *each) for each in WORDS.items()]
    + [("all_words", *each) for each in SNAKES.items()],
)
def test_a_comment_says_a_name_where_it_can_be_nothing_else(name, line, is_told):
    found = edit(FILE.replace("/robot/words", name).format(line), Remove(SUB, name, AT))
    assert [str(each.code) for each in found.diagnostics] == (
        ["uncalled-function"] + ["still-named"] * is_told
    )


def test_a_comment_of_a_function_that_nothing_calls_is_not_told():
    text = FILE.replace("    print(msg)", "    # from /robot/words\n    print(msg)").format("")
    (found,) = edit(text, Remove(SUB, "/robot/words", AT)).diagnostics
    assert found.code == "uncalled-function"


def test_a_comment_that_may_speak_of_another_endpoint_is_not_told():
    text = FILE.format("# from /robot/words\nrospy.Publisher('robot/words', String)")
    (found,) = edit(text, Remove(SUB, "/robot/words", AT)).diagnostics
    assert found.code == "uncalled-function"


PLAIN = {
    "rospy.loginfo('hear words')": "rospy.loginfo('hear words')",
    "rospy.loginfo('hear topic words')": "rospy.loginfo('hear topic texts')",
    "rospy.logwarn('no \"words\" topic')": "rospy.logwarn('no \"texts\" topic')",
    "print('words')": None,
}


@pytest.mark.parametrize("line", PLAIN)
def test_a_plain_word_in_a_log_is_a_name_where_it_is_called_one(line: str) -> None:
    before = FILE.replace("/robot/words", "words")
    found = edit(before.format(line), Rename(SUB, "words", "texts", AT))
    assert found.files is not None
    expected = before.replace("'words', String", "'texts', String").format(PLAIN[line] or line)
    assert found.files.main.decode() == expected
    assert [each.message for each in found.diagnostics] == (
        [] if PLAIN[line] else ["line 11 still says `words`"]
    )


@pytest.mark.parametrize(
    ("name", "count", "message"),
    [
        ("/abc", 1, None),
        ("/abcd", 1, "line 9 still says `/abcd`"),
        ("/abcd", 9, "lines 9, 10, 11, 12, 13, 14, 15, 16, 17 still say `/abcd`"),
    ],
)
def test_how_many_lines_say_it(name: str, count: int, message: str | None) -> None:
    lines = "\n".join([f"rospy.loginfo('{name}')"] * count)
    text = FILE.replace("/robot/words", name).format(lines)
    found = edit(text, Remove(SUB, name, AT)).diagnostics
    told = [each.message for each in found if each.code == "still-named"]
    assert told == ([] if message is None else [message])
