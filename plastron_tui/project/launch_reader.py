"""Reading the launch files that a program loads to change them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.launches import LaunchSource, LoadedLaunch

from .named_texts import NamedTexts

if TYPE_CHECKING:
    from plastron_tui.generating.text_layers import Form

_ENDINGS = (".launch", ".xml")
_ONLY_READ = {".py": "Python", ".yaml": "YAML", ".yml": "YAML"}


class LaunchReader:
    """Reads launch files by their paths from the program's folder, within the project."""

    def __init__(self, texts: NamedTexts) -> None:
        """Set what finds and reads files."""
        self._texts = texts

    def __call__(self, source: str) -> LoadedLaunch:
        """Read the file that a `load_launch` asks for."""
        path = self._texts.find(source, lambda each: each.suffix in _ENDINGS)
        if isinstance(path, Diagnostic):
            return LoadedLaunch(None, (path,))
        if path.suffix in _ONLY_READ:
            message = f"a launch file in {_ONLY_READ[path.suffix]} is only read, and not changed"
            remedy = f"`plastron graph {source}` shows it; only one in XML is changed"
            return LoadedLaunch(None, (Diagnostic(codes.EDIT_REFUSED, message, help=remedy),))
        text = self._texts.read(source, path)
        if isinstance(text, Diagnostic):
            return LoadedLaunch(None, (text,))
        from plastron_tui.sources.launch.xml_reader import read_launch_xml

        start = self._texts.started(path, text, _form)
        origin = None if start is None else start.origin
        text = text if start is None else start.text
        read = read_launch_xml(text, path)
        if read.launch is None:
            return LoadedLaunch(None, read.diagnostics)
        found = LaunchSource(path, text, read.format, read.launch, origin)
        return LoadedLaunch(found, read.diagnostics)


def _form() -> Form:
    from plastron_tui.generating.launch_layers import LAUNCH_FORM

    return LAUNCH_FORM
