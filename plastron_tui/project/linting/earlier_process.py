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
_SETTINGS = (
    "core.hooksPath=/dev/null", "core.fsmonitor=false", "core.pager=cat", "protocol.allow=never",
)  # fmt: skip


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
    listed = _git(folder, "ls-tree", "-r", "-z", "-l", "--full-tree", commit)
    wanted: list[tuple[bytes, str]] = []
    code: dict[str, str] = {}
    modules: list[tuple[str, str]] = []
    for row in listed.split(b"\0"):
        about, _, path = row.partition(b"\t")
        parts = about.split()
        if parts[1:2] == [b"commit"] and path.startswith(prefix) and depth < _DEEPEST:
            modules.append((os.fsdecode(path[len(prefix) :]), parts[2].decode()))
        is_file = len(parts) == 4 and parts[1] == b"blob" and parts[3].isdigit()
        if not is_file or not path.startswith(prefix) or parts[0] == b"120000":
            continue
        name = path[len(prefix) :].decode("utf-8", "replace")
        if name.endswith(_CODE):
            code[name] = parts[2].decode()
        elif _WANTED.fullmatch(path[len(prefix) :]) and int(parts[3]) <= _LARGEST:
            wanted.append((parts[2], name))
    wanted = wanted[:_MOST_FILES]
    asked = b"".join(each + b"\n" for each, _ in wanted)
    objects = _git(folder, "cat-file", "--batch", given=asked)
    files = dict(_cut(objects, [name for _, name in wanted]))
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


def _cut(objects: bytes, names: list[str]) -> list[tuple[str, str]]:
    """Return the texts that `git cat-file --batch` has written one after the other."""
    found = []
    at = 0
    for name in names:
        end = objects.find(b"\n", at)
        head = objects[at:end].split()
        if len(head) != 3:
            at = end + 1
            continue
        size = int(head[2])
        text = objects[end + 1 : end + 1 + size]
        found.append((name, text.decode("utf-8", "replace")))
        at = end + size + 2
    return found
