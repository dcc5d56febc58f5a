"""Types of a program that belong to packages which it loads."""

from __future__ import annotations

import difflib
from pathlib import Path

import pytest
from loaded_packages import AMENT_CMAKE, AMENT_PYTHON, CATKIN, KINDS, lay, run, texts

from plastron_tui.session import Options, Session

LOADED = "load_package 'demo' as demo\n"
SPEED = f"{LOADED}create_message_type Speed with float64 left, float64 right\n"
USED = (
    "create_node 'driver' as driver\n"
    "create_message fast of message_type Speed and input 1.0, 2.0\n"
    "driver publish fast to 'speed' of message_type Speed\n"
)
IN = "demo contains driver\ngenerate_package demo\n"


def test_a_python_package_gets_its_types_in_a_package_beside_it(tmp_path: Path) -> None:
    lay(tmp_path, AMENT_PYTHON)
    assert run(f"{SPEED}{USED}{IN}", tmp_path, "rclpy") == ()
    made = texts(tmp_path / "output")
    assert made["demo_interfaces/msg/Speed.msg"] == b"float64 left\nfloat64 right\n"
    assert b"<exec_depend>demo_interfaces</exec_depend>" in made["demo/package.xml"]
    assert b'"msg/Speed.msg"' in made["demo_interfaces/CMakeLists.txt"]


@pytest.mark.parametrize(
    ("kind", "type_", "end"),
    [("catkin", "Speed", ""), ("ament_cmake", "demo/Speed", ""), ("ament_python", "Speed", "")],
)
def test_a_type_of_a_package_that_nothing_writes_is_told(
    kind: str, type_: str, end: str, tmp_path: Path
) -> None:
    library, files = KINDS[kind]
    lay(tmp_path, files)
    if kind == "ament_python":
        lay(tmp_path, {"package.xml": files["package.xml"]}, "demo_interfaces")
    program = SPEED.replace("Speed", type_) + USED
    told = run(f"{program}generate_node driver{end}\n", tmp_path, library)
    assert [(each.code, each.span is not None) for each in told] == [("type-not-written", True)]
    assert not (tmp_path / "output").exists()


CATKIN_WITH_TYPES = {
    **CATKIN,
    "package.xml": CATKIN["package.xml"].replace(
        "  <exec_depend>rospy</exec_depend>\n",
        "  <build_depend>message_generation</build_depend>\n"
        "  <exec_depend>message_runtime</exec_depend>\n"
        "  <exec_depend>rospy</exec_depend>\n",
    ),
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.0.2)
project(demo)
find_package(catkin REQUIRED COMPONENTS message_generation rospy)

## types
add_message_files(
  FILES
  Num.msg   # a number
)
generate_messages()

catkin_package(CATKIN_DEPENDS message_runtime)
""",
    "msg/Num.msg": "int64 num\n",
}
AMENT_WITH_TYPES = {
    "package.xml": AMENT_CMAKE["package.xml"],
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.8)
project(demo)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/Num.msg"
)
ament_package()
""",
    "msg/Num.msg": "int64 num\n",
}
AMENT_ALONE = {
    "package.xml": AMENT_CMAKE["package.xml"],
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.8)
project(demo)
find_package(ament_cmake REQUIRED)
ament_package()
""",
}
HEADED = "Speed with std_msgs/Header header"
MADE = {
    "catkin, none before": (
        CATKIN,
        "create_message_type Speed with float64 left",
        "msg/Speed.msg",
        [
            "+find_package(catkin REQUIRED COMPONENTS message_generation)",
            "+",
            "+add_message_files(FILES",
            "+  Speed.msg)",
            "+",
            "+generate_messages()",
            "+catkin_package(CATKIN_DEPENDS message_runtime)",
        ],
        [
            "+  <build_depend>message_generation</build_depend>",
            "+  <exec_depend>message_runtime</exec_depend>",
        ],
    ),
    "catkin, beside others": (
        CATKIN_WITH_TYPES,
        "create_message_type Speed with float64 left",
        "msg/Speed.msg",
        ["+  Speed.msg"],
        [],
    ),
    "catkin, of another package": (
        CATKIN_WITH_TYPES,
        f"create_message_type {HEADED}",
        "msg/Speed.msg",
        [
            "+find_package(catkin REQUIRED COMPONENTS message_generation rospy std_msgs)",
            "+  Speed.msg",
            "+generate_messages(DEPENDENCIES std_msgs)",
            "+catkin_package(CATKIN_DEPENDS message_runtime std_msgs)",
        ],
        ["+  <build_depend>std_msgs</build_depend>", "+  <exec_depend>std_msgs</exec_depend>"],
    ),
    "catkin, a service": (
        CATKIN_WITH_TYPES,
        "create_service_type Go with none returning bool ok",
        "srv/Go.srv",
        ["+", "+add_service_files(FILES", "+  Go.srv", "+)"],
        [],
    ),
    "catkin, an action": (
        CATKIN_WITH_TYPES,
        "create_action_type Go with none returning bool ok reporting none",
        "action/Go.action",
        [
            "+find_package(catkin REQUIRED COMPONENTS actionlib_msgs message_generation rospy)",
            "+add_action_files(FILES",
            "+  Go.action",
            "+)",
            "+generate_messages(DEPENDENCIES actionlib_msgs)",
            "+",
            "+catkin_package(CATKIN_DEPENDS message_runtime actionlib_msgs)",
        ],
        [
            "+  <build_depend>actionlib_msgs</build_depend>",
            "+  <exec_depend>actionlib_msgs</exec_depend>",
        ],
    ),
    "ament_cmake, none before": (
        AMENT_ALONE,
        f"create_message_type demo/{HEADED}",
        "msg/Speed.msg",
        [
            "+find_package(std_msgs REQUIRED)",
            "+find_package(rosidl_default_generators REQUIRED)",
            "+rosidl_generate_interfaces(${PROJECT_NAME}",
            '+  "msg/Speed.msg"',
            "+  DEPENDENCIES std_msgs",
            "+)",
            "+ament_export_dependencies(rosidl_default_runtime)",
        ],
        [
            "+  <buildtool_depend>rosidl_default_generators</buildtool_depend>",
            "+  <depend>std_msgs</depend>",
            "+  <exec_depend>rosidl_default_runtime</exec_depend>",
            "+  <member_of_group>rosidl_interface_packages</member_of_group>",
        ],
    ),
    "ament_cmake, beside others": (
        AMENT_WITH_TYPES,
        "create_message_type demo/Speed with float64 left",
        "msg/Speed.msg",
        ['+  "msg/Speed.msg"'],
        [],
    ),
}


def added(before: str, after: bytes) -> list[str]:
    lines = difflib.unified_diff(before.splitlines(), after.decode().splitlines(), n=0)
    return [line for line in lines if line.startswith("+") and not line.startswith("+++")]


@pytest.mark.parametrize("name", MADE)
def test_a_loaded_package_builds_the_types(name: str, tmp_path: Path) -> None:
    files, statement, file, cmake, manifest = MADE[name]
    package = lay(tmp_path, files)
    library = "rospy" if name.startswith("catkin") else "rclpy"
    program = f"{LOADED}{statement}\ngenerate_package demo\n"
    assert run(program, tmp_path, library, in_place=True) == ()
    made = texts(package)
    assert set(made) == {*files, file}
    assert added(files["CMakeLists.txt"], made["CMakeLists.txt"]) == cmake
    assert sorted(added(files["package.xml"], made["package.xml"])) == sorted(manifest)
    assert run(program, tmp_path, library, in_place=True) == ()
    assert texts(package) == made


def test_a_package_that_is_built_for_a_run_has_its_other_types(tmp_path: Path) -> None:
    others = {"srv/Ask.srv": "std_msgs/Header header\n---\n", "msg/Bad.msg": "int64\n"}
    lay(tmp_path, {**CATKIN_WITH_TYPES, **others})
    program = f"{SPEED}{USED}generate_node driver\n"
    session = Session(program.encode(), tmp_path / "a.plastron", Options("rospy"), environ={})
    nodes = list(session.workspace.nodes.values())
    files = session.own_packages(nodes, 1)["demo"].files
    assert files is not None
    kinds = (".msg", ".srv", ".action")
    found = {path: file.text for path, file in files.items() if path.endswith(kinds)}
    assert found == {
        "msg/Num.msg": b"int64 num\n",
        "msg/Speed.msg": b"float64 left\nfloat64 right\n",
        "srv/Ask.srv": others["srv/Ask.srv"].encode(),
    }
    assert b"std_msgs" in files["CMakeLists.txt"].text


def test_a_type_that_is_changed_is_built_for_a_run_as_it_is_then(tmp_path: Path) -> None:
    lay(tmp_path, CATKIN_WITH_TYPES)
    change = "load_type 'demo/msg/Num.msg' as num\nnum has_field \"int64 more\"\n"
    node = USED.replace("Speed", "demo/Num").replace("1.0, 2.0", "1, 2")
    program = f"{LOADED}{change}{node}generate_node driver\n"
    session = Session(program.encode(), tmp_path / "a.plastron", Options("rospy"), environ={})
    assert session.diagnostics == ()
    files = session.own_packages(list(session.workspace.nodes.values()), 1)["demo"].files
    assert files is not None
    assert files["msg/Num.msg"].text == b"int64 num\nint64 more\n"


def test_types_may_be_of_a_package_of_ones_own_that_has_the_name_of_one_of_ros(
    tmp_path: Path,
) -> None:
    name = "control_msgs"
    renamed = {
        file: text.replace("<name>demo<", f"<name>{name}<").replace("(demo)", f"({name})")
        for file, text in CATKIN.items()
    }
    package = lay(tmp_path, renamed, name)
    program = f"""\
load_package '{name}' as mine
create_message_type {name}/Speed with float64 left
generate_package mine
"""
    assert run(program, tmp_path, "rospy", in_place=True) == ()
    assert texts(package)["msg/Speed.msg"] == b"float64 left\n"


@pytest.mark.parametrize(
    ("name", "told"),
    [("String", ["type-hidden"]), ("rover_msgs/String", ["type-hidden"]), ("Label", [])],
)
def test_a_type_that_a_bare_name_means_no_longer_is_told(
    name: str, told: list[str], tmp_path: Path
) -> None:
    text = f"create_message_type {name} with string data\ngenerate_type {name[-6:].strip('/')}\n"
    found = Session(
        text.encode(), tmp_path / "a.plastron", Options("rclpy"), environ={}
    ).diagnostics
    assert [each.code for each in found] == told
    for each in found:
        assert each.span is not None
        assert text[each.span.start : each.span.end] == name


@pytest.mark.parametrize("kind", ["ament_python", "catkin"])
def test_a_type_may_be_made_before_its_package_is_loaded(kind: str, tmp_path: Path) -> None:
    library, files = KINDS[kind]
    lay(tmp_path, files)
    program = f"{SPEED.removeprefix(LOADED)}{LOADED}{USED}{IN}"
    assert run(program, tmp_path, library) == ()
    package = "demo" if kind == "catkin" else "demo_interfaces"
    assert f"output/{package}/msg/Speed.msg" in texts(tmp_path)


def test_nothing_is_written_through_folders_that_lead_out_of_the_project(tmp_path: Path) -> None:
    outside = tmp_path / "outside"
    project = tmp_path / "project"
    project.mkdir()
    (project / "plastron.yaml").touch()
    package = lay(project, {name: text for name, text in CATKIN.items() if "/" not in name})
    for name in ("msg", "scripts"):
        (outside / name).mkdir(parents=True)
        (package / name).symlink_to(outside / name)
    before = texts(project)
    told = run(f"{SPEED}{USED}{IN}", project, "rospy", in_place=True)
    assert [each.code for each in told] == ["outside-project"] * 2
    assert texts(project) == before
    assert texts(outside) == {}


UNDER_CONDITION = {
    **AMENT_WITH_TYPES,
    "CMakeLists.txt": AMENT_WITH_TYPES["CMakeLists.txt"]
    .replace("rosidl_generate_interfaces(", "if(X)\nrosidl_generate_interfaces(")
    .replace("ament_package", "endif()\nament_package"),
}
GENERATING = "generate_messages()\n"
MESSAGES = "add_message_files(\n  FILES\n  Num.msg   # a number\n)\n"


@pytest.mark.parametrize(
    ("old", "new", "code", "line"),
    [
        (GENERATING, f"if(X)\n{GENERATING}endif()\n", "computed-build-file", 11),
        ("Num.msg   # a number", "${TYPES}", "computed-build-file", 6),
        ("catkin_package(CATKIN_DEPENDS message_runtime)", "", "computed-build-file", 1),
        ("find_package(catkin REQUIRED", "find_package(catkin REQUIRED ${X}", None, 0),
        (MESSAGES, f"foreach(each a b)\n{MESSAGES}endforeach()\n", None, 0),
    ],
)
def test_what_a_package_computes_is_refused_or_let_be(
    old: str, new: str, code: str | None, line: int, tmp_path: Path
) -> None:
    cmake = CATKIN_WITH_TYPES["CMakeLists.txt"].replace(old, new)
    package = lay(tmp_path, {**CATKIN_WITH_TYPES, "CMakeLists.txt": cmake})
    before = texts(package)
    program = f"{LOADED}create_message_type {HEADED}\ngenerate_package demo\n"
    told = run(program, tmp_path, "rospy", in_place=True)
    assert [each.code for each in told] == [code] * (code is not None)
    if code is not None:
        assert told[0].message.startswith(f"line {line} of `CMakeLists.txt`")
        assert texts(package) == before


@pytest.mark.parametrize(
    ("kind", "type_", "old", "new", "code"),
    [
        ("ament_python", "demo/Speed", "", "", "type-not-written"),
        ("ament_cmake", "demo/Speed", "", "", "edit-refused"),
        ("ament_types", "demo/Speed", "", "", "computed-build-file"),
        ("catkin", "Speed", "</package>", "</packag>", "broken-xml"),
    ],
)
def test_a_package_that_cannot_have_types_is_left(
    kind: str, type_: str, old: str, new: str, code: str, tmp_path: Path
) -> None:
    library, files = {**KINDS, "ament_types": ("rclpy", UNDER_CONDITION)}[kind]
    manifest = files["package.xml"].replace(old, new) if old else files["package.xml"]
    package = lay(tmp_path, {**files, "package.xml": manifest})
    before = texts(package)
    program = f"{LOADED}create_message_type {type_} with float64 left\ngenerate_package demo\n"
    told = run(program, tmp_path, library, in_place=True)
    assert [each.code for each in told] == [code]
    assert texts(package) == before


def test_a_definition_that_is_there_is_not_written_over(tmp_path: Path) -> None:
    package = lay(tmp_path, {**CATKIN_WITH_TYPES, "msg/Speed.msg": "int8 other\n"})
    before = texts(package)
    told = run(f"{SPEED}generate_package demo\n", tmp_path, "rospy", in_place=True)
    assert [(each.code, each.span is not None) for each in told] == [("type-exists", True)]
    assert texts(package) == before


def test_in_place_the_interface_package_stands_beside_the_loaded_one(tmp_path: Path) -> None:
    lay(tmp_path / "src", AMENT_PYTHON)
    program = f"{SPEED}{USED}{IN}".replace("'demo'", "'src/demo'")
    assert run(program, tmp_path, "rclpy", in_place=True) == ()
    made = texts(tmp_path / "src/demo_interfaces")
    assert made["msg/Speed.msg"] == b"float64 left\nfloat64 right\n"
    assert texts(tmp_path / "output") == {}
    assert run(program, tmp_path, "rclpy", in_place=True) == ()
    readme = tmp_path / "src/demo_interfaces/README.md"
    readme.write_text(readme.read_text() + "By hand.\n")
    wider = program.replace("float64 right", "float64 right, bool ok").replace(
        "1.0, 2.0", "1.0, 2.0, True"
    )
    assert run(wider, tmp_path, "rclpy", in_place=True) == ()
    after = texts(tmp_path / "src/demo_interfaces")
    assert after["msg/Speed.msg"].endswith(b"bool ok\n")
    assert after["README.md"].endswith(b"By hand.\n")
