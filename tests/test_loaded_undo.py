"""Whatever a build file lets a program add, it lets a later program take out to the byte."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_packages import AMENT_CMAKE, AMENT_PYTHON, CATKIN, IN, KINDS, OUT, lay, run, texts

from plastron_tui.diagnostics import Severity

_CMAKE_CALL = "install(PROGRAMS\n  nodes/listener.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n"
_CATKIN_CALL = """\
catkin_install_python(PROGRAMS scripts/listener.py
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
"""
_HERE = "${CMAKE_CURRENT_SOURCE_DIR}"

AMENT_CALLS = {
    "one of a line": "install(PROGRAMS nodes/listener.py DESTINATION lib/demo)\n",
    "a list": (
        "set(scripts nodes/listener.py)\ninstall(PROGRAMS ${scripts} DESTINATION lib/demo)\n"
    ),
    "an appended list": (
        "set(scripts)\nlist(APPEND scripts\n  nodes/listener.py\n)\n"
        "install(PROGRAMS ${scripts} DESTINATION lib/demo)\n"
    ),
    "a pattern": "file(GLOB x nodes/*.py)\ninstall(PROGRAMS ${x} DESTINATION lib/demo)\n",
    "a pattern by whole paths": (
        f"file(GLOB x CONFIGURE_DEPENDS {_HERE}/nodes/*.py)\n"
        "install(PROGRAMS ${x} DESTINATION lib/${PROJECT_NAME})\n"
    ),
    "relative patterns": (
        f"file(GLOB x RELATIVE {_HERE} nodes/*.py bin/*)\n"
        "install(PROGRAMS ${x} DESTINATION lib/${PROJECT_NAME})\n"
    ),
    "patterns of all depths": (
        "file(GLOB_RECURSE x nodes/*.py)\ninstall(PROGRAMS ${x} DESTINATION lib/demo)\n"
    ),
    "a pattern and a name": (
        "file(GLOB x nodes/l*.py)\ninstall(PROGRAMS ${x} nodes/b.py DESTINATION lib/demo)\n"
    ),
    "a loop over names": (
        "foreach(x listener)\n"
        "  install(PROGRAMS nodes/${x}.py DESTINATION lib/demo)\nendforeach()\n"
    ),
    "a loop that has it already": (
        "foreach(x listener talker)\n"
        "  install(PROGRAMS nodes/${x}.py DESTINATION lib/demo)\nendforeach()\n"
    ),
    "a loop over a pattern": (
        "file(GLOB all nodes/*.py)\nforeach(x ${all})\n"
        "  install(PROGRAMS ${x} DESTINATION lib/demo)\nendforeach()\n"
    ),
    "a name that is there already": (
        "install(PROGRAMS nodes/listener.py nodes/talker.py DESTINATION lib/demo)\n"
    ),
    "a branch": "if(X)\n  install(PROGRAMS nodes/talker.py DESTINATION lib/demo)\nendif()\n",
    "a folder": ("install(DIRECTORY nodes/ DESTINATION lib/demo USE_SOURCE_PERMISSIONS)\n"),
    "another name": "install(PROGRAMS nodes/listener.py DESTINATION lib/demo RENAME listener)\n",
    "nothing": "",
}
CATKIN_CALLS = {
    "a pattern": (
        "file(GLOB x scripts/*)\n"
        "install(PROGRAMS ${x} DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n"
    ),
    "a pattern for catkin": (
        f"file(GLOB x {_HERE}/scripts/*.py)\n"
        "catkin_install_python(PROGRAMS ${x} DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n"
    ),
    "a folder": (
        "install(DIRECTORY scripts/ DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION}\n"
        '  USE_SOURCE_PERMISSIONS PATTERN ".svn" EXCLUDE)\n'
    ),
    "nothing": "",
}
_LISTENER = "            'listener = demo.listener:main',  # hears it\n"
SETUPS = {
    "a loop": "            f'{x} = demo.{x}:main' for x in ['listener']\n",
    "nothing": "",
}
CASES = {
    **{
        f"ament: {name}": (
            "rclpy",
            {
                **AMENT_CMAKE,
                "nodes/b.py": "",
                "CMakeLists.txt": AMENT_CMAKE["CMakeLists.txt"].replace(_CMAKE_CALL, call),
            },
        )
        for name, call in AMENT_CALLS.items()
    },
    **{
        f"catkin: {name}": (
            "rospy",
            {**CATKIN, "CMakeLists.txt": CATKIN["CMakeLists.txt"].replace(_CATKIN_CALL, call)},
        )
        for name, call in CATKIN_CALLS.items()
    },
    **{
        f"setup: {name}": (
            "rclpy",
            {**AMENT_PYTHON, "setup.py": AMENT_PYTHON["setup.py"].replace(_LISTENER, scripts)},
        )
        for name, scripts in SETUPS.items()
    },
}


@pytest.mark.parametrize("runs", [1, 2])
@pytest.mark.parametrize("name", CASES)
def test_what_was_added_is_taken_out(name: str, runs: int, tmp_path: Path) -> None:
    library, files = CASES[name]
    package = lay(tmp_path, files)
    before = texts(package)
    for _ in range(runs):
        assert run(IN, tmp_path, library, in_place=True) == ()
    told = run(OUT, tmp_path, library, in_place=True)
    assert [each.code for each in told] == ["file-stays"]
    assert {each: texts(package)[each] for each in before} == before
    run(OUT, tmp_path, library, in_place=True)
    assert {each: texts(package)[each] for each in before} == before


def test_what_installs_it_still_is_told(tmp_path: Path) -> None:
    library, files = CASES["ament: a pattern"]
    lay(tmp_path, files)
    run(IN, tmp_path, library, in_place=True)
    [told] = run(OUT, tmp_path, library, in_place=True)
    assert "line 11 of `CMakeLists.txt`, which was there before the node" in told.message


def test_what_a_pattern_installs_that_no_program_added_is_not_taken_out(tmp_path: Path) -> None:
    library, files = CASES["ament: a pattern"]
    package = lay(tmp_path, files)
    before = texts(package)
    program = OUT.replace("'talker'", "'listener'")
    [told] = run(program, tmp_path, library, in_place=True)
    assert told.code == "computed-build-file"
    assert "line 11 of `CMakeLists.txt`" in told.message
    assert texts(package) == before


_BRINGUP = """\
load_package 'demo' as demo
create_launch 'bringup' as bringup
bringup starts 'other/eye'
demo contains bringup
generate_package demo
"""
_OTHER_NAME = "name it otherwise: `contains … as 'other_name'`"
_LOAD = "change it with `load_launch`, or call this one another name than `bringup`"


@pytest.mark.parametrize("in_place", [False, True])
@pytest.mark.parametrize(
    ("program", "file", "help_"),
    [(IN, "nodes/talker.py", _OTHER_NAME), (_BRINGUP, "launch/bringup.launch.xml", _LOAD)],
)
def test_the_remedy_for_a_file_that_is_there_works(
    program: str, file: str, help_: str, in_place: bool, tmp_path: Path
) -> None:
    lay(tmp_path, {**AMENT_CMAKE, file: "by hand\n"})
    [told] = run(program, tmp_path, "rclpy", in_place=in_place)
    assert (told.code, told.help) == ("already-contained", help_)


@pytest.mark.parametrize("program", [IN, _BRINGUP])
def test_what_an_earlier_run_put_in_place_is_written_in_place(program: str, tmp_path: Path) -> None:
    lay(tmp_path, AMENT_CMAKE)
    assert run(program, tmp_path, "rclpy", in_place=True) == ()
    changed = program.replace("2 hz", "3 hz").replace("'other/eye'", "'other/ear'")
    [told] = run(changed, tmp_path, "rclpy")
    help_ = "write over it with `--in-place`, as the run did that made it"
    assert (told.code, told.help) == ("already-contained", help_)
    assert run(changed, tmp_path, "rclpy", in_place=True) == ()


LAUNCH = """\
<launch>
  <group>
    <node pkg="demo" {0}="listener" name="ears"/>
  </group>
  <node pkg="other" {0}="listener" name="others"/>
</launch>
"""
TAKEN = "load_launch 'demo/launch/a.launch.xml' as a\na no_longer_starts 'ears'\n"


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_taken_out_is_not_taken_out_twice(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, files)
    program = OUT.replace("talker", "listener")
    assert [each.code for each in run(program, tmp_path, library, in_place=True)] == ["file-stays"]
    after = texts(package)
    assert run(program, tmp_path, library, in_place=True) == ()
    assert texts(package) == after
    [stays] = package.rglob("listener.py")
    stays.unlink()
    told = run(program, tmp_path, library, in_place=True)
    assert [(each.code, each.severity) for each in told] == [("not-contained", Severity.WARNING)]


@pytest.mark.parametrize("in_place", [False, True])
@pytest.mark.parametrize(
    ("change", "told"),
    [
        ("", ["line 3 of `launch/a.launch.xml` starts `listener` still"]),
        (f"{TAKEN}generate_launch a\n", []),
        (f"{TAKEN}demo contains a\n", []),
    ],
)
def test_a_launch_file_that_starts_what_is_taken_out_is_told(
    change: str, told: list[str], in_place: bool, tmp_path: Path
) -> None:
    lay(tmp_path, {**AMENT_PYTHON, "launch/a.launch.xml": LAUNCH.format("exec")})
    start, out, end = OUT.replace("talker", "listener").splitlines(keepends=True)
    found = run(f"{start}{out}{change}{end}", tmp_path, "rclpy", in_place=in_place)
    assert [each.message for each in found if each.code == "still-started"] == told
    assert all(each.severity is Severity.WARNING and each.span is not None for each in found)
