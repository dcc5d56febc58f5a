"""Each rule finds the mistake of its own example, and nothing in the example without it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from plastron_tui.lint import Rule, lint
from plastron_tui.lint.rules import RULES
from plastron_tui.lint.tree import Earlier
from plastron_tui.project.linting import read_tree
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.project.linting.earlier import interfaces_of

_rules = pytest.mark.parametrize("rule", RULES.values(), ids=lambda rule: rule.code)


def _found(
    folder: Path, files: dict[str, str], *rules: Rule, before: Mapping[str, str] | None = None
) -> list[str]:
    root = folder / "src"
    for name, text in files.items():
        file = root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    tree = read_tree([root], FactCache(root, folder / "cache"), workers=1)
    if before:
        tree = replace(tree, earlier=Earlier("main", interfaces_of(before, tree.packages)))
    return [each.rule.code for each in lint(tree, rules)]


@_rules
def test_bad_example_breaks_its_rule_once(tmp_path: Path, rule: Rule) -> None:
    assert _found(tmp_path, dict(rule.bad), rule, before=rule.before) == [rule.code]


@_rules
def test_good_example_breaks_no_rule(tmp_path: Path, rule: Rule) -> None:
    asked = [each for each in RULES.values() if not each.is_opt_in or each is rule]
    assert _found(tmp_path, dict(rule.good), *asked, before=rule.before) == []
