"""Files that are given by mistake where a program is meant: what they are, and what loads them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from plastron_tui.diagnostics import Code, Diagnostic

PROGRAM = "a program"
_MANIFEST = "package.xml"


class OtherKind(NamedTuple):
    """What a file is that is no program.

    Attributes:
        title: what it is, with its article: "a launch file".
        remedy: which command or statement takes it.
        load: the keyword that reads it in a program.
        generate: the keyword that writes it.
    """

    title: str
    remedy: str
    load: str
    generate: str


def other_file(file: Path, wanted: str = PROGRAM, code: Code | None = None) -> Diagnostic | None:
    """Say that a file is of another kind than a command reads, None where it is not.

    Args:
        file: the file, whose name tells.
        wanted: what the command reads; unless that is a program, a node's or a robot's file is
            no mistake.
        code: what the mistake is called; None for a file that cannot be read.
    """
    if not file.is_file():
        return None
    found = other_kind(file)
    if found is None or (wanted != PROGRAM and found.load in ("load", "load_robot")):
        return None
    from plastron_tui.diagnostics import Diagnostic, codes

    message = f"`{file.name}` is {found.title}, not {wanted}"
    return Diagnostic(code or codes.UNREADABLE_FILE, message, file=file, help=found.remedy)


def other_kind(file: Path) -> OtherKind | None:
    """Return what a file is, as its name tells; None for what may be a program."""
    if file.suffix == ".plastron":
        return None
    from plastron_tui.ros.interfaces import InterfaceKind
    from plastron_tui.ros.robots.names import FILE_ENDINGS
    from plastron_tui.sources import own_languages
    from plastron_tui.sources.launch.reader import is_launch_file

    if is_launch_file(file):
        return OtherKind(
            "a launch file",
            "`plastron graph` shows what it starts, `plastron run` starts that, and "
            "`load_launch` changes it in a program",
            "load_launch",
            "generate_launch",
        )
    if file.name == _MANIFEST:
        return OtherKind(
            "the manifest of a package",
            "`load_package` and the folder that it is in change the package in a program",
            "load_package",
            "generate_package",
        )
    if file.suffix.removeprefix(".") in {each.value for each in InterfaceKind}:
        remedy = "`load_type` changes it in a program"
        return OtherKind("the definition of a type", remedy, "load_type", "generate_type")
    if file.suffix in FILE_ENDINGS:
        remedy = "`plastron inspect` shows the robot, and `load_robot` changes it in a program"
        return OtherKind("the description of a robot", remedy, "load_robot", "generate_robot")
    language = next((each for each in own_languages() if file.suffix in each.suffixes), None)
    if language is None:
        return None
    remedy = "`plastron inspect` shows what a node file holds, and `load` changes it in a program"
    return OtherKind(language.title, remedy, "load", "generate_node")


def loading_program(file: Path, kind: OtherKind) -> bytes | None:
    """Return a program beside a file that loads it, and writes it with what is changed.

    None for a file that holds no node, or whose name no program can hold.
    """
    if "'" in file.name or not file.name.isprintable():
        return None
    if kind.load != "load":
        source = "." if file.name == _MANIFEST else file.name
        variable = _variable(_name(file), ())
        return _lines([f"{kind.load} '{source}' as {variable}"], kind, [variable])
    labels = _labels(file)
    variables: list[str] = []
    loads = []
    for label in labels:
        variable = _variable(label or file.stem, variables)
        node = f" node '{label}'" if label and len(labels) > 1 else ""
        loads.append(f"load '{file.name}'{node} as {variable}")
        variables.append(variable)
    return _lines(loads, kind, variables) if loads else None


def program_beside(file: Path) -> Path:
    """Return the path of a program that is called after a file, in its folder."""
    return file.absolute().with_name(f"{_name(file)}.plastron")


def _name(file: Path) -> str:
    """Return what a file is called without its suffixes; a manifest as its package's folder."""
    name = file.absolute().parent.name if file.name == _MANIFEST else file.name
    return name.split(".")[0] or "program"


def _lines(loads: Iterable[str], kind: OtherKind, variables: Iterable[str]) -> bytes:
    writes = [f"{kind.generate} {variable}" for variable in variables]
    return "\n".join([*loads, "", *writes, ""]).encode()


def _labels(file: Path) -> list[str | None]:
    """Return what the nodes of a file are called, as far as they have a name."""
    from plastron_tui.model.source import LARGEST_FILE
    from plastron_tui.regular_files import read_regular

    from .loader import read_node, with_others

    try:
        text = read_regular(file, LARGEST_FILE)
    except (OSError, ValueError):
        return []
    source = read_node(file, with_others(file, text)).source
    return [] if source is None else list(dict.fromkeys(node.label for node in source.nodes))


def _variable(name: str, taken: Iterable[str]) -> str:
    """Return a variable for a thing of a name, other than those that are taken."""
    from plastron_tui.language.keywords import KEYWORDS

    wanted = re.sub(r"\W", "_", name, flags=re.ASCII).strip("_") or "loaded"
    if wanted[0].isdigit() or wanted in KEYWORDS:
        wanted = f"loaded_{wanted}"
    variable, number, known = wanted, 2, frozenset(taken)
    while variable in known:
        variable, number = f"{wanted}_{number}", number + 1
    return variable
