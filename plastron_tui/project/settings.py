"""The project file, `plastron.yaml`: what a project sets for all of its programs."""

from __future__ import annotations

import os
from collections.abc import Collection, Container, Iterable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from plastron_tui.boundary import Boundary, belongs_to_another
from plastron_tui.diagnostics import Code, Diagnostic, Severity, Span, codes, did_you_mean
from plastron_tui.model.libraries import Libraries
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.catalog import DISTRIBUTIONS
from plastron_tui.trust import real_path

from .lint_settings import LintSettings, read_lint

LARGEST_PROJECT = 64 * 1024
"""The largest project file that is read, in bytes; one is a few lines."""

TRUST_CODES = frozenset(
    {
        codes.FOREIGN_PROJECT,
        codes.OUTSIDE_PROJECT,
        codes.UNTRUSTED_MACROS,
        codes.UNTRUSTED_TEMPLATES,
    }
)
"""The codes of what the user has to trust the project for."""

LONGEST_PATH = 4096
"""The longest path of a folder, in characters, as Linux has it."""

MOST_FOLDERS = 100
"""The most folders of types; each is searched."""

MOST_MISTAKES = 20
"""The most mistakes that are reported one by one; the rest is counted."""

_Node = Any
"""A node of PyYAML's tree: its `id` says whether it is a scalar, a sequence or a mapping."""

_KEYS = (
    "target", "distribution", "output", "file_names", "templates", "types", "launch", "cpp", "lint"
)  # fmt: skip
_LAUNCH = ("xml", "python")
_CPP = ("single", "split")
_FILE_NAMES = ("ending", "plain")
_TEXT, _NULL = "tag:yaml.org,2002:str", "tag:yaml.org,2002:null"


class Project(NamedTuple):
    """What the project file says; every path is absolute, or None where it says nothing.

    Attributes:
        file: the project file, None where there is none.
        target: the client library of nodes that name none.
        distribution: the ROS distribution whose types count.
        output: the output folder.
        file_names: how new files of created nodes are called: `plain`, as the node is; `ending`,
            with what it does behind that, as where nothing is said.
        templates: a folder of templates that go before Plastron's own.
        types: folders with `.msg`, `.srv` and `.action` files.
        launch: what new launch files of ROS 2 are written in: `python`; `xml`, as where nothing
            is said.
        cpp: whether a new node in C++ has its class in a header: `split`, or `single`; None for
            what is usual for its client library.
        lint: what it sets for `plastron lint`.
    """

    file: Path | None = None
    target: str | None = None
    distribution: str | None = None
    output: Path | None = None
    file_names: str | None = None
    templates: Path | None = None
    types: tuple[Path, ...] = ()
    launch: str | None = None
    cpp: str | None = None
    lint: LintSettings = LintSettings()

    @property
    def layouts(self) -> dict[str, str]:
        """How many files a new node has in languages that leave it open, by language."""
        return {} if self.cpp is None else {"cpp": self.cpp}


def find_project(
    boundary: Boundary, libraries: Libraries, overruled: Container[str] = ()
) -> tuple[Project, tuple[Diagnostic, ...]]:
    """Read the project file of a project; one that is another user's has to be trusted first.

    Args:
        boundary: the project.
        libraries: the client libraries that there are.
        overruled: the keys that the command line overrules, and that are therefore not judged.
    """
    file = boundary.project_file
    if file is None:
        return Project(), ()
    try:
        is_foreign = belongs_to_another(file)
    except OSError as error:
        return Project(file), (_unreadable(file, error),)
    if is_foreign and not boundary.is_trusted:
        return Project(file), (_foreign(file, boundary),)
    return read_project(file, libraries, boundary, overruled)


def read_project(
    file: Path,
    libraries: Libraries,
    boundary: Boundary,
    overruled: Container[str] = (),
) -> tuple[Project, tuple[Diagnostic, ...]]:
    """Read a project file; what it says wrongly counts as not said.

    Nor does what leads out of the project, nor do templates, until the user trusts the project.

    Args:
        file: the project file.
        libraries: the client libraries that there are.
        boundary: the project.
        overruled: the keys that the command line overrules.
    """
    import yaml

    try:
        text = read_regular(file, LARGEST_PROJECT).decode("utf-8")
        root = yaml.compose(text, Loader=yaml.SafeLoader)
    except (OSError, ValueError, OverflowError, RecursionError, yaml.YAMLError) as error:
        return Project(file), (_unreadable(file, error),)
    reader = _Reader(file, text, boundary, overruled)
    values = reader.pairs(root)
    project = Project(
        file,
        reader.choice("target", values.get("target"), libraries),
        reader.choice("distribution", values.get("distribution"), DISTRIBUTIONS),
        reader.folder("output", values.get("output")),
        reader.choice("file_names", values.get("file_names"), _FILE_NAMES),
        reader.templates(values.get("templates")),
        tuple(reader.folders("types", values.get("types"))),
        reader.choice("launch", values.get("launch"), _LAUNCH),
        reader.choice("cpp", values.get("cpp"), _CPP),
        read_lint(reader, values.get("lint")),
    )
    reader.check_agreement(project, values.get("distribution"), libraries)
    return project, reader.found()


class _Reader:
    """Reads values, and remembers what is wrong with them.

    It reads the tree of the YAML text, and no objects are made of it: so that each mistake has
    its place, and what is written is never guessed to be a date or a number.
    """

    def __init__(
        self, file: Path, text: str, boundary: Boundary, overruled: Container[str]
    ) -> None:
        self.diagnostics: list[Diagnostic] = []
        self._file = file
        self._text = text
        self._boundary = boundary
        self._overruled = overruled

    def found(self) -> tuple[Diagnostic, ...]:
        """Return what is wrong; of many mistakes the first."""
        more = len(self.diagnostics) - MOST_MISTAKES
        if more <= 0:
            return tuple(self.diagnostics)
        last = Diagnostic(codes.BAD_PROJECT, f"… and {more} more mistakes", file=self._file)
        return (*self.diagnostics[:MOST_MISTAKES], last)

    def pairs(
        self, root: _Node | None, keys: Collection[str] = _KEYS, of: str = "a project file"
    ) -> dict[str, _Node]:
        """Return the nodes of the keys that there are."""
        values: dict[str, _Node] = {}
        if root is None or root.tag == _NULL:
            return values
        if root.id != "mapping":
            self.report(root, f"{of} is a list of `key: value` lines")
            return values
        for key, value in root.value:
            name: str | None = key.value if key.id == "scalar" else None
            if name is None or name not in keys:
                shown = "this" if name is None else f"`{_short(name)}`"
                remedy = f"the keys are {', '.join(keys)}"
                if name is not None:
                    remedy = did_you_mean(name, keys) or remedy
                self.report(key, f"{shown} is no key of {of}", remedy)
            elif name in values:
                self.report(key, f"`{name}` is set twice")
            else:
                values[name] = value
        return values

    def choice(self, key: str, node: _Node | None, choices: Collection[str]) -> str | None:
        """Return one of the choices, None where nothing (or nothing right) is said."""
        if node is None or node.tag == _NULL:
            return None
        listed = f"`{key}` is one of {', '.join(choices)}"
        if node.id != "scalar":
            self.report(node, f"`{key}` cannot be a {node.id}", listed)
            return None
        value: str = node.value
        if value in choices:
            return value
        self.report(
            node, f"`{key}` cannot be `{_short(value)}`", did_you_mean(value, choices) or listed
        )
        return None

    def folders(self, key: str, node: _Node | None) -> Iterator[Path]:
        """Yield the folders of a list, or of a single entry."""
        entries = [node] if node is None or node.id != "sequence" else node.value
        for entry in entries[MOST_FOLDERS:][:1]:
            self.report(entry, f"`{key}` lists more than {MOST_FOLDERS} folders")
        for entry in entries[:MOST_FOLDERS]:
            folder = self.folder(key, entry, must_exist=True)
            if folder is not None:
                yield folder

    def folder(
        self, key: str, node: _Node | None, *, must_exist: bool = False, what: str = "folder"
    ) -> Path | None:
        """Return the path of a folder, or of a file, from the project file's own."""
        if node is None or node.tag == _NULL:
            return None
        if node.id != "scalar" or node.tag != _TEXT or not node.value or "\0" in node.value:
            self.report(node, f"`{key}` is to be the path of a {what}")
            return None
        if len(node.value) > LONGEST_PATH:
            self.report(node, f"the path of a {what} has at most {LONGEST_PATH} characters")
            return None
        # `Path.expanduser` raises for a user that there is none of.
        path: Path = self._file.parent / os.path.expanduser(node.value)  # noqa: PTH111
        if key not in self._overruled and not self._boundary.allows(path):
            self.report(node, *_outside(key, path, self._boundary), code=codes.OUTSIDE_PROJECT)
            return None
        if must_exist and not os.path.isdir(path):  # noqa: PTH112 - a path too long is none
            self.report(node, f"there is no folder `{_short(node.value)}`")
            return None
        return path

    def templates(self, node: _Node | None) -> Path | None:
        """Return the folder of templates, None where there is none that the user trusts."""
        folder = self.folder("templates", node, must_exist=True)
        if folder is None or self._boundary.is_trusted:
            return folder
        message = "the templates of the project are not used until you trust it"
        self.report(node, message, self._boundary.remedy, codes.UNTRUSTED_TEMPLATES)
        return None

    def check_agreement(self, project: Project, node: _Node | None, libraries: Libraries) -> None:
        """Report a distribution that is of another generation of ROS than the target."""
        target, distribution = project.target, project.distribution
        if node is None or target is None or distribution is None:
            return
        wanted = libraries[target].ros_version
        if DISTRIBUTIONS[distribution] != wanted:
            fitting = ", ".join(name for name, ros in DISTRIBUTIONS.items() if ros == wanted)
            self.report(
                node,
                f"`{distribution}` is no distribution of ROS {wanted}, which `{target}` is for",
                f"for `{target}` there is {fitting}",
            )

    def report(
        self,
        node: _Node,
        message: str,
        remedy: str | None = None,
        code: Code = codes.BAD_PROJECT,
    ) -> None:
        """Report a node that is wrong."""
        found = Diagnostic(code, message, self.span(node), self._file, help=remedy)
        self.diagnostics.append(found)

    def span(self, node: _Node) -> Span:
        """Return the bytes of a node."""
        text = self._text
        start, end = node.start_mark.index, node.end_mark.index
        return Span(len(text[:start].encode()), len(text[:end].rstrip().encode()))


def as_error(found: Diagnostic) -> Diagnostic:
    """Let what is not trusted stand against writing."""
    return found._replace(severity=Severity.ERROR) if found.code in TRUST_CODES else found


def outside_output(output: Path, boundary: Boundary) -> Diagnostic:
    """Say that the output folder, which nobody named, is a link out of the project."""
    message, remedy = _outside("output", output, boundary)
    return Diagnostic(codes.OUTSIDE_OUTPUT, message, file=output, help=remedy)


def outside_program(path: Path, boundary: Boundary) -> Diagnostic | None:
    """Return why a program is not to be written: it is a link out of its folder's project.

    A file that is no link is where the user said; a link is where somebody else may have said.
    """
    if not path.is_symlink() or boundary.allows(path):
        return None
    message = f"`{path.name}` is a link to a file {boundary.place_of(path)}"
    remedy = f"name the file itself; or {boundary.remedy}"
    return Diagnostic(codes.OUTSIDE_PROJECT, message, file=path, help=remedy)


def outside_definition(
    file: Path, folders: Iterable[Path], boundary: Boundary
) -> Diagnostic | None:
    """Return why a definition is not read: on the way to it a link leads out of the project.

    Args:
        file: the definition.
        folders: the folders of types; one that has the file in it is allowed itself.
        boundary: the project.
    """
    if not any(_is_really_in(file, folder) for folder in folders) and not boundary.allows(file):
        message = f"the definition `{file.name}` is {boundary.place_of(file)}, and is not read"
        warning = Severity.WARNING
        return Diagnostic(
            codes.OUTSIDE_PROJECT, message, file=file, help=boundary.remedy, severity=warning
        )
    return None


def _is_really_in(file: Path, folder: Path) -> bool:
    """Tell whether no link is on the way from a folder to a file."""
    if not file.is_relative_to(folder):
        return False
    return real_path(file) == real_path(folder) / file.relative_to(folder)


def _outside(key: str, path: Path, boundary: Boundary) -> tuple[str, str]:
    """Say that a folder leads out of the project, and what to do."""
    own_word = "; or name the folder with `-o`" if key == "output" else ""
    return f"`{key}` is {boundary.place_of(path)}", f"{boundary.remedy}{own_word}"


def _foreign(file: Path, boundary: Boundary) -> Diagnostic:
    return Diagnostic(
        codes.FOREIGN_PROJECT,
        "the project file, or the folder that it is in, belongs to another user",
        file=file,
        help=boundary.remedy,
    )


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
    return Diagnostic(codes.BAD_PROJECT, message, file=file)
