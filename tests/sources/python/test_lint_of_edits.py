"""What is added to files that linters have nothing to say of leaves them so."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

from edits import CATALOGS, DIALECTS, provide, publish, request, subscribe
from file_sets import one

from plastron_tui.sources.python import edit_python, read_python

LONG = "a_rather_long_name"
CHANGES = {
    f"{kind}_{len(name)}": change
    for name in ("b", LONG)
    for kind, change in (
        ("listen", subscribe(name)),
        ("send", publish(name, data="a text to be said")),
        ("serve", provide(name)),
        ("ask", request(name, "std_srvs/Trigger")),
    )
}
CHANGES["other_type"] = subscribe("c", "std_msgs/Bool")

RCLPY_CLASS = '''\
"""A node."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Robot(Node):
    """A robot."""

    def __init__(self) -> None:
        super().__init__('robot')
        self.a_sub = self.create_subscription(String, 'a', self.on_a, 10)

    def on_a(self, msg: String) -> None:
        """Hear it."""
        self.get_logger().info(msg.data)


def main() -> None:
    """Run it."""
    rclpy.init()
    rclpy.spin(Robot())


if __name__ == '__main__':
    main()
'''
CALL = "(String, 'a', self.on_a, 10)"
ALIGNED = RCLPY_CLASS.replace("'a', self.on_a, 10)", "'a',\n" + " " * 46 + "self.on_a, 10)")
HANGING = RCLPY_CLASS.replace(CALL, f"(\n            {CALL[1:]}")
ITEMS = CALL[1:-1].split()
EACH_APART = RCLPY_CLASS.replace(
    CALL, "(" + "".join(f"\n            {item}" for item in ITEMS) + ",\n        )"
)
RCLPY_FUNCTION = """\
import rclpy
from std_msgs.msg import String


def main():
    rclpy.init()
    node = rclpy.create_node("robot")
    node.create_publisher(String, "a", 10)
    rclpy.spin(node)


main()
"""
ROSPY_CLASS = """\
#!/usr/bin/env python
import rospy
from std_msgs.msg import String


class Robot:
    def __init__(self):
        rospy.Subscriber("a", String, self.on_a)

    def on_a(self, msg):
        rospy.loginfo("%s", msg)


if __name__ == "__main__":
    rospy.init_node("robot")
    Robot()
    rospy.spin()
"""
ROSPY_MODULE = """\
import rospy
from std_msgs.msg import String


def on_a(msg):
    print(msg)


rospy.init_node('robot')
rospy.Subscriber('a', String, on_a)
rospy.spin()
"""
SHAPES = {
    "rclpy_class": RCLPY_CLASS,
    "aligned": ALIGNED,
    "hanging": HANGING,
    "each_apart": EACH_APART,
    "rclpy_function": RCLPY_FUNCTION,
    "rospy_class": ROSPY_CLASS,
    "rospy_module": ROSPY_MODULE,
}
WIDTHS = (79, 99)


def edited_within(text: str, limit: int, *changes) -> str:
    source = read_python(Path("node.py"), one(text.encode())).source
    target = CATALOGS[source.library], DIALECTS[source.library]
    rendered = edit_python(source, changes, *target, limit)
    assert rendered.files is not None, [found.message for found in rendered.diagnostics]
    return rendered.files.main.decode()


def test_linters_have_nothing_to_say(tmp_path):
    for width in WIDTHS:
        folder = tmp_path / str(width)
        folder.mkdir()
        (folder / "ruff.toml").write_text(f"line-length = {width}\npreview = true\n")
        for shape, text in SHAPES.items():
            (folder / f"{shape}.py").write_text(text)
            for name, change in CHANGES.items():
                (folder / f"{shape}_{name}.py").write_text(edited_within(text, width, change))
            every = edited_within(text, width, *CHANGES.values())
            (folder / f"{shape}_every.py").write_text(every)
    command = ["check", "--no-cache", "--select", "E,W,F,I", "--output-format", "concise"]
    ruff = [sys.executable, "-m", "ruff", *command, str(tmp_path)]
    found = subprocess.run(ruff, capture_output=True, text=True, check=False, cwd=tmp_path)
    assert found.returncode == 0, found.stdout + found.stderr
