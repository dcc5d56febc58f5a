"""When what runs is older than the text, and when only a comment was changed."""

from __future__ import annotations

import pytest

from plastron_tui.studio.same_meaning import says_the_same

TEXT = """\
// what it does
create_node 'talker' as talker

create_message m of message_type String and input "hello  // you"
talker publish m to 'chatter' of message_type String at 5 hz /* often
enough */
generate_node talker
"""

CHANGES = {
    "a comment": (("what it does", "what it says, and why"), True),
    "an empty line": (("as talker\n\n", "as talker\n"), True),
    "blanks": (("publish m to", "publish  m\tto"), True),
    "a comment behind a statement": (("as talker\n", "as talker // it\n"), True),
    "a comment in a statement": (("publish m", "publish /* a message */ m"), True),
    "the second line of a comment": (("enough */", "or so */"), True),
    "line ends": (("\n", "\r\n"), True),
    "a rate": (("5 hz", "20 hz"), False),
    "a word that looks like a comment": (("// you", "// me"), False),
    "blanks in a text": (('"hello  ', '"hello '), False),
    "a statement that became a comment": (("generate_node", "// generate_node"), False),
    "a statement less": (("generate_node talker\n", ""), False),
    "a statement twice": (("generate_node talker\n", "generate_node talker\n" * 2), False),
    "two words that became one": (("of message_type String at", "of message_typeString at"), False),
}


@pytest.mark.parametrize("what", CHANGES)
def test_only_comments_and_blanks_say_nothing(what: str) -> None:
    (old, new), expected = CHANGES[what]
    assert old in TEXT
    changed = TEXT.replace(old, new).encode()
    assert says_the_same(TEXT.encode(), changed) is expected
    assert says_the_same(changed, TEXT.encode()) is expected
    assert says_the_same(changed, changed)
