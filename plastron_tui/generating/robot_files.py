"""The files of robots: written new, or changed where they are loaded from."""

from __future__ import annotations

from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.robots import Robot, RobotSource
from plastron_tui.output.plan import OutputFile
from plastron_tui.sources.urdf.edits import UrdfEdit, edited
from plastron_tui.sources.xml.outline import MOST_BYTES
from plastron_tui.targets.packages.spec import PackageFile
from plastron_tui.targets.robots.urdf import write_urdf

from .destination import Writing
from .robot_layers import ROBOT_FORM
from .robot_refusals import told_at_sentences
from .text_files import Folder
from .text_layers import changed_file

URDF = ".urdf"


class RobotText(NamedTuple):
    """What a robot's file is called and holds; None with the reason."""

    name: str
    text: bytes | None
    diagnostics: tuple[Diagnostic, ...] = ()


def robot_text(robot: Robot) -> RobotText:
    """Return the text of a robot's file; of a loaded one with what the program changes in it."""
    source = robot.source
    if source is None:
        name, text = f"{robot.stem}{URDF}", write_urdf(robot.description)
        if len(text) > MOST_BYTES:
            return RobotText(name, None, (_too_large(name, len(text)),))
        return RobotText(name, text)
    changed = _with_changes(source.text, robot, source)
    told = changed.diagnostics and tuple(told_at_sentences(robot, changed.diagnostics))
    return RobotText(source.path.name, changed.text, told)


def _too_large(name: str, size: int) -> Diagnostic:
    """Say that a file would be one that nobody could load, change or look at afterwards."""
    message = f"`{name}` would hold {size / 1024**2:.1f} MB, and at most {MOST_BYTES // 1024**2} MB"
    help_ = "describe it as several robots"
    return Diagnostic(codes.FILE_TOO_LARGE, f"{message} are read of a robot", help=help_)


def _with_changes(text: bytes, robot: Robot, source: RobotSource) -> UrdfEdit:
    """Return what a program that loads a robot makes of a text: its changes, and no more."""
    return edited(text, source.description, robot.description, source.path)


def robot_output(
    robot: Robot, named: tuple[str, PackageFile], folder: Folder, writing: Writing
) -> tuple[OutputFile, tuple[Diagnostic, ...]]:
    """Return a changed robot's file as it is to be written, and what is to be said of it.

    Args:
        robot: the robot, which was loaded.
        named: what it is called in the output folder, and what it shall hold.
        folder: the output folder.
        writing: whether it is written over the file that it came from, and what is known of that.
    """
    source = robot.source
    assert source is not None, "the robot was loaded"

    def remade(original: bytes) -> bytes | None:
        return _with_changes(original, robot, source).text

    return changed_file(source, named, remade, folder, writing, ROBOT_FORM)
