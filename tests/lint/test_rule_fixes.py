"""The fix of a rule's bad example mends it, and `--add-noqa` hides it: no rule breaks a file."""

from __future__ import annotations

from pathlib import Path

import pytest
from linted import run_over, told, write_tree

from plastron_tui.lint import Rule
from plastron_tui.lint.rules import RULES
from plastron_tui.project.linting.rewriting import fixed, mend, note_all


@pytest.mark.parametrize("rule", RULES.values(), ids=lambda rule: rule.code)
def test_a_bad_example_is_mended_or_noted(tmp_path: Path, rule: Rule) -> None:
    root = write_tree(tmp_path, {**rule.bad, "plastron.yaml": ""})
    run = run_over(root, rule.code)
    if not run.told:
        # What it is compared with is a revision of git.
        return
    if fixed(run):
        changes = mend(run)
        assert changes.diagnostics == ()
        assert told(changes.run) == []
        write_tree(tmp_path, dict(rule.bad))
        run = run.again()
    places = [each.diagnostic for each in run.told]
    changes = note_all(run)
    assert changes.diagnostics == ()
    # A definition of a type has no comments of this kind.
    left = [each for each in changes.run.told if each.diagnostic.file is not None]
    assert len(left) + changes.done == len(places)
    assert all(x.diagnostic.span is None or _has_no_comments(x.diagnostic.file) for x in left)


def _has_no_comments(file: Path | None) -> bool:
    return file is not None and file.suffix in (".msg", ".srv", ".action", "")
