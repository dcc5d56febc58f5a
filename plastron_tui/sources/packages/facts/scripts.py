"""Files of Python that can be started, and how they are installed."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import chain

from plastron_tui.diagnostics import Span
from plastron_tui.model.package_facts import How, Place, Script, Shebang
from plastron_tui.ros.launch_names import launch_language

from .cmake_lists import Lists
from .entry_points import PythonSetup
from .texts import SCRIPT_FOLDERS, PackageTexts, is_test

_GUARD = re.compile(rb"^if[ \t]*\(?[ \t]*__name__[ \t]*==[ \t]*['\"]__main__['\"]", re.M)
_MAIN = re.compile(rb"^(?:async[ \t]+)?def[ \t]+main\b", re.M)
_SHEBANG = re.compile(rb"\A(?:\xef\xbb\xbf)?#!.*")
_PYTHON_RUNS = re.compile(rb"\A#![^\n]*\bpython[\d.]*[ \t\r]*(?:\n|\Z)")
_IMPORTED = re.compile(
    rb"^[ \t]*(?:from[ \t]+([\w.]+)[ \t]+)?import[ \t]+(\([^)]*\)|[^\n#]*)", re.M
)
_NAME = re.compile(r"\w+")


def find_scripts(texts: PackageTexts, lists: Lists, setup: PythonSetup) -> Iterator[Script]:
    """Yield the files of a package that do something when they are started."""
    imported, named = _imported(texts), _named(lists)
    is_first = texts.source.ros_version == 1
    for name in chain(texts.python, _without_suffix(texts, lists)):
        text = texts.get(name)
        if text is None or is_test(name) or launch_language(name):
            continue
        guard, main = _GUARD.search(text), _MAIN.search(text)
        found = guard or main
        # ROS 1 starts what lies in the workspace, and such a first line asks for that.
        is_meant = is_first and _PYTHON_RUNS.match(text) is not None
        is_named = name in lists.installs or name in texts.programs
        if found is None and not is_named and not is_meant:
            continue
        how, installed = _how(texts, name, lists, setup)
        base = name.rpartition("/")[2]
        end = text.find(b"\n")
        first = Span(0, len(text) if end < 0 else end)
        yield Script(
            file=name,
            main=Span(*found.span()) if found else first,
            is_program=guard is not None,
            how=how,
            installed=installed,
            first=first,
            shebang=_shebang(text),
            is_executable=name in texts.programs,
            is_mentioned=base.removesuffix(".py") in imported
            or base in named
            or (
                how in (How.NOT, How.ELSEWHERE)
                and (_is_in_another(texts, name) or _is_by_hand(name, text))
            ),
            has_main=main is not None,
        )


def _without_suffix(texts: PackageTexts, lists: Lists) -> Iterator[str]:
    """Yield the scripts whose names have no suffix, as their first line or the build says."""
    if texts.source.build_type == "ament_python":
        return
    for name in texts.names:
        if "." in name.rpartition("/")[2]:
            continue
        installed = lists.installs.get(name)
        # Only what is said to be one is, where the first line does not tell.
        is_python = installed is not None and installed.how is How.PYTHON
        is_found = installed is not None or name in texts.programs
        if is_python or (is_found and _PYTHON_RUNS.match(texts.get(name) or b"")):
            yield name


def _shebang(text: bytes) -> Shebang:
    match = _SHEBANG.match(text)
    if match is None:
        return Shebang.MISSING
    return Shebang.CARRIAGE_RETURN if match[0].endswith(b"\r") else Shebang.GOOD


def _how(
    texts: PackageTexts, name: str, lists: Lists, setup: PythonSetup
) -> tuple[How, Place | None]:
    if name in lists.installs:
        found = lists.installs[name]
        own = f"lib/{lists.lists.name if lists.lists else texts.source.name}"
        if found.where != own and found.how is not How.UNKNOWN:
            # What is shared may be for others to read, and ROS 1 starts nodes from there.
            is_shared = found.where.startswith("share/") and (
                texts.source.ros_version == 1 or found.how is not How.PROGRAM
            )
            return (How.UNKNOWN if is_shared else How.ELSEWHERE), found.place
        return found.how, found.place
    if texts.source.build_type == "ament_python":
        if name in setup.started:
            return How.SCRIPT, None
        # An entry that leads nowhere may be meant for any of them.
        is_open = not setup.is_settled or bool(setup.wrong)
        if name in setup.scripts or name in setup.data or is_open:
            return How.UNKNOWN, None
        if not setup.has_module(name) and name.split("/")[0] not in SCRIPT_FOLDERS:
            return How.UNKNOWN, None
        return How.NOT, setup.place
    # Catkin installs the scripts of a setup.py, for the whole workspace.
    is_open = lists.is_open or (texts.source.build_type == "catkin" and name in setup.scripts)
    return (How.UNKNOWN if is_open else How.NOT), None


def _imported(texts: PackageTexts) -> set[str]:
    """Return the words of all statements that import something, but for the packages' own names."""
    packages = {part for each in texts.python for part in each.split("/")[:-1]}
    found: set[str] = set()
    for name in texts.python:
        # One that is called as the file itself is of another package.
        own = name.rpartition("/")[2].removesuffix(".py")
        for match in _IMPORTED.finditer(texts.get(name) or b""):
            above, given = (each.decode("utf-8", "replace") for each in match.groups(b""))
            for module in (above, *(given.split(",") if not above else ())):
                first, *inner = _NAME.findall(module.partition(" as ")[0]) or [""]
                found.update({*inner, *({first} - packages)} - {own})
            if above:
                found.update({*_NAME.findall(given)} - {own})
    return found


def _is_in_another(texts: PackageTexts, name: str) -> bool:
    """Tell whether another file, of tests or of launching, names a script by its file."""
    base = name.rpartition("/")[2].encode()
    stem = re.escape(base.removesuffix(b".py"))
    # `python -m` takes the name of the module, and in a comment it is switched off.
    module = re.escape(name.removesuffix(".py").replace("/", ".").encode())
    off = re.compile(rb"[\"' ]%b[\"' ]|^[ \t]*(?:#|<!--)[^\n]*\b%b\b" % (module, stem), re.M)
    is_dotted = "/" in name
    return any(
        base in text or (is_dotted and launch_language(file) and off.search(text))
        for file, text in texts.others()
        if file != name
    )


def _is_by_hand(name: str, text: bytes) -> bool:
    """Tell whether a script says that people start it with the interpreter."""
    base = re.escape(name.rpartition("/")[2].encode())
    return re.search(rb"\bpython3?[ \t]+(?:[\w./-]*/)?%b\b" % base, text) is not None


def _named(lists: Lists) -> frozenset[str]:
    """Return the names of the files that commands of CMake name which install nothing."""
    calls = () if lists.lists is None else lists.lists.calls
    return frozenset(
        item.value.rpartition("/")[2]
        for call in calls
        if call.command.name not in ("install", "catkin_install_python", "set", "list")
        for item in call.items
    )
