"""The tree of a robot as rows, the root first.

An only child stands below its parent, not to the right of it: so an arm of many joints is a
straight line, and a row moves to the right only where the tree branches.
"""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.ros.robots.description import Description, Joint
from plastron_tui.ros.robots.tree import branches

MOST_LANES = 40
"""A tree that branches more often than this on one way down goes no farther to the right."""


class TreeRow(NamedTuple):
    """A link, and how it hangs in the tree.

    Attributes:
        link: its name.
        joint: the joint that holds it, None for a root.
        lane: how far it is to the right.
        is_only: whether it is the only child, and so in its parent's lane.
        is_last: whether it is the last of the children that stand to the right of their parent.
        rails: the lanes left of it in which a line goes on down, to others.
    """

    link: str
    joint: Joint | None
    lane: int
    is_only: bool
    is_last: bool
    rails: tuple[int, ...]


def tree_rows(robot: Description) -> list[TreeRow]:
    """Return the rows of all links that hang on a root; those of a second root come last."""
    walk = list(branches(robot))
    # A link that two joints hold is drawn below the first that reaches it.
    counts: dict[str, int] = {}
    for branch in walk:
        if branch.joint is not None:
            counts[branch.joint.parent] = counts.get(branch.joint.parent, 0) + 1
    left = dict(counts)
    rows: list[TreeRow] = []
    lanes: dict[str, int] = {}
    rails: dict[str, tuple[int, ...]] = {}
    for link, joint, _ in walk:
        if joint is None:
            lanes[link], rails[link] = 0, ()
            rows.append(TreeRow(link, None, 0, is_only=False, is_last=False, rails=()))
            continue
        parent = joint.parent
        lane, above = lanes[parent], rails[parent]
        left[parent] -= 1
        is_only, is_last = counts[parent] == 1, left[parent] == 0
        if is_only or lane == MOST_LANES:
            lanes[link], rails[link] = lane, above
        else:
            lanes[link] = lane + 1
            rails[link] = above if is_last else (*above, lane)
        rows.append(TreeRow(link, joint, lanes[link], is_only, is_last and not is_only, above))
    return rows


def lead(row: TreeRow) -> str:
    """Return the lines before a row, in characters; a lane has two columns."""
    if row.joint is None:
        return ""
    rails = "".join("│ " if at in row.rails else "  " for at in range(row.lane))
    if row.is_only:
        return rails + "↓ "
    return rails[:-2] + ("└ " if row.is_last else "├ ")


def unheld(robot: Description, rows: list[TreeRow]) -> list[str]:
    """Return the links that hang on no root: those of a circle, or of a joint without a parent."""
    shown = {row.link for row in rows}
    return [name for name in robot.links if name not in shown]
