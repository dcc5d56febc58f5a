"""A package.xml is read and judged as catkin_pkg does it for the build tools."""

from __future__ import annotations

import pytest

from plastron_tui.sources.xml.package_xml import read_package

verdicts = pytest.importorskip("verdicts")

# Of catkin_pkg, about pyparsing.
pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")

HEAD = (
    "<name>rover</name><version>0.1.0</version><description>A rover.</description>"
    '<maintainer email="ada@example.org">Ada</maintainer><license>MIT</license>'
)


def of(content: str, number: int | None = 3) -> bytes:
    written = f' format="{number}"' if number is not None else ""
    return f"<package{written}>{content}</package>".encode()


GOOD = [
    of(HEAD),
    of(HEAD, None),
    of(HEAD + "<build_depend>a</build_depend><run_depend version_gte='1.0'>a</run_depend>", 1),
    of(HEAD + "<test_depend>b</test_depend><buildtool_depend>catkin</buildtool_depend>", 1),
    of(HEAD + "<depend>a</depend><exec_depend>b</exec_depend><exec_depend>b</exec_depend>", 2),
    of(HEAD + "<depend condition='$ROS_VERSION == 2'>a</depend><depend>a</depend>"),
    of(HEAD + "<depend condition='($A == b or $C != \"d e\") and 1 &lt; 2'>a</depend>"),
    of(HEAD + "<member_of_group>g</member_of_group><group_depend>h</group_depend>"),
    of(HEAD + "<license file='LICENSE'>BSD</license><url type='bugtracker'>http://x</url>"),
    of(HEAD + "<author>Bo</author><author email='bo@example.org'>Bo</author>"),
    of(HEAD + "<export><build_type>ament_cmake</build_type><x a='1'><y/></x></export>"),
    of(HEAD + "<conflict>c</conflict><replace version_lt='2'>d</replace>"),
    of(HEAD.replace("A rover.", "A <b>good</b> one.<br/>Really &amp; <!-- not --> so.")),
    of(HEAD + "<!-- a comment --><?go on?><depend> a <!-- b -->\n</depend>"),
    of(HEAD + "<depend>é</depend>"),
]

WARNED = [
    of(HEAD.replace("rover<", "Rover<")),
    of(HEAD.replace("rover<", "2rover<")),
    of(HEAD.replace("0.1.0", "0.01.0")),
    of(HEAD + "<export><metapackage/></export>"),
    of(
        HEAD + "<buildtool_depend>catkin</buildtool_depend><build_depend>a</build_depend>"
        "<export><metapackage/></export>"
    ),
]

BAD = [
    b"<package>",
    b"<robot/>",
    b"",
    of(HEAD, 4),
    of(HEAD.replace("<name>rover</name>", "")),
    of(HEAD + "<name>rover</name>"),
    of(HEAD.replace("rover<", "<")),
    of(HEAD.replace("rover<", "ro ver<")),
    of(HEAD.replace("0.1.0", "0.1")),
    of(HEAD.replace("0.1.0", "0.1.0-beta")),
    of(HEAD.replace("<version>", "<version compatibility='1'>")),
    of(HEAD.replace("A rover.", " ")),
    of(HEAD.replace("ada@example.org", "ada")),
    of(HEAD.replace("ada@example.org", "ada@example")),
    of(HEAD.replace("ada@example.org", "")),
    of(HEAD.replace(' email="ada@example.org"', "")),
    of(HEAD.replace("<license>MIT</license>", "")),
    of(HEAD.replace("MIT", "  ")),
    of(HEAD + "<author email=''>Bo</author>"),
    of(HEAD + "<author email='bo at home'>Bo</author>"),
    of(HEAD + "<depend>rover</depend>"),
    of(HEAD + "<doc_depend>rover</doc_depend>"),
    of(HEAD + "<depend>a</depend><depend>a</depend>"),
    of(HEAD + "<depend>a</depend><exec_depend>a</exec_depend>"),
    of(HEAD + "<run_depend>a</run_depend>"),
    of(HEAD + "<exec_depend>a</exec_depend>", 1),
    of(HEAD + "<depend>a</depend>", 1),
    of(HEAD + "<run_depend>a</run_depend><test_depend>a</test_depend>", 1),
    of(HEAD + "<member_of_group>g</member_of_group>", 2),
    of(HEAD + "<depend condition='1 == 1'>a</depend>", 2),
    of(HEAD + "<depend condition='$ROS_VERSION'>a</depend>"),
    of(HEAD + "<depend condition='1 == 1 and'>a</depend>"),
    of(HEAD + "<depend version='1'>a</depend>"),
    of(HEAD + "<depend>a<b/></depend>"),
    of(HEAD + "<member_of_group>g</member_of_group><group_depend>g</group_depend>"),
    of(HEAD + "<export/><export/>"),
    of(HEAD + "<export><build_type>a</build_type><build_type>b</build_type></export>"),
    of(HEAD + "<dependency>a</dependency>"),
    of(HEAD).replace(b"format", b"formats"),
]


@pytest.mark.parametrize("text", [*GOOD, *WARNED])
def test_what_is_good_is_read_as_catkin_reads_it(text: bytes) -> None:
    theirs, warns = verdicts.catkin(text)
    ours, ours_warns = verdicts.plastron(text)
    assert theirs is not None and ours is not None
    assert verdicts.own_facts(ours) == verdicts.facts(theirs)
    assert (warns, ours_warns) == (text in WARNED, text in WARNED)


@pytest.mark.parametrize("text", BAD)
def test_what_is_bad_is_refused_as_catkin_refuses_it(text: bytes) -> None:
    assert verdicts.catkin(text)[0] is None
    assert verdicts.plastron(text)[0] is None


PLACES = [
    (HEAD.replace("ada@example.org", "ada"), "ada", "`ada` is no mail address"),
    (HEAD.replace("0.1.0", "0.1"), "0.1", "`0.1` is no version: it is three numbers, as in 0.1.0"),
    (HEAD.replace("rover<", "ro ver<"), "ro ver", "no package can be called `ro ver`"),
    (HEAD + "<depend> rover\n</depend>", "rover", "a package cannot depend on itself"),
    (HEAD + "<depend condition='x'>a</depend>", "x", "`x` is no condition"),
    (
        HEAD + "<run_depend>a</run_depend>",
        "run_depend",
        "there is no `<run_depend>` in a package.xml of format 3",
    ),
    (
        HEAD + "<depend>a</depend><exec_depend>a</exec_depend>",
        "a",
        "`<exec_depend>` and `<depend>` both name `a`",
    ),
]


@pytest.mark.parametrize(("content", "wrong", "message"), PLACES)
def test_a_mistake_is_told_at_its_place(content: str, wrong: str, message: str) -> None:
    text = of(content)
    (diagnostic,) = read_package(text).diagnostics
    assert (diagnostic.code, diagnostic.message) == ("broken-package", message)
    assert diagnostic.span is not None
    assert text[diagnostic.span.start : diagnostic.span.end].decode() == wrong


def test_the_build_type_follows_its_condition() -> None:
    package = read_package(
        of(
            HEAD + "<export><build_type condition='$ROS_VERSION == 1'>catkin</build_type>"
            "<build_type condition='$ROS_VERSION == 2'>ament_cmake</build_type></export>"
        )
    ).package
    assert package is not None
    assert package.build_type({"ROS_VERSION": "1"}) == "catkin"
    assert package.build_type({"ROS_VERSION": "2"}) == "ament_cmake"
