from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from plastron_programs import read, shape, statements

from plastron_tui.language import Document, format_document
from plastron_tui.language.tokens import leaves

TABLE = {
    "": "",
    "\n\n": "",
    "create_node   'a'\tas n": "create_node 'a' as n\n",
    "create_message m of message_type B and input received . a [ 1 ]*5 ,x=received.b+ -1/2":
        "create_message m of message_type B and input received.a[1] * 5, x=received.b + -1 / 2\n",
    "create_message m of message_type B and input x=parameter   'p'-1, received . a = [ [1] ]":
        "create_message m of message_type B and input x=parameter 'p' - 1, received.a=[[1]]\n",
    "n provides_service 's' of service_type T answering received . b+received.c [1]/parameter 'p'":
        "n provides_service 's' of service_type T"
        " answering received.b + received.c[1] / parameter 'p'\n",
    "n publish m to 'a' of message_type T for_each 'b' when received.x[0]=5 with qos depth  5 ,a":
        "n publish m to 'a' of message_type T for_each 'b' when received.x[0] = 5"
        " with qos depth 5, a\n",
    "n publish m to 'a' of message_type T for_each 'b' when  any received.x<-.5":
        "n publish m to 'a' of message_type T for_each 'b' when any received.x < -.5\n",
    "n has_parameter 'a' of parameter_type int_list with default [ 1,2 ]  described_as  \"x\"":
        "n has_parameter 'a' of parameter_type int_list with default [1, 2] described_as \"x\"\n",
    "n repeats  f at  parameter 'a'  hz": "n repeats f at parameter 'a' hz\n",
    "  create_node 'a' as n  ": "create_node 'a' as n\n",
    "create_message m of message_type a/msg/B and input 1 ,2,  -3":
        "create_message m of message_type a/msg/B and input 1, 2, -3\n",
    "create_message m of message_type B and input x . y = ( 1 , [ 2 ] ) ,z=( )":
        "create_message m of message_type B and input x.y=(1, [2]), z=()\n",
    "create_message m of message_type B and input x=received . y [ 1 ] *2,z=[1]":
        "create_message m of message_type B and input x=received.y[1] * 2, z=[1]\n",
    "n publish m to 't' of message_type B for_each 'i' when received.x=1":
        "n publish m to 't' of message_type B for_each 'i' when received.x = 1\n",
    'create_message m of message_type B and input "a  b" , "//c"':
        'create_message m of message_type B and input "a  b", "//c"\n',
    "create_node 'a' as n// c  ": "create_node 'a' as n // c\n",
    "create_node/*c*/'a' as n": "create_node /*c*/ 'a' as n\n",
    "// c \n\n\n\n//d": "// c\n\n//d\n",
    "\n\ngenerate_node n\n\n\n\ngenerate_node m\n\n": "generate_node n\n\ngenerate_node m\n",
    "/* two\n   lines */ generate_node  n": "/* two\n   lines */ generate_node n\n",
    "generate_node  n /* two\n   lines */ // c": "generate_node n /* two\n   lines */ // c\n",
    "generate_node  n /* two\n\n\n lines */\ngenerate_node  m":
        "generate_node n /* two\n\n\n lines */\ngenerate_node m\n",
    "create_node  'a'\r\n  generate_node  n\r\n": "create_node  'a'\r\n  generate_node n\r\n"
        .replace("  generate_node", "generate_node"),
    "generate_node  n\r\ngenerate_node  m\n": "generate_node n\r\ngenerate_node m\r\n",
    "\ufeffgenerate_node  n": "\ufeffgenerate_node n\n",
    "  creat_node   'a'  as n  \ngenerate_node  n": "  creat_node   'a'  as n  \ngenerate_node n\n",
    "subscribe  n \n\n\n$$  $\n": "subscribe  n \n\n$$  $\n",
    "/* never  closed\ngenerate_node  n": "/* never  closed\ngenerate_node n\n",
}  # fmt: skip


def formatted(text: str | bytes) -> str:
    document = Document(text.encode() if isinstance(text, str) else text)
    return format_document(document).decode("utf-8")


@pytest.mark.parametrize(("text", "expected"), TABLE.items(), ids=range(len(TABLE)))
def test_layout(text: str, expected: str) -> None:
    assert formatted(text) == expected
    assert formatted(expected) == expected


def words(text: str) -> list[str]:
    """Return the words and comments of a text: what a format must not change."""
    root = Document(text.encode()).tree.root_node
    texts = [leaf.node.text for leaf in leaves(root)]
    found = [text.decode().rstrip() for text in texts if text is not None]
    return [word for word in found if word]


spaces = st.sampled_from([" ", "  ", "\t", " /* c */ ", " /* two\n lines */ "])
ends = st.sampled_from(["\n", "\n\n\n", "  \n", " // c\n", "\n// c\n\n", " /* d */\n"])


@st.composite
def messy_programs(draw: st.DrawFn) -> str:
    text = draw(st.sampled_from(["", "\ufeff", "\n\n", "// head\n"]))
    for line in draw(st.lists(statements(), max_size=5)):
        # Space within quotes is text, so only what is before the first of them is spread.
        head, quote, tail = line.partition('"')
        text += draw(spaces).join(head.split(" ")) + quote + tail + draw(ends)
    return text


@settings(max_examples=examples(150), deadline=None)
@given(messy_programs())
def test_a_format_keeps_words_comments_and_meaning(text: str) -> None:
    laid_out = formatted(text)
    assert words(laid_out) == words(text)
    assert shape(read(laid_out)) == shape(read(text))
    assert read(laid_out).diagnostics == ()
    assert formatted(laid_out) == laid_out


@settings(max_examples=examples(75), deadline=None)
@given(messy_programs())
def test_a_format_keeps_the_line_ending(text: str) -> None:
    windows = text.replace("\n", "\r\n")
    assert formatted(windows) == formatted(text).replace("\n", "\r\n")


broken_lines = st.sampled_from(
    [
        "creat_node  'a'   as n",
        "   subscribe  n   to",
        "n  publish   m to 'a",
        "create_message m of message_type B and input (1,   2",
        "$$   %",
        'create_message m of message_type B and input "a\\q"   ',
        "generate_node n   generate_node m",
    ]
)


@settings(max_examples=examples(150), deadline=None)
@given(st.lists(st.tuples(broken_lines | statements(), st.booleans()), max_size=6))
def test_a_format_keeps_broken_lines_byte_for_byte(found: list[tuple[str, bool]]) -> None:
    text = "".join(line + ("\n\n\n" if far else "\n") for line, far in found)
    laid_out = formatted(text)
    kept = [line for line in laid_out.split("\n") if line]
    expected = [line if read(line).diagnostics else formatted(line)[:-1] for line, _ in found]
    assert kept == expected
    assert formatted(laid_out) == laid_out


@settings(max_examples=examples(200), deadline=None)
@given(st.text(st.sampled_from("ab'\"/*\n\r \t(,.=)$é\\1\ufeff"), max_size=40))
def test_a_format_of_anything_is_stable_and_loses_nothing(text: str) -> None:
    laid_out = formatted(text)
    assert formatted(laid_out) == laid_out
    assert "".join(laid_out.replace("\ufeff", "").split()) == "".join(
        text.replace("\ufeff", "").split()
    )
