"""Comments that say that what breaks a rule is meant, and those that say so of nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import NO_QUEUE, run_over, told, write_tree

from plastron_tui.diagnostics import LineIndex, Span
from plastron_tui.lint.rule import RULES, Rule
from plastron_tui.lint.rules import RULES as DECLARED
from plastron_tui.lint.suppression import Comment, FileComments, comments_of, may_name_rules
from plastron_tui.project.linting.rewriting import mend

assert DECLARED is RULES
RULE = RULES["RC407"]


def _is_meant(name: str, text: str, at: str = "@") -> bool:
    """Tell whether a comment is about the first place of a sign, which ends with its second one."""
    raw = text.encode()
    start = raw.index(at.encode())
    end = raw.rindex(at.encode()) + 1
    lines = LineIndex(raw)
    return any(
        each.covers(lines, Span(start, end)) and each.is_about(RULE)
        for each in comments_of(Path(name), raw, lines)
    )


@pytest.mark.parametrize(
    ("name", "text", "meant"),
    [
        ("a.py", "@  # noqa\n", True),
        ("a.py", "@  # noqa: RC407\n", True),
        ("a.py", "@  # NOQA:rc407\n", True),
        ("a.py", "@  # Noqa: RC407\n", True),
        ("a.py", "@  # noqa: E501, RC407\n", True),
        ("a.py", "@  # noqa: E501 RC407\n", True),
        ("a.py", "@  # noqa: RC407 as ROS 1 needs it\n", True),
        ("a.py", "@  # noqa: RC\n", True),
        ("a.py", "@  # noqa: queue-size-missing\n", True),
        ("a.py", "@  # noqa: E501\n", False),
        ("a.py", "@  # noqa: E501 r is a letter\n", False),
        ("a.py", "@  # noqa: RC408\n", False),
        ("a.py", "@  # noqa-this\n", False),
        ("a.py", "@\nx  # noqa\n", False),
        ("a.py", "@ '# noqa'\n", False),
        ("a.cpp", '@ "// NOLINT"\n', False),
        ("a.py", "@(\n  1)@  # noqa\n", True),
        ("a.cpp", "@ // NOLINT\n", True),
        ("a.cpp", "@ // NOLINT(RC407)\n", True),
        ("a.cpp", "@ // NOLINT(readability-x, RC407)\n", True),
        ("a.cpp", "@ // NOLINT(readability-x)\n", False),
        ("a.cpp", "@ // noqa\n", False),
        ("a.cpp", "// NOLINTNEXTLINE(RC407)\n@\n", True),
        ("a.cpp", "// NOLINTNEXTLINE\n\n@\n", False),
        ("a.hpp", "@ // NOLINTNEXTLINE\n", False),
        ("a.hpp", "// NOLINTBEGIN(RC407)\nx\n@\n// NOLINTEND(RC407)\n", True),
        ("a.hpp", "// NOLINTBEGIN\nx\n@\n// NOLINTEND\n", True),
        ("a.hpp", "// NOLINTBEGIN(RC407)\n// NOLINTEND(RC407)\n@\n", False),
        ("a.hpp", "// NOLINTBEGIN(RC407)\n@\n// NOLINTEND(RC408)\n", False),
        ("a.hpp", '// NOLINTBEGIN(RC407)\nx("NOLINTEND(RC407)")\n@\n// NOLINTEND(RC407)\n', True),
        ("a.hpp", 'x("NOLINTBEGIN(RC407)")\n@\n// NOLINTEND(RC407)\n', False),
        ("a.hpp", "@ = 1'000;  // NOLINT(RC407)\n", True),
        ("CMakeLists.txt", "@ # noqa: RC407\n", True),
        ("other.txt", "@ # noqa: RC407\n", False),
        ("a.yaml", "x@ # noqa: RC407\n", True),
        ("a.xml", "<a @/> <!-- noqa: RC407 -->\n", True),
        ("a.xml", "<!-- noqa: RC407 -->\n<a\n  @\n  b=''/>\n", True),
        ("a.xml", "<!-- noqa: RC407 -->\n<a b='>'\n  @/>\n", True),
        ("a.xml", "<!-- noqa: RC407 -->\n<a/>\n<b @/>\n", False),
        ("a.plastron", "@ // noqa: RC407\n", True),
        ("a.msg", "@ # noqa: RC407\n", True),
        ("a.msg", "string A=@b # noqa: RC407\n", False),
        ("a.srv", "@ # noqa: RC407\n", True),
        ("a.action", "@ # noqa: RC407\n", True),
        ("a.launch", "<a @/> <!-- noqa: RC407 -->\n", True),
        ("package.xml", "<a @/> <!-- noqa: RC407 -->\n", True),
    ],
)  # fmt: skip
def test_which_lines_a_comment_is_about(name: str, text: str, meant: bool) -> None:
    assert _is_meant(name, text) is meant


@pytest.mark.parametrize(
    ("ending", "found"),
    [
        ("", [("RC407", 3)]),
        ("  # noqa: RC407", []),
        ("\nx = 1  # noqa: RC407", [("RC407", 3), ("unused-noqa", 4)]),
        ("\nx = 1  # noqa: E501", [("RC407", 3)]),
        ("\nx = 1  # noqa: RM999", [("RC407", 3), ("unused-noqa", 4)]),
        ("  # noqa: rc999, RC407", [("unused-noqa", 3)]),
        ("\nx = 1  # noqa: RM99, RM9999, RX999, RUF100", [("RC407", 3)]),
        ("\nx = 1  # noqa: RM999, unused-noqa", [("RC407", 3)]),
        ("\nx = 1  # noqa", [("RC407", 3)]),
        ("\nx = '# noqa: RC407'", [("RC407", 3)]),
        # The comments of the first line and of the last one are both of use.
        ("  # noqa: RC407\nrospy.Publisher('b',  # noqa: RC407\n    String)  # noqa: RC407", []),
        # Of a rule that is not followed nobody knows.
        ("  # noqa: RC407, RG101", []),
        ("\nx = 1  # noqa: RC407, unused-noqa", [("RC407", 3)]),
    ],
)
def test_comment_in_a_workspace(tmp_path: Path, ending: str, found: list[object]) -> None:
    root = write_tree(tmp_path, {"a.py": NO_QUEUE.rstrip() + ending + "\n"})
    assert told(run_over(root, "RC407", "unused-noqa")) == found
    # Another run knows from the first one which files have such comments.
    assert told(run_over(root, "RC407", "unused-noqa")) == found
    (root / "b.py").write_text("x = 1  # noqa: queue-size-missing\n")
    assert told(run_over(root, "RC407", "unused-noqa")) == [*found, ("unused-noqa", 1)]


@pytest.mark.parametrize(
    ("comment", "messages", "left"),
    [
        ("RM999", ["there is no rule `RM999`"], ""),
        (
            "RC407, RM999",
            ["nothing breaks `RC407` (queue-size-missing) here", "there is no rule `RM999`"],
            "",
        ),
        ("E501, RM999", ["there is no rule `RM999`"], "  # noqa: E501, RM999"),
    ],
)
def test_code_that_is_of_no_use(
    tmp_path: Path, comment: str, messages: list[str], left: str
) -> None:
    root = write_tree(tmp_path, {"a.py": f"x = 1  # noqa: {comment}\n"})
    run = run_over(root, "RC407", "unused-noqa")
    assert [each.diagnostic.message for each in run.told] == messages
    mend(run)
    assert (root / "a.py").read_text() == f"x = 1{left}\n"


def test_many_comments_are_judged_once_each(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = 0
    judge = Comment.is_about

    def counted(self: Comment, rule: Rule) -> bool:
        nonlocal asked
        asked += 1
        return judge(self, rule)

    monkeypatch.setattr(Comment, "is_about", counted)
    many = 1_000
    for line_end in (b"", b"\n"):
        asked, text = 0, (b"# noqa: RC408 " + line_end) * many
        comments = FileComments(Path("a.py"), text, LineIndex(text))
        assert not any(comments.mean(RULE, Span(at, at + 1)) for at in range(0, len(text), 7))
        assert asked == many


def test_comment_whose_codes_are_far_from_its_sign() -> None:
    assert may_name_rules(b"# noqa" * 20_000 + b": RC407\n")
    assert not may_name_rules(b"# noqa " * 20_000 + b"\nRC407\n")
