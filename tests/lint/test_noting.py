"""Comments are written where they change nothing else, and nowhere else."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.diagnostics import LineIndex, Span
from plastron_tui.lint.comment_syntax import CommentStyle, comment_spans, style_of
from plastron_tui.lint.noting import with_comments
from plastron_tui.lint.rules import RULES
from plastron_tui.lint.suppression import comments_of

RULE = RULES["RC407"]


def _noted(name: str, text: str, *marks: str) -> str | None:
    """Return a text with comments for the places between `«` and `»`, None where none is noted."""
    raw = text.encode()
    spans = []
    while "«".encode() in raw:
        start = raw.index("«".encode())
        raw = raw.replace("«".encode(), b"", 1)
        end = raw.index("»".encode())
        raw = raw.replace("»".encode(), b"", 1)
        spans.append((Span(start, end), "RC407"))
    noted = with_comments(Path(name), raw, spans)
    if not noted.done:
        assert noted.text == raw
        return None
    lines = LineIndex(noted.text)
    comments = comments_of(Path(name), noted.text, lines)
    assert any(each.is_about(RULE) for each in comments)
    return noted.text.decode()


@pytest.mark.parametrize(
    ("name", "text", "noted"),
    [
        ("a.py", "«f()»\ny\n", "f()  # noqa: RC407\ny\n"),
        ("a.py", "«f()»", "f()  # noqa: RC407"),
        ("a.py", "«f()»\r\ny\r\n", "f()  # noqa: RC407\r\ny\r\n"),
        ("a.py", "«f()»  # why\n", "f()  # why  # noqa: RC407\n"),
        ("a.py", "«f()»  # noqa: E501\n", "f()  # noqa: E501, RC407\n"),
        ("a.py", "«f()»  # noqa: E501 a long one\n", "f()  # noqa: E501, RC407 a long one\n"),
        ("a.py", "«f('''\n''')»\n", "f('''\n''')  # noqa: RC407\n"),
        ("a.py", "x = '''\n«f»\n'''\n", None),
        ("a.py", "«f('''a\n''')» + \\\n  1\n", None),
        ("a.py", "«f()» + \\\n  1\n", None),
        ("a.py", "«f(\\\n  1)»\n", "f(\\\n  1)  # noqa: RC407\n"),
        ("a.py", "«f('# noqa: E501')»\n", "f('# noqa: E501')  # noqa: RC407\n"),
        ("a.py", "«f()»; «g()»\n", "f(); g()  # noqa: RC407\n"),
        ("a.cpp", "«f();»\n", "f();  // NOLINT(RC407)\n"),
        ("a.cpp", "«f();»  // NOLINT(a-b)\n", "f();  // NOLINT(a-b, RC407)\n"),
        (
            "a.cpp",
            "// NOLINTBEGIN(a-b)\n«f();»\n// NOLINTEND(a-b)\n",
            "// NOLINTBEGIN(a-b)\nf();  // NOLINT(RC407)\n// NOLINTEND(a-b)\n",
        ),
        ("a.cpp", "// NOLINTNEXTLINE(a-b)\n«f();»\n", "// NOLINTNEXTLINE(a-b, RC407)\nf();\n"),
        ("a.cpp", "#define A \\\n  «f()»\nx\n", "#define A \\\n  f()  // NOLINT(RC407)\nx\n"),
        ("a.cpp", "#define A «f()» \\\n  x\n", None),
        ("a.cpp", "#define A «f()» \\ \n  x\n", None),
        ("a.cpp", "«f(1'000);»\n", "f(1'000);  // NOLINT(RC407)\n"),
        ("a.cpp", "«f(1'000);»  // NOLINT(a-b)\n", "f(1'000);  // NOLINT(a-b, RC407)\n"),
        ("a.cpp", 'x = R"(\n«f»\n)";\n', None),
        ("a.cpp", 'f("//");  «g();»\n', 'f("//");  g();  // NOLINT(RC407)\n'),
        ("a.yaml", "a: «b»\n", "a: b  # noqa: RC407\n"),
        ("a.yaml", "a: «don't»\n", "a: don't  # noqa: RC407\n"),
        ("a.yaml", "a: |\n  «b»\n  c\n", None),
        ("a.yaml", "a: 'b\n  «c»\n  d'\n", None),
        ("CMakeLists.txt", "f(«x»)\n", "f(x)  # noqa: RC407\n"),
        ("CMakeLists.txt", 'f("\n«x»\n")\n', None),
        ("CMakeLists.txt", "f([=[\n«x»\n]=])\n", None),
        ("a.xml", "<a>\n  <b «c=''»/>\n</a>\n", "<a>\n  <b c=''/>  <!-- noqa: RC407 -->\n</a>\n"),
        (
            "a.launch",
            "<a>\n  <b\n    «c=''»\n    d='1'/>\n</a>\n",
            "<a>\n  <!-- noqa: RC407 -->\n  <b\n    c=''\n    d='1'/>\n</a>\n",
        ),
        ("a.xml", "<a>\n<!-- «b»\n -->\n</a>\n", None),
        ("a.xml", "<a>\n<![CDATA[\n«b»\n]]></a>\n", None),
        ("a.plastron", "load «a»\n", "load a  // noqa: RC407\n"),
        ("a.msg", "«int32 a»\n", "int32 a  # noqa: RC407\n"),
        ("a.msg", "«int32 a»  # why\n", "int32 a  # why  # noqa: RC407\n"),
        ("a.msg", "«string a 'b # c'»\n", "string a 'b # c'  # noqa: RC407\n"),
        ("a.msg", "«string A=b»\n", None),
        ("a.msg", "«wstring A = 'b' # c»\n", None),
        ("a.srv", "«string a»\n---\n", "string a  # noqa: RC407\n---\n"),
        ("a.action", "---\n«int32 A=1»\n---\n", "---\nint32 A=1  # noqa: RC407\n---\n"),
        ("a.test", "<a>\n  <b «c=''»/>\n</a>\n", "<a>\n  <b c=''/>  <!-- noqa: RC407 -->\n</a>\n"),
        ("a.txt", "«a»\n", None),
    ],
)
def test_where_a_comment_goes(name: str, text: str, noted: str | None) -> None:
    assert _noted(name, text) == noted


@given(
    st.lists(
        st.sampled_from(
            ["f()\n", "x = '''\n", "'''\n", "'''", '"', "'", "\\\n", "# a\n", "(\n", ")\n", "\n"]
        ),
        max_size=12,
    ),
    st.integers(0, 60),
)
def test_python_says_the_same_with_comments(parts: list[str], at: int) -> None:
    text = "".join(parts)
    try:
        before = ast.dump(ast.parse(text))
    except SyntaxError:
        return
    at = min(at, len(text))
    after = with_comments(Path("a.py"), text.encode(), [(Span(at, at), "RC407")]).text
    assert ast.dump(ast.parse(after)) == before


@given(st.sampled_from(list(CommentStyle)), st.text(alphabet="\"'\\/*#<>![]-()=R\n a", max_size=60))
def test_any_text_has_comments_that_do_not_overlap(style: CommentStyle, text: str) -> None:
    ends = 0
    for span in comment_spans(style, text.encode()):
        assert ends <= span.start <= span.end
        ends = span.end


def test_which_files_have_comments() -> None:
    assert style_of(Path("a/CMakeLists.txt")) is CommentStyle.CMAKE
    assert style_of(Path("a/notes.txt")) is None
    assert style_of(Path("a/b.msg")) is CommentStyle.DEFINITION
