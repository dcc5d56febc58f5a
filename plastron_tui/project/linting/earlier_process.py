"""The process that asks git for definitions: a request in JSON comes in, an answer in JSON goes."""

from __future__ import annotations

import json
import os
import re
import sys
from typing import NamedTuple

from plastron_tui.limited_process import Limits, limit_itself

LIMITS = Limits(work=30, wait=60, memory=4 * 1024**3, reply=64 * 1024**2)
_WANTED = re.compile(
    rb"(?:(?:.*/)?(?:msg/[^/]+\.msg|srv/[^/]+\.srv|action/[^/]+\.action)|(?:.*/)?package\.xml)"
)
_CODE = (".py", ".cpp", ".cc", ".cxx", ".hpp", ".h")
_MOST_FILES = 20_000
_LARGEST = 1_000_000
_MOST_MODULES = 100
_DEEPEST = 5
_SETTINGS = ("core.hooksPath=/dev/null", "core.fsmonitor=false", "core.pager=cat")


class Answer(NamedTuple):
    """What git knows.

    Attributes:
        files: the texts of definitions and of package.xml, by their paths from the folder.
        code: the names that git has for what files of code hold, by their paths.
        error: why there is nothing.
    """

    files: dict[str, str]
    code: dict[str, str]
    error: str = ""


class _GitError(Exception):
    """Git does not know what it is asked for."""


def main() -> int:
    """Answer the request on the standard input, with limits."""
    limit_itself(LIMITS)
    request = json.load(sys.stdin)
    try:
        answer = _answer(request["folder"], request["revision"])
    except _GitError as error:
        answer = Answer({}, {}, str(error))
    json.dump(answer._asdict(), sys.stdout)
    return 0


def _git(folder: str, *words: str, given: bytes = b"") -> bytes:
    import subprocess

    environ = {
        name: value
        for name, value in os.environ.items()
        # What says which repository is meant, or what is run beside git.
        if not name.startswith("GIT_")
    }
    environ |= {
        # Git before 2.45 fetches what is missing, and the repository says which program does that.
        # Of all that forbids it, nothing but this goes before `protocol.ext.allow` of its settings.
        "GIT_ALLOW_PROTOCOL": "none",
        "GIT_NO_LAZY_FETCH": "1",
        "GIT_NO_REPLACE_OBJECTS": "1",
        "GIT_OPTIONAL_LOCKS": "0",
        "GIT_TERMINAL_PROMPT": "0",
        "LC_ALL": "C",
    }
    settings = [part for each in _SETTINGS for part in ("-c", each)]
    command = ["git", "--no-pager", "-C", folder, *settings, *words]
    try:
        done = subprocess.run(command, input=given, capture_output=True, env=environ, check=False)
    except OSError as error:
        raise _GitError(f"git cannot be started: {error.strerror}") from None
    if done.returncode:
        said = done.stderr.decode("utf-8", "replace").strip().splitlines()
        raise _GitError(said[-1].removeprefix("fatal: ") if said else "git gives no reason")
    return done.stdout


def _answer(folder: str, revision: str, depth: int = 0) -> Answer:
    """Return what git knows of what is below a folder at a revision, in submodules too."""
    commit = _commit(folder, revision)
    prefix = _git(folder, "rev-parse", "--show-prefix").rstrip(b"\n")
    # No sizes: git asks every file for its own, and tries to fetch each that is missing.
    listed = _git(folder, "ls-tree", "-r", "-z", "--full-tree", commit)
    wanted: list[tuple[bytes, str]] = []
    code: dict[str, str] = {}
    modules: list[tuple[str, str]] = []
    for row in listed.split(b"\0"):
        about, _, path = row.partition(b"\t")
        parts = about.split()
        if parts[1:2] == [b"commit"] and path.startswith(prefix) and depth < _DEEPEST:
            modules.append((os.fsdecode(path[len(prefix) :]), parts[2].decode()))
        is_file = parts[1:2] == [b"blob"] and parts[0] != b"120000"
        if not is_file or not path.startswith(prefix):
            continue
        name = path[len(prefix) :].decode("utf-8", "replace")
        if name.endswith(_CODE):
            code[name] = parts[2].decode()
        elif _WANTED.fullmatch(path[len(prefix) :]):
            wanted.append((parts[2], name))
    files = dict(_texts(folder, wanted[:_MOST_FILES]))
    for name, earlier in modules[:_MOST_MODULES]:
        # One that is not fetched has no files now, either.
        if os.path.exists(os.path.join(folder, name, ".git")):
            inner = _of_module(os.path.join(folder, name), name, earlier, depth)
            files |= {f"{name}/{each}": text for each, text in inner.files.items()}
            code |= {f"{name}/{each}": known for each, known in inner.code.items()}
    return Answer(files, code)


def _of_module(folder: str, name: str, revision: str, depth: int) -> Answer:
    try:
        return _answer(folder, revision, depth + 1)
    except _GitError as error:
        raise _GitError(f"the submodule `{name}` has not what it was then ({error})") from None


def _commit(folder: str, revision: str) -> str:
    if not revision or revision.startswith("-") or not revision.isprintable():
        raise _GitError("it is no name of a revision")
    # In two steps: of what is searched for, `:/text`, the rest would be a part.
    try:
        found = _git(folder, "rev-parse", "--verify", "--quiet", revision).decode().strip()
    except _GitError as error:
        said = str(error)
        raise _GitError("there is none" if said == "git gives no reason" else said) from None
    try:
        words = ("rev-parse", "--verify", "--quiet", f"{found}^{{commit}}")
        return _git(folder, *words).decode().strip()
    except _GitError:
        raise _GitError("it is no commit") from None


def _texts(folder: str, wanted: list[tuple[bytes, str]]) -> list[tuple[str, str]]:
    """Return the texts of files, by their names, of those that git has under names of its own."""
    known = b"".join(each + b"\n" for each, _ in wanted)
    rows = _git(folder, "cat-file", "--batch-check", given=known).splitlines()
    heads = [(row.split(), name) for row, (_, name) in zip(rows, wanted, strict=True)]
    missing = [name for head, name in heads if len(head) != 3]
    if missing:
        # What is left would be compared as if these had never been.
        more = f" and {len(missing) - 1} more" if missing[1:] else ""
        raise _GitError(f"the repository lacks `{missing[0]}`{more}, as a partial clone does")
    heads = [(head, name) for head, name in heads if int(head[2]) <= _LARGEST]
    known = b"".join(head[0] + b"\n" for head, _ in heads)
    objects = _git(folder, "cat-file", "--batch", given=known)
    found = []
    at = 0
    for head, name in heads:
        start = objects.index(b"\n", at) + 1
        at = start + int(head[2])
        found.append((name, objects[start:at].decode("utf-8", "replace")))
        at += 1
    return found
