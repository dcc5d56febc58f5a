"""Tables of cases that one test goes through: pytest takes longer for a test than most cases do."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any


def check_each(cases: Iterable[tuple[Any, ...]], check: Callable[..., None]) -> None:
    """Check each case, and tell all that fail.

    Raises:
        AssertionError: some fail; it comes from the first of their errors.
    """
    told = [(case, error) for case in cases if (error := _error_of(check, case)) is not None]
    if told:
        said = "\n".join(f"{case}: {type(error).__name__}: {error}" for case, error in told)
        raise AssertionError(f"{len(told)} cases fail:\n{said}") from told[0][1]


def _error_of(check: Callable[..., None], case: tuple[Any, ...]) -> Exception | None:
    try:
        check(*case)
    # Whatever is raised is a failure of this case, and not the end of the others.
    except Exception as error:
        return error
    return None
