"""Lines that are no statement."""

from __future__ import annotations

from plastron_tui.diagnostics import escapes
from plastron_tui.diagnostics.code import Code

from .programs import LISTENER

UNKNOWN_STATEMENT = Code(
    "unknown-statement",
    "A line starts with no word that starts a statement, and is no node doing something "
    "either. Often a word is misspelt; the help line then offers the nearest one.",
    bad="creat_node 'talker' as talker\n",
    good="create_node 'talker' as talker\n",
)

SYNTAX_ERROR = Code(
    "syntax-error",
    "A statement is not the sentence that its first words promise: a word is missing, "
    "misspelt, or too many. The help line has the whole sentence, or what to write.",
    bad=f"{LISTENER}unsubscribe listener form 'chatter'\n",
    good=f"{LISTENER}unsubscribe listener from 'chatter'\n",
)

UNCLOSED_QUOTE = Code(
    "unclosed-quote",
    "A name in single quotes, or a text in double quotes, is not closed on its line.",
    bad="create_node 'talker as talker\n",
    good="create_node 'talker' as talker\n",
)

UNCLOSED_COMMENT = Code(
    "unclosed-comment",
    "A comment that starts with `/*` is not closed with `*/`. The lines after it still count "
    "as statements.",
    bad="/* a node that talks\ncreate_node 'talker' as talker\n",
    good="/* a node that talks */\ncreate_node 'talker' as talker\n",
)

UNKNOWN_ESCAPE = Code(
    "unknown-escape",
    "A backslash in a text is followed by something that no escape is made of. The escapes "
    f"are {escapes.listed('`')}.",
    bad='create_message path of message_type String and input "C:\\docs"\n',
    good='create_message path of message_type String and input "C:\\\\docs"\n',
)

KEYWORD_AS_VARIABLE = Code(
    "keyword-as-variable",
    "A word of the language stands where the variable of a node or of a message belongs.",
    bad="create_node 'talker' as publish\n",
    good="create_node 'talker' as publisher\n",
)

TOO_DEEP = Code(
    "too-deep",
    "Values are in more parentheses or brackets than any message is deep.",
    bad="create_message origin of message_type Point and input " + "(" * 60 + "1" + ")" * 60 + "\n",
    good="create_message origin of message_type Point and input 1, 0, 0\n",
)
