"""The lanes in which lines turn, so that no two run upon each other and few cross.

Between two columns a net comes in at some rows on the left, runs up or down in a lane, and goes
out at some rows on the right. Where one net comes in at the row at which another goes out, the
first has to turn before the other does; as with the channels of a printed circuit, such demands
can run in a circle.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class Turn(NamedTuple):
    """The rows at which a net comes in from the left, and goes out to the right."""

    lefts: tuple[int, ...]
    rights: tuple[int, ...]

    @property
    def is_level(self) -> bool:
        """Whether the net runs straight through and needs no lane."""
        return len({*self.lefts, *self.rights}) == 1


class Lanes(NamedTuple):
    """The lane of each net from left to right, 0 for one that runs straight through.

    `circle` has the nets for which there are no lanes: each would have to turn before the next.
    """

    numbers: tuple[int, ...]
    circle: tuple[int, ...] = ()


def lanes_of(turns: Sequence[Turn]) -> Lanes:
    """Return the lanes of nets, as few and with as few crossings as a quick look finds."""
    lanes = [0] * len(turns)
    placed: list[int] = []
    spans = [(min(turn.lefts + turn.rights), max(turn.lefts + turn.rights)) for turn in turns]
    order, circle = _ordered(turns, spans)
    for number in order:
        top, bottom = spans[number]
        taken = [
            lanes[other] for other in placed if spans[other][0] <= bottom and top <= spans[other][1]
        ]
        lanes[number] = max(taken, default=-1) + 1
        placed.append(number)
    return Lanes(tuple(lanes), tuple(circle))


def _ordered(
    turns: Sequence[Turn], spans: Sequence[tuple[int, int]]
) -> tuple[list[int], list[int]]:
    """Return the nets that turn, and those that cannot.

    Who has to be first is first, then who crosses few others so.
    """
    rest = [number for number, turn in enumerate(turns) if not turn.is_level]
    entering = {row: number for number in rest for row in turns[number].lefts}
    # A net waits for those that come in where it goes out.
    waits = {
        number: {entering[row] for row in turns[number].rights if row in entering} - {number}
        for number in rest
    }
    # What a net crosses of another: as the first of the two, and as the second.
    first = {one: [_inside(turns[one].rights, spans[other]) for other in rest] for one in rest}
    second = {one: [_inside(turns[one].lefts, spans[other]) for other in rest] for one in rest}
    places = {number: at for at, number in enumerate(rest)}

    def saved(one: int, other: int) -> int:
        """Return how many crossings fewer there are if the one net turns before the other."""
        here, there = places[one], places[other]
        return second[one][there] + first[other][here] - first[one][there] - second[other][here]

    gain = {one: sum(saved(one, other) for other in rest) for one in rest}
    order = []
    while rest:
        free = [number for number in rest if not waits[number]]
        if not free:
            break
        chosen = max(free, key=gain.__getitem__)
        order.append(chosen)
        rest.remove(chosen)
        for number in rest:
            waits[number].discard(chosen)
            gain[number] -= saved(number, chosen)
    return order, rest


def _inside(rows: Sequence[int], span: tuple[int, int]) -> int:
    """Count the rows within a span, its ends left out."""
    top, bottom = span
    return sum(top < row < bottom for row in rows)
