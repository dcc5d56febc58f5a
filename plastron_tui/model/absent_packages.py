"""Types whose package is not installed in the ROS that is to run the nodes."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.language import DECLARATIONS
from plastron_tui.language.declaration import Statement
from plastron_tui.language.lowering import Program
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .context import Setting
from .kinds import INTERFACES
from .workspace import Workspace

_KINDS: dict[type[Statement], InterfaceKind] = {
    type_: INTERFACES[slot.kind]
    for type_, declaration in DECLARATIONS.items()
    for slot in declaration.slots
    if slot.name == "type" and slot.kind in INTERFACES
}
"""The statements that name a type of a package, and of which kind it is."""

Resolve = Callable[[str, InterfaceKind, int], "InterfaceName | None"]
"""Returns the full name of a type in a generation of ROS, None for what is none."""


def absent_packages(
    program: Program, workspace: Workspace, setting: Setting, resolve: Resolve
) -> Iterator[Diagnostic]:
    """Yield a warning at the first type of each package that is not installed.

    Nodes that a package has to build are left out: what they need, the build says.

    Args:
        program: the statements.
        workspace: what they have built.
        setting: tells what is not installed, if anybody wants to know.
        resolve: returns the full name of a type.
    """
    if setting.absent is None:
        return
    known: set[tuple[str, InterfaceKind, int]] = set()
    told: set[tuple[int, str]] = set()
    for statement in program.statements:
        kind = _KINDS.get(type(statement))
        if kind is None:
            continue
        node = workspace.nodes.get(getattr(statement, "node", ""))
        library = setting.library if node is None or node.library is None else node.library
        if library not in setting.libraries or setting.libraries[library].is_built:
            continue
        text: str = getattr(statement, "type")  # noqa: B009 - each of these statements has it
        use = text, kind, setting.ros_version(library)
        if use in known:
            continue
        known.add(use)
        name = resolve(*use)
        if name is None or (use[2], name.package) in told:
            continue
        told.add((use[2], name.package))
        found = setting.absent(use[2], name.package)
        if found is not None:
            yield found._replace(span=statement.span_of("type"), severity=Severity.WARNING)
