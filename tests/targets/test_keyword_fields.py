"""Fields whose names are keywords of Python: genpy writes `class_`, rosidl no class at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.session import Options, Session

DEFINITIONS = {
    "msg/Lesson.msg": "int32 class\nstring type\n",
    "msg/Week.msg": "Lesson[] lessons\n",
    "msg/Plain.msg": "string type\n",
    "msg/Pupil.msg": "int32 errno\n",
    "srv/Enrol.srv": "int32 pupil\n---\nbool pass\n",
}
LOADED = {
    "rospy": "import rospy\n\nrospy.init_node('n')\nrospy.spin()\n",
    "rclpy": "import rclpy\n\nrclpy.init()\nnode = rclpy.create_node('n')\nrclpy.spin(node)\n",
}
USES = {
    'create_message m of message_type Lesson and input 3, "x"\n'
    "n publish m to 't' of message_type Lesson at 1 hz\n": "school_msgs/Lesson` has a field `class",
    "subscribe n to 't' of message_type Lesson\n": "school_msgs/Lesson` has a field `class",
    "subscribe n to 't' of message_type Week\n": "school_msgs/Lesson` has a field `class",
    "n provides_service 's' of service_type Enrol\n": "school_msgs/Enrol` has a field `pass",
    "n client_requests 's' of service_type Enrol with input 3\n": "`pass`",
}


def session(folder: Path, program: str) -> Session:
    for name, text in DEFINITIONS.items():
        file = folder / "types" / "school_msgs" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    (folder / "plastron.yaml").write_text("types: types\n")
    for library, text in LOADED.items():
        (folder / f"{library}_node.py").write_text(text)
    opened = Session(program.encode(), folder / "a.plastron", Options(), environ={})
    assert opened.diagnostics == ()
    return opened


@pytest.mark.parametrize("start", ["create_node 'n' as n using {}\n", "load {}_node as n\n"])
@pytest.mark.parametrize("use", USES)
def test_no_node_of_rclpy_has_the_type(tmp_path: Path, start: str, use: str) -> None:
    opened = session(tmp_path, start.format("rclpy") + use + "generate_node n\n")
    found = [each for made in opened.generated() for each in made.diagnostics]
    assert [each.code for each in found] == ["unusable-type"]
    assert USES[use] in found[0].message
    assert "keyword of Python" in found[0].message


@pytest.mark.parametrize("start", ["create_node 'n' as n using {}\n", "load {}_node as n\n"])
@pytest.mark.parametrize("use", USES)
def test_a_node_of_rospy_has_it(tmp_path: Path, start: str, use: str) -> None:
    opened = session(tmp_path, start.format("rospy") + use + "generate_node n\n")
    [made] = opened.generated()
    assert made.files is not None
    if "publish" in use:
        assert b"Lesson(class_=3, type=" in made.files.files.main


def test_a_name_that_is_no_reserved_word_is_a_field(tmp_path: Path) -> None:
    program = "create_node 'n' as n using rclpy\nsubscribe n to 't' of message_type Plain\n"
    [made] = session(tmp_path, program + "generate_node n\n").generated()
    assert made.files is not None


@pytest.mark.parametrize("library", LOADED)
def test_no_node_imports_a_package_that_is_called_as_a_keyword(
    tmp_path: Path, library: str
) -> None:
    file = tmp_path / "types" / "class" / "msg" / "Lesson.msg"
    file.parent.mkdir(parents=True)
    file.write_text("int32 number\n")
    use = "subscribe n to 't' of message_type class/Lesson\ngenerate_node n\n"
    opened = session(tmp_path, f"create_node 'n' as n using {library}\n{use}")
    [made] = opened.generated()
    assert [each.code for each in made.diagnostics] == ["unusable-type"]
    assert "keyword of Python" in made.diagnostics[0].message


@pytest.mark.parametrize("library", ["roscpp", "rclcpp", "component"])
@pytest.mark.parametrize(
    ("type_", "word"),
    [("Lesson", "a keyword of C++"), ("Week", "a keyword of C++"), ("Pupil", "a macro of C++")],
)
def test_no_node_in_cpp_has_the_type(tmp_path: Path, library: str, type_: str, word: str) -> None:
    program = f"create_node 'n' as n using {library}\nsubscribe n to 't' of message_type {type_}\n"
    [made] = session(tmp_path, program + "generate_node n\n").generated()
    [found] = made.diagnostics
    assert found.code == "unusable-type"
    assert word in found.message


@pytest.mark.parametrize("library", ["roscpp", "rclcpp", "component"])
def test_a_keyword_of_python_is_a_field_in_cpp(tmp_path: Path, library: str) -> None:
    use = "n provides_service 's' of service_type Enrol\ngenerate_node n\n"
    [made] = session(tmp_path, f"create_node 'n' as n using {library}\n{use}").generated()
    assert made.files is not None
