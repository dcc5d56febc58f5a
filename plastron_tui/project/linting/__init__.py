"""Reading a workspace for `plastron lint`: in parallel, and each file only where it has changed."""

from __future__ import annotations

from .reading import read_tree

__all__ = ["read_tree"]
