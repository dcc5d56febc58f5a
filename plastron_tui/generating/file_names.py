"""The names that no node file gets, because something runs files of these names by itself.

A loaded node keeps its file's name, and its text is somebody's: under another name, or in another
folder, the text would run without being asked for.
"""

from __future__ import annotations

import os
from collections.abc import Container
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes

if TYPE_CHECKING:
    from plastron_tui.sources.base import Language

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
