from __future__ import annotations

import pytest

from plastron_tui.ros.catalog import DISTRIBUTIONS, Catalog
from plastron_tui.ros.common_types import most_common_first, types_for
from plastron_tui.ros.interfaces import InterfaceKind

_ELSEWHERE = {"nav2_msgs", "move_base_msgs", "control_msgs"}
"""Packages that no catalog has: their types are offered where they are installed."""


@pytest.mark.parametrize("kind", list(InterfaceKind))
def test_what_is_common_exists(kind: InterfaceKind) -> None:
    from plastron_tui.ros.common_types import _listed

    known = {name for each in DISTRIBUTIONS for name in Catalog(each).names(kind)}
    listed = _listed(kind)
    assert len(listed) == len(set(listed)) > 2
    assert {
        name for name in listed if name not in known and name.package not in _ELSEWHERE
    } == set()


@pytest.mark.parametrize("kind", list(InterfaceKind))
def test_no_type_is_lost_or_comes_twice(kind: InterfaceKind) -> None:
    names = Catalog("jazzy").names(kind)
    assert sorted(most_common_first(names, kind)) == list(names)


@pytest.mark.parametrize("word", ["", "a", "the", "sp", "xyzzy", "Twist("])
def test_no_word_of_purpose(word: str) -> None:
    assert (
        types_for(word, Catalog("jazzy").names(InterfaceKind.MESSAGE), InterfaceKind.MESSAGE) == []
    )
