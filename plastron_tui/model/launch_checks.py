"""What keeps launch files from being written, once a program has come to its end."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Diagnostic, codes

from .launches import Launch
from .workspace import Workspace


def in_no_package(launch: Launch) -> Iterator[Diagnostic]:
    """Yield an error for each node that a launch file starts and that no package contains."""
    for start in launch.starts.values():
        if start.node is not None and start.node.home is None:
            variable = start.node.variable
            yield Diagnostic(
                codes.IN_NO_PACKAGE,
                f"`{variable}` is in no package, and a launch file starts what packages have",
                start.where,
                help=f"put it into one: `PACKAGE contains {variable}`",
            )


def check_launches(workspace: Workspace) -> Iterator[Diagnostic]:
    """Yield what keeps launch files from being written that a program writes."""
    written = {each.launch.variable: each.launch for each in workspace.written_launches}
    for each in workspace.written_packages:
        for variable, contained in each.package.contents.items():
            if isinstance(contained.item, Launch):
                written[variable] = contained.item
    for launch in written.values():
        yield from in_no_package(launch)
