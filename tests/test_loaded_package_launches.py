"""Launch files that programs put into packages that exist, change there, and take out again."""

from __future__ import annotations

from pathlib import Path

import pytest
from loaded_packages import AMENT_CMAKE, KINDS, TALKER, lay, run, texts

from plastron_tui.ros.launch_names import LAUNCH_ENDINGS
from plastron_tui.sources.cmake.facts import covers, shared
from plastron_tui.sources.cmake.reader import read_cmake
from plastron_tui.sources.setup_py.reader import read_setup

BRINGUP = "create_launch 'bringup' as bringup\nbringup starts 'other/eye'\n"
WRITE = "demo contains bringup\ngenerate_package demo\n"
IN = f"load_package 'demo' as demo\n{BRINGUP}{WRITE}"
NODE_IN = f"{TALKER}demo contains talker\n{BRINGUP}bringup starts talker\n{WRITE}"
OUT = "load_package 'demo' as demo\ndemo no_longer_contains 'bringup'\ngenerate_package demo\n"
NAMES = {"rospy": "bringup.launch", "rclpy": "bringup.launch.xml"}
CHANGED = (
    "load_package 'demo' as demo\nload_launch 'demo/launch/{0}' as bringup\n"
    f"bringup starts 'more/ear'\n{WRITE}"
)


@pytest.mark.parametrize("kind", KINDS)
def test_a_launch_file_is_put_in_and_taken_out_to_the_byte(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, files)
    before = texts(package)
    name = f"launch/{NAMES[library]}"
    assert run(IN, tmp_path, library, in_place=True) == ()
    after = texts(package)
    assert set(after) == {*before, name}
    build = "setup.py" if kind == "ament_python" else "CMakeLists.txt"
    assert b"launch" in after[build].replace(before[build], b"")
    assert after[build] != before[build]
    assert b"<exec_depend>other</exec_depend>" in after["package.xml"]
    assert run(IN, tmp_path, library, in_place=True) == ()
    assert texts(package) == after
    assert [x.code for x in run(OUT, tmp_path, library, in_place=True)] == ["file-stays"]
    assert texts(package) == {**before, name: after[name]}


@pytest.mark.parametrize("kind", KINDS)
def test_output_gets_the_launch_file_and_what_installs_it(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, files)
    before = texts(package)
    assert run(NODE_IN, tmp_path, library) == ()
    assert texts(package) == before
    made = texts(tmp_path / "output" / "demo")
    assert b"talker" in made[f"launch/{NAMES[library]}"]
    assert set(made) >= {"package.xml", f"launch/{NAMES[library]}"}


@pytest.mark.parametrize("kind", KINDS)
def test_what_was_installed_before_stays_installed(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    package = lay(tmp_path, files)
    install = {
        "ament_python": ("setup.py", "['package.xml'])]",
                         "['package.xml']), ('share/demo/launch', glob('launch/*'))]"),
        "ament_cmake": ("CMakeLists.txt", "ament_package()",
                        "install(DIRECTORY launch DESTINATION share/demo)\nament_package()"),
        "catkin": ("CMakeLists.txt", "catkin_install_python",
                   "install(DIRECTORY launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})\n"
                   "catkin_install_python"),
    }[kind]  # fmt: skip
    file = package / install[0]
    file.write_text(
        file.read_text()
        .replace(*install[1:])
        .replace(
            "from setuptools import setup", "from glob import glob\nfrom setuptools import setup"
        )
    )
    before = texts(package)
    run(IN, tmp_path, library, in_place=True)
    run(IN, tmp_path, library, in_place=True)
    run(OUT, tmp_path, library, in_place=True)
    assert {name: texts(package)[name] for name in before} == before


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("in_place", [True, False])
def test_a_launch_file_of_the_package_is_changed_where_it_is(
    kind: str, in_place: bool, tmp_path: Path
) -> None:
    library, files = KINDS[kind]
    name = NAMES[library]
    launch = f"launch/{name}"
    word = "type" if library == "rospy" else "exec"
    text = f'<launch>\n  <node pkg="demo" {word}="listener" name="a"/>\n</launch>\n'
    package = lay(tmp_path, {**files, launch: text})
    before = texts(package)
    for _ in range(2):
        assert run(CHANGED.format(name), tmp_path, library, in_place=in_place) == ()
        made = texts(package if in_place else tmp_path / "output" / "demo")
        assert made[launch].count(b'"ear"') == (2 if library == "rospy" else 1)
        assert b"<exec_depend>more</exec_depend>" in made["package.xml"]
    assert in_place or texts(package) == before
    assert [x for x in tmp_path.rglob(name) if x.parent.name != "launch"] == []


def test_a_launch_file_that_is_there_is_not_written_over(tmp_path: Path) -> None:
    library, files = KINDS["ament_cmake"]
    package = lay(tmp_path, {**files, "launch/bringup.launch.xml": "<launch/>\n"})
    before = texts(package)
    [told] = run(IN, tmp_path, library, in_place=True)
    assert told.code == "already-contained"
    assert texts(package) == before


@pytest.mark.parametrize("place", ["demo/config/own.yaml", "own.yaml"])
def test_a_parameter_file_has_to_be_in_the_loaded_package(place: str, tmp_path: Path) -> None:
    library, files = KINDS["ament_python"]
    parameters = "ear:\n  ros__parameters:\n    loud: true\n"
    package = lay(tmp_path, {**files, "config/own.yaml": parameters})
    (tmp_path / "own.yaml").write_text(parameters)
    before = texts(package)
    bringup = BRINGUP.replace("'other/eye'", f"'other/eye' with parameters '{place}'")
    found = run(f"load_package 'demo' as demo\n{bringup}{WRITE}", tmp_path, library, in_place=True)
    if place == "own.yaml":
        assert [each.code for each in found] == ["edit-refused"]
        assert texts(package) == before
    else:
        assert found == ()
        launch = texts(package)["launch/bringup.launch.xml"]
        assert b"$(find-pkg-share demo)/config/own.yaml" in launch


INSTALLED = AMENT_CMAKE["CMakeLists.txt"].replace(
    "ament_package()",
    "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n\nament_package()",
)
OTHERS = ["y.launch.xml", "bringup_launch.py", "params.yaml", "robots/z.rviz"]


@pytest.mark.parametrize("other", OTHERS)
def test_the_folder_stays_installed_while_other_files_are_in_it(other: str, tmp_path: Path) -> None:
    package = lay(
        tmp_path,
        {
            **AMENT_CMAKE,
            "CMakeLists.txt": INSTALLED,
            "launch/x.launch.xml": "<launch/>\n",
            f"launch/{other}": "",
        },
    )
    before = texts(package)
    told = run(OUT.replace("bringup", "x"), tmp_path, "rclpy", in_place=True)
    assert [each.code for each in told] == ["file-stays"]
    assert texts(package) == before


@pytest.mark.parametrize("ending", LAUNCH_ENDINGS)
def test_a_launch_file_is_taken_out_by_its_name(ending: str, tmp_path: Path) -> None:
    package = lay(
        tmp_path, {**AMENT_CMAKE, "CMakeLists.txt": INSTALLED, f"launch/bringup{ending}": ""}
    )
    told = run(OUT, tmp_path, "rclpy", in_place=True)
    assert [each.code for each in told] == ["file-stays"]
    assert texts(package)["CMakeLists.txt"].decode() == AMENT_CMAKE["CMakeLists.txt"]


PLACES = {"x": "share/demo", "launch/x": "share/demo/launch", "launch/a/x": "share/demo/launch/a"}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("place", PLACES)
def test_a_launch_file_is_installed_where_it_is_in_the_package(
    place: str, kind: str, tmp_path: Path
) -> None:
    library, files = KINDS[kind]
    file = f"{place}{'.launch' if library == 'rospy' else '.launch.xml'}"
    package = lay(tmp_path, {**files, file: "<launch/>\n"})
    before = texts(package)
    program = f"load_package 'demo' as demo\nload_launch 'demo/{file}' as x\n"
    assert (
        run(f"{program}demo contains x\ngenerate_package demo\n", tmp_path, library, in_place=True)
        == ()
    )
    after = texts(package)
    if kind == "ament_python":
        described = read_setup(after["setup.py"], package / "setup.py").setup
        assert described is not None
        assert [x.destination for x in described.data_files if x.covers(file)] == [PLACES[place]]
    else:
        lists = read_cmake(after["CMakeLists.txt"], package / "CMakeLists.txt").lists
        assert lists is not None
        assert [covers(x, file, PLACES[place]) for x in shared(lists)] == [True]
        what, kinds = ("launch", "DIRECTORY") if "/" in place else (file, "FILES")
        assert [(x.what, x.call.items[0].value) for x in shared(lists)] == [(what, kinds)]
    told = run(OUT.replace("bringup", "x"), tmp_path, library, in_place=True)
    assert [each.code for each in told] == ["file-stays"]
    assert {**texts(package), "package.xml": b""} == {**before, "package.xml": b""}
