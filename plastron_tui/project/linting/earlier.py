"""The definitions of types at a revision of git.

Git is asked in a process of its own with limits, which reads objects and nothing else: no working
tree is touched, and no hook, filter, pager or helper for fetching is run.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.limited_process import TimedOutError, run_limited, starting
from plastron_tui.lint.tree import Earlier, PackageFacts, SourceTree
from plastron_tui.model.source import LARGEST_FILE
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.definition import MAX_DEFINITION_BYTES, member_spans, parse_definition
from plastron_tui.ros.interfaces import Interface, InterfaceKind, InterfaceName

from .earlier_process import LIMITS

_MODULE = "plastron_tui.project.linting.earlier_process"
_DEFINITIONS = frozenset(f".{each.value}" for each in InterfaceKind)
_NAME = re.compile(r"<name>\s*([A-Za-z0-9_-]+)\s*</name>")


def read_earlier(tree: SourceTree, revision: str) -> Earlier | Diagnostic:
    """Return the definitions of a workspace at a revision, or why there are none.

    Args:
        tree: the workspace as it is now.
        revision: what git calls it: a branch, a tag, a commit.
    """
    request = json.dumps({"folder": os.fspath(tree.root), "revision": revision}).encode()
    answer: dict[str, Any] = {}
    try:
        reply = run_limited(starting(_MODULE), request, LIMITS)
    except TimedOutError:
        why = "git takes too long"
    except OSError as error:
        why = f"no process can be started: {error.strerror}"
    else:
        if len(reply.text) > LIMITS.reply:
            why = "there is too much of it"
        elif reply.status != 0:
            why = reply.why(LIMITS)
        else:
            answer = json.loads(reply.text)
            why = answer["error"]
    if why:
        message = f"the revision `{revision}` cannot be read: {why}"
        return Diagnostic(codes.UNREADABLE_FILE, message, file=tree.root)
    interfaces = interfaces_of(answer["files"], tree.packages)
    unchanged = _unchanged(tree.root, answer["code"], (each.path for each in tree.units))
    places = dict(_places(tree, answer["files"]))
    return Earlier(revision, interfaces, frozenset(unchanged), places)


def _places(
    tree: SourceTree, files: Mapping[str, str]
) -> Iterator[tuple[Path, Mapping[tuple[int, str], Span]]]:
    """Yield the definitions that are not what they were, with the places of their members."""
    versions = {each.folder: each.ros_versions[0] for each in tree.packages.values()}
    for name, old in files.items():
        path = tree.root / name
        version = versions.get(path.parent.parent)
        if version is None or path.suffix not in _DEFINITIONS:
            continue
        with suppress(OSError, ValueError):
            text = read_regular(path, MAX_DEFINITION_BYTES).decode("utf-8", "surrogateescape")
            if text != old:
                yield path, member_spans(text, version)


def _unchanged(root: Path, code: Mapping[str, str], paths: Iterable[Path]) -> Iterable[Path]:
    """Yield the files that hold what they held, as the names tell that git has for contents."""
    for path in paths:
        name = code.get(os.path.relpath(path, root))
        with suppress(OSError, ValueError):
            if name is not None and name == _git_name(read_regular(path, LARGEST_FILE), name):
                yield path


def _git_name(text: bytes, other: str) -> str:
    """Return git's name for what a file holds, of the kind that another name is of."""
    kind = hashlib.sha1 if len(other) == hashlib.sha1().digest_size * 2 else hashlib.sha256
    return kind(b"blob %d\0" % len(text) + text).hexdigest()


def interfaces_of(
    files: Mapping[str, str], packages: Mapping[str, PackageFacts]
) -> dict[tuple[InterfaceKind, InterfaceName], Interface]:
    """Return the types of texts, by their paths from the root; one that is no type is left out."""
    found = {}
    names = {
        path.rpartition("/")[0]: match[1]
        for path, text in files.items()
        if path.rpartition("/")[2] == "package.xml" and (match := _NAME.search(text))
    }
    for path, text in files.items():
        folder, _, base = path.rpartition("/")
        above, _, kind = folder.rpartition("/")
        stem, _, suffix = base.rpartition(".")
        if suffix != kind or kind not in (each.value for each in InterfaceKind):
            continue
        package = names.get(above)
        if package is None:
            continue
        now = packages.get(package)
        version = 2 if now is None else now.ros_versions[0]
        name = InterfaceName(package, stem)
        interface = parse_definition(text, name, InterfaceKind(kind), version).interface
        if interface is not None:
            found[InterfaceKind(kind), name] = interface
    return found
