"""Programs that make launch files, and the files that they come to."""

from __future__ import annotations

from pathlib import Path

import pytest

from plastron_tui.model.launch_checks import with_parameter_files
from plastron_tui.model.workspace import Node
from plastron_tui.ros.launch_resolution import Opened, resolve
from plastron_tui.ros.launch_text import Scope
from plastron_tui.session import Options, Session
from plastron_tui.sources.launch.python_reader import read_launch_python
from plastron_tui.sources.launch.xml_reader import read_launch_xml
from plastron_tui.targets.launch.program import ExecutableName, request_of
from plastron_tui.targets.launch.python import write_python
from plastron_tui.targets.launch.xml import write_xml

HEAD = """\
create_node 'talker' as talker
create_message m of message_type String and input "hi"
talker publish m to 'chatter' of message_type String at 1 hz
generate_node talker using rclpy
create_launch 'bringup' as bringup
"""
PACKAGE = """\
create_package 'demo' as demo described_as "x" maintained_by "A <a@b.example>" licensed_under "MIT"
demo contains talker
"""
FULL = (
    HEAD
    + PACKAGE
    + """\
bringup has_argument 'robot' with default "rover"
bringup starts talker in 'front' remapping 'chatter' to 'hello' setting 'speed' = 0.5, 'id' = "1"
bringup starts 'ears/listener' as 'ear' with parameters 'config/ear.yaml'
bringup starts 'demo/Camera' as 'camera' inside 'eyes'
bringup includes 'rover/sensors.launch.xml'
demo contains bringup
generate_package demo
"""
)
WRITTEN = """\
<launch>
  <arg name="robot" default="rover"/>

  <include file="$(find-pkg-share rover)/launch/sensors.launch.xml"/>

  <node pkg="own" exec="talker" name="talker" namespace="front" output="screen">
    <param name="speed" value="0.5"/>
    <param name="id" value="1" type="str"/>
    <remap from="chatter" to="hello"/>
  </node>

  <node pkg="ears" exec="listener" name="ear" output="screen">
    <param from="$(find-pkg-share demo)/config/ear.yaml"/>
  </node>

  <node_container pkg="rclcpp_components" exec="component_container" name="eyes">
    <composable_node pkg="demo" plugin="Camera" name="camera"/>
  </node_container>
</launch>
"""


def _own(node: Node) -> ExecutableName:
    return ExecutableName("own", node.name)


def _wrong(session: Session) -> list[str]:
    """Return what is wrong with a program, whose nodes need not have the parameters it sets."""
    found = (str(each.code) for each in session.diagnostics)
    return [code for code in found if code != "undeclared-parameter"]


def test_a_program_makes_a_launch_file(tmp_path: Path) -> None:
    (tmp_path / "config").mkdir()
    (tmp_path / "config" / "ear.yaml").write_text("ear:\n  ros__parameters:\n    loud: true\n")
    session = Session(FULL.encode(), tmp_path / "p.plastron", Options("rclpy"), environ={})
    assert _wrong(session) == []
    workspace = session.workspace
    made = with_parameter_files(workspace.launches["bringup"], workspace.packages["demo"])
    assert write_xml(request_of(made, 2, _own).added, 2) == WRITTEN


@pytest.mark.parametrize(
    "statements, code",
    [
        ("bringup starts talkr\n", "unknown-node"),
        ("bringup starts 'listener'\n", "bad-launch-name"),
        ("bringup starts talker\nbringup starts talker\n", "already-started"),
        ("bringup no_longer_starts 'talker'\n", "not-started"),
        ("bringup has_argument 'a b'\n", "bad-launch-name"),
        ("bringup includes 'sensors.launch'\n", "bad-launch-name"),
        ("bringup includes 'rover/../x.launch'\n", "bad-launch-name"),
        ("brngup starts talker\n", "unknown-launch"),
        ("create_launch 'bringup' as other\n", "launch-exists"),
        ("bringup starts talker remapping 'a b' to 'c'\n", "invalid-name"),
        ("bringup starts talker inside 'eyes'\n", "not-a-component"),
        ("bringup starts 'demo/talker.py' inside 'eyes'\n", "not-a-component"),
        ("bringup starts talker in '$(var robot)'\n", "unknown-argument"),
        ("bringup starts talker in '$(env ROBOT)'\n", "invalid-name"),
    ],
)
def test_mistakes_are_told(statements: str, code: str) -> None:
    assert [each.code for each in Session((HEAD + statements).encode()).diagnostics] == [code]


@pytest.mark.parametrize(
    "statements",
    [
        "bringup starts talker\nbringup no_longer_starts 'talker'\n",
        "bringup has_argument 'a'\nbringup no_longer_has_argument 'a'\n",
        "bringup includes 'rover/a.launch'\nbringup no_longer_includes 'rover/a.launch'\n",
    ],
)
def test_what_is_taken_back_leaves_nothing(statements: str) -> None:
    session = Session((HEAD + statements).encode())
    assert session.diagnostics == ()
    assert request_of(session.workspace.launches["bringup"], 2, _own).added.items == ()


@pytest.mark.parametrize(
    "packages, remedy",
    [
        ("", "make one, such as `create_package 'talker_demo' as demo`, and put it in: "
         "`demo contains talker`"),
        ("create_package 'rover' as rover\n", "put it into one: `rover contains talker`"),
        ("create_package 'aa' as a\ncreate_package 'bb' as b\n",
         "put it into one: `PACKAGE contains talker`"),
    ],
)  # fmt: skip
def test_how_a_node_gets_into_a_package(packages: str, remedy: str) -> None:
    text = f"{HEAD}{packages}bringup starts talker\ngenerate_launch bringup\n"
    [found] = [each for each in Session(text.encode()).diagnostics if each.code == "in-no-package"]
    assert found.help == remedy


@pytest.mark.parametrize(
    "statements, wrong",
    [
        ("bringup starts talker as 'x'\ngenerate_launch bringup\n", "talker"),
        (f"{PACKAGE}demo no_longer_contains talker\nbringup starts talker\n"
         "demo contains bringup\ngenerate_package demo\n", "talker"),
        ("bringup starts talker\n", None),
        (f"bringup starts talker\ngenerate_launch bringup\n{PACKAGE}", None),
    ],
)  # fmt: skip
def test_what_is_in_no_package_is_told_where_it_is_started(
    statements: str, wrong: str | None
) -> None:
    text = HEAD + statements
    found = [each for each in Session(text.encode()).diagnostics if each.severity.value == "error"]
    assert [each.code for each in found] == ([] if wrong is None else ["in-no-package"])
    for each in found:
        assert each.span is not None
        assert text[each.span.start : each.span.end] == wrong
        assert text[: each.span.start].endswith("bringup starts ")


@pytest.mark.parametrize(
    "statements, late",
    [
        ("generate_launch bringup\nbringup starts 'demo/b'\n", "bringup starts 'demo/b'"),
        ("generate_launch bringup\nbringup has_argument 'a'\ngenerate_launch bringup\n", None),
        (f"{PACKAGE}generate_package demo\ndemo contains bringup\n", "demo contains bringup"),
        (f"{PACKAGE}demo contains bringup\ngenerate_launch bringup\nbringup starts 'demo/b'\n"
         "generate_package demo\n", None),
    ],
)  # fmt: skip
def test_what_comes_after_writing_is_told(statements: str, late: str | None) -> None:
    text = HEAD + statements
    found = [
        each
        for each in Session(text.encode()).diagnostics
        if each.code == "changed-after-generating"
    ]
    assert len(found) == (late is not None)
    for each in found:
        assert each.span is not None
        assert text[each.span.start : each.span.end] == late


SPOKEN = """\
bringup has_argument 'speed' with default 0.5
bringup has_argument 'robot' with default "rover"
bringup starts talker as '$(var robot)_talker' in '/$(arg robot)' remapping 'chatter' to \
'$(var robot)/hello' setting 'speed' = "$(var speed)", 'label' = "of $(var robot)", \
'home' = "$(env HOME)"
"""
HEARD = {
    1: """\
  <node pkg="own" type="talker" name="$(arg robot)_talker" ns="/$(arg robot)" output="screen">
    <param name="speed" value="$(arg speed)" type="double"/>
    <param name="label" value="of $(arg robot)" type="str"/>
    <remap from="chatter" to="$(arg robot)/hello"/>
  </node>
""",
    2: """\
  <node pkg="own" exec="talker" name="$(var robot)_talker" namespace="/$(var robot)" \
output="screen">
    <param name="speed" value="$(var speed)" type="float"/>
    <param name="label" value="of $(var robot)" type="str"/>
    <remap from="chatter" to="$(var robot)/hello"/>
  </node>
""",
}


@pytest.mark.parametrize("ros_version", [1, 2])
def test_what_is_given_as_an_argument_is_used(ros_version: int) -> None:
    library = "rospy" if ros_version == 1 else "rclpy"
    head = HEAD.replace("rclpy", library).replace(
        "generate_node",
        "talker has_parameter 'speed' of parameter_type float with default 1.0\n"
        "talker has_parameter 'label' of parameter_type string with default \"\"\n"
        "generate_node",
    )
    spoken = SPOKEN.replace(", 'home' = \"$(env HOME)\"", "") if ros_version == 1 else SPOKEN
    session = Session((head + spoken).encode(), options=Options(library))
    assert _wrong(session) == []
    request = request_of(session.workspace.launches["bringup"], ros_version, _own).added
    written = write_xml(request, ros_version)
    home = '    <param name="home" value="\\$(env HOME)"/>\n'
    assert HEARD[ros_version] in written.replace(home, "")
    assert (home in written) is (ros_version == 2)
    assert read_launch_xml(written.encode(), ros_version=ros_version).launch == request
    if ros_version == 2:
        python = write_python(request)
        assert "ParameterValue(LaunchConfiguration('speed'), value_type=float)" in python
        assert read_launch_python(python.encode()).launch == request


@pytest.mark.parametrize(
    "setting, written",
    [("'speed' = 5", 'value="5.0"'), ("'label' = \"5\"", 'value="5" type="str"')],
)
def test_a_value_has_the_type_that_the_node_declares(setting: str, written: str) -> None:
    declared = "talker has_parameter 'speed' of parameter_type float with default 1.0\n"
    head = HEAD.replace("generate_node", f"{declared}generate_node")
    session = Session(
        f"{head}bringup starts talker setting {setting}\n".encode(), options=Options("rclpy")
    )
    assert _wrong(session) == []
    request = request_of(session.workspace.launches["bringup"], 2, _own).added
    assert written in write_xml(request, 2)


@pytest.mark.parametrize(
    "text",
    ["as '$(var robt)_x'", "in 'é/$(arg robt)'", "remapping 'a' to '/$(var robt)'",
     "setting 'x' = \"é $(var robt)\""],
)  # fmt: skip
@pytest.mark.parametrize("before", ["", "talker publish m to 'more' of message_type String\n"])
def test_an_unknown_argument_is_told_at_its_name(text: str, before: str) -> None:
    program = f"{before}bringup has_argument 'robot'\nbringup starts talker {text}\n"
    source = (HEAD + program).encode()
    found = next(each for each in Session(source).diagnostics if each.code == "unknown-argument")
    assert found.span is not None
    assert source[found.span.start : found.span.end] == b"robt"
    assert found.help == "did you mean `robot`?"


def test_an_argument_that_is_used_is_not_taken_away() -> None:
    program = (
        f"{HEAD}bringup has_argument 'robot'\nbringup starts talker in '$(var robot)'\n"
        "bringup no_longer_has_argument 'robot'\n"
    )
    assert [each.code for each in Session(program.encode()).diagnostics] == ["unknown-argument"]


def test_nodes_are_told_apart_by_their_full_names() -> None:
    text = HEAD + "".join(
        f"bringup starts 'demo/ear'{place}\n" for place in ("", " in 'front'", " in '/rear/'")
    )
    for statement, code in (
        ("bringup starts 'demo/ear' in '/front'", "already-started"),
        ("bringup starts 'demo/other' as 'ear' in 'rear'", "already-started"),
        ("bringup starts 'demo/ear' as 'ear' in '/rear'", "already-started"),
        ("bringup starts 'demo/other' as 'ear'", "already-started"),
        ("bringup no_longer_starts 'eye'", "not-started"),
    ):
        found = Session(f"{text}{statement}\n".encode()).diagnostics
        assert [each.code for each in found] == [code], statement
    session = Session(f"{text}bringup no_longer_starts 'rear/ear'\n".encode())
    assert session.diagnostics == ()
    assert list(session.workspace.launches["bringup"].starts) == ["ear", "front/ear"]


def test_a_name_alone_is_enough_where_one_node_has_it() -> None:
    two = "bringup starts 'demo/ear' in 'front'\nbringup starts 'demo/ear' in 'rear'\n"
    taken = "bringup no_longer_starts 'ear'\n"
    [told] = Session(f"{HEAD}{two}{taken}".encode()).diagnostics
    assert told.help == "say which: `front/ear`, `rear/ear`"
    both = Session(f"{HEAD}{two}".encode()).workspace.launches["bringup"]
    assert list(both.by_shortest_name) == ["front/ear", "rear/ear"]
    one = two.partition("\n")[0]
    alone = Session(f"{HEAD}{one}\n".encode()).workspace.launches["bringup"]
    assert list(alone.by_shortest_name) == ["ear"]
    session = Session(f"{HEAD}{one}\n{taken}".encode())
    assert session.diagnostics == ()
    assert session.workspace.launches["bringup"].starts == {}


def test_a_component_is_a_class() -> None:
    text = f"{HEAD}bringup starts 'image_proc/image_proc::RectifyNode' inside 'eyes'\n"
    session = Session(text.encode())
    assert session.diagnostics == ()
    launch = session.workspace.launches["bringup"]
    assert (
        '<composable_node pkg="image_proc" plugin="image_proc::RectifyNode" name="RectifyNode"/>'
        in write_xml(request_of(launch, 2, _own).added, 2)
    )
    [told] = Session(text.replace("image_proc::RectifyNode", "rectify").encode()).diagnostics
    assert (told.code, told.severity.value) == ("not-a-component", "warning")
    assert told.span is not None
    assert text.replace("image_proc::RectifyNode", "rectify")[slice(*told.span)] == "rectify"


@pytest.mark.parametrize(
    ("value", "number"), [("1", 1.0), ("2.5", 2.5), ("1e3", 1000.0), ("fast", "fast")]
)
@pytest.mark.parametrize(("ros_version", "library"), [(1, "rospy"), (2, "rclpy")])
def test_an_argument_for_a_float_is_one(
    ros_version: int, library: str, value: str, number: object
) -> None:
    declared = "talker has_parameter 'speed' of parameter_type float with default 1.0\n"
    program = HEAD.replace("rclpy", library).replace("generate_node", f"{declared}generate_node")
    program += (
        "bringup has_argument 'speed'\nbringup starts talker setting 'speed' = \"$(var speed)\"\n"
    )
    session = Session(program.encode(), options=Options(library))
    request = request_of(session.workspace.launches["bringup"], ros_version, _own).added
    read = [read_launch_xml(write_xml(request, ros_version).encode(), ros_version=ros_version)]
    if ros_version == 2:
        read.append(read_launch_python(write_python(request).encode()))
    for each in read:
        assert each.launch is not None
        scope = Scope({"speed": value}, {}, "/", lambda name: f"/{name}")
        (started,) = resolve(each.launch, ros_version, scope, "/x", _nothing).started
        assert repr(dict(started.parameters)["speed"]) == repr(number)


def _nothing(path: str) -> Opened:
    raise AssertionError(path)
