"""Which nodes of a graph one box can stand for, where there is no room for all of them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from .layers import Link

_SHOWN = 5
"""So many nodes that only meet others at one topic are shown one by one."""


class Fold(NamedTuple):
    """Nodes that have only one link each, all of the same hub in the same direction."""

    links: tuple[Link, ...]
    members: tuple[int, ...]


def folds_of(links: Sequence[Link], hubs: frozenset[int]) -> list[Fold]:
    """Return what can be folded: behind the first few, in their order, all such nodes of a hub."""
    degree = Counter(end for link in links for end in link)
    found: dict[tuple[int, bool], list[Link]] = {}
    for link in links:
        from_hub = link.tail in hubs
        hub, node = link if from_hub else link[::-1]
        if degree[node] == 1:
            found.setdefault((hub, from_hub), []).append(link)
    folds = []
    for (hub, _), own in found.items():
        folded = tuple(own[_SHOWN:])
        if len(folded) > 1:
            folds.append(
                Fold(folded, tuple(link.head if link.tail == hub else link.tail for link in folded))
            )
    return folds


def folded_links(links: Iterable[Link], folds: Sequence[Fold], first: int) -> list[Link]:
    """Return the links where one box stands for the members of each fold, the first numbered so."""
    folded = {link for fold in folds for link in fold.links}
    rest = [link for link in links if link not in folded]
    for number, fold in enumerate(folds, first):
        tail, head = fold.links[0]
        rest.append(Link(tail, number) if head in fold.members else Link(number, head))
    return rest
