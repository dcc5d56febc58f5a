"""Types and packages that cannot be: each is told at its place, and nothing is written."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import pytest
from command_line import TALKER, Run, snapshot
from loaded_packages import AMENT_CMAKE, AMENT_PYTHON, CATKIN, lay
from loaded_packages import IN as LOADED
from machine import mostly_long

Files = dict[str, str] | dict[str, bytes]


class Wrong(NamedTuple):
    """A program, the files beside it, and what is told.

    Attributes:
        files: those of the folder `demo`; a program without any has no such folder.
        program: the program.
        told: the error that is told, and where.
        place: the file, and the line and column.
        word: what is underlined.
    """

    files: Files
    program: str
    told: str
    place: str
    word: str


def made(name: str, mail: str = "Ada <ada@example.com>") -> str:
    return f'create_package \'{name}\' as {name} maintained_by "{mail}" licensed_under "MIT"\n'


def with_file(files: dict[str, str], name: str, text: str | bytes) -> Files:
    whole = {path: each.encode() for path, each in files.items()}
    return whole | {name: text if isinstance(text, bytes) else text.encode()}


ROVER = made("rover") + "rover contains talker\ngenerate_package rover\n"
MANIFEST = AMENT_PYTHON["package.xml"]
LISTS = AMENT_CMAKE["CMakeLists.txt"]

WRONG = {
    "no folder": Wrong(
        {}, LOADED, "file-not-found]: no folder `demo` beside the program",
        "a.plastron:4:14", "'demo'",
    ),
    "no package.xml": Wrong(
        {"demo/__init__.py": ""}, LOADED,
        "file-not-found]: `demo` has no `package.xml`: it is no package",
        "a.plastron:4:14", "'demo'",
    ),
    "package.xml that is cut off": Wrong(
        with_file(AMENT_PYTHON, "package.xml", MANIFEST.replace("</package>\n", "")), LOADED,
        "broken-xml]: `<package>` is not closed", "demo/package.xml:2:2", "package",
    ),
    "package.xml that is empty": Wrong(
        with_file(AMENT_PYTHON, "package.xml", ""), LOADED,
        "broken-xml]: there is no element in the file", "demo/package.xml:1:1", "",
    ),
    "package.xml that is no text": Wrong(
        with_file(AMENT_PYTHON, "package.xml", b"\xff\xfe<\0p\0"), LOADED,
        "unsupported-xml]: the file is not in UTF-8", "demo/package.xml", "",
    ),
    "package.xml without a name": Wrong(
        with_file(AMENT_PYTHON, "package.xml", MANIFEST.replace("  <name>demo</name>\n", "")),
        LOADED, "broken-package]: there is no `<name>`", "demo/package.xml:2:2", "package",
    ),
    "no build file": Wrong(
        {"package.xml": AMENT_CMAKE["package.xml"]}, LOADED,
        "broken-build-file]: the package has no `CMakeLists.txt`, which its build type wants",
        "demo/package.xml", "",
    ),
    "command of CMake that is not closed": Wrong(
        with_file(AMENT_CMAKE, "CMakeLists.txt", LISTS.replace("cmake REQUIRED)", "cmake")),
        LOADED, "broken-build-file]: line 4 of `CMakeLists.txt` has a syntax error",
        "demo/CMakeLists.txt:4:1", "find_package(",
    ),
    "last command of CMake that is not closed": Wrong(
        with_file(AMENT_CMAKE, "CMakeLists.txt", LISTS.replace("package()", "package(")),
        LOADED, "broken-build-file]: line 15 of `CMakeLists.txt` has a syntax error",
        "demo/CMakeLists.txt:15:1", "ament_package(",
    ),
    "block of CMake that is not closed": Wrong(
        with_file(AMENT_CMAKE, "CMakeLists.txt", LISTS.replace("# Nodes", "if(WIN32)")),
        LOADED, "broken-build-file]: line 9 of `CMakeLists.txt` has a syntax error",
        "demo/CMakeLists.txt:9:1", "if(WIN32)",
    ),
    "CMake of catkin": Wrong(
        with_file(CATKIN, "CMakeLists.txt", CATKIN["CMakeLists.txt"] + "install(\n"), LOADED,
        "broken-build-file]: line 7 of `CMakeLists.txt` has a syntax error",
        "demo/CMakeLists.txt:7:1", "install(",
    ),
    "two packages of one name": Wrong(
        {}, TALKER + ROVER + made("rover").replace("as rover", "as second"),
        "package-exists]: a package `rover` exists already", "a.plastron:8:16", "'rover'",
    ),
    "two packages of one name, one loaded": Wrong(
        AMENT_PYTHON, LOADED + made("demo").replace("as demo", "as second"),
        "package-exists]: a package `demo` exists already", "a.plastron:7:16", "'demo'",
    ),
    "type that contains itself": Wrong(
        {}, "create_message_type Chain with Chain next\n" + TALKER,
        "circular-type]: `Chain` contains itself", "a.plastron:1:32", "Chain",
    ),
    "cycle of types": Wrong(
        {}, "create_message_type A with int8 x\ncreate_message_type B with A[] a\n"
        'A has_field "B b"\n' + TALKER,
        "circular-type]: `A` contains itself: `A` in `B` in `A`", "a.plastron:3:14", "B",
    ),
    "cycle of types that are made": Wrong(
        {}, "create_message_type A with B b\ncreate_message_type B with A a\n" + TALKER,
        "circular-type]: `A` contains itself: `A` in `B` in `A`", "a.plastron:1:28", "B",
    ),
    "cycle of definition files": Wrong(
        {"A.msg": "B b\n", "B.msg": "A a\n"},
        "load_type 'demo/A.msg' as a\nload_type 'demo/B.msg' as b\n" + TALKER,
        "circular-type]: `A` contains itself: `A` in `B` in `A`", "a.plastron:2:11", "'demo/B.msg'",
    ),
    "no mail": Wrong(
        {}, TALKER + ROVER.replace("Ada <ada@example.com>", "Ada"),
        "bad-maintainer]: a maintainer is a name and an address, as in `Ada <ada@example.com>`",
        "a.plastron:5:47", '"Ada"',
    ),
    "mail without @": Wrong(
        {}, TALKER + ROVER.replace("ada@", "ada."), "bad-maintainer]: an address has an `@`",
        "a.plastron:5:53", "ada.example.com",
    ),
}  # fmt: skip


@pytest.mark.parametrize(
    "command",
    mostly_long([("generate",), ("generate", "--in-place"), ("check",)], [("generate",)]),
)
@pytest.mark.parametrize("what", WRONG)
def test_is_told_and_nothing_is_written(
    run: Run, here: Path, what: str, command: tuple[str, ...]
) -> None:
    wrong = WRONG[what]
    library = "rospy" if "scripts/listener.py" in wrong.files else "rclpy"
    lay(here, wrong.files)
    (here / "a.plastron").write_text(wrong.program)
    before = snapshot(here)
    result = run(*command, "--target", library, "a.plastron")
    told = result.stderr.decode().replace(f"{here}/", "")
    assert (result.returncode, result.stdout) == (1, b"")
    assert told.startswith(f"error[{wrong.told}"), told
    assert f"--> {wrong.place}" in told, told
    assert told.endswith("found 1 error\n"), told
    assert underlined(told) == wrong.word
    assert snapshot(here) == before


def underlined(told: str) -> str:
    """Return what the first carets stand below; "" where there is one below a single place."""
    lines = told.splitlines()
    for line, marks in pairwise(lines):
        if "^" in marks:
            start = marks.index("^")
            return line[start : start + marks.count("^")].rstrip()
    return ""
