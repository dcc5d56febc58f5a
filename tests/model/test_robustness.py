"""Whatever bytes come in: no crash, no hang, and diagnostics that can be shown."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from machine import examples
from workspaces import LIBRARIES, FakeReader, catalog

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.render import TextRenderer, as_json
from plastron_tui.language import Document, format_document, lower
from plastron_tui.language.keywords import WORDS
from plastron_tui.model.context import Setting
from plastron_tui.model.interpreter import interpret
from plastron_tui.project.program_file import check_text
from plastron_tui.ros.qos_words import WORDS as QOS_WORDS

PROGRAMS = [
    path.read_bytes()
    for folder in ("programs", "../examples")
    for path in sorted((Path(__file__).parents[1] / folder).glob("*.plastron"))
]
PROGRAMS += [
    program.encode()
    for code in codes.CODES.values()
    for program in (code.bad, code.good)
    if program
]
TOKENS = [
    *(word.encode() for word in sorted(WORDS)),
    *(word.encode() for word in sorted(QOS_WORDS)),
    b"parameter 'speed'",
    b"received.data",
    b"received.ranges[0] * 2",
    b"+ - * < >",
    *b"( ) [ ] , . = / // /* */ ' \" \\ \\u12 \\ud800 \n \r\n \t 1 -.5 1e999 0x1 $ _ a".split(b" "),
    b" ",
    b"\n",
    "é世🐢\ufeff\u202e\x1b".encode(),
    b"\x80\xff",
    b"\0",
    b"9" * 5000,
    b"(" * 200,
    b"[[" * 40 + b"]]" * 40,
    b"'/x'",
    b"'~'",
    b'"a"',
]
SETTING = Setting("rospy", LIBRARIES, catalog, FakeReader())


def swallow(text: bytes) -> tuple[Diagnostic, ...]:
    """Do all that `check` and `fmt` do with a text, and look at what comes out."""
    found = check_text(None, text).diagnostics
    if found:
        return found
    document = Document(text)
    found = interpret(lower(document), SETTING).diagnostics
    renderer = TextRenderer(lambda _: document.lines)
    for diagnostic in found:
        assert diagnostic.code in codes.CODES
        assert diagnostic.span is not None
        assert 0 <= diagnostic.span.start <= diagnostic.span.end <= len(text)
        shown = renderer.render(diagnostic).replace("\n", "")
        assert shown.isprintable()
    assert len(as_json(found, lambda _: document.lines)) == len(found)
    format_document(document)
    return found


def random_bytes(random: Random) -> bytes:
    if random.random() < 0.5:
        return random.randbytes(random.randrange(120))
    # Most random bytes are no UTF-8 and go no further: these are, and are near the language.
    alphabet = random.choice(["ab1 '\"\n", '()[],.="1 \n', "/* \n'", 'aé世\ufeff\r\n \\"u0'])
    return "".join(random.choices(alphabet, k=random.randrange(80))).encode()


def mutated(random: Random) -> bytes:
    lines = random.choice(PROGRAMS).splitlines(keepends=True)
    for _ in range(random.randrange(1, 4)):
        index = random.randrange(len(lines))
        line = lines[index]
        words = line.split(b" ")
        at = random.randrange(len(words))
        match random.randrange(8):
            case 0:
                words[at] = random.choice(TOKENS)
            case 1:
                words.insert(at, random.choice(TOKENS))
            case 2:
                del words[at]
            case 3:
                words[at] = random.choice(random.choice(lines).split(b" "))
            case 4:
                random.shuffle(words)
            case 5:
                cut = random.randrange(len(words[at]) + 1)
                words[at] = words[at][:cut] + random.choice(TOKENS) + words[at][cut:]
            case 6:
                lines.insert(index, random.choice(lines))
            case _:
                cut = random.randrange(len(words[at]) + 1)
                words[at] = words[at][:cut] + bytes([random.randrange(256)]) + words[at][cut + 1 :]
        lines[index] = b" ".join(words)
        if random.random() < 0.1:
            del lines[random.randrange(len(lines))]
            lines = lines or [b""]
    return b"".join(lines)


@pytest.mark.long
@pytest.mark.parametrize("make", [random_bytes, mutated])
@pytest.mark.parametrize("seed", range(4))
def test_ten_thousand_of_each(make: object, seed: int) -> None:
    assert callable(make)
    random = Random(seed)
    for _ in range(2_500):
        swallow(make(random))


@settings(max_examples=examples(200), deadline=None)
@given(st.binary(max_size=200) | st.text(max_size=100).map(str.encode))
def test_anything(text: bytes) -> None:
    swallow(text)


def deep(number: int) -> Iterator[tuple[str, bytes]]:
    """Return texts that have much of one thing: this number, or some times as many."""
    head = b"create_message m of message_type Twist and input "
    for name, opening, closing in (
        ("parentheses", b"(", b")"),
        ("brackets", b"[", b"]"),
        ("both", b"([", b"])"),
        ("named", b"(x=", b")"),
    ):
        yield f"{name} open", head + opening * number
        yield f"{name} closed", head + opening * number + b"1" + closing * number
        yield f"{name} too often closed", head + b"1" + closing * number
    yield "path", head + b".".join([b"x"] * (2 * number)) + b"=1"
    yield "path that exists", head + b"linear" + b".x" * (2 * number) + b"=1"
    yield "commas", head + b"," * (2 * number)
    yield "values", head + b"1," * (2 * number) + b"1"
    yield "type", b"subscribe n to 'a' of message_type " + b"a/" * (2 * number) + b"b"
    yield "quotes", b'"' * (2 * number)
    yield "single quotes", b"'" * (2 * number + 1)
    yield "comments", b"/*" * (2 * number)
    yield "closed comments", b"/**/" * (2 * number)
    yield "line comments", b"//" * (2 * number)
    yield "backslashes", head + b'"' + b"\\" * (2 * number + 1) + b'"'
    yield "escapes", head + b'"' + b"\\u0041" * number + b'"'
    yield "word", b"x" * (8 * number)
    yield "garbage", b"$" * (8 * number)
    yield "words", b"a " * (4 * number)
    yield "mixture", b"subscribe n $ '" * (number // 2)
    yield "newlines", b"\n" * (4 * number)
    yield "carriage returns", b"\r" * (4 * number)
    yield "broken lines", b"creat_node 'a' as n\n" * number
    yield "unknown nodes", b"generate_node n1\n" * (number // 5)


MUCH, VERY_MUCH = [*deep(2_500)], [*deep(25_000)]


@pytest.mark.parametrize(("name", "text"), MUCH, ids=[name for name, _ in MUCH])
def test_much_of_one_thing(name: str, text: bytes) -> None:
    swallow(text)


@pytest.mark.long
@pytest.mark.parametrize(("name", "text"), VERY_MUCH, ids=[name for name, _ in VERY_MUCH])
def test_very_much_of_one_thing(name: str, text: bytes) -> None:
    swallow(text)
