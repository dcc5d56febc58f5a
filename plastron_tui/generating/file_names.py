"""The names of node files: what a created node's is, and which names no node file gets.

A created node keeps the file that it was first written to. A loaded node keeps its file's name, and
its text is somebody's: under another name, or in another folder, something might run it without
being asked for.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Container
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Node
    from plastron_tui.output.manifest import Manifest
    from plastron_tui.sources.base import Language
    from plastron_tui.targets.base import Target

_ENDINGS = ("", "_pub", "_sub1", "_sub2", "_client", "_server", "_node")
"""What stands behind a node's name: nothing with `file_names: plain`, else what the node does."""

_GIT_HOOKS = frozenset(
    {
        "applypatch-msg", "commit-msg", "fsmonitor-watchman", "p4-changelist",
        "p4-post-changelist", "p4-pre-submit", "p4-prepare-changelist", "post-applypatch",
        "post-checkout", "post-commit", "post-index-change", "post-merge", "post-receive",
        "post-rewrite", "post-update", "pre-applypatch", "pre-auto-gc", "pre-commit",
        "pre-merge-commit", "pre-push", "pre-rebase", "pre-receive", "prepare-commit-msg",
        "proc-receive", "push-to-checkout", "reference-transaction", "sendemail-validate",
        "update",
    }
)  # fmt: skip
"""The hooks of githooks(5): a repository may keep them in any folder (`core.hooksPath`)."""


class FileNames(NamedTuple):
    """How the files of created nodes are called.

    Attributes:
        output: the output folder.
        manifest: gives what is remembered of the files of a folder.
        program: the name of the program's file: nodes of one name in two programs are two.
        is_plain: whether a new file is called as its node is, without an ending.
        written: the nodes that the program generates, by name, each with its client library.
    """

    output: Path
    manifest: Callable[[Path], Manifest]
    program: str
    is_plain: bool = False
    written: frozenset[tuple[str, str]] = frozenset()

    def of(self, node: Node, target: Target) -> str:
        """Return the name of a node's main file: the one that it has, or what it is written to."""
        suffix = target.language.suffix
        home = node.home
        if home is not None and not home.is_own:
            return target.packaged(home, f"{home.stem}{suffix}")
        new = f"{node.name}{suffix}" if self.is_plain else target.file_name(node)
        usual = (new, *(f"{node.name}{ending}{suffix}" for ending in _ENDINGS))
        names = dict.fromkeys(usual if home is None else (target.packaged(home, x) for x in usual))
        new = next(iter(names))
        held = {name: self._library(name, node) for name in names}
        own = (name for name, library in held.items() if library == target.name)
        # A node that is no longer written for another client library takes that file along.
        left = (
            name
            for name, library in held.items()
            if library is not None and (node.name, library) not in self.written
        )
        return next(own, None) or next(left, new)

    def _library(self, name: str, node: Node) -> str | None:
        """Return the client library of a file that was written for a node of the program.

        None where the file was written for something else, or replaced since.
        """
        manifest = self.manifest(self.output)
        known = manifest.bases.get(name, {})
        is_own = (known.get("node"), known.get("program")) == (node.name, self.program)
        if not is_own or manifest.successor(name) is not None:
            return None
        library = known.get("library")
        is_there = isinstance(library, str) and (self.output / name).is_file()
        return library if is_there else None


def refuse_name(
    name: str, packages: Container[str], language: Language, *, is_own: bool, is_in_place: bool
) -> Diagnostic | None:
    """Say why a node file cannot get a name, None where it can.

    Args:
        name: the file's name.
        packages: the packages whose types the node imports.
        language: the language that the file is in.
        is_own: whether Plastron makes the whole text: pytest may then import it.
        is_in_place: whether the node is written over the file that it comes from.
    """
    if is_in_place:
        return None
    small = name.lower()
    what = _runner(small) or language.runs_by_itself(small, packages, is_own=is_own)
    if what is None:
        return None
    remedy = "give the node another name"
    if not is_own:
        remedy = "give the loaded file another name, or write the node over it with `--in-place`"
    return Diagnostic(codes.RUNS_BY_ITSELF, f"no node is written to `{name}`: {what}", help=remedy)


def _runner(name: str) -> str | None:
    """Tell what runs a file of a name in whatever language, None where nothing does."""
    if name.startswith("."):
        return "shells and other programs read hidden files by themselves"
    if name in _GIT_HOOKS:
        return "git runs a file of this name"
    return None


def is_same_path(path: Path, other: Path) -> bool:
    """Tell whether two paths lead to one file, which need not be there."""
    return os.path.realpath(path) == os.path.realpath(other)
