"""What is wrong in the code of one node."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import SourceTree

from .code_examples import EARLY, IDLE

_TALKER = """\
import rospy
from std_msgs.msg import String

rospy.init_node('talker')
pub = rospy.Publisher('chatter', String{queue})
rospy.spin()
"""


@rule(
    "RC407",
    "queue-size-missing",
    "A publisher of rospy says no `queue_size`, or an endpoint of rclpy has no `qos_profile`.",
    severity=Severity.WARNING,
    why="rospy then sends as ROS did before Hydro: `publish` waits until each subscriber has taken "
    "the message, and a slow one holds the node up. It says so in a warning at each start; "
    "`queue_size=None` is what it takes by itself. In rclpy it is an error: the call raises a "
    "TypeError. That is told of methods of `Node` itself.",
    bad={"talker.py": _TALKER.format(queue="")},
    good={"talker.py": _TALKER.format(queue=", queue_size=10")},
)
def queue_size_missing(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find publishers whose messages are sent while the node waits, and calls that fail."""
    for unit in tree.built:
        is_rclpy = unit.library == "rclpy"
        for file, span in () if unit.is_test else unit.code.no_queue:
            yield Diagnostic(
                code,
                "the call has no `qos_profile`: rclpy raises a TypeError"
                if is_rclpy
                else "the publisher has no `queue_size`: `publish` waits for every subscriber",
                span,
                unit.file(file),
                help="add `qos_profile=10`, which has the place of `queue_size`"
                if is_rclpy
                else "add `queue_size=10`",
                severity=Severity.ERROR if is_rclpy else None,
            )


@rule(
    "RC405",
    "never-spins",
    "A program has callbacks, and never lets them be called.",
    why="rclpy and rclcpp call a callback only while something spins the node: `rclpy.spin(node)`, "
    "or an executor. rospy calls them by itself, until the main thread ends, which `rospy.spin()` "
    "keeps. An executor that gets the node calls nothing before it is told to spin. Not told where "
    "the node is handed to code that was not read, where no node is made, or where anything of "
    "the program may keep it going.",
    bad=IDLE["bad"],
    good=IDLE["good"],
)
def never_spins(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find programs that end, or go on, without calling any callback of their node."""
    for unit in tree.built:
        if unit.code.idle is not None and not unit.is_test:
            is_rospy = unit.library == "rospy"
            yield Diagnostic(
                code,
                "the program ends at once: no callback of the node is called"
                if is_rospy
                else "nothing spins the node: no callback of it is called",
                unit.code.idle,
                unit.path,
                help=_SPINNING.get(unit.library, "spin the node, with `rclcpp::spin(node)`"),
            )


_SPINNING = {
    "rclpy": "spin the node, with `rclpy.spin(node)`",
    "rospy": "let the program go on, with `rospy.spin()`",
    "roscpp": "let the program go on, with `ros::spin()`",
}


@rule(
    "RC408",
    "published-too-early",
    "A message is published once, right after its publisher is created.",
    severity=Severity.WARNING,
    why="Subscribers find a publisher some time after it is there, and hear nothing of what was "
    "sent before, unless the publisher keeps its last message for them: `latch=True` in rospy, the "
    "durability `transient_local` on both sides in ROS 2. Not told where anything in between may "
    "take time, where the publisher sends anything else, or where `endpoint-made-again` tells why.",
    bad=EARLY["bad"],
    good=EARLY["good"],
)
def published_too_early(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find messages that nobody can hear."""
    for unit in tree.built:
        again = {(each.file, each.span) for each in unit.code.repeated}
        for each in () if unit.is_test else unit.code.early:
            if (each.file, each.created) in again:
                # It is told that the publisher is created too often, which is why it is too late.
                continue
            file = unit.file(each.file)
            yield Diagnostic(
                code,
                "the message is sent before any subscriber can have found the publisher",
                each.span,
                file,
                help="wait for a subscriber first, or let the publisher keep the message for those "
                "who come later",
                labels=(Label(each.created, "the publisher is created here", file),),
            )
