"""What is found out of a whole workspace is found once, and goes with it."""

from __future__ import annotations

import gc
import weakref
from pathlib import Path

from plastron_tui.lint.tree import SourceTree, once_a_tree


class _Found:
    """Something of which a weak reference tells whether it is still there."""


def test_a_tree_is_asked_once_and_not_kept() -> None:
    @once_a_tree
    def find(tree: SourceTree) -> tuple[SourceTree, _Found]:
        return tree, _Found()

    one, other = SourceTree(Path("/one")), SourceTree(Path("/other"))
    assert find(one) is find(one)
    assert find(other)[0] is other
    assert find(one)[0] is one
    kept = weakref.ref(find(one)[1])
    del one
    gc.collect()
    assert kept() is None


def test_two_that_ask_are_kept_apart() -> None:
    names = once_a_tree(lambda tree: tree.root.name)
    lengths = once_a_tree(lambda tree: len(tree.root.name))
    tree = SourceTree(Path("/workspace"))
    assert (names(tree), lengths(tree)) == ("workspace", 9)
