"""Where a text has comments: nothing else says that something is meant, or is taken away."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml
from linted import run_over, told, write_tree

from plastron_tui.lint.comment_syntax import comment_spans, style_of
from plastron_tui.lint.yaml_comments import yaml_comments
from plastron_tui.project.linting.rewriting import mend

MARK = "\ufeff"


def _comments(name: str, text: str) -> list[str]:
    raw, style = text.encode(), style_of(Path(name))
    assert style is not None
    return [raw[span.start : span.end].decode() for span in comment_spans(style, raw)]


YAML = [
    ("a: b  # c\n", ["# c"]),
    ("# c\na: b\n# d", ["# c", "# d"]),
    ("a: b#c\n", []),
    ("a: don't  # c\n", ["# c"]),
    ("a: |\n  b  # c\n  # d\n# e\n", ["# e"]),
    ("a: >-  # c\n  b  # d\n\n # e\nf: g  # h\n", ["# c", "# e", "# h"]),
    ("a: |2\n    b\n   # c\n # d\n", ["# d"]),
    ("a:\n- |\n b # c\n- d # e\n", ["# e"]),
    ("a: |\n  b # c", []),
    ("a: 'b\n  # c\n  d'  # e\n", ["# e"]),
    ('a: "b # c\n\n  # d"  # e\n', ["# e"]),
    ("a: b\n  c#d\n  e  # f\n", ["# f"]),
    ("a: [b,  # c\n  'd # e',  # f\n]\n", ["# c", "# f"]),
    ("---\na: b  # c\n---\n# d\na: |\n # e\n...\n# f\n", ["# c", "# d", "# f"]),
    ("é: ü  # ö\nß: |\n  # ä\n", ["# ö"]),
    (f"{MARK}# c\na: b  # d\n", ["# c", "# d"]),
    ("a: b\r\nc: |\r\n  # d\r\ne: f  # g\r\n", ["# g"]),
    ("a: b\u2028# c\u2028d: e\n", ["# c"]),
    # What follows a mistake nobody can tell.
    ("a: b  # c\nd: 'e  # f\n", ["# c"]),
    ("a: @b  # c\n", []),
    ("", []),
]


@pytest.mark.parametrize("is_fast", [True, False])
@pytest.mark.parametrize(("text", "comments"), YAML)
def test_comments_of_yaml(
    text: str, comments: list[str], is_fast: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(yaml, "__with_libyaml__", yaml.__with_libyaml__ and is_fast)
    raw = text.encode()
    assert [raw[start:end].decode() for start, end in yaml_comments(raw)] == comments


@pytest.mark.parametrize(
    ("text", "comments"),
    [
        ("int32 a  # c\n", ["# c"]),
        ("string a 'b # c'  # d\n", ["# d"]),
        ("string a 'b\\\n# c\n", ["# c"]),
        ("string A=b # c\n# d\n", ["# d"]),
        ("string<=5 A=# c\n# d\n", ["# d"]),
        ("wstring<=5 A=# c\n", []),
        ("  string <= 5 A = # c\n", []),
        (f"{MARK}string A=# c\n", []),
        ("string<=5 a  # c\n", ["# c"]),
        ("string<=5[<=3] a ['# c']  # d\n", ["# d"]),
    ],
)
def test_comments_of_definitions(text: str, comments: list[str]) -> None:
    assert _comments("a.msg", text) == comments


@pytest.mark.parametrize(
    ("text", "comments"),
    [
        ("int x = 1'000;  // c\n", ["// c"]),
        ("int x = 1'000'000;  // c\n", ["// c"]),
        ("int x = 0x1'Fp+1'0 + 'a';  // c\n", ["// c"]),
        ("auto x = .5'0e-1'0f;  // c 'd'\n", ["// c 'd'"]),
        ('f(1\'0, "// b");  // c\n', ["// c"]),
        ("int x = 0xF'F; char y = '\"';  // c\n", ["// c"]),
        ("char x = u8'/', y = u'\\'', z = L'\"';  // c\n", ["// c"]),
        ("case 1:x = '//' + a1'//';  // c\n", ["// c"]),
        ('f("\\"// b", \'"\');  // c\n', ["// c"]),
        ('f("a\\\n// b");  // c\n', ["// c"]),
        ('f("a\\\r\n// b");  // c\r\n', ["// c"]),
        ('f(R"(")" // b)");  // c\n', ['// b)");  // c']),
        ('f(R"x(" )" // b\n)x");  // c\n', ["// c"]),
        ('f(u8R"(\n// b)", LR"(//)", UR"(//)");  // c\n', ["// c"]),
        # The end of a name makes no raw string.
        ('f(FOOR"(a");  // c\n', ["// c"]),
        ("x;  // c \\\nd\ny;\n", ["// c \\\nd"]),
        ("x;  // c \\ \t\nd\ny;\n", ["// c \\ \t\nd"]),
        ("x;  // c \\\r\nd\r\ny;\r\n", ["// c \\\r\nd"]),
        ("x; /* c // d\n e */ y;  // f /* g\nz;\n", ["/* c // d\n e */", "// f /* g"]),
    ],
)
def test_comments_of_cpp(text: str, comments: list[str]) -> None:
    assert _comments("a.cpp", text) == comments


@pytest.mark.parametrize(
    ("text", "comments"),
    [
        ("x = 'a # b'  # c\n", ["# c"]),
        ("x = 'don\\'t # b'  # c\n", ["# c"]),
        ("x = r'\\'  # b'\ny  # c\n", ["# c"]),
        ("x = 'a\\\n# b'  # c\n", ["# c"]),
        ("x = 'a\\\r\n# b'  # c\r\n", ["# c"]),
        ('def f():\n    """a\n    # b\n    """  # c\n', ["# c"]),
        ("x = '''a ' # b\n''' '# c'  # d\n", ["# d"]),
        ("x = 1  # a\ry = '# b'  # c\r", ["# a", "# c"]),
        ('x = f"{d["# a"]}"  # b\n', ["# b"]),
        ("x = f'{d['# a']!r:{w['# b']}#} # c'  # d\n", ["# d"]),
        ("x = Rf'{a:#x}' + fr'\\{b}' + f'\\'# c'  # d\n", ["# d"]),
        ("x = f'{{# a' f'{ {1: 2}[1]:>3}' '}'  # b\n", ["# b"]),
        ("x = f'''{\n  a['# b']  # c\n}# d\n'''  # e\n", ["# e"]),
        ("x = f'{f'{f'{\"# a\"}'}'}'  # b\n", ["# b"]),
        ("x = t'{a[\"'# b\"]}'  # c\n", ["# c"]),
        ("x = f'a{b:c\ny  # b\n", ["# b"]),
        ("if'a':pass  # b\n", ["# b"]),
    ],
)
def test_comments_of_python(text: str, comments: list[str]) -> None:
    assert _comments("a.py", text) == comments


@pytest.mark.parametrize(
    ("text", "comments"),
    [
        ('set(a "b # c")  # d\n', ["# d"]),
        ('set(a "b\n# c")  # d\n', ["# d"]),
        ("set(a b\\# c)\n", []),
        ('set(a \\"b)  # c "\n', ['# c "']),
        ('set(a b"c # d")  # e\n', ["# e"]),
        ("set(a b#c\n)\n", ["#c"]),
        ("set(a [[ # b\n]] # c\n)\n", ["# c"]),
        ("set(a [=[ # b ]] # c\n]=]) # d\n", ["# d"]),
        ('set(a b[[c "d ]] # e")  # f\n', ["# f"]),
        ("#[==[ a # b\n]] # c\n]==] set(d)# e\n", ["#[==[ a # b\n]] # c\n]==]", "# e"]),
        ("# [[ a\nset(b)  # ]] c\n", ["# [[ a", "# ]] c"]),
    ],
)
def test_comments_of_cmake(text: str, comments: list[str]) -> None:
    assert _comments("CMakeLists.txt", text) == comments


@pytest.mark.parametrize(
    ("text", "comments"),
    [
        ("<a b='<!-- c -->'/> <!-- d -->\n", ["<!-- d -->"]),
        ("<a>it's <!-- b --> it's</a>\n", ["<!-- b -->"]),
        ("<?a <!-- b --> ?><![CDATA[<!-- c -->]]><!-- d -->\n", ["<!-- d -->"]),
        ("<!DOCTYPE a [<!ENTITY b '<!-- c -->'> <!-- d -->]>\n", ["<!-- d -->"]),
    ],
)
def test_comments_of_xml(text: str, comments: list[str]) -> None:
    assert _comments("a.xml", text) == comments


@pytest.mark.parametrize(
    ("text", "comments"),
    [
        ('load "a // b"  // c\n', ["// c"]),
        ("/* // a\nb // c\n*/ d  // e\n", ["// e"]),
        ("it's  // a\n", ["// a"]),
    ],
)
def test_comments_of_programs(text: str, comments: list[str]) -> None:
    assert _comments("a.plastron", text) == comments


@pytest.mark.parametrize(
    ("name", "text", "left"),
    [
        ("a.yml", "a: |\n  see # noqa: RG101\n", None),
        ("a.yml", "a: >\n  see # noqa: RG101\n  # noqa: RG101\n", None),
        ("a.yml", "a: 'see\n  x # noqa: RG101'\n", None),
        ("a.yml", 'a: "see # noqa: RG101"\n', None),
        ("a.yml", "a: b# noqa: RG101\n", None),
        ("a.yml", "a: b  # noqa: RG101\n", "a: b\n"),
        ("a.yml", "a: b  # noqa: RG101 \t\nc: d\n", "a: b\nc: d\n"),
        ("a.yml", "a: |  # noqa: RG101\n  # noqa: RG101\n", "a: |\n  # noqa: RG101\n"),
        ("a.yml", f"{MARK}a: ü  # noqa: RG101\r\nb: |\r\n", f"{MARK}a: ü\r\nb: |\r\n"),
        ("a.py", 'x = f"{d["# noqa: RG101"]}"\n', None),
        ("a.py", "x = 1  # noqa: RG101\ry = 2\r", "x = 1\ry = 2\r"),
        ("CMakeLists.txt", "set(a b\\# noqa: RG101\n)\n", None),
        ("a.plastron", "/*\na // noqa: RG101\n*/\n", None),
        ("README", "Write `x = 1  # noqa: RG101`\n", None),
        ("Makefile", "x:  # noqa: RG101\n", None),
        (".ignored", "x  # noqa: RG101\n", None),
        ("run", "#!/bin/sh\npython x  # noqa: RG101\n", None),
        (
            "run",
            "#!/usr/bin/env python3\nx = 1  # noqa: RG101\n",
            "#!/usr/bin/env python3\nx = 1\n",
        ),
        ("a.hpp", "int x = 1'000;  // NOLINT(RG101)\n", "int x = 1'000;\n"),
        ("a.xml", "<a>b <!-- noqa: RG101 -->c</a>\n", "<a>b c</a>\n"),
        ("a.xml", "<a>b<!-- noqa: RG101 --> c</a>\n", "<a>b c</a>\n"),
        ("a.xml", "<a/> <!-- noqa: RG101 --> \n", "<a/>\n"),
        ("a.msg", "wstring<=5 D=# noqa: RG101\n", None),
        ("a.srv", "string<=5 D=x # noqa: RG101\n---\n", None),
        ("a.msg", "int32 D=1 # noqa: RG101\n", "int32 D=1\n"),
    ],
)
def test_only_comments_are_taken_away(
    tmp_path: Path, name: str, text: str, left: str | None
) -> None:
    root = write_tree(tmp_path, {name: text})
    run = run_over(root, "RG101", "unused-noqa")
    assert [code for code, _ in told(run)] == ([] if left is None else ["unused-noqa"])
    mend(run)
    assert (root / name).read_bytes() == (text if left is None else left).encode()


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.hpp", "x;  // NOLINTBEGIN(RG101)\ny;\nz;  // NOLINTEND(RG101)\n"),
        ("a.hpp", "#define A x \\  // NOLINT(RG101)\ny\n"),
        ("CMakeLists.txt", "set(a b\\ # noqa: RG101\n)\n"),
    ],
)
def test_comment_that_is_needed_stays(tmp_path: Path, name: str, text: str) -> None:
    root = write_tree(tmp_path, {name: text})
    run = run_over(root, "RG101", "unused-noqa")
    assert [code for code, _ in told(run)] == ["unused-noqa"]
    mend(run)
    assert (root / name).read_text() == text
