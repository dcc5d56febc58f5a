"""Launch files that are run: two nodes in two namespaces talk by a name that both get."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import pytest
from loaded_packages import KINDS, lay
from loaded_packages import TALKER as PROGRAM_TALKER
from loaded_packages import run as write_program
from machine import find_ros, graph_environ, skip_or_fail, wait_until

from plastron_tui.diagnostics import has_errors
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_text import Scope
from plastron_tui.ros.run_names import Remap, RunNames
from plastron_tui.runtime.environment import missing_packages
from plastron_tui.runtime.launch_run import ros_arguments_of
from plastron_tui.sources.launch.xml_reader import read_launch_xml

pytestmark = pytest.mark.live

MANIFEST = """<package format="3"><name>demo</name><version>0.1.0</version>
<description>d</description><maintainer email="a@b.cc">a</maintainer><license>MIT</license>
</package>
"""
SETUP = """from setuptools import setup
setup(name="demo", packages=["demo"], entry_points={"console_scripts": [
    "talker = demo.talker:main", "listener = demo.listener:main"]})
"""
TALKER = {
    1: """#!/usr/bin/env python3
import rospy
from std_msgs.msg import String
rospy.init_node("talker")
publisher = rospy.Publisher("chatter", String, queue_size=10)
rate = rospy.Rate(5)
while not rospy.is_shutdown():
    publisher.publish(rospy.get_param("~word"))
    rate.sleep()
""",
    2: """import rclpy
from rclpy.node import Node
from std_msgs.msg import String

def main():
    rclpy.init()
    node = Node("talker")
    word = node.declare_parameter("word", "nothing").value
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_timer(0.2, lambda: publisher.publish(String(data=word)))
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
""",
}
LISTENER = {
    1: """#!/usr/bin/env python3
import rospy
from std_msgs.msg import String
rospy.init_node("listener")
rospy.Subscriber("chatter", String,
                 lambda message: print(rospy.get_name(), "heard", message.data, flush=True))
rospy.spin()
""",
    2: """import rclpy
from rclpy.node import Node
from std_msgs.msg import String

def main():
    rclpy.init()
    node = Node("listener")
    node.create_subscription(
        String, "chatter",
        lambda told: print(node.get_fully_qualified_name(), "heard", told.data, flush=True), 10)
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
""",
}
LAUNCH = {
    1: """<launch>
  <arg name="word" default="hello"/>
  <group ns="front">
    <node pkg="demo" type="talker" name="speaker">
      <param name="word" value="$(arg word)"/>
      <remap from="chatter" to="/shared/words"/>
    </node>
  </group>
  <node pkg="demo" type="listener" name="ear" ns="back" output="screen">
    <remap from="chatter" to="/shared/words"/>
  </node>
</launch>
""",
    2: """<launch>
  <arg name="word" default="hello"/>
  <group>
    <push_ros_namespace namespace="front"/>
    <node pkg="demo" exec="talker" name="speaker">
      <param name="word" value="$(var word)"/>
      <remap from="chatter" to="/shared/words"/>
    </node>
  </group>
  <node pkg="demo" exec="listener" name="ear" namespace="back">
    <remap from="chatter" to="/shared/words"/>
  </node>
</launch>
""",
}


def _package(folder: Path, ros_version: int) -> Path:
    """Write a package, and return its launch file."""
    package = folder / "src/demo"
    code = package / ("scripts" if ros_version == 1 else "demo")
    code.mkdir(parents=True)
    (package / "package.xml").write_text(MANIFEST)
    if ros_version == 2:
        (package / "setup.py").write_text(SETUP)
        (code / "__init__.py").write_text("")
    for name, text in (("talker", TALKER), ("listener", LISTENER)):
        file = code / (name if ros_version == 1 else f"{name}.py")
        file.write_text(text[ros_version])
        file.chmod(0o755)
    file = package / "launch" / ("two.launch" if ros_version == 1 else "two.launch.xml")
    file.parent.mkdir()
    file.write_text(LAUNCH[ros_version])
    return file


@pytest.mark.long
@pytest.mark.parametrize("ros_version", [1, 2])
def test_nodes_of_a_launch_file_talk_and_are_ended(tmp_path: Path, ros_version: int) -> None:
    environment = find_ros(ros_version)
    if ros_version == 1 and missing_packages(environment, ["roslaunch"]):
        skip_or_fail("roslaunch is not installed")
    file = _package(tmp_path, ros_version)
    environ = graph_environ(tmp_path)
    log = tmp_path / "said.log"
    with log.open("w") as out:
        run = subprocess.Popen(
            [sys.executable, "-m", "plastron_tui", "run", str(file), "word:=salut", "--for", "90"],
            env=environ,
            stdout=out,
            stderr=out,
        )
        try:
            heard = "/back/ear heard salut"
            wait_until(lambda: run.poll() is not None or heard in log.read_text(), "it is heard")
            assert heard in log.read_text()
            said = _described(environ, ros_version)
            assert '<node pkg="demo" type="talker" name="speaker"' in said or ros_version == 2
            assert all(f'name="{name}"' in said for name in ("speaker", "ear", "word")), said
            assert 'value="salut"' in said
        finally:
            run.send_signal(signal.SIGINT)
            status = run.wait(60)
    assert status == 128 + signal.SIGINT, log.read_text()
    assert _processes(str(tmp_path)) == []


@pytest.mark.long
@pytest.mark.parametrize("kind", ["catkin", "ament_python"])
def test_a_launch_file_of_a_loaded_package_starts_its_new_node(tmp_path: Path, kind: str) -> None:
    library, files = KINDS[kind]
    ros_version = 1 if library == "rospy" else 2
    environment = find_ros(ros_version)
    if ros_version == 1 and missing_packages(environment, ["roslaunch"]):
        skip_or_fail("roslaunch is not installed")
    package = lay(tmp_path / "src", files)
    program = (
        f"{PROGRAM_TALKER}demo contains talker\ncreate_launch 'bringup' as bringup\n"
        "bringup starts talker as 'speaker'\ndemo contains bringup\ngenerate_package demo\n"
    )
    assert write_program(program, tmp_path / "src", library, in_place=True) == ()
    file = package / "launch" / ("bringup.launch" if ros_version == 1 else "bringup.launch.xml")
    environ = graph_environ(tmp_path)
    log = tmp_path / "said.log"
    with log.open("w") as out:
        run = subprocess.Popen(
            [sys.executable, "-m", "plastron_tui", "run", str(file), "--for", "50"],
            env=environ,
            stdout=out,
            stderr=out,
        )
        try:
            wait_until(
                lambda: (
                    run.poll() is not None or 'name="speaker"' in _described(environ, ros_version)
                ),
                "the node is up",
            )
            assert run.poll() is None, log.read_text()
        finally:
            run.send_signal(signal.SIGINT)
            status = run.wait(60)
    assert status == 128 + signal.SIGINT, log.read_text()


OWN_TYPE = """\
create_message_type WheelSpeed with float64 left
create_node 'wheels' as wheels
create_message turning of message_type WheelSpeed and input left=0.5
wheels publish turning to 'wheel_speed' of message_type WheelSpeed at 10 hz
create_node 'watcher' as watcher
subscribe watcher to 'wheel_speed' of message_type WheelSpeed
create_launch 'bringup' as bringup
bringup starts wheels
bringup starts watcher
create_package 'rover' as rover maintained_by "Ada <ada@example.com>" licensed_under "MIT"
rover contains wheels
rover contains watcher
rover contains bringup
generate_package rover
"""


@pytest.mark.long
@pytest.mark.parametrize("library", ["rospy", "rclpy"])
def test_types_beside_a_launch_file_are_built_before_it_runs(tmp_path: Path, library: str) -> None:
    ros_version = 1 if library == "rospy" else 2
    environment = find_ros(ros_version)
    if ros_version == 1 and missing_packages(environment, ["roslaunch"]):
        skip_or_fail("roslaunch is not installed")
    assert not has_errors(write_program(OWN_TYPE, tmp_path, library))
    (file,) = (tmp_path / "output/rover/launch").iterdir()
    done = subprocess.run(
        [sys.executable, "-m", "plastron_tui", "run", str(file), "--for", "8"],
        env=graph_environ(tmp_path),
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert "left" in done.stdout, done.stdout + done.stderr
    assert "0.5" in done.stdout
    assert "launch-differs" not in done.stderr


def _described(environ: dict[str, str], ros_version: int) -> str:
    """Return the graph as a launch file."""
    words = ["describe", "--ros", str(ros_version), "--format", "launch"]
    done = subprocess.run(
        [sys.executable, "-m", "plastron_tui", *words],
        env=environ,
        capture_output=True,
        text=True,
        timeout=60,
    )
    return done.stdout + done.stderr


def _processes(folder: str) -> list[str]:
    """Return the command lines that name a folder, or have it in their environment."""
    found = []
    for each in Path("/proc").glob("[0-9]*"):
        try:
            words = (each / "cmdline").read_bytes() + (each / "environ").read_bytes()
        except OSError:
            continue
        if folder.encode() in words:
            found.append(str((each / "cmdline").read_bytes()))
    return found


REMAPS = {
    1: """<launch><remap from="s" to="outer"/><remap from="t" to="outer"/><group>
<remap from="s" to="inner"/><remap from="u" to="inner"/>
<node pkg="demo" type="a" name="a"><remap from="s" to="own"/><remap from="/u" to="own"/></node>
</group></launch>""",
    2: """<launch><set_remap from="s" to="outer"/><set_remap from="t" to="outer"/><group>
<set_remap from="s" to="inner"/><set_remap from="u" to="inner"/>
<node pkg="demo" exec="a" name="a"><remap from="s" to="own"/><remap from="/u" to="own"/></node>
</group></launch>""",
}
ASK = {
    1: """import sys
from roslaunch.config import ROSLaunchConfig
from roslaunch.xmlloader import XmlLoader
from rospy.names import initialize_mappings, resolve_name
from rosgraph.names import load_mappings
import rospy.names
config = ROSLaunchConfig()
XmlLoader().load(sys.argv[1], config, verbose=False)
words = [f"{old}:={new}" for old, new in config.nodes[0].remap_args]
rospy.names._mappings = load_mappings(words)
initialize_mappings("/a")
print(*(resolve_name(name) and rospy.names.get_resolved_mappings().get(f"/{name}", f"/{name}")
        for name in "stuv"))
""",
    2: """import sys
import rclpy
rclpy.init(args=sys.argv[2:])
print(*map(rclpy.create_node("b").resolve_topic_name, "stuv"))
""",
}


@pytest.mark.long
@pytest.mark.parametrize("ros_version", [1, 2])
def test_the_remap_that_holds_is_the_one_that_ros_takes(tmp_path: Path, ros_version: int) -> None:
    environment = find_ros(ros_version)
    if ros_version == 1 and missing_packages(environment, ["roslaunch"]):
        skip_or_fail("roslaunch is not installed")
    file, script = tmp_path / "a.launch", tmp_path / "ask.py"
    file.write_text(REMAPS[ros_version])
    script.write_text(ASK[ros_version])
    launch = read_launch_xml(file.read_bytes(), file, ros_version).launch
    assert launch is not None
    (started,) = resolve(launch, ros_version, Scope()).started
    names = RunNames(started.namespace, tuple(Remap(*each) for each in started.remaps))
    asked = subprocess.run(
        [str(environment.python), str(script), str(file), *ros_arguments_of(started)],
        env=graph_environ(tmp_path),
        capture_output=True,
        text=True,
    )
    assert asked.stdout.split() == [names.resolved("a", name) for name in "stuv"], asked.stderr
