"""Files that two nodes of a program would be written to, each with another text."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Workspace
    from plastron_tui.output.plan import FilePlan

Plan = Callable[[], "tuple[FilePlan, tuple[Diagnostic, ...]]"]
"""Makes the files of a program, and says why one cannot be written."""


def written_twice(workspace: Workspace, plan: Plan) -> Iterator[Diagnostic]:
    """Yield what is wrong where one node is loaded twice and both are written.

    Args:
        workspace: what the program built.
        plan: makes all files of the program; it is asked in such a case only.
    """
    if _is_loaded_twice(workspace):
        # Only the texts tell whether both are the same: then one is written, and nothing is wrong.
        _, found = plan()
        yield from (each for each in found if each.code == codes.SAME_FILE)


def _is_loaded_twice(workspace: Workspace) -> bool:
    """Tell whether a program reads one node from its file twice, and writes both."""
    written = {made.node.variable: made.node.source for made in workspace.generations}
    read = Counter((each.path, each.label) for each in written.values() if each is not None)
    return any(count > 1 for count in read.values())
