"""Files that begin with a byte order mark: places, fixes and comments are those of other files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml
from linted import run_over, write_tree

from plastron_tui.diagnostics import LineIndex, Span
from plastron_tui.lint import Rule
from plastron_tui.lint.noting import with_comments
from plastron_tui.lint.rules import RULES
from plastron_tui.lint.suppression import comments_of
from plastron_tui.project.linting.rewriting import Changes, mend, note_all
from plastron_tui.project.linting.run import LintRun
from plastron_tui.ros.launch import StartedNode, items_of
from plastron_tui.ros.parameter_blocks import read_blocks
from plastron_tui.sources.launch.yaml_reader import read_launch_yaml
from plastron_tui.sources.splices import BYTE_ORDER_MARK as MARK


def _told(run: LintRun, root: Path) -> list[Any]:
    """Return what a run tells, with the lines, columns and texts of all places."""
    found = []
    for each in run.told:
        said = each.diagnostic
        assert said.file is not None
        lines, text = run.lines(said.file), run.text(said.file)
        assert lines is not None
        assert text is not None
        fixes = () if said.fix is None else said.fix.edits
        spans = [*([said.span] if said.span else []), *(edit.span for edit in fixes)]
        places = [
            (lines.position(s.start), lines.position(s.end), text[s.start : s.end]) for s in spans
        ]
        found.append((said.file.relative_to(root), said.message, places))
    return found


@pytest.mark.parametrize("change", [mend, note_all])
@pytest.mark.parametrize("rule", RULES.values(), ids=lambda rule: rule.code)
def test_what_is_found_and_written(
    tmp_path: Path, rule: Rule, change: Callable[[LintRun], Changes]
) -> None:
    plain = write_tree(tmp_path / "plain", {**rule.bad, "plastron.yaml": ""})
    files = {name: MARK + text.encode() for name, text in rule.bad.items()}
    marked = write_tree(tmp_path / "marked", {**files, "plastron.yaml": ""})
    expected, found = run_over(plain, rule.code), run_over(marked, rule.code)
    assert _told(found, marked) == _told(expected, plain)
    change(expected)
    change(found)
    for name in rule.bad:
        assert (marked / name).read_bytes() == MARK + (plain / name).read_bytes()


@pytest.mark.parametrize("is_fast", [True, False])
@pytest.mark.parametrize("marks", [0, 1, 2])
def test_places_in_parameter_files(
    is_fast: bool, marks: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(yaml, "__with_libyaml__", yaml.__with_libyaml__ and is_fast)
    text = MARK * marks + "a:\n  ros__parameters:\n    größe: 'ü'\n".encode()
    blocks = read_blocks(text)
    assert blocks is not None
    (key,) = blocks[0].keys
    spans = [blocks[0].name.span, key.parts[0].span, key.span]
    assert [text[start:end].decode() for start, end in spans] == ["a", "größe", "'ü'"]


def test_places_in_launch_files_of_yaml() -> None:
    text = MARK + b"launch:\n- node: {pkg: demo, exec: talker}\n"
    launch = read_launch_yaml(text).launch
    assert launch is not None
    (node,) = items_of(launch.items, StartedNode)
    assert node.place is not None
    assert text[node.place.start :].startswith(b"node:")
    (broken,) = read_launch_yaml(MARK + b"lunch:\n- a\n").diagnostics
    assert broken.span == Span(3, 8)


def test_comment_in_the_first_line() -> None:
    text = MARK + b"<!-- noqa: RK501 -->\n<package\n  format='3'/>\n"
    (comment,) = comments_of(Path("package.xml"), text, LineIndex(text))
    assert (comment.first, comment.last) == (2, 3)


def test_comment_above_the_first_tag() -> None:
    text = MARK + b"<package\n  format='3'/>\n"
    noted = with_comments(Path("package.xml"), text, [(Span(3, 11), "RK501")])
    assert noted.text == MARK + b"<!-- noqa: RK501 -->\n<package\n  format='3'/>\n"


def test_comment_alone_in_the_first_line_stays(tmp_path: Path) -> None:
    text = MARK + b"# noqa: RG101\nx = 1\n"
    root = write_tree(tmp_path, {"a.py": text})
    mend(run_over(root, "RG101", "unused-noqa"))
    assert (root / "a.py").read_bytes() == text
