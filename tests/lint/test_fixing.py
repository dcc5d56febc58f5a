"""Fixes are applied byte for byte, in turns where they touch, and put back where they harm."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from linted import NO_QUEUE, run_over, told, write_tree

from plastron_tui.diagnostics import Code, Diagnostic, Edit, Fix, Severity, Span
from plastron_tui.lint.fixing import with_fixes
from plastron_tui.lint.rule import RULES, rule
from plastron_tui.lint.tree import SourceTree
from plastron_tui.project.linting.rewriting import Changes, fixed, mend, note_all
from plastron_tui.project.linting.run import LintRun


def _fix(*edits: tuple[int, int, str]) -> Fix:
    return Fix("mend it", tuple(Edit(Span(start, end), text) for start, end, text in edits))


@pytest.mark.parametrize(
    ("text", "fixes", "after", "waiting"),
    [
        (b"abcdef", [_fix((1, 2, "X"))], b"aXcdef", 0),
        (b"abcdef", [_fix((4, 5, "Y")), _fix((1, 2, "X"))], b"aXcdYf", 0),
        (b"abcdef", [_fix((1, 3, "X")), _fix((2, 4, "Y"))], b"aXdef", 1),
        (b"abcdef", [_fix((1, 1, "X")), _fix((1, 1, "Y"))], b"aXbcdef", 1),
        (b"abcdef", [_fix((1, 1, "X")), _fix((1, 1, "X"))], b"aXbcdef", 0),
        (b"abcdef", [_fix((0, 1, "X"), (5, 6, "Y")), _fix((5, 6, ""))], b"XbcdeY", 1),
        (b"abcdef", [_fix((1, 3, "")), _fix((3, 4, "Y"))], b"aYef", 0),
        (b"a\r\nb\r\n", [_fix((0, 1, "x\ny"))], b"x\r\ny\r\nb\r\n", 0),
        ("ä\xff".encode("latin-1"), [_fix((0, 0, "ü"))], "ü".encode() + b"\xe4\xff", 0),
    ],
)
def test_fixes_of_a_text(text: bytes, fixes: list[Fix], after: bytes, waiting: int) -> None:
    found = with_fixes(text, fixes)
    assert found.text == after
    assert len(set(fixes)) - len(found.applied) == waiting


@pytest.fixture
def replacing() -> Iterator[Callable[[str, str], None]]:
    """Declare rules that find a word in any file, and mend it with another one."""
    codes: list[str] = []

    def declare(old: str, new: str) -> None:
        code = f"RC9{len(codes):02}"
        codes.append(code)

        @rule(code, f"no-{old}", "A.", why="B.", bad={}, good={}, severity=Severity.WARNING)
        def check(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
            for name in tree.files:
                text = Path(name).read_bytes()
                at = text.find(old.encode())
                while at >= 0:
                    span = Span(at, at + len(old))
                    edits = (Edit(span, new),)
                    yield Diagnostic(code, "x", span, Path(name), fix=Fix("mend", edits))
                    at = text.find(old.encode(), at + 1)

    yield declare
    for code in codes:
        del RULES[code]


Replacing = Callable[[str, str], None]


def test_overlapping_fixes_have_their_turns(tmp_path: Path, replacing: Replacing) -> None:
    root = write_tree(tmp_path, {"a.py": "aaa = 1\n"})
    replacing("aa", "b")
    assert len(fixed(run_over(root, "RC9"))) == 1
    changes = mend(run_over(root, "RC9"))
    assert (root / "a.py").read_text() == "ba = 1\n"
    assert (changes.done, changes.files, told(changes.run)) == (1, 1, [])


def test_one_fix_calls_for_another(tmp_path: Path, replacing: Replacing) -> None:
    root = write_tree(tmp_path, {"a.py": b"one = 1\r\n", "b.py": "x = 1\n"})
    (root / "a.py").chmod(0o755)
    replacing("one", "two")
    changes = mend(run_over(root, "RC9"))
    assert (root / "a.py").read_bytes() == b"two = 1\r\n"
    assert (root / "a.py").stat().st_mode & 0o777 == 0o755
    assert changes.done == 1
    # Nothing is left beside the files.
    assert sorted(each.name for each in root.iterdir()) == ["a.py", "b.py"]


def test_what_reads_worse_is_left(tmp_path: Path, replacing: Replacing) -> None:
    root = write_tree(tmp_path, {"a.py": "one = bad\n", "b.yaml": "a: bad\n", "c.xml": "<bad/>\n"})
    replacing("bad", "(")
    replacing("one", "two")
    replacing("a: ", "{")
    replacing("<", "")
    mend(run_over(root, "RC9"))
    assert (root / "a.py").read_text() == "two = bad\n"
    assert (root / "b.yaml").read_text() == "a: (\n"
    assert (root / "c.xml").read_text() == "<bad/>\n"


@pytest.mark.parametrize(
    "selected",
    [
        ("RC9",),
        # What is broken then is not told, and is broken nevertheless.
        ("RC900", "RC902"),
    ],
)
def test_what_breaks_another_rule_is_put_back(
    tmp_path: Path, replacing: Replacing, selected: tuple[str, ...]
) -> None:
    root = write_tree(tmp_path, {"a.py": "one = 'good'\n"})
    replacing("one", "worse")
    replacing("worse", "worst")
    replacing("good", "better")
    changes = mend(run_over(root, *selected))
    assert (root / "a.py").read_text() == "one = 'better'\n"
    assert (changes.done, changes.files, told(changes.run)) == (1, 1, [("RC900", 1)])


@pytest.mark.parametrize("count", [1, 2, 5, 40])
def test_what_breaks_a_rule_in_another_file_is_put_back(
    tmp_path: Path, replacing: Replacing, count: int
) -> None:
    names = [f"f{number:02}.py" for number in range(count)]
    root = write_tree(tmp_path, {**dict.fromkeys(names, "one = 1\n"), "z.py": "x = 1\n"})
    harmful = root / names[count // 2]
    harmful.write_text("one = 1; bad = 1\n")
    replacing("one", "two")
    replacing("bad", "gone")

    @rule("RC950", "elsewhere", "A.", why="B.", bad={}, good={}, severity=Severity.WARNING)
    def check(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
        if "gone" in harmful.read_text():
            yield Diagnostic(code, "x", Span(0, 1), root / "z.py")

    try:
        changes = mend(run_over(root, "RC900", "RC901"))
    finally:
        del RULES["RC950"]
    assert harmful.read_text() == "two = 1; bad = 1\n"
    assert all("two" in (root / name).read_text() for name in names)
    assert (changes.done, changes.files, told(changes.run)) == (count, count, [("RC901", 1)])


def test_a_file_that_cannot_be_written_is_told(tmp_path: Path, replacing: Replacing) -> None:
    root = write_tree(tmp_path, {"a.py": "one = 1\n", "b.py": "one = 1\n"})
    (root / "a.py").chmod(0o444)
    replacing("one", "two")
    changes = mend(run_over(root, "RC9"))
    assert (root / "a.py").read_text() == "one = 1\n"
    assert (root / "b.py").read_text() == "two = 1\n"
    assert (changes.done, changes.files) == (1, 1)
    assert [str(each.code) for each in changes.diagnostics] == ["cannot-write"]


@pytest.mark.parametrize("change", [mend, note_all])
def test_file_that_cannot_be_written_counts_for_nothing(
    tmp_path: Path, change: Callable[[LintRun], Changes]
) -> None:
    root = write_tree(tmp_path, {"a.py": NO_QUEUE, "b.py": NO_QUEUE + "x = 1  # noqa: RC407\n"})
    for name in ("a.py", "b.py"):
        (root / name).chmod(0o444)
    changes = change(run_over(root, "RC407", "unused-noqa"))
    assert (changes.done, changes.files) == (0, 0)
    assert changes.diagnostics
    # What is generated can go elsewhere, a file of a workspace cannot.
    assert not any(each.help for each in changes.diagnostics)
