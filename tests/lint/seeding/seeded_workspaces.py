"""Defects put into workspaces: what is changed, where it is to be told, and what lint says."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

from click.testing import CliRunner

from plastron_tui.cli.lint import command

WORKSPACES = Path(__file__).parent / "workspaces"
HERE = "§"
"""Stands in a replacement on the line at which the defect may be told."""


class Edit(NamedTuple):
    """Text of a file that something else stands for.

    Without `old` the file is made anew, without `new` it is removed.
    """

    file: str
    old: str | None
    new: str | None


class Seed(NamedTuple):
    """One defect."""

    code: str
    workspace: str
    edits: tuple[Edit, ...]
    places: tuple[tuple[str, str], ...] = ()
    """Files, and a text that stands once in each, on whose line it may be told as well."""

    also: tuple[str, ...] = ()
    """Codes of what the defect surely breaks besides."""

    options: tuple[str, ...] = ()
    """What `plastron lint` is called with."""

    not_executable: str = ""
    """A file that loses the permission to be run."""

    missed: str = ""
    """Why lint does not tell it; it counts as missed."""

    @property
    def label(self) -> str:
        """What a reader of the table finds it by."""
        edit = self.edits[0]
        old, new = (edit.old or "").splitlines(), (edit.new or "").splitlines()
        text = next((line for line in new if line.strip() and line not in old), None)
        if text is None:
            text = "without " + next((line.strip() for line in old if line not in new), "a file")
        return f"{self.code} {self.workspace}/{edit.file}: {text.strip()[:70]}"


class Finding(NamedTuple):
    """A problem that lint tells."""

    code: str
    file: str
    line: int
    message: str


class Outcome(NamedTuple):
    """What lint says of a seed."""

    seed: Seed
    places: frozenset[tuple[str, int]]
    told: tuple[Finding, ...]

    @property
    def is_found(self) -> bool:
        """Tell whether the defect is told in one of its places."""
        return any(
            each.code == self.seed.code and (each.file, each.line) in self.places
            for each in self.told
        )

    @property
    def strays(self) -> tuple[Finding, ...]:
        """What is told besides, and is not wrong."""
        return tuple(
            each for each in self.told if each.code not in (self.seed.code, *self.seed.also)
        )

    def __str__(self) -> str:
        """Return what was sought, and what was told."""
        at = " or ".join(f"{file}:{line}" for file, line in sorted(self.places))
        said = "".join(f"\n      told: {' '.join(map(str, each))}" for each in self.told)
        return f"{self.seed.label}\n      sought: {at}{said}"


class SeededWorkspace:
    """A copy of a workspace that takes one seed after another."""

    def __init__(self, source: Path, copy: Path) -> None:
        shutil.copytree(source, copy, symlinks=True)
        for command_of_git in (("init", "-q"), ("add", "-A"), ("commit", "-qm", "before")):
            subprocess.run(
                [
                    "git",
                    "-c",
                    "user.name=Mira",
                    "-c",
                    "user.email=mira@example.org",
                    *command_of_git,
                ],
                cwd=copy,
                check=True,
            )
        self.root = copy.resolve()
        self._before: dict[tuple[str, ...], list[Finding]] = {}

    def told_before(self, options: tuple[str, ...] = ()) -> list[Finding]:
        """Return what lint says of it without a seed."""
        if options not in self._before:
            self._before[options] = told_of(self.root, options)
        return self._before[options]

    def outcome(self, seed: Seed) -> Outcome:
        """Return what lint says with the seed in it, and not without."""
        before = {(each.code, each.file, each.message) for each in self.told_before(seed.options)}
        with self.broken(seed) as places:
            told = told_of(self.root, seed.options)
        return Outcome(
            seed,
            places,
            tuple(each for each in told if (each.code, each.file, each.message) not in before),
        )

    @contextmanager
    def broken(self, seed: Seed) -> Iterator[frozenset[tuple[str, int]]]:
        """Break the workspace, and mend it again; it gives where the defect may be told.

        Raises:
            ValueError: a text does not stand in its file exactly once.
        """
        files = {edit.file for edit in seed.edits}
        before = {each: _bytes_of(self.root / each) for each in files}
        places: set[tuple[str, int]] = set()
        try:
            for edit in seed.edits:
                self._change(edit)
            if seed.not_executable:
                (self.root / seed.not_executable).chmod(0o644)
            places = {place for each in files for place in self._marked(each)}
            for file, text in seed.places:
                places.add((file, _line_of(self.root / file, text)))
            yield frozenset(places)
        finally:
            for each, data in before.items():
                path = self.root / each
                if data is None:
                    path.unlink(missing_ok=True)
                else:
                    path.parent.mkdir(parents=True, exist_ok=True)
                    path.write_bytes(data)
            if seed.not_executable:
                (self.root / seed.not_executable).chmod(0o755)

    def _change(self, edit: Edit) -> None:
        path = self.root / edit.file
        if edit.new is None:
            path.unlink()
            return
        old = edit.old or ""
        before = path.read_bytes().decode() if edit.old is not None else ""
        if old and before.count(old) != 1:
            raise ValueError(f"{edit.file}: {old!r} stands {before.count(old)} times")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(before.replace(old, edit.new, 1).encode())

    def _marked(self, file: str) -> Iterator[tuple[str, int]]:
        path = self.root / file
        if path.is_file():
            text = path.read_bytes().decode()
            path.write_bytes(text.replace(HERE, "").encode())
            yield from ((file, at) for at, line in enumerate(text.split("\n"), 1) if HERE in line)


def told_of(root: Path, options: Iterable[str]) -> list[Finding]:
    """Return what `plastron lint` says of a folder."""
    result = CliRunner().invoke(command, [str(root), "-j1", "--format", "json", *options])
    if result.exit_code not in (0, 1):
        raise RuntimeError(result.output) from result.exception
    return [_finding(each, root) for each in json.loads(result.stdout)]


def _finding(each: dict[str, Any], root: Path) -> Finding:
    file = Path(each["file"])
    if file.is_relative_to(root):
        file = file.relative_to(root)
    return Finding(each["code"], str(file), each["range"]["start"]["line"], each["message"])


def _bytes_of(path: Path) -> bytes | None:
    return path.read_bytes() if path.is_file() else None


def _line_of(path: Path, text: str) -> int:
    whole = path.read_bytes().decode()
    text = text.replace(HERE, "")
    if whole.count(text) != 1:
        raise ValueError(f"{path.name}: {text!r} stands {whole.count(text)} times")
    return whole[: whole.index(text)].count("\n") + 1
