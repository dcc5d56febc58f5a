"""A dependency stands where the file has its like, is not said twice, and goes without a trace."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plastron_tui.sources.xml.dependencies import (
    NEEDS,
    add_dependency,
    add_group,
    remove_dependency,
)
from plastron_tui.sources.xml.package_data import DEPENDENCY_TAGS, PackageXml
from plastron_tui.sources.xml.package_xml import read_package

HEAD = """\
  <name>rover</name>
  <version>0.1.0</version>
  <description>A rover.</description>
  <maintainer email="ada@example.org">Ada</maintainer>
  <license>MIT</license>
"""
C_PLUS_PLUS = ("build", "build_export", "exec")


def package_of(lines: list[str], number: int = 3, newline: str = "\n") -> PackageXml:
    content = "".join(f"  {line}\n" if line else "\n" for line in lines)
    text = f'<?xml version="1.0"?>\n<package format="{number}">\n{HEAD}{content}</package>\n'
    package, diagnostics = read_package(text.replace("\n", newline).encode())
    assert package is not None, diagnostics
    return package


def lines_of(package: PackageXml) -> list[str]:
    text = package.document.text.decode().partition("<license>MIT</license>")[2]
    return [line.strip() for line in text.splitlines()[1:-1]]


CASES: list[tuple[int, list[str], tuple[str, ...], int, list[str]]] = [
    (3, [], ("exec",), 2, ["+<exec_depend>new</exec_depend>"]),
    (3, [], C_PLUS_PLUS, 2, ["+<depend>new</depend>"]),
    (3, [], ("build", "exec"), 2, ["+<depend>new</depend>"]),
    (3, ["<export/>"], ("test",), 2, ["+<test_depend>new</test_depend>", "<export/>"]),
    # Covered by what is there.
    (3, ["<depend>new</depend>"], ("exec", "build", "test"), 2, ["<depend>new</depend>"]),
    (3, ["<build_depend>new</build_depend>", "<depend>z</depend>"], ("build", "exec"), 2,
     ["<build_depend>new</build_depend>", "<depend>z</depend>", "+<exec_depend>new</exec_depend>"]),
    # The style of the file.
    (3, ["<depend>z</depend>"], ("exec",), 2,
     ["<depend>z</depend>", "+<depend>new</depend>"]),
    (2, ["<build_depend>a</build_depend>", "<exec_depend>a</exec_depend>"], ("build", "exec"), 1,
     ["<build_depend>a</build_depend>", "+<build_depend>new</build_depend>",
      "<exec_depend>a</exec_depend>", "+<exec_depend>new</exec_depend>"]),
    (1, ["<build_depend>a</build_depend>", "<run_depend>a</run_depend>"], ("build", "exec"), 1,
     ["<build_depend>a</build_depend>", "+<build_depend>new</build_depend>",
      "<run_depend>a</run_depend>", "+<run_depend>new</run_depend>"]),
    # Alphabetical where the file is.
    (3, ["<depend>a</depend>", "<depend>z</depend>"], C_PLUS_PLUS, 2,
     ["<depend>a</depend>", "+<depend>new</depend>", "<depend>z</depend>"]),
    (3, ["<depend>p</depend>", "<depend>z</depend>"], C_PLUS_PLUS, 2,
     ["+<depend>new</depend>", "<depend>p</depend>", "<depend>z</depend>"]),
    (3, ["<depend>z</depend>", "<depend>a</depend>"], C_PLUS_PLUS, 2,
     ["<depend>z</depend>", "<depend>a</depend>", "+<depend>new</depend>"]),
    (3, ["<depend>z</depend>", "", "<depend>a</depend>", "<depend>p</depend>"], C_PLUS_PLUS, 2,
     ["<depend>z</depend>", "", "<depend>a</depend>", "+<depend>new</depend>",
      "<depend>p</depend>"]),
    # A comment at the end of a line stays there.
    (3, ["<depend>a</depend> <!-- why -->", "<export/>"], C_PLUS_PLUS, 2,
     ["<depend>a</depend> <!-- why -->", "+<depend>new</depend>", "<export/>"]),
    # Conditions.
    (3, ['<depend condition="$ROS_VERSION == 1">new</depend>'], C_PLUS_PLUS, 1,
     ['<depend condition="$ROS_VERSION == 1">new</depend>']),
    (3, ['<depend condition="$ROS_VERSION == 1">new</depend>'], C_PLUS_PLUS, 2,
     ['<depend condition="$ROS_VERSION == 1">new</depend>',
      '+<depend condition="$ROS_VERSION == 2">new</depend>']),
    (3, ["<depend condition='$ROS_VERSION == 1'>a</depend>",
         "<depend condition='$ROS_VERSION == 2'>a</depend>", "<depend>b</depend>"], C_PLUS_PLUS, 2,
     ["<depend condition='$ROS_VERSION == 1'>a</depend>",
      "<depend condition='$ROS_VERSION == 2'>a</depend>",
      "+<depend condition='$ROS_VERSION == 2'>new</depend>", "<depend>b</depend>"]),
    (3, ['<depend condition="$ROS_DISTRO == humble">new</depend>'], ("exec",), 2,
     ['<depend condition="$ROS_DISTRO == humble">new</depend>',
      "+<depend>new</depend>"]),
    (2, ["<buildtool_depend>catkin</buildtool_depend>", "<exec_depend>a</exec_depend>",
         "<export><metapackage/></export>"], ("exec",), 1,
     ["<buildtool_depend>catkin</buildtool_depend>", "<exec_depend>a</exec_depend>",
      "+<exec_depend>new</exec_depend>", "<export><metapackage/></export>"]),
]  # fmt: skip


@pytest.mark.parametrize("newline", ["\n", "\r\n"])
@pytest.mark.parametrize(("number", "lines", "needs", "ros", "expected"), CASES)
def test_a_dependency_stands_behind_its_like(
    number: int,
    lines: list[str],
    needs: tuple[str, ...],
    ros: int,
    expected: list[str],
    newline: str,
) -> None:
    package = package_of(lines, number, newline)
    added = add_dependency(package, "new", needs, ros)
    assert added.package is not None
    assert lines_of(added.package) == [line.removeprefix("+") for line in expected]
    assert len(added.tags) == sum(line.startswith("+") for line in expected)
    removed = remove_dependency(added.package, "new", ros, added.tags)
    assert removed.package is not None
    if added.tags:
        assert removed.package.document.text == package.document.text
        assert removed.tags == added.tags


METAPACKAGE = ["<buildtool_depend>catkin</buildtool_depend>", "<export><metapackage/></export>"]
REFUSED = [
    (METAPACKAGE, "new", ("build",), "a metapackage has no `<build_depend>`, as on `new`"),
    ([], "rover", ("exec",), "a package cannot depend on itself"),
]


@pytest.mark.parametrize(("lines", "name", "needs", "message"), REFUSED)
def test_what_the_build_tools_would_refuse_is_refused(
    lines: list[str], name: str, needs: tuple[str, ...], message: str
) -> None:
    edit = add_dependency(package_of(lines), name, needs, 1)
    assert edit.package is None
    assert [(one.code, one.message) for one in edit.diagnostics] == [("edit-refused", message)]


@pytest.mark.parametrize(("needs", "tag"), [("exec", "run_depend"), ("build", "build_depend")])
def test_the_first_format_takes_nothing_beside_a_test_depend(needs: str, tag: str) -> None:
    package = package_of(["<test_depend>new</test_depend>"], 1)
    [told] = add_dependency(package, "new", {needs}, 1).diagnostics
    assert told.code == "edit-refused"
    assert f"no `<{tag}>` on `new` beside the `<test_depend>`" in told.message
    assert told.span is not None and told.help is not None
    text = package.document.text
    assert text[told.span.start : told.span.end] == b"test_depend"
    assert f"`<{tag}>` in its place" in told.help


@st.composite
def files(draw: st.DrawFn) -> bytes:
    number = draw(st.sampled_from([1, 2, 3]))
    names = st.sampled_from(["a", "new", "tf2", "z"])
    lines = []
    for tag in draw(st.lists(st.sampled_from(DEPENDENCY_TAGS[number]), max_size=6)):
        condition = ""
        if number == 3:
            conditions = ["", "$ROS_VERSION == 1", "$ROS_VERSION == 2", "$X == y"]
            condition = draw(st.sampled_from(conditions))
        written = f' condition="{condition}"' if condition else ""
        lines.append(f"<{tag}{written}>{draw(names)}</{tag}>")
        lines += draw(st.sampled_from([[], [], [""], ["<!-- more -->"]]))
    root = f'<package format="{number}">'
    return "\n".join([root, HEAD, *lines, "</package>"]).encode()


@given(files(), st.sets(st.sampled_from(sorted(NEEDS - {"doc"}))), st.sampled_from([1, 2]))
def test_what_is_added_is_there_and_goes_without_a_trace(
    text: bytes, needs: set[str], ros: int
) -> None:
    package = read_package(text).package
    assert package is not None
    if package.format == 1:
        needs -= {"buildtool_export"}
    if ("test_depend", "new") in [(one.tag, one.name) for one in package.dependencies]:
        # Format 1 takes no other one beside it.
        needs &= {"test"} if package.format == 1 else NEEDS
    added = add_dependency(package, "new", needs, ros)
    assert added.package is not None
    variables = {"ROS_VERSION": str(ros)}
    covered = added.package.covered("new", variables)
    assert needs - covered <= ({"test"} if covered & {"build", "exec"} else set())
    assert add_dependency(added.package, "new", needs, ros).tags == ()
    if set(added.tags) & {one.tag for one in package.dependencies if one.name == "new"}:
        return
    removed = remove_dependency(added.package, "new", ros, added.tags)
    assert removed.package is not None
    assert removed.package.document.text == package.document.text


def test_a_group_is_of_format_3() -> None:
    package = package_of(["<export/>"])
    added = add_group(package, "rosidl_interface_packages")
    assert added.package is not None
    group = "<member_of_group>rosidl_interface_packages</member_of_group>"
    assert lines_of(added.package) == [group, "<export/>"]
    refused = add_group(package_of([], 2), "rosidl_interface_packages")
    assert refused.package is None
    assert [one.code for one in refused.diagnostics] == ["edit-refused"]
