"""Packages, definitions and launch files of a program, on the disk."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from plastron_tui.diagnostics import has_errors
from plastron_tui.output.writer import write
from plastron_tui.session import Options, Session
from plastron_tui.sources.python import ament_style

TALKER = """\
create_node 'talker' as talker
create_message greeting of message_type String and input "hello"
talker publish greeting to 'chatter' of message_type String at 2 hz
"""
ABOUT = 'maintained_by "Ada <ada@example.com>" licensed_under "MIT"'
PACKAGE = f"{TALKER}create_package 'demo' as demo {ABOUT}\ndemo contains talker\n"
WRITE = "generate_package demo\n"
LISTENER = """\
create_node 'listener' as listener
subscribe listener to 'chatter' of message_type String
demo contains listener as 'ears'
"""
SPEED = """\
create_message_type WheelSpeed with float64 left, geometry_msgs/Point[] path
create_node 'driver' as driver
create_message fast of message_type WheelSpeed and input left=1
driver publish fast to 'speed' of message_type WheelSpeed
"""
OF_PACKAGE = SPEED.replace("WheelSpeed", "demo/WheelSpeed")
LAUNCH = """\
create_launch 'bringup' as bringup
bringup starts talker in 'front' remapping 'chatter' to 'words'
"""


def session(folder: Path, text: str, library: str = "rclpy", *, force: bool = False) -> Session:
    options = Options(library, folder / "output", force=force)
    return Session(text.encode(), folder / "robot.plastron", options, environ={})


def generate(folder: Path, text: str, library: str = "rclpy", *, force: bool = False) -> list[str]:
    """Write the files of a program, and return the codes of what is said of that."""
    program = session(folder, text, library, force=force)
    assert not has_errors(program.diagnostics), program.diagnostics
    plan, diagnostics = program.plan()
    result = write(plan, force=force)
    return [each.code for each in (*diagnostics, *result.diagnostics)]


def files(folder: Path) -> dict[str, bytes]:
    output = folder / "output"
    return {
        str(path.relative_to(output)): path.read_bytes()
        for path in sorted(output.rglob("*"))
        if path.is_file() and path.name != ".plastron.json"
    }


MADE = {
    ("rclpy", PACKAGE + WRITE): {
        "demo/package.xml": "<build_type>ament_python</build_type>",
        "demo/setup.py": "talker = demo.talker:main",
        "demo/demo/talker.py": "class TalkerNode(Node)",
        "demo/demo/__init__.py": "",
        "demo/resource/demo": "",
        "demo/LICENSE": "MIT License",
        "demo/test/test_talker_node.py": "chatter",
    },
    ("rospy", PACKAGE + WRITE): {
        "demo/package.xml": "<exec_depend>rospy</exec_depend>",
        "demo/CMakeLists.txt": "scripts/talker.py",
        "demo/scripts/talker.py": "rospy.init_node",
    },
    ("rclpy", PACKAGE + LISTENER + WRITE): {
        "demo/demo/ears.py": "class ListenerNode(Node)",
        "demo/setup.py": "ears = demo.ears:main",
    },
    ("rclpy", PACKAGE + SPEED + "demo contains driver\n" + WRITE): {
        "demo_interfaces/msg/WheelSpeed.msg": "float64 left\ngeometry_msgs/Point[] path\n",
        "demo_interfaces/package.xml": "rosidl_interface_packages",
        "demo_interfaces/CMakeLists.txt": '"msg/WheelSpeed.msg"',
        "demo/package.xml": "<exec_depend>demo_interfaces</exec_depend>",
    },
    ("rospy", PACKAGE + SPEED + "demo contains driver\n" + WRITE): {
        "demo/msg/WheelSpeed.msg": "float64 left\ngeometry_msgs/Point[] path\n",
        "demo/package.xml": "message_generation",
        "demo/CMakeLists.txt": "WheelSpeed.msg",
    },
    ("rclpy", SPEED + "generate_node driver\n"): {
        "driver_pub.py": "from robot_interfaces.msg import WheelSpeed",
        "robot_interfaces/msg/WheelSpeed.msg": "float64 left\ngeometry_msgs/Point[] path\n",
    },
    ("rospy", SPEED + "generate_node driver\n"): {
        "robot_interfaces/msg/WheelSpeed.msg": "float64 left\ngeometry_msgs/Point[] path\n",
        "robot_interfaces/CMakeLists.txt": "generate_messages",
    },
    ("rclpy", "create_message_type own_msgs/A with int32 x\ngenerate_type A\n"): {
        "own_msgs/msg/A.msg": "int32 x\n",
    },
    ("rclpy", PACKAGE + LAUNCH + "demo contains bringup\n" + WRITE): {
        "demo/launch/bringup.launch.xml": '<node pkg="demo" exec="talker"',
        "demo/setup.py": "launch",
    },
    ("rospy", PACKAGE + LAUNCH + "demo contains bringup\n" + WRITE): {
        "demo/launch/bringup.launch": '<node pkg="demo" type="talker.py"',
    },
    ("rclpy", PACKAGE + LAUNCH + WRITE + "generate_launch bringup\n"): {
        "bringup.launch.xml": '<remap from="chatter" to="words"/>',
    },
}


@pytest.mark.parametrize(("library", "text"), MADE, ids=range(len(MADE)))
def test_a_program_becomes_files(tmp_path: Path, library: str, text: str) -> None:
    generate(tmp_path, text, library)
    found = files(tmp_path)
    for name, part in MADE[library, text].items():
        assert part in found[name].decode(), name


@pytest.mark.parametrize(("library", "text"), MADE, ids=range(len(MADE)))
def test_files_are_made_twice_as_once(tmp_path: Path, library: str, text: str) -> None:
    generate(tmp_path, text, library)
    before = files(tmp_path)
    plan, _ = session(tmp_path, text, library).plan()
    assert {each.state.value for each in plan.files} == {"identical"}
    generate(tmp_path, text, library)
    assert files(tmp_path) == before


def test_a_folder_of_definitions_alone_is_no_package_of_nodes(tmp_path: Path) -> None:
    generate(tmp_path, SPEED + "generate_node driver\n")
    assert not any(name.startswith("robot/") for name in files(tmp_path))


def test_what_is_written_by_hand_stays(tmp_path: Path) -> None:
    generate(tmp_path, PACKAGE + WRITE)
    manifest = tmp_path / "output" / "demo" / "package.xml"
    setup = manifest.with_name("setup.py")
    manifest.write_text(
        manifest.read_text().replace(
            "  <test_depend>", "  <exec_depend>my_tools</exec_depend>\n  <test_depend>", 1
        )
    )
    setup.write_text(setup.read_text() + "# mine\n")
    codes = generate(tmp_path, PACKAGE + LISTENER + WRITE)
    assert codes.count("merged-by-hand") == 1
    assert "<exec_depend>my_tools</exec_depend>" in manifest.read_text()
    assert "ears = demo.ears:main" in setup.read_text()
    assert setup.read_text().endswith("# mine\n")
    assert "merged-by-hand" not in generate(tmp_path, PACKAGE + LISTENER + WRITE)


def test_what_both_changed_is_a_conflict_and_is_forced_with_a_backup(tmp_path: Path) -> None:
    generate(tmp_path, PACKAGE + WRITE)
    setup = tmp_path / "output" / "demo" / "setup.py"
    by_hand = setup.read_text().replace("talker = demo.talker:main", "talk = demo.talker:main")
    setup.write_text(by_hand)
    text = PACKAGE.replace("contains talker", "contains talker as 'mouth'") + WRITE
    plan, _ = session(tmp_path, text).plan()
    assert [each.name for each in plan.files if each.problem] == ["demo/setup.py"]
    generate(tmp_path, text, force=True)
    assert "mouth = demo.mouth:main" in setup.read_text()
    backups = [each for each in setup.parent.iterdir() if each.name.startswith("setup.py.")]
    assert [each.read_text() for each in backups] == [by_hand]


@pytest.mark.parametrize("is_earlier", [False, True], ids=["own style", "style of an earlier one"])
def test_a_node_keeps_the_style_that_its_file_has(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, is_earlier: bool
) -> None:
    with monkeypatch.context() as patched:
        if is_earlier:
            patched.setattr(ament_style, "ament_style", lambda text: text)
        generate(tmp_path, PACKAGE + WRITE)
    node = tmp_path / "output/demo/demo/talker.py"
    quote = '"' if is_earlier else "'"
    text = node.read_text(encoding="utf-8")
    assert f"super().__init__({quote}talker{quote})" in text
    # What nothing was changed in by hand is written anew.
    generate(tmp_path, PACKAGE + WRITE)
    assert "super().__init__('talker')" in node.read_text(encoding="utf-8")
    by_hand = text.replace("import rclpy\n", "import rclpy  # by hand\n")
    node.write_text(by_hand, encoding="utf-8")
    # Where the lines do not fit, a new parameter is a conflict.
    more = PACKAGE + "talker has_parameter 'gain' of parameter_type int with default 1\n" + WRITE
    assert generate(tmp_path, more) == ["merged-by-hand"]
    merged = node.read_text(encoding="utf-8")
    assert "import rclpy  # by hand\n" in merged
    assert f"super().__init__({quote}talker{quote})" in merged
    assert f"self.declare_parameter({quote}gain{quote}, 1)" in merged


def test_a_node_that_moves_into_a_package_is_written_there(tmp_path: Path) -> None:
    generate(tmp_path, f"{TALKER}generate_node talker\n")
    assert generate(tmp_path, PACKAGE + WRITE) == ["file-stays"]
    made = files(tmp_path)
    assert b'super().__init__("talker")' in made["talker_pub.py"]
    assert b"super().__init__('talker')" in made["demo/demo/talker.py"]


def test_a_file_of_somebody_else_is_a_conflict(tmp_path: Path) -> None:
    folder = tmp_path / "output" / "demo"
    folder.mkdir(parents=True)
    (folder / "setup.py").write_text("mine = True\n")
    plan, _ = session(tmp_path, PACKAGE + WRITE).plan()
    assert [each.name for each in plan.files if each.problem] == ["demo/setup.py"]
    assert "was not written by plastron" in plan.conflicts[0].message


def test_types_of_a_package_are_its_maintainers_too(tmp_path: Path) -> None:
    generate(tmp_path, PACKAGE + SPEED + "demo contains driver\n" + WRITE)
    assert b"ada@example.com" in files(tmp_path)["demo_interfaces/package.xml"]


def test_the_file_of_an_executable_is_what_a_module_can_be_called(tmp_path: Path) -> None:
    text = PACKAGE.replace("contains talker", "contains talker as 'my-talk.v2'")
    generate(tmp_path, text + WRITE)
    found = files(tmp_path)
    assert "demo/demo/my_talk_v2.py" in found
    assert b"my-talk.v2 = demo.my_talk_v2:main" in found["demo/setup.py"]


def test_a_node_in_no_package_is_not_launched(tmp_path: Path) -> None:
    text = f"{TALKER}{LAUNCH}generate_launch bringup\n"
    _, found = session(tmp_path, text).plan()
    assert [each.code for each in found] == ["in-no-package"]


def test_launch_files_are_written_in_python_on_request(tmp_path: Path) -> None:
    (tmp_path / "plastron.yaml").write_text("launch: python\n")
    generate(tmp_path, PACKAGE + LAUNCH + "demo contains bringup\n" + WRITE)
    text = files(tmp_path)["demo/launch/bringup.launch.py"].decode()
    assert "LaunchDescription" in text and "remappings" in text


def test_a_file_that_is_written_no_longer_is_told(tmp_path: Path) -> None:
    generate(tmp_path, PACKAGE + WRITE)
    renamed = (PACKAGE + WRITE).replace("create_node 'talker'", "create_node 'speaker'")
    assert generate(tmp_path, renamed) == ["file-stays", "file-stays"]
    for name in ("demo/talker.py", "test/test_talker_node.py"):
        (tmp_path / "output" / "demo" / name).unlink()
    assert generate(tmp_path, renamed) == []


STAYS = "is of an earlier run of the program, and stays where it is"
ALONE = f"{TALKER}generate_node talker\n"


def stays(folder: Path, text: str) -> list[str]:
    """Return what is told of files that stay."""
    found = [each.message for each in session(folder, text).plan()[1] if each.code == "file-stays"]
    return sorted(found)


@pytest.mark.parametrize("name", ["rover", None])
def test_a_package_that_has_another_name_or_is_gone_is_told(
    name: str | None, tmp_path: Path
) -> None:
    made = f"{SPEED}{PACKAGE}demo contains driver\n{WRITE}"
    generate(tmp_path, made)
    assert stays(tmp_path, made) == []
    changed = ALONE if name is None else made.replace("_package 'demo'", f"_package '{name}'")
    assert stays(tmp_path, changed) == [
        f"the package `demo_interfaces` {STAYS}",
        f"the package `demo` {STAYS}",
    ]
    shutil.rmtree(tmp_path / "output" / "demo")
    assert stays(tmp_path, changed) == [f"the package `demo_interfaces` {STAYS}"]


def test_what_a_mistake_keeps_from_being_written_is_not_told(tmp_path: Path) -> None:
    generate(tmp_path, PACKAGE + WRITE)
    wrong = PACKAGE.replace("contains talker", "contains talker as 'class'") + WRITE
    assert has_errors(session(tmp_path, wrong).plan()[1])
    assert stays(tmp_path, wrong) == []


@pytest.mark.parametrize("file", ["other.plastron", None])
def test_files_of_another_program_are_not_told(file: str | None, tmp_path: Path) -> None:
    options = Options("rclpy", tmp_path / "output")
    path = None if file is None else tmp_path / file
    renamed = (PACKAGE + WRITE).replace("_package 'demo'", "_package 'other'")
    write(Session((PACKAGE + WRITE).encode(), path, options, environ={}).plan()[0])
    own = tmp_path / "robot.plastron" if path else None
    plan, found = Session(renamed.encode(), own, options, environ={}).plan()
    assert "other/package.xml" in [each.name for each in plan.files]
    assert found == ()


def test_a_node_comes_beside_a_version_that_was_changed_by_hand(tmp_path: Path) -> None:
    generate(tmp_path, PACKAGE + WRITE)
    for name in ("package.xml", "setup.py"):
        path = tmp_path / "output" / "demo" / name
        path.write_text(path.read_text().replace("0.0.0", "1.2.3").replace("MIT", "X11"))
    told = generate(tmp_path, PACKAGE + LISTENER + WRITE)
    assert set(told) == {"merged-by-hand"}
    setup = files(tmp_path)["demo/setup.py"]
    assert b"1.2.3" in setup
    assert b"ears" in setup


def test_a_taken_name_is_told_once(tmp_path: Path) -> None:
    program = session(tmp_path, f"create_package 'json' as p {ABOUT}\ngenerate_package p\n")
    told = dict.fromkeys((*program.diagnostics, *program.plan()[1]))
    assert [each.code for each in told].count("taken-package-name") == 1


def test_types_that_come_after_their_package_was_written_are_told(tmp_path: Path) -> None:
    late = "create_message_type demo/Late with int8 x\n"
    text = f"{SPEED}create_package 'demo' as demo {ABOUT}\ndemo contains driver\n{WRITE}{late}"
    _, diagnostics = session(tmp_path, text).plan()
    [found] = [each for each in diagnostics if each.code == "bad-package-file"]
    assert found.span is not None
    assert text[found.span.start :].startswith("create_message_type demo/Late")


def test_files_of_types_and_nodes_together(tmp_path: Path) -> None:
    text = f"{OF_PACKAGE}create_package 'demo' as demo {ABOUT}\ndemo contains driver\n{WRITE}"
    assert generate(tmp_path, text) == []
    found = files(tmp_path)
    assert {name.partition("/")[0] for name in found if "/" in name} == {"demo"}
    assert not {"demo/setup.py", "demo/demo/__init__.py"} & found.keys()
    for name, part in {
        "demo/CMakeLists.txt": "ament_python_install_package(demo_nodes)",
        "demo/package.xml": "<member_of_group>rosidl_interface_packages</member_of_group>",
        "demo/msg/WheelSpeed.msg": "float64 left",
        "demo/demo_nodes/driver.py": "from demo.msg import WheelSpeed",
        "demo/demo_nodes/__init__.py": "",
        "demo/test/test_driver_node.py": "demo_nodes.driver",
    }.items():
        assert part in found[name].decode(), name


BY_BOB = ABOUT.replace("Ada", "Bob")
TYPES_ALONE = {
    "alone": SPEED.replace("WheelSpeed", "demo_interfaces/WheelSpeed", 1)
    + f"create_package 'demo_interfaces' as demo {BY_BOB}\n{WRITE}",
    "beside its nodes": f"{SPEED}create_package 'demo' as demo {ABOUT}\ndemo contains driver\n"
    f"create_package 'demo_interfaces' as types {BY_BOB}\ngenerate_package types\n{WRITE}",
}


@pytest.mark.parametrize("text", TYPES_ALONE.values(), ids=list(TYPES_ALONE))
def test_a_package_may_be_created_for_types_alone(text: str, tmp_path: Path) -> None:
    assert generate(tmp_path, text) == []
    made = files(tmp_path)
    assert b"msg/WheelSpeed.msg" in made["demo_interfaces/CMakeLists.txt"]
    assert b">Bob<" in made["demo_interfaces/package.xml"]
    assert b"rosidl_interface_packages" in made["demo_interfaces/package.xml"]
