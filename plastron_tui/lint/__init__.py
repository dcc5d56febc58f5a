"""Rules over the packages, nodes and launch files of a workspace: what is wrong between them.

All here is a function of facts that were read before (`project/linting`): no rule opens a file.
"""

from __future__ import annotations

from .engine import Found, lint
from .rule import Rule

__all__ = ["Found", "Rule", "lint"]
