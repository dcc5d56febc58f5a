"""Generating again over C++ nodes and build files that were changed by hand."""

from __future__ import annotations

import re
from collections import Counter
from pathlib import Path
from typing import NamedTuple

import pytest
from machine import mostly_long
from merging_driver import (
    EMPTY,
    INT,
    KEEP,
    KEPT,
    MESSAGES,
    PROVIDE,
    PROVIDE_TRIGGER,
    PUBLISH,
    PUBLISH_INT,
    REQUEST,
    REQUEST_TRIGGER,
    STRING,
    SUBSCRIBE,
    SUBSCRIBE_INT,
    TRIGGER,
)

from plastron_tui.diagnostics import Severity
from plastron_tui.generating.user_edits import files_on_disk
from plastron_tui.model.source import EndpointKind
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.targets import find_target

KINDS = {
    "publisher": (PUBLISH, PUBLISH_INT, ("publishers", "a", STRING), ("publishers", "a", INT)),
    "subscription": (
        SUBSCRIBE, SUBSCRIBE_INT, ("subscriptions", "a", STRING), ("subscriptions", "a", INT),
    ),
    "service": (PROVIDE, PROVIDE_TRIGGER, ("services", "s", EMPTY), ("services", "s", TRIGGER)),
    "client": (REQUEST, REQUEST_TRIGGER, ("clients", "s", EMPTY), ("clients", "s", TRIGGER)),
}  # fmt: skip
LIBRARIES = ("roscpp", "nodelet", "rclcpp", "component")
LAYOUTS = ("single", "split")
SOURCE, HEADER = "src/robot_node.cpp", "include/robot/robot_node.hpp"
MANNERS = [(library, layout) for library in LIBRARIES for layout in LAYOUTS]
ALL = [(*manner, kind) for kind in KINDS for manner in MANNERS]
SOME = [
    "roscpp-split-subscription",
    "component-split-client",
]
_FUNCTION = re.compile(r"^ *(?:void|bool) (?:\w+::)?(?:on|handle)_\w+\([^{;]*?\)\n *\{\n", re.M)


class Outcome(NamedTuple):
    """What a `generate` did: the state of each file, warnings, conflicts."""

    states: dict[str, str]
    warnings: list[str]
    conflicts: list[str]


class Package:
    """An output folder that is a package, and the program beside it."""

    def __init__(self, path: Path, library: str, layout: str) -> None:
        self.path, self.library, self.layout = path, library, layout

    def generate(
        self, *statements: str, program: str = "robot", node: str = "robot", force: bool = False
    ) -> Outcome:
        lines = "\n".join(statements)
        return self.run(f"create_node '{node}' as n\n{lines}\ngenerate_node n\n", program, force)

    def run(self, text: str, program: str = "robot", force: bool = False) -> Outcome:
        (self.path / "plastron.yaml").write_text(f"cpp: {self.layout}\n")
        options = Options(self.library, self.path / "output", force=force)
        path = self.path / f"{program}.plastron"
        session = Session(f"{MESSAGES}{text}".encode(), path, options, environ={})
        assert session.diagnostics == ()
        plan, told = session.plan()
        assert all(found.severity is not Severity.ERROR for found in told), told
        if force or not plan.conflicts:
            assert write(plan, force=force).diagnostics == ()
        return Outcome(
            {file.name: file.state.value for file in plan.files},
            [f"{found.code}: {found.message}" for found in told],
            [f"{found.code}: {found.message}" for found in plan.conflicts],
        )

    def file(self, name: str) -> Path:
        return self.path / "output" / name

    def files(self) -> dict[str, bytes]:
        found = (path for path in self.file("").rglob("*") if path.is_file())
        return {path.relative_to(self.file("")).as_posix(): path.read_bytes() for path in found}

    def endpoints(self, name: str = SOURCE) -> Counter[tuple[str, str, str]]:
        target, files = find_target(self.library), files_on_disk(self.file(name))
        assert target is not None and files is not None
        source = target.read(self.file(name), files).source
        assert source is not None
        return Counter(
            (each.kind.value, str(each.name), str(each.type))
            for each in source.endpoints
            if each.kind is not EndpointKind.TIMER
        )

    def edit(self, name: str, old: str, new: str) -> str:
        text = self.file(name).read_text()
        assert old in text, text
        self.file(name).write_text(text.replace(old, new, 1))
        return name

    def fill(self) -> list[tuple[str, str]]:
        """Change all files by hand; return what each of them now has."""
        source = self.file(SOURCE)
        text = _FUNCTION.sub(lambda found: f"{found[0]}  mine();\n", source.read_text())
        assert "  mine();\n" in text
        source.write_text(text)
        header = HEADER if self.layout == "split" else SOURCE
        return [
            (SOURCE, "  mine();\n"),
            (self.edit(header, "private:\n", "private:\n  int my_count_ = 0;\n\n"), "my_count_"),
            (self.edit(header, "#include", "#include <map>\n#include"), "#include <map>\n"),
            (self.edit("package.xml", "</license>", "</license>\n  <author>Me</author>"), "Me<"),
            (self.edit("CMakeLists.txt", "\ninstall(", "\nset(MINE 1)\n\ninstall("), "set(MINE 1)"),
        ]

    def check(self, mine: list[tuple[str, str]], expected: list[tuple[str, str, str]]) -> None:
        assert self.endpoints() == Counter(expected)
        assert [each for each in mine if each[1] not in self.file(each[0]).read_text()] == []

    def check_again(self, *statements: str) -> None:
        """Check that generating once more changes nothing."""
        before = self.files()
        assert set(self.generate(*statements).states.values()) == {"identical"}
        assert self.files() == before


@pytest.mark.parametrize("case", mostly_long(ALL, SOME, "-".join))
def test_changes_of_the_program_over_handwork(tmp_path: Path, case: tuple[str, str, str]) -> None:
    library, layout, kind = case
    package = Package(tmp_path, library, layout)
    statement, other, shown, differs = KINDS[kind]
    package.generate(KEEP)
    mine = package.fill()
    for statements, expected in (
        ([KEEP, statement], [*KEPT, shown]),
        ([KEEP, other], [*KEPT, differs]),
        ([KEEP], KEPT),
    ):
        assert package.generate(*statements).conflicts == []
        package.check(mine, expected)
        package.check_again(*statements)


BODIES = [(*manner, kind) for kind in ("subscription", "service") for manner in MANNERS]


@pytest.mark.parametrize("case", mostly_long(BODIES, ["rclcpp-split-service"], "-".join))
def test_a_callback_that_somebody_wrote_in_is_called_again(
    tmp_path: Path, case: tuple[str, str, str]
) -> None:
    library, layout, kind = case
    package = Package(tmp_path, library, layout)
    statement, shown = KINDS[kind][0], KINDS[kind][2]
    package.generate(KEEP, statement)
    mine = package.fill()
    before = package.files()
    package.generate(KEEP)
    package.check(mine, KEPT)
    assert package.generate(KEEP, statement).conflicts == []
    package.check(mine, [*KEPT, shown])
    changed = {name for name, text in package.files().items() if text != before[name]}
    assert changed <= {".plastron.json"}


@pytest.mark.parametrize("manner", mostly_long(MANNERS, ["component-split"], "-".join))
def test_used_publisher_is_one_conflict(tmp_path: Path, manner: tuple[str, str]) -> None:
    package = Package(tmp_path, *manner)
    package.generate(KEEP, PUBLISH)
    mine = package.fill()
    package.edit(SOURCE, "  mine();\n", "  mine();\n  keep(a_publisher_);\n")
    before = package.files()
    (conflict,) = package.generate(KEEP).conflicts
    assert "the publisher `a` is used in line" in conflict
    assert package.files() == before
    package.generate(KEEP, force=True)
    package.check([], KEPT)
    assert package.file(f"{SOURCE}.bak").read_bytes() == before[SOURCE]
    assert mine


@pytest.mark.parametrize("library", mostly_long(LIBRARIES, ["roscpp"]))
def test_header_that_is_no_longer_written_is_told(tmp_path: Path, library: str) -> None:
    package = Package(tmp_path, library, "split")
    package.generate(KEEP)
    header = package.file(HEADER).read_bytes()
    package.layout = "single"
    for _ in range(2):
        (told,) = package.generate(KEEP).warnings
        assert told.startswith(f"file-stays: `{HEADER}` is of an earlier run")
    assert package.file(HEADER).read_bytes() == header
    package.file(HEADER).unlink()
    assert package.generate(KEEP).warnings == []
    package.layout = "split"
    assert package.generate(KEEP).states[HEADER] == "create"
    mine = package.fill()
    before = package.files()
    package.layout = "single"
    # What was written in the header by hand holds the node to it.
    package.generate(KEEP)
    assert package.files() == before
    package.check(mine, KEPT)


def test_files_of_a_node_that_has_another_name_are_told(tmp_path: Path) -> None:
    package = Package(tmp_path, "rclcpp", "split")
    package.generate(KEEP)
    mine = package.fill()
    outcome = package.generate(KEEP, node="rover")
    assert outcome.conflicts == []
    left = [each for each in outcome.warnings if each.startswith("file-stays")]
    assert [each.split("`")[1] for each in left] == [HEADER, SOURCE]
    package.check(mine, KEPT)
    assert "robot_node" not in package.file("CMakeLists.txt").read_text()


@pytest.mark.parametrize("manner", mostly_long(MANNERS, ["nodelet-single"], "-".join))
def test_nodes_of_two_programs_in_one_package(tmp_path: Path, manner: tuple[str, str]) -> None:
    package = Package(tmp_path, *manner)
    image = "subscribe n to 'view' of message_type Image"
    for second in (PUBLISH, f"{PUBLISH}\n{image}"):
        for program, node, statement in (("one", "robot", KEEP), ("two", "other", second)):
            outcome = package.generate(statement, program=program, node=node)
            assert outcome[1:] == ([], [])
    before = package.files()
    for program, node, statement in (("one", "robot", KEEP), ("two", "other", second)):
        outcome = package.generate(statement, program=program, node=node)
        assert set(outcome.states.values()) == {"identical"}
    assert package.files() == before
    build = before["CMakeLists.txt"].decode()
    assert "src/robot_node.cpp" in build and "src/other_pub.cpp" in build
    assert b"<depend>sensor_msgs</depend>" in before["package.xml"]
    assert b"<name>one</name>" in before["package.xml"]
    # The first goes on to write them as a whole, and keeps what the other needs there.
    outcome = package.generate(KEEP, image, program="one")
    assert outcome.conflicts == []
    assert "src/other_pub.cpp" in package.file("CMakeLists.txt").read_text()


POINT = "geometry_msgs/Point"
LOADED = "load {} as m\nsubscribe m to 'more' of message_type Point\ngenerate_node m\n"
CREATED = f"create_node 'robot' as n\n{KEEP}generate_node n\n"


@pytest.mark.parametrize("library", mostly_long(LIBRARIES, ["nodelet"]))
def test_what_the_program_writes_is_loaded_by_its_name(tmp_path: Path, library: str) -> None:
    package = Package(tmp_path, library, "split")
    for states in ("create", "identical"):
        outcome = package.run(f"{CREATED}{LOADED.format('robot_node')}")
        assert set(outcome.states.values()) == {states}
    package.check([], [*KEPT, ("subscriptions", "more", POINT)])
    build = package.file("CMakeLists.txt").read_text()
    assert build.count(f"{SOURCE})") + build.count(f"{SOURCE}\n") == 1


@pytest.mark.parametrize("library", mostly_long(LIBRARIES, ["nodelet"]))
def test_another_program_loads_what_one_wrote(tmp_path: Path, library: str) -> None:
    package = Package(tmp_path, library, "single")
    package.run(CREATED, "one")
    build = {name: text for name, text in package.files().items() if ".json" not in name}
    loaded = LOADED.format("robot_node")
    assert package.run(loaded, "two").states == {SOURCE: "changed"}
    after = package.files()
    assert {name for name, text in build.items() if after[name] != text} == {SOURCE}
    for program, text in (("one", CREATED), ("two", loaded), ("one", CREATED)):
        assert set(package.run(text, program).states.values()) == {"identical"}
        assert package.files() == after
    outcome = package.run(CREATED.replace("kept'", "held'"), "one")
    assert [each.split(":")[0] for each in outcome.warnings] == ["changes-undone"]
    assert set(package.run(loaded, "two").states.values()) == {"changed"}
    assert package.endpoints()["subscriptions", "more", POINT] == 1
