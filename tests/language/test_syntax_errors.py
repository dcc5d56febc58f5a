from __future__ import annotations

from functools import cache

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from machine import examples, mostly_long
from plastron_programs import EXAMPLES, broken_lines, read
from wrong_clauses import CLAUSES, SENTENCE
from wrong_fields import FIELDS, MENDED
from wrong_robots import ROBOTS

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.language import DECLARATIONS, Document, lower
from plastron_tui.language.inputs import DEEPEST_NESTING
from plastron_tui.language.keywords import KEYWORDS
from plastron_tui.language.syntax_errors import MOST_BROKEN_LINES

M = "create_message m of message_type T and input"

# A line, the code, the text of the span, what the message says, what the help says.
TABLE: list[tuple[str, str, str, str, str | None]] = [
    ("lod x as y", "unknown-statement", "lod", "starts no statement", "did you mean `load`?"),
    ("n publsh m to 'a'", "unknown-statement", "publsh", "no statement", "did you mean `publish`?"),
    ("foo bar baz", "unknown-statement", "foo", "starts no statement", "a statement starts with"),
    ("node1", "unknown-statement", "node1", "alone is no statement", "comes publish"),
    ("none as x", "unknown-statement", "none", "starts no statement", "a statement starts with"),
    ("(((", "syntax-error", "(", "unexpected `(`", None),
    ("$ create_node 'a' as n", "syntax-error", "$", "unexpected `$`", None),
    ("1 2 3", "syntax-error", "1", "unexpected `1`", None),
    ('"abc', "unclosed-quote", '"', "not closed", "close it with"),
    ('"abc\\', "unclosed-quote", '"', "not closed", "close it with"),
    ("'abc", "unclosed-quote", "'", "not closed", "close it with '"),
    ("create_node", "syntax-error", "", "expected a node name", SENTENCE),
    ("create_node 'a'", "syntax-error", "", "expected `as` here", "write `as a`"),
    ("create_node 'a' as", "syntax-error", "", "a variable for the node here", SENTENCE),
    ("create_node talker as n", "syntax-error", "talker", "in single quotes", "write 'talker'"),
    ('create_node "a" as n', "syntax-error", '"a"', "in single quotes", "write 'a'"),
    ("create_node 'a as n", "unclosed-quote", "'", "not closed", "close it with '"),
    ("create_node 'a' is n", "syntax-error", "is", "expected `as`, not `is`", None),
    ("create_node 'a' ass n", "syntax-error", "ass", "expected `as`", "did you mean `as`?"),
    ("create_node 'a' as 5", "syntax-error", "5", "starts with a letter", "write `node_5`"),
    ("create_node 'a' as é", "syntax-error", "é", "expected a variable", SENTENCE),
    ("create_node 'a' as n using", "syntax-error", "", "expected a client library", SENTENCE),
    ("create_node 'a' as n with", "syntax-error", "with", "unexpected `with`", SENTENCE),
    ("create_node 'a' as n extra", "syntax-error", "extra", "unexpected `extra`", SENTENCE),
    ("create_node 'a' as load", "keyword-as-variable", "load", "is a keyword", "another name"),
    ("subscribe at to 'a'", "keyword-as-variable", "at", "is a keyword", "another name"),
    ("generate_node True", "keyword-as-variable", "True", "is a keyword", "another name"),
    ("create_message of of message_type T", "keyword-as-variable", "of", "keyword", None),
    ("generate_node generate_node", "keyword-as-variable", "generate_node", "is a keyword", None),
    ("n publish publish m", "keyword-as-variable", "publish", "is a keyword", "another name"),
    ("load x.py as n", "syntax-error", "x.py", "is quoted", "write 'x.py'"),
    ("load a/b as n", "syntax-error", "a/b", "is quoted", "write 'a/b'"),
    ("subscribe n too 'a'", "syntax-error", "too", "expected `to`", "did you mean `to`?"),
    ("subscribe n to 'a' of T", "syntax-error", "T", "expected `message_type`", SENTENCE),
    ("subscribe n to 'a' of message_type", "syntax-error", "", "a message type here", SENTENCE),
    ("subscribe n to 'a' of message_type \"T\"", "syntax-error", '"T"', "no quotes", "`T`"),
    ("subscribe n to 'a' of message_type a /T", "syntax-error", "/", "no space", SENTENCE),
    ("subscribe n to 'a' of message_type a/", "syntax-error", "/", "after the `/`", SENTENCE),
    ("subscribe n to 'a' of message_type a/b/c/d", "syntax-error", "d", "three parts", SENTENCE),
    ("subscribe n to 'a' of message_type T calling", "syntax-error", "", "function", SENTENCE),
    ("unsubscribe n", "syntax-error", "", "expected `from`", SENTENCE),
    ("unsubscribe n form 'a'", "syntax-error", "form", "`from`", "did you mean `from`?"),
    ("publish n m to 'a'", "syntax-error", "publish n", "comes second", "write `n publish`"),
    ("n publish", "syntax-error", "", "the variable of a message here", SENTENCE),
    ("n publish m to a of message_type T", "syntax-error", "a", "in single quotes", "write 'a'"),
    ("n publish m to 'a' of message_type T at fast hz", "syntax-error", "fast", "number", None),
    ("n publish m to 'a' of message_type T at 5", "syntax-error", "", "expected `hz`", SENTENCE),
    ("n publish m to 'a' of message_type T at 5 Hz", "syntax-error", "Hz", "`hz`", "`hz`?"),
    ("n stop_publishing 'a'", "syntax-error", "'a'", "expected `to`", SENTENCE),
    ("n stop_service", "syntax-error", "", "a service name", SENTENCE),
    (M, "syntax-error", "", "expected values, or `none`", SENTENCE),
    (
        f"{M} abc",
        "syntax-error",
        "abc",
        "is no value",
        'a number is written in digits, text in double quotes: "abc"',
    ),
    (f"{M} 'abc'", "syntax-error", "'abc'", "is no value", '"abc"'),
    (f"{M} true", "syntax-error", "true", "is no value", "did you mean `True`?"),
    (f"{M} x=y", "syntax-error", "y", "is no value", '"y"'),
    (f"{M} x=", "syntax-error", "=", "expected a value after this", SENTENCE),
    (f"{M} x=y=1", "syntax-error", "y", "expected a value", SENTENCE),
    (f"{M} x=y.z=1", "syntax-error", "y", "expected a value", SENTENCE),
    (f"{M} x.=1", "syntax-error", ".", "expected a field", SENTENCE),
    (f"{M} x.y", "syntax-error", "y", "expected `=`", SENTENCE),
    (f"{M} 1,", "syntax-error", ",", "expected a value after this", SENTENCE),
    (f"{M} 1,,2", "syntax-error", ",", "expected a value", SENTENCE),
    (f"{M} 1 2", "syntax-error", "2", "unexpected `2`", SENTENCE),
    (f"{M} (1, 2", "syntax-error", "(", "is not closed", SENTENCE),
    (f"{M} x=(1, 2", "syntax-error", "(", "is not closed", SENTENCE),
    (f"{M} x=(1, y)", "syntax-error", "y", "is no value", '"y"'),
    (f"{M} x=[y=1]", "syntax-error", "y", "have no names", SENTENCE),
    (f"{M} [(1, 2]", "syntax-error", "(", "is not closed", SENTENCE),
    (f"{M} 1, 2)", "syntax-error", ")", "closes nothing", SENTENCE),
    (f"{M} [x=1]", "syntax-error", "x", "have no names", SENTENCE),
    (f"{M} 1, none", "syntax-error", "none", "stands alone", SENTENCE),
    (f"{M} none, 1", "syntax-error", ",", "unexpected", SENTENCE),
    (f"{M} 0x10", "syntax-error", "x10", "unexpected `x10`", SENTENCE),
    (f'{M} "abc', "unclosed-quote", '"', "not closed", 'close it with "'),
    (f'{M} "abc\\"', "unclosed-quote", '"', "not closed", 'close it with "'),
    (f'{M} "a\\qb"', "unknown-escape", "\\q", "is no escape", "a backslash is written"),
    (f'{M} "a\\u12"', "unknown-escape", "\\u", "is no escape", "a backslash is written"),
    (f'{M} x=("a\\é")', "unknown-escape", "\\é", "is no escape", "a backslash is written"),
    (f"{M.replace('input', 'inputs')} 1", "syntax-error", "inputs", "`input`", "`input`?"),
    (f"{M.replace('and ', '')} 1", "syntax-error", "input", "expected `and`", SENTENCE),
    ("n subscribe to 'a'", "syntax-error", "n subscribe", "comes first", "`subscribe n`"),
    ("n generate_node", "syntax-error", "n generate_node", "comes first", "`generate_node n`"),
    ("n load x as y", "unknown-statement", "n", "starts no statement", "a statement starts with"),
    ("stop_service n 'a'", "syntax-error", "stop_service n", "second", "`n stop_service`"),
    ("publish m to 'a'", "syntax-error", "publish", "of a node before `publish`", SENTENCE),
    ("subscribe to 'a'", "syntax-error", "to", "the variable of a node before `to`", SENTENCE),
    ("n publish to 'a'", "syntax-error", "to", "of a message before `to`", SENTENCE),
    ("create_message of message_type T", "syntax-error", "of", "before `of`", SENTENCE),
    ("# so", "syntax-error", "#", "a comment starts with `//`", "write `//`"),
    ("-- so", "syntax-error", "--", "a comment starts with `//`", "write `//`"),
    ("generate_node n # so", "syntax-error", "#", "a comment starts with `//`", "write `//`"),
    ("generate_node n;", "syntax-error", ";", "without a `;`", "take it away"),
    ("load x as n; load y as m", "syntax-error", ";", "with its line", "on a line of its own"),
    ("create_node ‘a b’ as n", "syntax-error", "‘a b’", "quotes are straight", "write 'a b'"),
    ("create_node “a” as n", "syntax-error", "“a”", "quotes are straight", "write 'a'"),
    (f"{M} “a b”", "syntax-error", "“a b”", "quotes are straight", 'write "a b"'),
    (f'{M} 1, x=“a"', "syntax-error", '“a"', "quotes are straight", 'write "a"'),
    (f"{M} “a", "syntax-error", "“", "quotes are straight", 'write "'),
    ("create_node 'a' as my-node", "syntax-error", "my-node", "no `-`", "write `my_node`"),
    ("my-node publish m", "syntax-error", "my-node", "no `-`", "write `my_node`"),
    ("create_node 'a' as my-", "syntax-error", "-", "unexpected `-`", None),
    ("create-node 'a' as n", "syntax-error", "create-node", "no `-`", "write `create_node`"),
    ("subscribe joint-1 to 'a'", "syntax-error", "joint-1", "no `-`", "write `joint_1`"),
    ("create_node 'a' as 1a", "syntax-error", "1a", "with a letter", "write `node_1a`"),
    ("create_message 2m of", "syntax-error", "2m", "with a letter", "write `message_2m`"),
    ("generate_node 'n'", "syntax-error", "'n'", "of a node has no quotes", "write `n`"),
    ("create_node 'a' as n using \"rospy\"", "syntax-error", '"rospy"', "quotes", "write `rospy`"),
    ("subscribe n to 'a' of message_type 'a/T'", "syntax-error", "'a/T'", "no quotes", "`a/T`"),
    ("subscribe n to 'a' of message_type T calling 'f'", "syntax-error", "'f'", "quotes", "`f`"),
    ("subscribe n to 'a' of message_type T calling f()", "syntax-error", "()", "alone", "away"),
    ("subscribe n to 'a' of message_type a.msg.T", "syntax-error", "a.msg.T", "`/`", "`a/T`"),
    ("create_message m of message_type a.T and", "syntax-error", "a.T", "`/`", "write `a/T`"),
    ("subscribe n to 'a' of message_type a::msg::T", "syntax-error", "a::msg::T", "/", "`a/T`"),
    ("n publish \"hi you\" to 'a'", "syntax-error", '"hi you"', "expected", "`create_message`"),
    ('load "a.py" as n', "syntax-error", '"a.py"', "in single quotes", "write 'a.py'"),
    (
        "n publish m to 'a' of message_type T every 5 s",
        "syntax-error",
        "every 5 s",
        "hertz",
        "0.2 hz",
    ),
    (
        "n publish m to 'a' of message_type T every second",
        "syntax-error",
        "every second",
        "",
        "1 hz",
    ),
    ("n publish m to 'a' of message_type T every day", "syntax-error", "every", "unexp", SENTENCE),
    ("generate_node\u00a0n", "syntax-error", "\u00a0", "no-break space", "a plain space"),
    (f"{M} 80%", "syntax-error", "80%", "a number has no unit", "write `80`"),
    (f"{M} on", "syntax-error", "on", "is no value", 'write `True`; or, for a text, "on"'),
    (f"{M} x=Off", "syntax-error", "Off", "is no value", "write `False`"),
    (f"{M} --5", "syntax-error", "-", "unexpected `-`", None),
    ("/* open", "unclosed-comment", "/*", "not closed", "close it with `*/`"),
    ("create_node 'a' as n /* open", "unclosed-comment", "/*", "not closed", "`*/`"),
    ("create_node 'a' as n create_node 'b' as m", "syntax-error", "create_node", "unexp", SENTENCE),
]

LINES = [*TABLE, *CLAUSES, *FIELDS, *ROBOTS]


def spanned(text: str, found: Diagnostic) -> str:
    assert found.span is not None
    return text.encode()[found.span.start : found.span.end].decode()


@pytest.mark.parametrize("case", LINES, ids=[case[0] for case in LINES])
def test_a_wrong_line_is_explained(case: tuple[str, str, str, str, str | None]) -> None:
    """Alone, however it ends, and between two statements, which stay what they are."""
    line, code, where, message, remedy = case
    for ending in ("", "\n", "\r\n"):
        (found,) = read(line + ending).diagnostics
        assert (found.code, spanned(line, found)) == (code, where)
        assert message in found.message
        assert remedy is None or remedy in (found.help or "")
    text = f"// é\ngenerate_node a\n{line}\ngenerate_node b\n"
    program = read(text)
    (found,) = program.diagnostics
    assert (found.code, spanned(text, found)) == (code, where)
    assert [statement.span_of("node") for statement in program.statements] == [
        (
            text.encode().index(b"generate_node a") + 14,
            text.encode().index(b"generate_node a") + 15,
        ),
        (len(text.encode()) - 2, len(text.encode()) - 1),
    ]


# Two statements on a line are a mistake that nothing in the tree but their places tells of.
NEIGHBOURS = [
    *(case[0] for case in TABLE if "/*" not in case[0]),
    "'chatter'create_node 'talker' as talker",
    "unsubscribe talker from 'chatter'create_node 'talker' as talker",
    "generate_node a generate_node b",
    "n stop_publishing to 'a'load x as y",
]


@cache
def alone(line: str) -> tuple[Diagnostic, ...]:
    return read(line).diagnostics


@pytest.mark.parametrize("line", mostly_long(NEIGHBOURS, NEIGHBOURS[::4]))
def test_each_of_two_broken_lines_has_a_mistake_of_its_own(line: str) -> None:
    for other in NEIGHBOURS:
        first, second = read(f"{line}\n{other}\n").diagnostics
        assert (first,) == alone(line)
        assert (second.moved(-len(line.encode()) - 1),) == alone(other)


@settings(max_examples=examples(1000), deadline=None)
@given(st.lists(broken_lines | st.sampled_from(EXAMPLES), min_size=2, max_size=5))
@example(["'a'load x as n", "n stop_publishing to 'a' unsubscribe n from 'b'", "'a'load x as n"])
def test_a_line_says_what_it_says_alone(lines: list[str]) -> None:
    expected = []
    at = 0
    for line in lines:
        expected += [found.moved(at) for found in read(line).diagnostics]
        at += len(line.encode()) + 1
    assert list(read("\n".join(lines)).diagnostics) == expected


def test_a_comment_that_joins_lines_hides_no_second_statement() -> None:
    text = "'a'load x as n\nn stop_publishing to 'b' /* a\nb */ generate_node m\n"
    assert [(found.code, spanned(text, found)) for found in read(text).diagnostics] == [
        ("syntax-error", "'a'"),
        ("syntax-error", "generate_node m"),
    ]


def test_a_fix_brings_the_line_further() -> None:
    for text, *_ in LINES:
        line = text.encode()
        (found,) = lower(Document(line)).diagnostics
        if found.fix is None:
            continue
        (edit,) = found.fix.edits
        mended = line[: edit.span.start] + edit.text.encode() + line[edit.span.end :]
        left = lower(Document(mended)).diagnostics
        further = [again.span > found.span for again in left if again.span and found.span]
        assert all(further), text


@pytest.mark.parametrize(("line", "right"), MENDED.items(), ids=list(MENDED))
def test_a_type_is_mended(line: str, right: str | None) -> None:
    (found,) = read(line).diagnostics
    edits = () if found.fix is None else found.fix.edits
    mended = line
    for edit in edits:
        mended = f"{mended[: edit.span.start]}{edit.text}{mended[edit.span.end :]}"
    assert (mended if edits else None) == right
    assert right is None or not read(right).diagnostics


@pytest.mark.parametrize("word", sorted(KEYWORDS))
def test_a_keyword_is_no_variable(word: str) -> None:
    for text in (
        f"create_node 'a' as {word}",
        f"load x as {word}",
        f"create_message {word} of message_type T and input none",
        f"generate_node {word}",
    ):
        (found,) = read(text).diagnostics
        if word == text.split()[0]:
            assert found.code in ("keyword-as-variable", "syntax-error")
        else:
            assert (found.code, spanned(text, found)) == ("keyword-as-variable", word)


def test_every_cut_of_a_statement_is_one_mistake_at_its_end() -> None:
    for declaration in DECLARATIONS.values():
        words = declaration.example.split(" ")
        for count in range(1, len(words)):
            text = " ".join(words[:count])
            program = read(f"generate_node a\n{text}\ngenerate_node b\n")
            whole = [statement for statement in program.statements if statement.span.start in (0,)]
            assert len(whole) == 1
            assert len(program.diagnostics) <= 1
            assert len(program.statements) + len(program.diagnostics) == 3


def test_a_comment_of_two_lines_keeps_a_mistake_one() -> None:
    assert len(read("create_node /* a\nb */ 'x' is n\n").diagnostics) == 1
    assert len(read("create_node /* a\nb */ 'x' /* c\nd */ is n\n").diagnostics) == 1
    found = read("generate_node a /* two\nlines */ generate_node b\n").diagnostics
    assert [each.code for each in found] == ["syntax-error"]


def test_only_so_many_lines_are_explained() -> None:
    program = read("creat_node 'a' as n\n" * (MOST_BROKEN_LINES + 500))
    assert len(program.diagnostics) == MOST_BROKEN_LINES


def test_the_words_of_broken_lines_are_known() -> None:
    program = read("creat_node 'talker' as a\nsubscribe b too 'x'\ncreate_message c of T\n")
    assert {"talker", "a", "b", "x", "c"} <= program.broken.words
    assert {"a", "c"} <= program.broken.declared
    assert "b" not in program.broken.declared


def test_what_is_too_deep_was_to_declare_its_variable_also_beside_a_broken_line() -> None:
    deep = "(" * (DEEPEST_NESTING + 1) + "1" + ")" * (DEEPEST_NESTING + 1)
    program = read(f"create_message deep of message_type T and input {deep}\nsubscribe b too 'x'\n")
    assert [found.code for found in program.diagnostics] == ["syntax-error", "too-deep"]
    assert "deep" in program.broken.declared
