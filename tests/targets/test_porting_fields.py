"""What goes into the fields of messages in ways of Python, brought to rclpy: before → after."""

from __future__ import annotations

import ast

import pytest
from ported_nodes import MARK, count_marks, ported

HEAD = """\
import rospy
from geometry_msgs.msg import Vector3
from sensor_msgs.msg import JointState
from shape_msgs.msg import Plane
from std_msgs.msg import Float64

rospy.init_node('n')
v = Vector3()
js = JointState()
p = Plane()
"""
FIELDS = [
    ("v.x, (v.y, v.z) = 1, (2, w)", "v.x, (v.y, v.z) = 1.0, (2.0, float(w))"),
    ("v.x, (v.y, v.z) = 1, pair", "v.x, (v.y, v.z) = 1.0, map(float, pair)"),
    ("[v.x, v.y] = [1, 2]", "[v.x, v.y] = [1.0, 2.0]"),
    ("v.x, (v.y, v.z) = pair", f"{MARK}fields of numbers\nv.x, (v.y, v.z) = pair"),
    ("v.x, v.y = *a, 1", f"{MARK}fields of numbers\nv.x, v.y = *a, 1"),
    (
        "from mine.msg import Move\nm = Move()\nm.far = 1.5\nm.far = 2\nm.kind = 3",
        "from mine.msg import Move\nm = Move()\nm.far = 1.5\nm.far = 2.0\nm.kind = 3",
    ),
    ("a, (b, c) = 1, (2, 3)", "a, (b, c) = 1, (2, 3)"),
    ("w = Vector3(**{'x': 1})", "w = Vector3(**{'x': 1.0})"),
    ("w = Vector3(**given)", f"{MARK}the fields of Vector3\nw = Vector3(**given)"),
    ("def f(m=Float64(3)): m.data = 5", "def f(m=Float64(data=3.0)): m.data = 5.0"),
    ("def f(a, m=Float64()): m.data = a", "def f(a, m=Float64()): m.data = float(a)"),
    ("js.position += [1, 2]", "js.position.extend([1, 2])"),
    ("js.position += more, more", f"{MARK}js.position\njs.position += more, more"),
    ("js.position *= 2", f"{MARK}js.position\njs.position *= 2"),
    ("js.name += ['a']", "js.name += ['a']"),
    ("js.position.append(1)", "js.position.append(1)"),
    ("js.position.sort()", f"{MARK}js.position.sort\njs.position.sort()"),
    ("p.coef.append(1)", f"{MARK}p.coef\np.coef.append(1)"),
    ("p.coef += [1]", f"{MARK}p.coef\np.coef += [1]"),
]


@pytest.mark.parametrize(("before", "after"), FIELDS)
def test_what_goes_into_fields(before: str, after: str) -> None:
    text, _ = ported(HEAD + before + "\n", "rospy")
    ast.parse(text)
    assert text.endswith(f"\np = Plane()\n{after}\n")


CAMERA = """\
import {library}
from sensor_msgs.msg import CameraInfo


def hear(info):
    {inside}


{made}
"""
MADE = {
    "rospy": "rospy.init_node('n')\nrospy.Subscriber('c', CameraInfo, hear)",
    "rclpy": "rclpy.init()\nnode = rclpy.create_node('n')\n"
    "node.create_subscription(CameraInfo, 'c', hear, 10)",
}
RENAMED = [
    ("rospy", "x = info.K[0], info.width", "x = info.k[0], info.width"),
    ("rospy", "c = CameraInfo(); c.D = [1]", "c = CameraInfo(); c.d = [1.0]"),
    ("rospy", "c = CameraInfo(D=[1], width=2)", "c = CameraInfo(d=[1.0], width=2)"),
    ("rospy", "print(other.K)", f"{MARK}.K\n    print(other.K)"),
    ("rospy", "rospy.loginfo('%s', info.R)", "node.get_logger().info(f'{info.r}')"),
    (
        "rospy",
        "rospy.loginfo('%s', info.header.stamp.secs)",
        "node.get_logger().info(f'{info.header.stamp.sec}')",
    ),
    (
        "rospy",
        "rospy.loginfo_once('%s', info.R)",
        "node.get_logger().info(f'{info.r}', once=True)",
    ),
    ("rclpy", "x = info.p[0], info.width", "x = info.P[0], info.width"),
    ("rclpy", "c = CameraInfo(d=[1.0])", "c = CameraInfo(D=[1.0])"),
    ("rclpy", "print(other.k)", f"{MARK}.k\n    print(other.k)"),
]


@pytest.mark.parametrize(("library", "before", "after"), RENAMED)
def test_fields_that_the_other_ros_calls_otherwise(library: str, before: str, after: str) -> None:
    file = CAMERA.format(library=library, inside=before, made=MADE[library])
    text, _ = ported(file, library)
    assert f"def hear(info):\n    {after}\n" in text
    assert count_marks(text) == after.count(MARK)


ELSEWHERE = [
    ("rospy", "vision_msgs.msg", "Detection2DArray", "x = m.results[0].id", ".id"),
    ("rospy", "vision_msgs.msg", "Detection2DArray", "x = [r.score for r in m.results]", ".score"),
    ("rospy", "vision_msgs.msg", "Detection2DArray", "x = m.bbox.center.x", ".center.x"),
    ("rospy", "vision_msgs.msg", "Detection2DArray", "x = m.bbox.size_x", ""),
    ("rospy", "vision_msgs.msg", "ObjectHypothesis", "x = 1", "vision_msgs/ObjectHypothesis"),
    ("rospy", "gazebo_msgs.srv", "SpawnModel", "x = 1", "gazebo_msgs/SpawnModel"),
    ("rospy", "gazebo_msgs.srv", "GetModelState", "q.model_name = 'a'", ".model_name"),
    ("rospy", "mine.msg", "Detection2DArray", "x = m.results[0].id", ""),
    ("rclpy", "vision_msgs.msg", "Detection2DArray", "x = m.results[0].hypothesis", ".hypothesis"),
    ("rclpy", "vision_msgs.msg", "BoundingBox2D", "x = m.center.position", ".center.position"),
    ("rclpy", "gazebo_msgs.srv", "SpawnEntity", "x = 1", "gazebo_msgs/SpawnEntity"),
]


@pytest.mark.parametrize(("library", "module", "name", "line", "what"), ELSEWHERE)
def test_a_field_of_a_package_outside_of_the_catalog(
    library: str, module: str, name: str, line: str, what: str
) -> None:
    made = {"rospy": "rospy.init_node('n')\n", "rclpy": "rclpy.init()\nrclpy.create_node('n')\n"}
    text, found = ported(
        f"import {library}\nfrom {module} import {name}\n{made[library]}{line}\n", library
    )
    marks = {each.message.split("`")[1] for each in found}
    assert (what in marks) == bool(what)
    assert what or not {each for each in marks if each.startswith(".")}
    assert all(each.help for each in found)
    assert text.endswith(f"\n{line}\n")
