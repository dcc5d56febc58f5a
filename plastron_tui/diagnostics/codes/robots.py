"""Robots: links, joints, and what they are made of."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code
from plastron_tui.diagnostics.severity import Severity

_ROVER = "create_robot 'rover' as rover\n"
_BASE = f"{_ROVER}rover has_link 'base'\n"
_BODY = f"{_BASE}rover has_link 'body' shaped box 0.4, 0.3, 0.1 weighing 5\n"
_FIXED = "rover has_joint 'hold' of joint_type fixed from 'base' to 'body'\n"
_TURNING = "rover has_joint 'turn' of joint_type revolute from 'base' to 'body' with axis 0, 0, 1\n"
_LIMITED = "rover limits_joint 'turn' between -90 and 90 deg with effort 10 and velocity 1\n"
_END = "generate_robot rover\n"
_MAST = f"{_BASE}rover has_link 'mast' shaped box 0.1, 0.1, 0.5"
_TURN = "rover has_joint 'turn' of joint_type continuous from 'base' to 'mast' with axis 0, 0, 1\n"
_WHOLE = f"{_BODY}{_FIXED}{_END}"

UNKNOWN_ROBOT = Code(
    "unknown-robot",
    "No robot has this variable: it is misspelt, or the robot is described further down.",
    bad=f"{_ROVER}rovr has_link 'base'\n{_END}",
    good=f"{_BASE}{_END}",
)

ROBOT_EXISTS = Code(
    "robot-exists",
    "Two robots of a program have one name.",
    bad="create_robot 'rover' as first\ncreate_robot 'rover' as second\n",
    good="create_robot 'rover' as first\ncreate_robot 'arm' as second\n",
)

BAD_ROBOT_NAME = Code(
    "bad-robot-name",
    "A name that a robot, a link or a joint cannot have: letters, digits, `_`, `-` and dots are "
    "what all tools take.",
    bad=f"{_ROVER}rover has_link 'the base'\n{_END}",
    good=f"{_ROVER}rover has_link 'the_base'\n{_END}",
)

UNKNOWN_LINK = Code(
    "unknown-link",
    "A robot has no link of this name.",
    bad=f"{_BODY}rover has_joint 'hold' of joint_type fixed from 'bse' to 'body'\n{_END}",
    good=_WHOLE,
)

UNKNOWN_JOINT = Code(
    "unknown-joint",
    "A robot has no joint of this name.",
    bad=f"{_BODY}{_TURNING}rover limits_joint 'trun' between -90 and 90 deg with effort 10 and "
    f"velocity 1\n{_END}",
    good=f"{_BODY}{_TURNING}{_LIMITED}{_END}",
)

PART_EXISTS = Code(
    "part-exists",
    "A robot has a link or a joint of this name already. One that a loaded robot has is changed by "
    "the same sentence; one of the program's own is changed where it is made.",
    bad=f"{_BASE}rover has_link 'base'\n{_END}",
    good=f"{_BODY}{_FIXED}{_END}",
)

PART_IN_USE = Code(
    "part-in-use",
    "A link or a joint is to go while something holds to it.",
    bad=f"{_BODY}{_FIXED}rover no_longer_has_link 'body'\n{_END}",
    good=f"{_BODY}{_FIXED}rover no_longer_has_joint 'hold'\n"
    f"rover no_longer_has_link 'body'\n{_END}",
)

BAD_SHAPE = Code(
    "bad-shape",
    'A shape is `box X, Y, Z`, `cylinder RADIUS, LENGTH`, `sphere RADIUS` or `mesh "URI"`, and '
    "lengths are positive.",
    bad=f"{_ROVER}rover has_link 'base' shaped box 0.4, 0.3\n{_END}",
    good=f"{_ROVER}rover has_link 'base' shaped box 0.4, 0.3, 0.1\n{_END}",
)

BAD_WEIGHT = Code(
    "bad-weight",
    "What a link weighs is a positive number of kilograms.",
    bad=f"{_BASE}rover has_link 'body' shaped sphere 0.1 weighing 0\n{_FIXED}{_END}",
    good=f"{_BASE}rover has_link 'body' shaped sphere 0.1 weighing 0.5\n{_FIXED}{_END}",
)

MISSING_WEIGHT = Code(
    "missing-weight",
    "A joint moves a link that has a shape and no weight: Gazebo leaves it out, and all that hangs "
    "on it. Pictures do without a weight.",
    severity=Severity.WARNING,
    bad=f"{_MAST}\n{_TURN}{_END}",
    good=f"{_MAST} weighing 1\n{_TURN}{_END}",
)

UNKNOWN_COLOR = Code(
    "unknown-color",
    "A colour has one of the names that Plastron knows, the name of a material of the robot, or a "
    'code such as `"#3060ff"`.',
    bad=f"{_ROVER}rover has_link 'base' shaped sphere 0.1 painted bleu\n{_END}",
    good=f"{_ROVER}rover has_link 'base' shaped sphere 0.1 painted blue\n{_END}",
)

INCOMPLETE_JOINT = Code(
    "incomplete-joint",
    "A new joint has a type, and names the link that holds and the one that is held. Only of a "
    "joint that a loaded robot has may both be left out: they stay as they are.",
    bad=f"{_BODY}rover has_joint 'hold' at 0, 0, 0.1\n{_END}",
    good=_WHOLE,
)

UNKNOWN_JOINT_TYPE = Code(
    "unknown-joint-type",
    "A joint is `revolute`, `continuous`, `prismatic`, `fixed`, `floating` or `planar`.",
    bad=f"{_BODY}rover has_joint 'hold' of joint_type fix from 'base' to 'body'\n{_END}",
    good=_WHOLE,
)

BAD_UNIT = Code(
    "bad-unit",
    "Angles are in `deg` or `rad`, and how far a prismatic joint slides is in `m`.",
    bad=f"{_BODY}{_TURNING}rover limits_joint 'turn' between -1 and 1 m with effort 10 and "
    f"velocity 1\n{_END}",
    good=f"{_BODY}{_TURNING}{_LIMITED}{_END}",
)

BAD_AXIS = Code(
    "bad-axis",
    "An axis points somewhere, and belongs to a joint that moves about it or along it.",
    bad=f"{_BODY}rover has_joint 'turn' of joint_type continuous from 'base' to 'body' with axis "
    f"0, 0, 0\n{_END}",
    good=f"{_BODY}rover has_joint 'turn' of joint_type continuous from 'base' to 'body' with axis "
    f"0, 0, 1\n{_END}",
)

BAD_LIMITS = Code(
    "bad-limits",
    "Limits go from the least to the greatest, effort and velocity are not negative, and a joint "
    "that is fixed, floating or planar has none.",
    bad=f"{_BODY}{_TURNING}rover limits_joint 'turn' between 90 and -90 deg with effort 10 and "
    f"velocity 1\n{_END}",
    good=f"{_BODY}{_TURNING}{_LIMITED}{_END}",
)

MISSING_LIMITS = Code(
    "missing-limits",
    "URDF wants limits, effort and velocity of joints that are revolute or prismatic.",
    bad=f"{_BODY}{_TURNING}{_END}",
    good=f"{_BODY}{_TURNING}{_LIMITED}{_END}",
)

BAD_MIMIC = Code(
    "bad-mimic",
    "A joint follows another one that moves, and not in a circle.",
    bad=f"{_BODY}{_TURNING}{_LIMITED}rover has_link 'lid'\nrover has_joint 'open' of joint_type "
    f"continuous from 'body' to 'lid' with axis 0, 0, 1 mimicking 'open'\n{_END}",
    good=f"{_BODY}{_TURNING}{_LIMITED}rover has_link 'lid'\nrover has_joint 'open' of joint_type "
    f"continuous from 'body' to 'lid' with axis 0, 0, 1 mimicking 'turn'\n{_END}",
)

BAD_ROBOT_NUMBER = Code(
    "bad-robot-number",
    "A place, an angle or an axis has a number that is beyond all that a robot is.",
    bad=f"{_ROVER}rover has_link 'base' shaped sphere 0.1 at 0, 0, 1e99\n{_END}",
    good=f"{_ROVER}rover has_link 'base' shaped sphere 0.1 at 0, 0, 0.1\n{_END}",
)

MADE_BY_MACRO = Code(
    "made-by-macro",
    "A link or a joint does not stand in a robot's file as it is: macros make it, and what they "
    "make cannot be changed one by one. Change the macro, or what it is called with, in its file.",
)

BAD_ROBOT_ARGUMENT = Code(
    "bad-robot-argument",
    "A robot's file is given an argument that it does not ask for, or that is no name and value: "
    "the arguments of a xacro file, `$(arg NAME)`, are texts, numbers and booleans.",
)

UNCLEAR_ROBOT = Code(
    "unclear-robot",
    "A program has several robots, and a node that says where joints are does not say of which: it "
    "is started with each of them. Joints that its message names tell it, or the robot's name in "
    "the topic, `ROBOT/joint_states`.",
    severity=Severity.WARNING,
)

SEVERAL_SHAPES = Code(
    "several-shapes",
    "A link of a loaded robot has several visuals or collisions, and a sentence is about one. "
    "Change it in its file, or take the link away and make it anew; where it is as a whole is said "
    "by the joint that holds it. A shape of which it has one, say the only cylinder, can be said.",
)

LINK_APART = Code(
    "link-apart",
    "What is seen of a link of a loaded robot, what collides, and its center of mass differ, or "
    "are at several places. A shape becomes that of what is seen and of what collides, unless one "
    "of them is of that kind already, which then is meant; a new place is that of what is seen, "
    "and of what was in the same place before.",
    severity=Severity.WARNING,
)

INERTIA_STAYS = Code(
    "inertia-stays",
    "The inertia of a link of a loaded robot did not follow from its shape, and stays as it is "
    "when the shape changes. Say what the link weighs as well, and it follows from both.",
    severity=Severity.WARNING,
)

MESH_INERTIA = Code(
    "mesh-inertia",
    "The inertia of a mesh is taken to be that of the box around it, which is more than that of "
    "the mesh mostly; where nobody knows how large the mesh is, none is written.",
    severity=Severity.WARNING,
    bad=f"{_ROVER}rover has_link 'base'\nrover has_link 'body' shaped mesh "
    f'"package://rover/body.stl" weighing 5\n{_FIXED}{_END}',
    good=_WHOLE,
)

LINK_NAME_AGAIN = Code(
    "link-name-again",
    "A link and a joint of a robot have one name. URDF takes that, and Gazebo does not: in its own "
    "format both are parts of one model, which have names of their own.",
    severity=Severity.WARNING,
    bad=f"{_BODY}rover has_joint 'body' of joint_type fixed from 'base' to 'body'\n{_END}",
    good=_WHOLE,
)

UNKNOWN_JOINT_NAME = Code(
    "unknown-joint-name",
    "A message of `JointState` or `JointTrajectory` names a joint that the program's robot does "
    "not have: what drives the robot, or shows it, leaves it out.",
    severity=Severity.WARNING,
    bad=f"{_BODY}{_TURNING}{_LIMITED}{_END}create_message states of message_type JointState and "
    'input name=["trun"], position=[0.5]\n',
    good=f"{_BODY}{_TURNING}{_LIMITED}{_END}create_message states of message_type JointState and "
    'input name=["turn"], position=[0.5]\n',
)

NO_TREE = Code(
    "no-tree",
    "The links of a robot hang on one, its root: each other one is held by one joint, and none "
    "holds itself by way of others.",
    bad=f"{_BODY}{_END}",
    good=_WHOLE,
)

IMPOSSIBLE_INERTIA = Code(
    "impossible-inertia",
    "No body has such an inertia: simulators refuse it, or go astray.",
    severity=Severity.WARNING,
)

ROOT_INERTIA = Code(
    "root-inertia",
    "The root has an inertia, which KDL, and what stands on it, leaves out of account.",
    severity=Severity.WARNING,
    bad=f"{_ROVER}rover has_link 'base' shaped box 0.4, 0.3, 0.1 weighing 5\n{_END}",
    good=_WHOLE,
)

UNIT_SLIP = Code(
    "unit-slip",
    "A number looks like one of another unit: a link of 400 m may be one of 400 mm, an angle of "
    "90 rad one of 90 deg.",
    severity=Severity.WARNING,
    bad=f"{_ROVER}rover has_link 'base' shaped box 400, 300, 100\n{_END}",
    good=f"{_ROVER}rover has_link 'base' shaped box 0.4, 0.3, 0.1\n{_END}",
)

BROKEN_URDF = Code(
    "broken-urdf",
    "A robot's file says what the parser of URDF does not take: a name or a number that is not "
    "there or is none, two parts of one name, a material that is not described. Correct it there; "
    "what is wrong counts as not said.",
)

SIDE_EFFECT = Code(
    "side-effect",
    "A change of a robot's file takes along something that no sentence speaks of, or leaves "
    "something that does not fit any more: an attribute of a newer version of URDF, a comment, "
    "what Gazebo or a transmission says of a part that is taken away. The change is made.",
    severity=Severity.WARNING,
)

UNTRUSTED_MACROS = Code(
    "untrusted-macros",
    "The macros of a robot's file (xacro) are expanded by running expressions that stand in it, so "
    "that they are not until you trust the project with `plastron trust`. Links and joints are "
    "missing from what is shown; what stands outside of macros can be changed all the same.",
    severity=Severity.WARNING,
)

NOT_EXPANDED = Code(
    "not-expanded",
    "The macros of a robot's file (xacro) are not expanded, so that links and joints are missing "
    "from what is shown: the package `xacro` is not there; a file that is included is not there, "
    "or lies neither in the project nor in an installed package; or the macros have a mistake, or "
    "take more time or memory than a robot needs. What stands outside of them can be changed all "
    "the same.",
    severity=Severity.WARNING,
)
