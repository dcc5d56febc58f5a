"""Reading programs for `plastron lint`."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.lint.programs import ProgramFacts, units_of
from plastron_tui.project.program_file import check_text
from plastron_tui.session import Session
from plastron_tui.targets import ros_version


def read_program(path: Path, text: bytes) -> ProgramFacts:
    """Return what a program says; nothing of it is generated, whatever ROS is sourced."""
    read = check_text(path, text)
    if read.text is None:
        return ProgramFacts(path, read.diagnostics)
    session = Session(read.text, path, environ={})
    found = (*read.diagnostics, *session.diagnostics)
    diagnostics = tuple(each if each.file else each._replace(file=path) for each in found)
    nodes = session.workspace.nodes.values()
    units = units_of(path, nodes, session.document.lines, session.library, ros_version)
    return ProgramFacts(path, diagnostics, tuple(units))
