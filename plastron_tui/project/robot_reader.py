"""Reading the robots that a program loads to change them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.robots import LoadedRobot, RobotSource
from plastron_tui.ros.robots.description import Description
from plastron_tui.ros.robots.macros import Arguments
from plastron_tui.ros.robots.names import FILE_ENDINGS

from .named_texts import NamedTexts

if TYPE_CHECKING:
    from plastron_tui.generating.text_layers import Form
    from plastron_tui.sources.urdf.reader import PartPlaces, UrdfRead
    from plastron_tui.sources.xml.document import XmlDocument

_UTF_16 = (b"\xff\xfe", b"\xfe\xff", b"<\0", b"\0<")
"""What XML in that encoding begins with."""

_EXPORT = "export it as URDF from what it was made with"
_OTHER_ROOTS = {
    "sdf": ("a model of Gazebo (SDF), not URDF", _EXPORT),
    "mujoco": ("a model of MuJoCo (MJCF), not URDF", _EXPORT),
    "launch": ("a launch file", "`load_launch` changes it"),
    "package": ("the manifest of a package", "`load_package` and its folder change the package"),
    "COLLADA": ("a mesh", 'a link has it as `shaped mesh "URI"`'),
}
"""What else is in XML, by its outermost element."""


class Expansion(NamedTuple):
    """What the macros of a robot's file make of it; None with the reason.

    Attributes:
        description: the robot.
        diagnostics: what is wrong with it, or the reason.
        asked: the arguments that the macros asked for, or give a default.
        unused: those that they were given, and did not ask for.
        opened: the files that they were looked for in, or that were not there.
    """

    description: Description | None
    diagnostics: tuple[Diagnostic, ...] = ()
    asked: tuple[str, ...] = ()
    unused: tuple[str, ...] = ()
    opened: tuple[Path, ...] = ()


Expander = Callable[[Path, bytes, "XmlDocument", Arguments], Expansion]
"""Expands the macros of a file: its path, its text, what that is in XML, and what it is given."""


class RobotReader:
    """Reads robots by the paths of their files from the program's folder, within the project."""

    def __init__(
        self, texts: NamedTexts, expand: Expander, found: Callable[[Path], None] = lambda _: None
    ) -> None:
        """Set what is asked.

        Args:
            texts: finds and reads files.
            expand: expands their macros.
            found: is told the folders of robots, beside which their meshes may be.
        """
        self._texts = texts
        self._expand = expand
        self._found = found

    def __call__(self, source: str, arguments: Arguments = ()) -> LoadedRobot:
        """Read the file that a `load_robot` asks for.

        Args:
            source: its path, as the program has it.
            arguments: what its macros are given.
        """
        path = self._texts.find(source, lambda each: each.suffix in FILE_ENDINGS)
        if isinstance(path, Diagnostic):
            return LoadedRobot(None, (path,))
        text = self._texts.read(source, path)
        if isinstance(text, Diagnostic):
            return LoadedRobot(None, (text,))
        return self.read_given(source, path, text, arguments)

    def read_given(
        self, source: str, path: Path, text: bytes, arguments: Arguments = ()
    ) -> LoadedRobot:
        """Read what a robot's file holds.

        Args:
            source: what the file is called where it is spoken of.
            path: the file.
            text: what it holds.
            arguments: what its macros are given.
        """
        if b"\0" in text:
            message = f"`{source}` is no text, and so no robot"
            help_text = "it is UTF-16: save it as UTF-8" if text.startswith(_UTF_16) else None
            return LoadedRobot(None, (Diagnostic(codes.UNREADABLE_FILE, message, help=help_text),))
        self._found(path.parent)
        start = self._texts.started(path, text, _form)
        origin = None if start is None else start.origin
        text = text if start is None else start.text
        empty = Description("")
        return self._read(source, path, RobotSource(path, text, empty, origin, arguments=arguments))

    def _read(self, source: str, path: Path, found: RobotSource) -> LoadedRobot:
        from plastron_tui.sources.urdf.macros import has_macros, read_macros
        from plastron_tui.sources.urdf.reader import read_urdf

        read = read_urdf(found.text, path)
        if read.description is None or read.document is None:
            return LoadedRobot(None, _why_none(source, read))
        found = found._replace(description=read.description, spans=_spans(read.places))
        if not has_macros(read.document):
            return LoadedRobot(found, read.diagnostics)
        expansion = self._expand(path, found.text, read.document, found.arguments)
        macros = read_macros(read.document)
        found = found._replace(
            expanded=expansion.description,
            macros=macros,
            opened=expansion.opened,
            computed=_computed(read.places),
        )
        told = (*read.diagnostics, *expansion.diagnostics)
        return LoadedRobot(found, told, expansion.asked, expansion.unused)


def _spans(places: PartPlaces) -> dict[tuple[str, str], Span]:
    """Return where the names of links and joints stand."""
    return {
        (kind, name): attribute.value_span
        for kind, parts in (("link", places.links), ("joint", places.joints))
        for name, element in parts.items()
        if (attribute := element.attribute("name")) is not None
    }


def _computed(places: PartPlaces) -> dict[tuple[str, str], dict[str, tuple[str, int]]]:
    """Return what macros compute of links and joints, as a `RobotSource` has it."""
    from plastron_tui.sources.urdf.values import is_computed

    found: dict[tuple[str, str], dict[str, tuple[str, int]]] = {}
    for kind, parts in (("link", places.links), ("joint", places.joints)):
        for name, part in parts.items():
            values: dict[str, tuple[str, int]] = {}
            inner = [(each, each.name) for each in part.children]
            while inner:
                element, path = inner.pop()
                for attribute in element.attributes:
                    if is_computed(attribute.value):
                        values[f"{path}/{attribute.name}"] = attribute.value, element.line
                inner += ((each, f"{path}/{each.name}") for each in element.children)
            if values:
                found[kind, name] = values
    return found


def _why_none(source: str, read: UrdfRead) -> tuple[Diagnostic, ...]:
    """Say why a file has no robot; of a file of another kind, what it is."""
    known = None if read.document is None else _OTHER_ROOTS.get(read.document.root.name)
    if known is None:
        return read.diagnostics
    kind, remedy = known
    return (Diagnostic(codes.BROKEN_URDF, f"`{source}` is {kind}", help=remedy),)


def _form() -> Form:
    from plastron_tui.generating.robot_layers import ROBOT_FORM

    return ROBOT_FORM
