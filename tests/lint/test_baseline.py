"""What was found before is left: only what is new is told."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import NO_QUEUE, run_over, told, write_tree

from plastron_tui.lint.baseline import read_baseline


def test_only_what_is_new_is_told(tmp_path: Path) -> None:
    root = write_tree(tmp_path, {"p/a.py": NO_QUEUE, "plastron.yaml": ""})
    baseline = tmp_path / "known.json"
    baseline.write_text(run_over(root, "RC").baseline_text())
    assert told(run_over(root, "RC", baseline=baseline)) == []

    file = root / "p" / "a.py"
    # Lines above move it, and a second one of the same text is new.
    file.write_text("# more\n" + NO_QUEUE + "pub = rospy.Publisher('a', String)\n")
    assert told(run_over(root, "RC", baseline=baseline)) == [("RC407", 5)]
    # A part of the workspace has the same paths in it.
    assert told(run_over(root / "p", "RC", baseline=baseline)) == [("RC407", 5)]


def test_the_settings_name_a_baseline(tmp_path: Path) -> None:
    root = write_tree(tmp_path, {"a.py": NO_QUEUE, "plastron.yaml": "lint: {baseline: known.json}"})
    run = run_over(root, "RC")
    assert told(run) == [("RC407", 3)]
    (missing,) = run.diagnostics
    assert missing.message.startswith("the baseline cannot be read: ")
    (root / "known.json").write_text(run.baseline_text())
    assert told(run_over(root, "RC")) == []


@pytest.mark.parametrize(
    "text",
    [b"", b"{", b"[]", b"{}", b'{"version": 2, "findings": []}', b"\xff",
     b'{"version": 1, "findings": 5}',
     b'{"version": 1, "findings": [{}]}', b"[" * 100_000,
     b'{"version": 1, "findings": [{"code": "", "file": "", "line": "", "message": "",'
     b' "count": 1e999}]}'],
)  # fmt: skip
def test_what_is_no_baseline_is_told(text: bytes) -> None:
    with pytest.raises(ValueError, match=r".+"):
        read_baseline(text)
