"""Names, addresses and versions of packages: what catkin_pkg takes, and what REP 144 adds."""

from __future__ import annotations

import re

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from plastron_tui.ros.package_keys import key_of_module
from plastron_tui.ros.packages import (
    check_mail,
    check_package_name,
    check_version,
    mended_package_name,
    parse_maintainer,
    taken_package_name,
)

TEXTS = st.one_of(
    st.text(max_size=20),
    st.text("aB1_-.@%+é <>", max_size=20),
    st.from_regex(r"[a-z.]{1,5}@[a-z0-9-]{1,5}(\.[a-z]{0,3}){0,3}", fullmatch=True),
    st.from_regex(r"[0-9]{1,2}\.[0-9]{1,2}\.[0-9]{1,2}", fullmatch=True),
)


@pytest.mark.parametrize(
    ("name", "start", "length", "better"),
    [
        ("", 0, 0, None),
        ("MyRobot", 0, 1, "my_robot"),
        ("my-robot", 2, 1, "my_robot"),
        ("my robot", 2, 1, "my_robot"),
        ("2robots", 0, 1, "package_2robots"),
        ("_robot", 0, 1, "robot"),
        ("my__robot", 2, 2, "my_robot"),
        ("r", 0, 1, None),
        ("roboté", 5, 1, "robot"),
        ("a/../b", 1, 4, "a_b"),
    ],
)
def test_wrong_name(name: str, start: int, length: int, better: str | None) -> None:
    problem = check_package_name(name)
    assert problem is not None
    assert (problem.offset, problem.length, problem.suggestion) == (start, length, better)


@given(TEXTS)
def test_name_is_one_that_rep_144_allows(name: str) -> None:
    is_allowed = re.fullmatch(r"[a-z][a-z0-9_]+", name) is not None and "__" not in name
    assert (check_package_name(name) is None) == is_allowed
    mended = mended_package_name(name)
    assert mended is None or check_package_name(mended) is None


@given(TEXTS)
@example(f"{'a' * 243}@example.com")
def test_address_is_one_that_catkin_pkg_takes(mail: str) -> None:
    package = pytest.importorskip("catkin_pkg.package")
    try:
        package.Person("Ada", mail).validate()
        is_allowed = "\n" not in mail
    except package.InvalidPackage:
        is_allowed = False
    problem = check_mail(mail)
    assert (problem is None) == is_allowed
    assert problem is None or problem.offset + problem.length <= len(mail)


@given(TEXTS)
def test_version_is_one_that_catkin_pkg_takes_without_a_warning(version: str) -> None:
    number = r"(0|[1-9][0-9]*)"
    is_allowed = re.fullmatch(rf"{number}\.{number}\.{number}", version) is not None
    assert (check_version(version) is None) == is_allowed


@pytest.mark.parametrize(
    ("text", "start", "length"),
    [
        ("Ada", 0, 3),
        ("ada@example.com", 0, 15),
        ("Ada <ada>", 5, 3),
        ("Ada <ada@example>", 9, 7),
        ("Ada <ada@example.c>", 9, 9),
        ("Ada <ada@example.c0m>", 9, 11),
        ("Ada <a da@example.com>", 6, 1),
        ("<ada@example.com>", 0, 17),
        ("Ada <a..b@example.com>", 5, 4),
    ],
)
def test_wrong_maintainer(text: str, start: int, length: int) -> None:
    found, problem = parse_maintainer(text)
    assert found is None
    assert problem is not None
    assert (problem.offset, problem.length) == (start, length)


@given(TEXTS)
def test_a_maintainer_is_read_or_told(text: str) -> None:
    found, problem = parse_maintainer(text)
    assert (found is None) != (problem is None)


@pytest.mark.parametrize(
    ("module", "ros_version", "key"),
    [
        ("numpy", 2, "python3-numpy"),
        ("google.protobuf.message", 1, "python3-protobuf"),
        ("google", 2, None),
        ("tf2_ros", 1, "tf2_ros"),
        ("tf2_ros", 2, "tf2_ros_py"),
        ("rospy", 2, None),
        ("std_msgs.msg", 2, "std_msgs"),
        ("no_such_thing", 2, None),
    ],
)
def test_key_of_a_module(module: str, ros_version: int, key: str | None) -> None:
    assert key_of_module(module, ros_version, {"std_msgs"}) == key


@pytest.mark.parametrize(
    ("name", "owner"), [("class", "word of Python"), ("json", "module"), ("rover", None)]
)
def test_names_that_python_has(name: str, owner: str | None) -> None:
    taken = taken_package_name(name)
    assert owner in taken if owner is not None and taken is not None else taken is owner
