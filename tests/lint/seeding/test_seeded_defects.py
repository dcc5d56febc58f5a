"""Defects that people make, put into workspaces: lint tells each at its line, and nothing else.

Whoever wrote the seeds had not seen how a rule finds what it tells.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

import boat_seeds
import orchard_code_seeds
import orchard_graph_seeds
import pytest
import warehouse_seeds
from seeded_workspaces import WORKSPACES, Outcome, Seed, SeededWorkspace, told_of

SEEDS: tuple[Seed, ...] = (
    *orchard_graph_seeds.SEEDS,
    *orchard_code_seeds.SEEDS,
    *warehouse_seeds.SEEDS,
    *boat_seeds.SEEDS,
)
NAMES = sorted({seed.workspace for seed in SEEDS})
SHARES = {"RG": 0.95, "RM": 0.97, "RP": 0.95, "RC": 0.98, "RK": 0.95}
"""How much of the defects of each group of rules is told at the least; 0.95 is meant of each."""

QUICK = ("RG101", "RG104", "RM201", "RM203", "RP301", "RP303", "RC403", "RC406", "RK501", "RK506")
"""Rules of which the quick suite tries one seed each."""


@pytest.fixture(scope="module")
def workspaces(tmp_path_factory: pytest.TempPathFactory) -> dict[str, SeededWorkspace]:
    folder = tmp_path_factory.mktemp("seeded")
    return {name: SeededWorkspace(WORKSPACES / name, folder / name) for name in NAMES}


@pytest.mark.parametrize("name", NAMES)
def test_a_workspace_without_a_seed_is_right(name: str) -> None:
    assert told_of(WORKSPACES / name, ()) == []


def test_a_seed_of_each_kind_is_told(workspaces: dict[str, SeededWorkspace]) -> None:
    firsts = {seed.code: seed for seed in reversed(SEEDS) if not seed.missed}
    outcomes = [_outcome(workspaces, firsts[code]) for code in QUICK]
    assert [str(each) for each in outcomes if not each.is_found or each.strays] == []


@pytest.mark.long(3)
def test_seeds_are_told_at_their_lines(workspaces: dict[str, SeededWorkspace]) -> None:
    outcomes = [_outcome(workspaces, seed) for seed in SEEDS]
    missed = [each for each in outcomes if not each.is_found]
    all_of, found_of = _tally(outcomes), _tally(each for each in outcomes if each.is_found)
    shares = {group: found_of[group] / all_of[group] for group in SHARES}
    listed = "\n".join(str(each) for each in missed)
    assert all(shares[group] >= least for group, least in SHARES.items()), f"{shares}\n{listed}"
    unknown = [str(each) for each in missed if not each.seed.missed]
    assert unknown == [], "\n".join(unknown)
    strays = [str(each) for each in outcomes if each.strays]
    assert strays == [], "\n".join(strays)


def test_there_are_ten_seeds_of_each_rule() -> None:
    numbers = Counter(seed.code for seed in SEEDS)
    assert {code: number for code, number in numbers.items() if number < 10} == {}
    assert len(numbers) == 36


def _outcome(workspaces: dict[str, SeededWorkspace], seed: Seed) -> Outcome:
    return workspaces[seed.workspace].outcome(seed)


def _tally(outcomes: Iterator[Outcome] | list[Outcome]) -> Counter[str]:
    return Counter(each.seed.code[:2] for each in outcomes)
