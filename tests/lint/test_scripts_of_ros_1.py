"""Scripts that ROS 1 starts from the workspace, and that somebody installs or forgot to."""

from __future__ import annotations

from pathlib import Path

import pytest
from packages import CATKIN, CATKIN_LISTS, ROS1_NODE, Break, told_of

_ONE = "scripts/mover.py\n"
_LAUNCH = '<launch>\n  <node pkg="old" type="{}" name="other"/>\n</launch>\n'
_UNDER = (
    '<launch>\n  <arg name="has_joy" default="false"/>\n{}'
    '  <node if="$(arg has_joy)" pkg="old" type="{}" name="other"/>\n</launch>\n'
)
_FURTHER = {"old/scripts/mover": ROS1_NODE, "old/scripts/other": ROS1_NODE}
_STARTED = _FURTHER | {"old/launch/more.launch": _LAUNCH.format("other")}
_NO_MAIN = ROS1_NODE.replace("if __name__ == '__main__':", "if True:")
_SHARE = CATKIN_LISTS.replace("_BIN_DESTINATION}", "_SHARE_DESTINATION}/scripts")
_NOTHING = CATKIN_LISTS.partition("catkin_install")[0]
_TWO = {"old/scripts/other.py": ROS1_NODE, "old/launch/more.launch": _LAUNCH.format("other.py")}
_PROGRAMS = ("old/scripts/mover.py", "old/scripts/mover", "old/scripts/other")
_BOTH = (*_PROGRAMS, "old/scripts/other.py")
_LISTS = "old/CMakeLists.txt"


def _launch(type_: str, found: str, above: str = "", **more: str) -> Break:
    text = _UNDER.format(above, type_)
    return Break("old/launch/more.launch", "", text, found, _FURTHER | more)


_CASES = [
    # One of the scripts of a folder is not installed, and a launch file starts it.
    (Break(_LISTS, _ONE, "scripts/mover.py scripts/mover\n", "RK503 old/scripts/other:5",
           _STARTED), _PROGRAMS),
    (Break(_LISTS, _ONE, "scripts/mover.py scripts/mover scripts/other\n", "", _STARTED),
     _PROGRAMS),
    # No launch file starts it: it is told where it alone is left out of several.
    (Break(_LISTS, _ONE, "scripts/mover.py scripts/mover\n", "RK503 old/scripts/other:5",
           _FURTHER), _PROGRAMS),
    (Break(_LISTS, "", CATKIN_LISTS, "", _FURTHER), _PROGRAMS),
    # Nothing is installed at all, so people work in the workspace.
    (Break(_LISTS, "", _NOTHING, "", _STARTED), _PROGRAMS),
    # Where nodes are shared, as ROS 1 may start them.
    (Break(_LISTS, "", _SHARE, "RK503 old/scripts/other.py:5", _TWO), _BOTH),
    # Tests are run in the workspace.
    (Break(_LISTS, _ONE, "scripts/mover.py scripts/mover scripts/third\n", "",
           _FURTHER | {"old/scripts/fourth": ROS1_NODE, "old/scripts/third": ROS1_NODE,
                       "old/test/more.launch": _LAUNCH.format("other")}),
     (*_PROGRAMS, "old/scripts/third", "old/scripts/fourth")),
    # It is in another language.
    (Break(_LISTS, _ONE, "scripts/mover.py scripts/mover\n", "",
           _STARTED | {"old/scripts/other": "#!/bin/sh\nrosrun a b\n"}), _PROGRAMS),
    # The first line.
    (Break(_LISTS, _ONE, "scripts/mover.py scripts/other\n", "RK504 old/scripts/other:1",
           _STARTED | {"old/scripts/other": ROS1_NODE.partition("\n")[2]}), _PROGRAMS),
    (Break(_LISTS, _ONE, "scripts/mover.py scripts/other\n", "RK504 old/scripts/other:1",
           _STARTED | {"old/scripts/other": ROS1_NODE.replace("\n", "\r\n", 1)}), _PROGRAMS),
    # The mode of one that does all when it is read.
    (Break(_LISTS, "", _NOTHING, "RK504 old/scripts/other.py:1",
           _TWO | {"old/scripts/other.py": _NO_MAIN}), _PROGRAMS),
    (Break(_LISTS, "", _NOTHING, "", {"old/scripts/other.py": _NO_MAIN}), _PROGRAMS),
    # What hangs on an argument is started with another value of it.
    (_launch("others", "RK506 old/launch/more.launch:3"), _PROGRAMS),
    (_launch("mover", "RK503 old/scripts/mover:5"), _PROGRAMS),
    (_launch("mover", "", **{_LISTS: _NOTHING}), _PROGRAMS),
    (_launch("other.py", "RK504 old/scripts/other.py:1",
             **{"old/scripts/other.py": ROS1_NODE, _LISTS: _NOTHING}), _PROGRAMS),
    # What is chosen by another condition, of which nobody knows whether it holds then.
    (_launch("$(arg kind)", "", '  <arg name="kind" value="nothing" unless="$(arg has_joy)"/>\n'),
     _PROGRAMS),
    # A script that nobody can start yet uses what it uses all the same.
    (Break("old/scripts/other.py", "", ROS1_NODE.replace("geometry_msgs", "sensor_msgs"),
           "RK504 old/scripts/other.py:1, RK501 old/scripts/other.py:3",
           {"old/launch/more.launch": _LAUNCH.format("other.py"),
            _LISTS: _NOTHING}), _PROGRAMS),
    # Those of other packages, and what a comment has.
    *((Break("old/scripts/other.py", "", ROS1_NODE.replace("geometry_msgs", "sensor_msgs"), "",
             {"old/launch/more.launch": text, _LISTS: _NOTHING}), _PROGRAMS)
      for text in (_LAUNCH.format("other.py").replace('"old"', '"far"'),
                   _LAUNCH.format("other.py").replace("<node", "<!-- <node").replace(
                       "</launch", "--></launch"))),
    # The launch file may mean another one of that name.
    (Break("old/scripts/other.py", "", ROS1_NODE.replace("geometry_msgs", "sensor_msgs"), "",
           {"old/launch/more.launch": _LAUNCH.format("other.py"), _LISTS: _NOTHING,
            "old/nodes/other.py": ROS1_NODE}), (*_PROGRAMS, "old/nodes/other.py")),
]  # fmt: skip


@pytest.mark.parametrize(("case", "programs"), _CASES)
def test_script_is_told(case: Break, programs: tuple[str, ...], tmp_path: Path) -> None:
    assert told_of(tmp_path, case.files(CATKIN), programs) == case.found
