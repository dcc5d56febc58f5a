"""Expands the macros of a file, in a process of its own (`xacro`).

The package `xacro` computes its expressions with Python's `eval`, which no list of forbidden words
makes harmless: the process has limits, reads what it may (`file_guard`), and answers with bytes.
"""

from __future__ import annotations

import importlib
import json
import os
import pickle
import re
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple
from xml.parsers import expat

from plastron_tui.limited_process import Limits, limit_itself
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.robots.macros import Arguments
from plastron_tui.sources.urdf.reach import Reach

from .file_guard import guard_files, leave_network

_LONGEST_REASON = 400
_LARGEST_FILE = 4 * 1024**2
_MOST_ARGUMENTS = 500

# What is imported as it is needed: nothing is, once files are guarded.
_MODULES = ("xml.dom.expatbuilder", "xml.dom.minidom", "yaml", "encodings.latin_1")
_VARIABLE = re.compile(r"environment variable '(\w+)' is not set")
_ARGUMENT = re.compile(r"Undefined substitution argument (\w+)")
_NO_VALUE = re.compile(r"the argument `(\w+)` has no value")
_SUBSTITUTIONS = ("xacro.substitution_args", "roslaunch.substitution_args")


class Request(NamedTuple):
    """What is to be expanded.

    Attributes:
        path: where the file is.
        text: what it holds.
        reach: how far it may lead.
        limits: what the process may use.
        arguments: what the file's arguments are given.
    """

    path: Path
    text: bytes
    reach: Reach
    limits: Limits
    arguments: Arguments = ()


class _Mappings(dict[str, str]):
    """What the file's arguments are given; it notes which of them are asked for."""

    def __init__(self, arguments: Arguments) -> None:
        super().__init__(arguments)
        self.asked: dict[str, None] = {}

    def __contains__(self, name: object) -> bool:
        self._note(name)
        return super().__contains__(name)

    def __getitem__(self, name: str) -> str:
        self._note(name)
        return super().__getitem__(name)

    def _note(self, name: object) -> None:
        if isinstance(name, str) and len(self.asked) < _MOST_ARGUMENTS:
            self.asked[name] = None


class _RefusedError(Exception):
    """Why a file is not expanded."""


def main() -> int:
    """Expand what the standard input asks for; return the exit status."""
    request: Request = pickle.load(sys.stdin.buffer)
    reply = os.dup(1)
    with Path(os.devnull).open("w") as nowhere:
        sys.stdout = sys.stderr = nowhere
        answer = _answer(request)
    while answer:
        answer = answer[os.write(reply, answer) :]
    return 0


def _answer(request: Request) -> bytes:
    xacro = _load()
    leave_network()
    limit_itself(request.limits)
    guard = guard_files(request.reach.allows)
    text, reason, missing = b"", "", ""
    mappings = _Mappings(request.arguments)
    try:
        text = _expanded(xacro, request, mappings)
    # An expression of a file may fail in any way.
    except (Exception, SystemExit) as error:
        reason = _reason(xacro, error, request.limits)
        argument = _NO_VALUE.fullmatch(reason)
        missing = "" if argument is None else argument.group(1)
    if not reason and len(text) > request.limits.reply // 2:
        text, reason = b"", f"they make more than {request.limits.reply // 2 // 1024**2} MB"
    head = {
        "reason": reason,
        "refused": guard.refused,
        "opened": list(guard.opened),
        "missing": missing,
        "asked": [each for each in mappings.asked if each not in dict(request.arguments)],
        "unused": [name for name, _ in request.arguments if name not in mappings.asked],
    }
    return b"\n".join((json.dumps(head).encode(), text))


def _load() -> Any:
    """Import xacro, and all that it imports later."""
    for name in _MODULES:
        importlib.import_module(name)
    xacro = importlib.import_module("xacro")
    for name in _SUBSTITUTIONS:
        with suppress(ImportError):
            importlib.import_module(name)
    return xacro


def _expanded(xacro: Any, request: Request, mappings: _Mappings) -> bytes:
    """Return the file with its macros expanded.

    Raises:
        Exception: whatever xacro, or an expression, raises.
    """
    main = os.fspath(request.path)

    def parse(given: Any, filename: str | None = None) -> Any:
        """Read a file in the place of `xacro.parse`: without entities, and with a limit."""
        if given is not None:
            raise _RefusedError("a text stands for a file")
        try:
            is_main = filename == main
            text = request.text if is_main else read_regular(str(filename), _LARGEST_FILE)
        except OSError as error:
            # As xacro does: an include may be optional.
            xacro.filestack.pop()
            raise xacro.XacroException(f"{error.strerror}: {filename}", exc=error) from error
        _refuse_entities(text)
        return importlib.import_module("xml.dom.minidom").parseString(text)

    def find(name: str) -> str:
        """Return the folder of a package in the place of `$(find …)`."""
        folder = request.reach.package(name)
        if folder is None:
            raise _RefusedError(f"the package `{name}` is neither in the project nor installed")
        return os.fspath(folder)

    named = xacro.abs_filename_spec

    def abs_filename_spec(name: str) -> Any:
        path = Path(named(name))
        moved = None if path.exists() else request.reach.installed(path)
        return os.fspath(path if moved is None else moved)

    extend = xacro.eval_extension

    def eval_extension(text: str) -> Any:
        words = text[2:-1].split()
        return find(words[1]) if words[:1] == ["find"] and len(words) == 2 else extend(text)

    xacro.parse = parse
    xacro.eval_extension = eval_extension
    xacro.abs_filename_spec = abs_filename_spec
    for name in _SUBSTITUTIONS:
        module: Any = sys.modules.get(name)
        if module is not None:
            module._eval_find = find
            module._eval_dict["find"] = find
    document = xacro.process_file(main, verbosity=0, mappings=mappings)
    text: bytes = document.documentElement.toxml().encode()
    return text


def _refuse_entities(text: bytes) -> None:
    """Refuse a document type with declarations: entities of entities grow without end."""

    def refuse(*_: object) -> None:
        raise _RefusedError("a file declares entities, which are not expanded")

    parser = expat.ParserCreate()
    parser.EntityDeclHandler = refuse
    parser.Parse(text, True)


def _reason(xacro: Any, error: BaseException, limits: Limits) -> str:
    """Return why a file is not expanded, on one line, with the file that the mistake is in."""
    inner, said = error, error
    while True:
        match inner:
            case MemoryError():
                return f"they need more than {limits.memory // 1024**2} MB of memory"
            case RecursionError():
                return "macros, files or expressions are within each other without end"
            case _RefusedError():
                return str(inner)
        cause = getattr(inner, "exc", None) or inner.__cause__
        if not isinstance(cause, BaseException):
            break
        # What is around it says where it is: "when evaluating expression …".
        is_told_whole = cause.__class__.__name__ == "XacroException"
        said = cause if is_told_whole or str(inner).startswith("<class") else said
        inner = cause
    text = " ".join(str(said).split()) or type(inner).__name__
    variable = _VARIABLE.fullmatch(text)
    if variable is not None:
        return f"they ask for the environment variable `{variable.group(1)}`, and get none"
    argument = _ARGUMENT.fullmatch(text)
    if argument is not None:
        return f"the argument `{argument.group(1)}` has no value"
    files = [each for each in getattr(xacro, "filestack", None) or () if isinstance(each, str)]
    macros = (each.body.getAttribute("name") for each in getattr(said, "macros", ()))
    places = [f"in the macro `{each}`" for each in macros]
    places += [f"in `{Path(files[-1]).name}`"] if len(files) > 1 else []
    return text[:_LONGEST_REASON] + (f" ({', '.join(places[:2])})" if places else "")
