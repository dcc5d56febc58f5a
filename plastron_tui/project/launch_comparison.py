"""What a launch file starts, compared with what the program that wrote it said.

A launch file that was changed by hand is what is started; how it differs is told, since the
program no longer shows it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes
from plastron_tui.output.manifest import NAME, load_manifest
from plastron_tui.ros.launch import LaunchFile
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_started import Opened, Started
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.parameter_values import yaml_text
from plastron_tui.sources.launch.reader import read_launch

_HIGHEST = 6
"""How many folders above a launch file are looked at for the manifest that knows it."""

_SHOWN = frozenset(("output", "emulate_tty"))
"""What says how the lines of a node are shown, and nothing of what runs."""


class _Written(NamedTuple):
    """What a program wrote as a launch file, and the folder of its output."""

    folder: Path
    program: str
    text: bytes


class _Starts(NamedTuple):
    """What a launch file starts, and the files that it includes."""

    nodes: tuple[Started, ...]
    included: tuple[str, ...]


def differences(
    launch: LaunchFile, text: bytes, file: Path, ros_version: int, arguments: Mapping[str, str]
) -> tuple[Diagnostic, ...]:
    """Return a warning for each thing that a launch file starts otherwise than its program said.

    There is none for a file that no program wrote.

    Args:
        launch: what the file says.
        text: the text of the file.
        file: its path.
        ros_version: the generation of ROS that it is for.
        arguments: the values that its arguments get.
    """
    written = _written(Path(os.path.realpath(file)))
    if written is None or written.text == text:
        return ()
    said = read_launch(written.text, file).launch
    if said is None:
        return ()
    now = _starts(launch, file, ros_version, arguments)
    then = _starts(said, file, ros_version, arguments)
    return tuple(_compared(now, then, file, written.program))


class Author(NamedTuple):
    """The program that wrote a launch file, and the folder of its output."""

    program: Path
    output: Path


def author_of(file: Path) -> Author | None:
    """Return the program that wrote a launch file, None where it is not found by the output."""
    written = _written(Path(os.path.realpath(file)))
    if written is None or Path(written.program).name != written.program:
        return None
    places = (written.folder.parent, written.folder)
    found = (each / written.program for each in places)
    program = next((each for each in found if each.is_file()), None)
    return None if program is None else Author(program, written.folder)


def _written(file: Path) -> _Written | None:
    """Return what a program wrote as a file, None where none is known to have written it."""
    for folder in file.parents[:_HIGHEST]:
        if not (folder / NAME).is_file():
            continue
        base = load_manifest(folder)[0].bases.get(file.relative_to(folder).as_posix(), {})
        program, text = base.get("program"), base.get("text")
        if isinstance(program, str) and isinstance(text, str):
            return _Written(folder, program, text.encode("utf-8", "surrogatepass"))
    return None


def _starts(
    launch: LaunchFile, file: Path, ros_version: int, arguments: Mapping[str, str]
) -> _Starts:
    included: list[str] = []

    def opened(path: str) -> Opened:
        included.append(path)
        return Opened(None, ros_version, "", "only its name is compared")

    # A package is in the same folder for both, wherever that is.
    scope = Scope(arguments, os.environ, str(file.absolute().parent), lambda name: f"/{name}", str)
    found = resolve(launch, ros_version, scope, str(file), opened)
    return _Starts(found.started, tuple(included))


def _compared(now: _Starts, then: _Starts, file: Path, program: str) -> Iterator[Diagnostic]:
    def told(message: str, node: Started | None = None) -> Diagnostic:
        place = None if node is None else node.place
        return Diagnostic(
            codes.LAUNCH_DIFFERS,
            message,
            None if place is None else Span(place.start, place.end),
            file,
            severity=Severity.WARNING,
        )

    waiting = list(then.nodes)
    pairs: list[tuple[Started, Started]] = []
    for alike in (_full, _name, _executable):
        taken = [node for node, _ in pairs]
        for node in now.nodes:
            if any(node is each for each in taken):
                continue
            other = next((each for each in waiting if alike(each) == alike(node)), None)
            if other is not None:
                waiting = [each for each in waiting if each is not other]
                pairs.append((node, other))
    partners = {id(node): other for node, other in pairs}
    for node in now.nodes:
        if id(node) not in partners:
            yield told(f"`{_shown(node)}` is started, which `{program}` did not write", node)
            continue
        for what, here, there in _aspects(node, partners[id(node)]):
            said = f"{what} of `{_shown(node)}` is {_value(here)}"
            yield told(f"{said}, and {_value(there)} as `{program}` wrote it", node)
    for node in waiting:
        yield told(f"`{_shown(node)}` is not started, as `{program}` wrote it")
    for path in now.included:
        if path not in then.included:
            yield told(f"`{path}` is included, which `{program}` did not write")
    for path in then.included:
        if path not in now.included:
            yield told(f"`{path}` is not included, as `{program}` wrote it")


def _full(node: Started) -> object:
    return node.package, node.executable, node.namespace, node.name


def _name(node: Started) -> object:
    return node.namespace, node.name or node.executable


def _executable(node: Started) -> object:
    return node.package, node.executable


def _shown(node: Started) -> str:
    return node.full_name or f"{node.namespace}/{node.executable}"


def _value(value: str | None) -> str:
    return "not set" if value is None else f"`{value}`"


def _aspects(here: Started, there: Started) -> Iterator[tuple[str, str | None, str | None]]:
    """Yield what differs between two nodes: what it is, and its value in either."""
    before, now = _facts(there), _facts(here)
    for what in dict.fromkeys((*now, *before)):
        if now.get(what) != before.get(what):
            yield what, now.get(what), before.get(what)


def _facts(node: Started) -> dict[str, str]:
    """Return what makes a difference to how a node runs, by the words for it."""
    found = {"the executable": f"{node.package}/{node.executable}"}
    if node.name is not None:
        found["the name"] = node.name
    found["the namespace"] = node.namespace or "/"
    if node.container is not None:
        found["the container"] = node.container
    for old, new in reversed(node.remaps):
        found[f"the remap of `{old}`"] = new
    for name, value in node.parameters:
        found[f"the parameter `{name}`"] = yaml_text(value)
    if node.files:
        found["the parameter file"] = " ".join(node.files)
    for key, text in node.others:
        if key not in _SHOWN:
            found[f"`{key}`"] = text
    return found
