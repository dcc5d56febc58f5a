"""Names for what would otherwise have the name of something else."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count


def numbered(name: str) -> Iterator[str]:
    """Yield a name, then `name_2`, `name_3` and so on, without end."""
    yield name
    for number in count(2):
        yield f"{name}_{number}"
