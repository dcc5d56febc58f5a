from __future__ import annotations

import pytest
from cases import check_each


def test_all_cases_that_fail_are_told() -> None:
    def check(name: str, number: int) -> None:
        assert 12 // number == 4, name

    check_each([("three", 3)], check)
    with pytest.raises(AssertionError, match="3 cases fail") as told:
        check_each([("two", 2), ("three", 3), ("none", 0), ("six", 6)], check)
    for said in ("('two', 2): AssertionError", "('none', 0): ZeroDivision", "('six', 6): Asser"):
        assert said in str(told.value)
    assert "three" not in str(told.value)
