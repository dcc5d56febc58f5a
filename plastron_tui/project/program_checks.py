"""What is wrong with a program as a whole that no statement of it shows alone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes

from .start_checks import start_problems

if TYPE_CHECKING:
    from plastron_tui.generating.generation import Generated
    from plastron_tui.model.workspace import Generation, Workspace
    from plastron_tui.output.plan import FilePlan

Plan = Callable[[], "tuple[FilePlan, tuple[Diagnostic, ...]]"]
"""Makes the files of a program, and says why one cannot be written."""


def program_problems(
    workspace: Workspace,
    generate: Callable[[Generation], Generated],
    plan: Plan,
    output: Path,
    library: str,
) -> Iterator[Diagnostic]:
    """Yield what launch files name in vain, and files that two nodes would be written to.

    Args:
        workspace: what the program built.
        generate: makes the files of a node.
        plan: makes all files of the program.
        output: the output folder.
        library: the client library of a node that names none.
    """
    yield from start_problems(workspace, generate, output, library)
    if is_loaded_twice(workspace):
        # Only the texts tell whether both are the same: then one is written, and nothing is wrong.
        _, found = plan()
        yield from (each for each in found if each.code == codes.SAME_FILE)


def is_loaded_twice(workspace: Workspace) -> bool:
    """Tell whether a program reads one node from its file twice, and writes both."""
    written = {made.node.variable: made.node.source for made in workspace.generations}
    read = Counter((each.path, each.label) for each in written.values() if each is not None)
    return any(count > 1 for count in read.values())
