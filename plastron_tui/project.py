"""The project file, `plastron.yaml`: what a project sets for all of its programs."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Severity, Span, did_you_mean
from plastron_tui.ros.catalog import DISTRIBUTIONS

FILE_NAME = "plastron.yaml"
DEFAULT_OUTPUT = "output"

_KEYS = ("target", "distribution", "output", "templates", "types")


class Project(NamedTuple):
    """What the project file says; every path is absolute, or None where it says nothing.

    Attributes:
        file: the project file, None where there is none.
        target: the client library of nodes that name none.
        distribution: the ROS distribution whose types count.
        output: the output folder.
        templates: a folder of templates that go before Plastron's own.
        types: folders with `.msg`, `.srv` and `.action` files.
    """

    file: Path | None = None
    target: str | None = None
    distribution: str | None = None
    output: Path | None = None
    templates: Path | None = None
    types: tuple[Path, ...] = ()


class _Reader:
    """Reads values, and remembers what is wrong with them."""

    def __init__(self, file: Path, marks: dict[str, Span], libraries: Mapping[str, int]) -> None:
        self.file = file
        self.marks = marks
        self.libraries = libraries
        self.diagnostics: list[Diagnostic] = []

    def report(self, key: str, message: str, remedy: str | None = None) -> None:
        self.diagnostics.append(
            Diagnostic("bad-project", message, self.marks.get(key), self.file, help=remedy)
        )

    def choice(self, values: Mapping[str, Any], key: str, choices: Mapping[str, int]) -> str | None:
        value = values.get(key)
        if value is None or value in choices:
            return value
        remedy = did_you_mean(str(value), choices) or f"one of {', '.join(choices)}"
        self.report(key, f"`{key}` cannot be `{value}`", remedy)
        return None

    def folder(self, key: str, value: object) -> Path | None:
        if value is None:
            return None
        if isinstance(value, str) and value and "\0" not in value:
            return self.file.parent / Path(value).expanduser()
        self.report(key, f"`{key}` is to be the path of a folder")
        return None


def find_project(
    folder: Path, libraries: Mapping[str, int]
) -> tuple[Project, tuple[Diagnostic, ...]]:
    """Read the project file of a folder, or of the nearest folder above that has one."""
    for place in (folder, *folder.parents):
        file = place / FILE_NAME
        if file.is_file():
            return read_project(file, libraries)
    return Project(), ()


def read_project(
    file: Path, libraries: Mapping[str, int]
) -> tuple[Project, tuple[Diagnostic, ...]]:
    """Read a project file; what it says wrongly counts as not said."""
    import yaml

    try:
        text = file.read_bytes().decode("utf-8")
        root = yaml.compose(text, Loader=yaml.SafeLoader)
        values = yaml.safe_load(text)
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        return Project(file), (_unreadable(file, error),)
    reader = _Reader(file, _marks(root, text), libraries)
    if values is None:
        return Project(file), ()
    if not isinstance(values, dict):
        reader.report("", "a project file is a list of `key: value` lines")
        return Project(file), tuple(reader.diagnostics)
    for key in values:
        if key not in _KEYS:
            remedy = did_you_mean(str(key), _KEYS) or f"the keys are {', '.join(_KEYS)}"
            reader.report(str(key), f"unknown key `{key}`", remedy)
    types = values.get("types") or []
    folders = [reader.folder("types", entry) for entry in _listed(types)]
    project = Project(
        file,
        reader.choice(values, "target", libraries),
        reader.choice(values, "distribution", DISTRIBUTIONS),
        reader.folder("output", values.get("output")),
        reader.folder("templates", values.get("templates")),
        tuple(found for found in folders if found is not None),
    )
    return project, tuple(reader.diagnostics)


def _listed(value: object) -> list[object]:
    return value if isinstance(value, list) else [value]


def _marks(root: Any, text: str) -> dict[str, Span]:
    """Return where each key of the top level stands, in bytes."""
    pairs = root.value if root is not None and root.id == "mapping" else []
    return {
        str(key.value): Span(
            len(text[: key.start_mark.index].encode()), len(text[: key.end_mark.index].encode())
        )
        for key, _ in pairs
    }


def _unreadable(file: Path, error: Exception) -> Diagnostic:
    mark = getattr(error, "problem_mark", None)
    problem = getattr(error, "problem", None) or str(error)
    where = "" if mark is None else f" (line {mark.line + 1})"
    return Diagnostic(
        "bad-project",
        f"the project file cannot be read{where}: {problem}",
        file=file,
        severity=Severity.ERROR,
    )
