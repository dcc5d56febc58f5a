"""What RK501 says is to be written into package.xml: it mends it, and package.xml stays valid."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from packages import CATKIN, CMAKE, PYTHON, found_in

from plastron_tui.lint.rules.package_examples import package_xml, setup_py
from plastron_tui.sources.xml.package_xml import read_package

_TAG = re.compile(r"`<(\w+)>geometry_msgs</\w+>`")
_FILES = {"wheels": PYTHON, "rover": CMAKE, "old": CATKIN}
_WRITE = "write `<{0}>geometry_msgs</{0}>` into package.xml"
_BOTH = _WRITE.replace("write ", "write `<build_depend>geometry_msgs</build_depend>` and ")


def _tag(tag: str, name: str = "geometry_msgs", condition: str = "") -> str:
    return (
        f'<{tag} condition="{condition}">{name}</{tag}>' if condition else f"<{tag}>{name}</{tag}>"
    )


_CASES = [
    # Nothing is there: the tags of the format.
    ("wheels", 3, "", _WRITE.format("exec_depend"), "does not depend on it"),
    ("rover", 3, "", _WRITE.format("depend"), "does not depend on it"),
    ("old", 2, "", _WRITE.format("depend"), "does not depend on it"),
    ("old", 1, "", _BOTH.format("run_depend"), "does not depend on it"),
    # A part is there: no tag that says it again.
    ("rover", 3, _tag("exec_depend"), _WRITE.format("build_depend"), "`<exec_depend>` alone"),
    ("rover", 3, _tag("test_depend"), _WRITE.format("depend"), "`<test_depend>` alone"),
    ("old", 2, _tag("build_depend"), _WRITE.format("exec_depend"), "`<build_depend>` alone"),
    ("old", 2, _tag("build_depend") * 2, _WRITE.format("exec_depend"), "`<build_depend>` alone"),
    ("old", 2, _tag("build_export_depend"), _BOTH.format("exec_depend"), "_depend>` alone"),
    ("old", 1, _tag("build_depend"), _WRITE.format("run_depend"), "`<build_depend>` alone"),
    ("old", 1, _tag("test_depend"),
     f"{_BOTH.format('run_depend')} in place of the `<test_depend>`", "`<test_depend>` alone"),
    # It is there for the other generation, by another name, or among others.
    ("wheels", 3, _tag("exec_depend", condition="$ROS_VERSION == 1"),
     "write a condition of `<exec_depend>` that holds for ROS 2, too", "has it for ROS 1 alone"),
    ("wheels", 3, _tag("exec_depend", "geometry-msgs"),
     "write `geometry_msgs` in place of `geometry-msgs`", "says `geometry-msgs`"),
    ("wheels", 3, _tag("exec_depend", "geometry_msg"),
     "write `geometry_msgs` in place of `geometry_msg`", "says `geometry_msg`"),
    ("rover", 3, _tag("depend", "goemetry_msgs"),
     "write `geometry_msgs` in place of `goemetry_msgs`", "says `goemetry_msgs`"),
    ("wheels", 3, _tag("exec_depend", "geometry_2msgs"),
     _WRITE.format("exec_depend"), "does not depend on it"),
    ("old", 2, _tag("build_depend", "rospy geometry_msgs"),
     "write a tag for each name of `rospy geometry_msgs`", "names it in a tag of several"),
]  # fmt: skip


def _package(name: str, format_: int, lines: str) -> str:
    """Return the package.xml of a package, with other lines for what it uses."""
    text = _FILES[name][f"{name}/package.xml"]
    text = re.sub(r"  <\w*depend>geometry_msgs</\w*depend>\n", lines, text)
    text = re.sub(r'format="\d"', f'format="{format_}"', text)
    if format_ > 1:
        return text
    for old in ("depend", "exec_depend"):
        text = text.replace(f"<{old}>", "<run_depend>").replace(f"</{old}>", "</run_depend>")
    return text


@pytest.mark.parametrize(("name", "format_", "lines", "remedy", "message"), _CASES)
def test_remedy_mends_a_valid_package(
    name: str, format_: int, lines: str, remedy: str, message: str, tmp_path: Path
) -> None:
    text = _package(name, format_, f"  {lines}\n")
    files = {**_FILES[name], f"{name}/package.xml": text}
    found = [x.diagnostic for x in found_in(tmp_path / "a", files) if x.rule.code == "RK501"]
    assert [each.help and each.help.partition(", and `find")[0] for each in found] == [remedy]
    assert message in found[0].message
    if not (tags := _TAG.findall(remedy)):
        return
    kept = "" if "in place" in remedy else lines
    written = "".join(f"  {_tag(each)}\n" for each in tags)
    files[f"{name}/package.xml"] = _package(name, format_, f"  {kept}\n{written}")
    package, wrong = read_package(files[f"{name}/package.xml"].encode(), Path("package.xml"))
    assert package is not None and wrong == ()
    assert "RK501" not in [x.rule.code for x in found_in(tmp_path / "b", files)]


@pytest.mark.parametrize(
    ("more", "is_slip"),
    [
        ({}, True),
        ({"geometry_msg/package.xml": package_xml("geometry_msg"),
          "geometry_msg/setup.py": setup_py(name="geometry_msg")}, False),
        ({"wheels/wheels/other.py": "import geometry_msg\n"}, False),
    ],
)  # fmt: skip
def test_name_that_is_a_slip_is_of_no_package(
    more: dict[str, str], is_slip: bool, tmp_path: Path
) -> None:
    text = _package("wheels", 3, f"  {_tag('exec_depend', 'geometry_msg')}\n")
    found = found_in(tmp_path, {**PYTHON, "wheels/package.xml": text, **more})
    helps = [x.diagnostic.help or "" for x in found if x.rule.code == "RK501"]
    assert ["in place of" in each for each in helps] == [is_slip]
