"""The project file, `plastron.yaml`: what a project sets for all of its programs."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, did_you_mean
from plastron_tui.ros.catalog import DISTRIBUTIONS

FILE_NAME = "plastron.yaml"
DEFAULT_OUTPUT = "output"
LARGEST_PROJECT = 64 * 1024
"""The largest project file that is read, in bytes; one is a few lines."""

_Node = Any
"""A node of PyYAML's tree: its `id` says whether it is a scalar, a sequence or a mapping."""

_KEYS = ("target", "distribution", "output", "templates", "types")
_TEXT, _NULL = "tag:yaml.org,2002:str", "tag:yaml.org,2002:null"


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


def find_project(
    folder: Path, libraries: Mapping[str, int]
) -> tuple[Project, tuple[Diagnostic, ...]]:
    """Read the project file of a folder, or of the nearest folder above that has one."""
    for place in (folder, *folder.parents):
        file = place / FILE_NAME
        if os.path.isfile(file):  # noqa: PTH113 - a folder that may not be read has none
            return read_project(file, libraries)
    return Project(), ()


def read_project(
    file: Path, libraries: Mapping[str, int]
) -> tuple[Project, tuple[Diagnostic, ...]]:
    """Read a project file; what it says wrongly counts as not said.

    Args:
        file: the project file.
        libraries: the client libraries that there are, each with its generation of ROS.
    """
    import yaml

    try:
        with file.open("rb") as stream:
            source = stream.read(LARGEST_PROJECT + 1)
        if len(source) > LARGEST_PROJECT:
            raise ValueError(f"it is larger than {LARGEST_PROJECT // 1024} kB")
        text = source.decode("utf-8")
        root = yaml.compose(text, Loader=yaml.SafeLoader)
    except (OSError, ValueError, RecursionError, yaml.YAMLError) as error:
        return Project(file), (_unreadable(file, error),)
    reader = _Reader(file, text)
    values = reader.pairs(root)
    project = Project(
        file,
        reader.choice("target", values.get("target"), libraries),
        reader.choice("distribution", values.get("distribution"), DISTRIBUTIONS),
        reader.folder("output", values.get("output")),
        reader.folder("templates", values.get("templates"), must_exist=True),
        tuple(reader.folders("types", values.get("types"))),
    )
    reader.check_agreement(project, values.get("distribution"), libraries)
    return project, tuple(reader.diagnostics)


class _Reader:
    """Reads values, and remembers what is wrong with them.

    It reads the tree of the YAML text, and no objects are made of it: so that each mistake has
    its place, and what is written is never guessed to be a date or a number.
    """

    def __init__(self, file: Path, text: str) -> None:
        self.diagnostics: list[Diagnostic] = []
        self._file = file
        self._text = text

    def pairs(self, root: _Node | None) -> dict[str, _Node]:
        """Return the nodes of the keys that there are."""
        values: dict[str, _Node] = {}
        if root is None or root.tag == _NULL:
            return values
        if root.id != "mapping":
            self._report(root, "a project file is a list of `key: value` lines")
            return values
        for key, value in root.value:
            name = key.value if key.id == "scalar" else None
            if name not in _KEYS:
                shown = "this" if name is None else f"`{_short(name)}`"
                remedy = f"the keys are {', '.join(_KEYS)}"
                if name is not None:
                    remedy = did_you_mean(name, _KEYS) or remedy
                self._report(key, f"{shown} is no key of a project file", remedy)
            elif name in values:
                self._report(key, f"`{name}` is set twice")
            else:
                values[name] = value
        return values

    def choice(self, key: str, node: _Node | None, choices: Mapping[str, int]) -> str | None:
        """Return one of the choices, None where nothing (or nothing right) is said."""
        if node is None or node.tag == _NULL:
            return None
        listed = f"`{key}` is one of {', '.join(choices)}"
        if node.id != "scalar":
            self._report(node, f"`{key}` cannot be a {node.id}", listed)
            return None
        value: str = node.value
        if value in choices:
            return value
        self._report(
            node, f"`{key}` cannot be `{_short(value)}`", did_you_mean(value, choices) or listed
        )
        return None

    def folders(self, key: str, node: _Node | None) -> Iterator[Path]:
        """Yield the folders of a list, or of a single entry."""
        entries = [node] if node is None or node.id != "sequence" else node.value
        for entry in entries:
            folder = self.folder(key, entry, must_exist=True)
            if folder is not None:
                yield folder

    def folder(self, key: str, node: _Node | None, *, must_exist: bool = False) -> Path | None:
        """Return the path of a folder, from the project file's own."""
        if node is None or node.tag == _NULL:
            return None
        if node.id != "scalar" or node.tag != _TEXT or not node.value or "\0" in node.value:
            self._report(node, f"`{key}` is to be the path of a folder")
            return None
        # `Path.expanduser` raises for a user that there is none of.
        path: Path = self._file.parent / os.path.expanduser(node.value)  # noqa: PTH111
        if must_exist and not os.path.isdir(path):  # noqa: PTH112 - a path too long is none
            self._report(node, f"there is no folder `{_short(node.value)}`")
            return None
        return path

    def check_agreement(
        self, project: Project, node: _Node | None, libraries: Mapping[str, int]
    ) -> None:
        """Report a distribution that is of another generation of ROS than the target."""
        target, distribution = project.target, project.distribution
        if node is None or target is None or distribution is None:
            return
        wanted = libraries[target]
        if DISTRIBUTIONS[distribution] != wanted:
            fitting = ", ".join(name for name, ros in DISTRIBUTIONS.items() if ros == wanted)
            self._report(
                node,
                f"`{distribution}` is no distribution of ROS {wanted}, which `{target}` is for",
                f"for `{target}` there is {fitting}",
            )

    def _report(self, node: _Node, message: str, remedy: str | None = None) -> None:
        text = self._text
        start, end = node.start_mark.index, node.end_mark.index
        span = Span(len(text[:start].encode()), len(text[:end].rstrip().encode()))
        self.diagnostics.append(Diagnostic("bad-project", message, span, self._file, help=remedy))


def _short(text: str) -> str:
    return text if len(text) <= 40 else f"{text[:40]}…"


def _unreadable(file: Path, error: Exception) -> Diagnostic:
    mark = getattr(error, "problem_mark", None)
    problem = getattr(error, "problem", None) or getattr(error, "strerror", None)
    if isinstance(error, UnicodeDecodeError):
        problem = "it is not UTF-8"
    elif isinstance(error, RecursionError):
        problem = "it is nested too deeply"
    elif problem is None:
        problem = getattr(error, "reason", None) or str(error)
    where = "" if mark is None else f" (line {mark.line + 1})"
    message = f"the project file cannot be read{where}: {problem[:1].lower()}{problem[1:]}"
    return Diagnostic("bad-project", message, file=file)
