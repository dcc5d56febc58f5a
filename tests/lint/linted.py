"""What the tests of the linter's front end share."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from plastron_tui.lint.selection import Selection
from plastron_tui.project.linting.cache import FactCache
from plastron_tui.project.linting.run import LintOptions, LintRun

NO_QUEUE = "import rospy\nfrom std_msgs.msg import String\npub = rospy.Publisher('a', String)\n"
"""A file that breaks RC407 in its third line."""


def write_tree(folder: Path, files: Mapping[str, str | bytes]) -> Path:
    """Write files, and return the folder that they are in."""
    root = folder / "src"
    for name, text in files.items():
        file = root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
    return root


def run_over(root: Path, *select: str, baseline: Path | None = None) -> LintRun:
    """Return a run over a folder, with a cache beside it."""
    cache = FactCache(root, root.parent / "cache")
    return LintRun(LintOptions((root,), Selection(select), baseline, workers=1, cache=cache))


def told(run: LintRun) -> list[tuple[str, int]]:
    """Return the codes of what a run tells, each with its line."""
    found = []
    for each in run.told:
        lines, span = run.lines(each.diagnostic.file), each.diagnostic.span
        line = 0 if lines is None or span is None else lines.line_at(span.start)
        found.append((str(each.rule.code), line))
    return found
