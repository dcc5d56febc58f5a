from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.output.diff import file_diff, visible_patch
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.plan import FileState, OutputFile, PlannedFile, make_plan

_HUNK = re.compile(rb"@@ -(\d+)(?:,(\d+))? \+(\d+)(?:,(\d+))? @@\n")


def planned(before: bytes | None, after: bytes) -> PlannedFile:
    state = FileState.CREATE if before is None else FileState.CHANGED
    return PlannedFile("a.py", Path("a.py"), after, state, False, before)


def apply(before: bytes, patch: bytes) -> bytes:
    """Apply a patch as `patch -p1` would, and check what it says about the old text."""
    old = re.findall(rb"[^\n]*\n|[^\n]+\Z", before)
    out: list[bytes] = []
    at = 0
    lines = re.findall(rb"[^\n]*\n", patch)
    for number, line in enumerate(lines):
        if hunk := _HUNK.fullmatch(line):
            start, count = int(hunk[1]), int(hunk[2] or 1)
            upto = start - 1 if count else start
            out += old[at:upto]
            at = upto
        elif line[:1] in (b" ", b"+", b"-") and not line.startswith((b"--- ", b"+++ ")):
            text = line[1:]
            if lines[number + 1 : number + 2] == [b"\\ No newline at end of file\n"]:
                text = text[:-1]
            if line[:1] != b"+":
                assert old[at] == text
                at += 1
            if line[:1] != b"-":
                out.append(text)
    return b"".join(out + old[at:])


# No text here starts a line with "-- " or "++ ", which this reader takes for a header.
TEXTS = st.lists(st.sampled_from([b"a", b"b", b"\n", b"\r\n", b"\r", b"\xff", b"\n\n", b"c"]))


@given(TEXTS.map(b"".join), TEXTS.map(b"".join))
def test_the_patch_makes_the_new_text_of_the_old(before: bytes, after: bytes) -> None:
    assert apply(before, file_diff(planned(before, after))) == after


@given(TEXTS.map(b"".join))
def test_the_patch_of_a_new_file(after: bytes) -> None:
    patch = file_diff(planned(None, after))
    assert apply(b"", patch) == after
    assert patch.startswith(b"diff --git a/a.py b/a.py\nnew file mode 100644\n")


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [
        (b"a\r\n", b"a\n", b"--- a/a.py\n+++ b/a.py\n@@ -1 +1 @@\n-a\r\n+a\n"),
        (
            b"a\n",
            b"a",
            b"--- a/a.py\n+++ b/a.py\n@@ -1 +1 @@\n-a\n+a\n\\ No newline at end of file\n",
        ),
        (
            None,
            b"\xff\n",
            b"new file mode 100644\n--- /dev/null\n+++ b/a.py\n@@ -0,0 +1 @@\n+\xff\n",
        ),
    ],
)
def test_text(before: bytes | None, after: bytes, expected: bytes) -> None:
    assert file_diff(planned(before, after)) == b"diff --git a/a.py b/a.py\n" + expected


def test_identical_is_empty_and_a_missing_bit_is_shown(tmp_path: Path) -> None:
    (tmp_path / "a.py").write_bytes(b"#!x\n")
    (tmp_path / "a.py").chmod(0o644)
    files = [OutputFile("a.py", b"#!x\n"), OutputFile("a.py", b"#!x\n", False)]
    (changed,) = make_plan(tmp_path, files[:1], Manifest())[0].files
    assert file_diff(changed) == b"diff --git a/a.py b/a.py\nold mode 100644\nnew mode 100755\n"
    (identical,) = make_plan(tmp_path, files[1:], Manifest())[0].files
    assert file_diff(identical) == b""


@pytest.mark.parametrize(
    ("patch", "shown"),
    [
        (b"+a\r\n", "+a^M\n"),
        (b"+\xff\t\xc3\xa4\n", "+\\xff\tä\n"),
        (b"+\x1b[2J\x7f\n", "+^[[2J\\x7f\n"),
        ("+\u202eabc\u200b\u3000\n".encode(), "+\\u202eabc\\u200b\u3000\n"),
    ],
)
def test_a_terminal_is_told_nothing_by_a_patch(patch: bytes, shown: str) -> None:
    assert visible_patch(patch) == shown


@pytest.mark.long
@pytest.mark.parametrize("before", [None, b"", b"text\n", bytes(range(256)) * 9])
@pytest.mark.parametrize("after", [b"\0", b"a\0b" * 20, bytes(range(255, -1, -1)) * 99])
def test_git_applies_the_patch_of_what_is_no_text(
    before: bytes | None, after: bytes, tmp_path: Path
) -> None:
    file = tmp_path / "a.py"
    if before is not None:
        file.write_bytes(before)
    patch = file_diff(planned(before, after))
    command = ["git", "apply", "-"]
    subprocess.run(command, input=patch, cwd=tmp_path, check=True, capture_output=True)
    assert file.read_bytes() == after


def test_what_is_no_text_is_only_named_for_people() -> None:
    patch = file_diff(planned(b"text\n", b"\0" * 1_000))
    assert visible_patch(patch).splitlines()[2:] == ["Binary files differ"]
