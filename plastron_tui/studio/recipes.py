"""Recipes: whole programs that work, to begin with. Each is a file in `examples/`, nothing more.

The comment at its top says what it is: `// Title: what it does.`, over as many lines as it takes.
"""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.language import statements
from plastron_tui.project.program_file import LARGEST_PROGRAM
from plastron_tui.regular_files import read_regular, reason
from plastron_tui.session import Session

from .files import OnDisk, open_file, save_file

_COMMENT = "//"

_FIRST = ("talker_listener", "service_and_client", "drive", "emergency_stop")
"""What most begin with, in this order: to send and to listen, to ask, to drive, and to stop."""


@dataclass(frozen=True, slots=True)
class Recipe:
    """A program to begin with.

    Attributes:
        title: what it is called.
        description: one sentence about it, without the full stop.
        path: the program.
        text: what is in it.
        files: the node files that it loads, from the program's folder; they go along with it.
    """

    title: str
    description: str
    path: Path
    text: bytes
    files: tuple[Path, ...] = ()


def recipes_folder() -> Path:
    """Return the folder of the recipes, in an installed Plastron or in a checkout."""
    package = Path(__file__).parent
    installed = package / "examples"
    return installed if installed.is_dir() else package.parents[1] / "examples"


def recipes(folder: Path | None = None) -> tuple[Recipe, ...]:
    """Return the recipes: what most begin with, the shortest, then those that bring files along.

    A file that cannot be read is left out.
    """
    found = []
    with suppress(OSError):
        for path in (folder or recipes_folder()).glob("*.plastron"):
            with suppress(OSError, UnicodeDecodeError):
                found.append(_recipe(path))
    return tuple(sorted(found, key=_rank))


def _rank(recipe: Recipe) -> tuple[int, bool, int, Path]:
    stem = recipe.path.stem
    place = _FIRST.index(stem) if stem in _FIRST else len(_FIRST)
    return place, bool(recipe.files), len(recipe.text), recipe.path


def _recipe(path: Path) -> Recipe:
    text = read_regular(path, LARGEST_PROGRAM)
    about = _about(text.decode("utf-8"))
    title, _, description = about.partition(": ")
    if not description:
        title, description = path.stem.replace("_", " ").capitalize(), about
    loads = (
        statement
        for statement in Session(text, path).program.statements
        if isinstance(statement, statements.Load) and statement.is_path
    )
    files = (Path(load.source) for load in loads)
    inside = (file for file in files if not file.is_absolute() and ".." not in file.parts)
    return Recipe(title, description, path, text, tuple(dict.fromkeys(inside)))


def _about(text: str) -> str:
    """Return the comment at the top of a program."""
    lines = []
    for line in text.splitlines():
        if not line.startswith(_COMMENT):
            break
        lines.append(line.removeprefix(_COMMENT).strip())
    return " ".join(lines).rstrip(".")


@dataclass(frozen=True, slots=True)
class Placed:
    """What became of a recipe's files.

    Attributes:
        written: those that are there now as the recipe has them.
        kept: those that were there already with another text, and stayed as they are.
        problem: why one could not be written; the rest was then not tried.
    """

    written: tuple[Path, ...] = ()
    kept: tuple[Path, ...] = ()
    problem: Diagnostic | None = None


def place_files(recipe: Recipe, folder: Path) -> Placed:
    """Copy the files that a recipe loads beside its program; nothing is written over."""
    written: list[Path] = []
    kept: list[Path] = []
    for file in recipe.files:
        source = open_file(recipe.path.parent / file).disk
        target = folder / file
        problem = _make_folder(target.parent)
        if problem is None and source is not None and source.text is not None:
            saved = save_file(target, source.text, OnDisk(target, None, None))
            if saved.found is not None:
                kept.append(file)
                continue
            problem = saved.refusal
        if problem is not None:
            return Placed(tuple(written), tuple(kept), problem)
        written.append(file)
    return Placed(tuple(written), tuple(kept))


def _make_folder(folder: Path) -> Diagnostic | None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        return Diagnostic(
            codes.CANNOT_WRITE, f"cannot make the folder `{folder.name}`: {reason(error)}"
        )
    return None
