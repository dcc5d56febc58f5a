"""Files that are given to a command by mistake: which of another kind they are."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, codes

_MANIFEST = "package.xml"


def other_file(
    file: Path, wanted: str = "a program", code: Code = codes.UNREADABLE_FILE
) -> Diagnostic | None:
    """Say that a file is a launch file, a definition or a manifest, None where it is none.

    Args:
        file: the file, whose name tells.
        wanted: what the command reads.
        code: what the mistake is called.
    """
    if file.suffix == ".plastron" or not file.is_file():
        return None
    found = _kind_of(file)
    if found is None:
        return None
    kind, remedy = found
    return Diagnostic(code, f"`{file.name}` is {kind}, not {wanted}", file=file, help=remedy)


def _kind_of(file: Path) -> tuple[str, str] | None:
    """Return what a file is, and which command or statement takes it."""
    from plastron_tui.ros.interfaces import InterfaceKind
    from plastron_tui.sources.launch.reader import is_launch_file

    if is_launch_file(file):
        return (
            "a launch file",
            "`plastron graph` shows what it starts, `plastron run` starts that, and "
            "`load_launch` changes it in a program",
        )
    if file.name == _MANIFEST:
        return (
            "the manifest of a package",
            "`load_package` and the folder that it is in change the package in a program",
        )
    if file.suffix.removeprefix(".") in {each.value for each in InterfaceKind}:
        return "the definition of a type", "`load_type` changes it in a program"
    return None
