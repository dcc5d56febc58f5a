"""The statements about robots: links, joints, and what they are made of."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from ..definitions import SettingTexts, Vector
from ..inputs import Input, Nothing

ROBOT_HELP = "the robot"
LINK_HELP = "the link, a rigid part of the robot"
JOINT_HELP = "the joint, which holds two links together"
UNIT_HELP = "what the angles are in: deg or rad"


@statement(
    "create_robot_statement",
    "create_robot {name} as {variable}",
    summary="Describe a new robot.",
    example="create_robot 'rover' as rover",
    purpose="describe a robot: its parts, and how they move",
    ros_term="robot description (URDF)",
    about="A description says what a robot is made of, for simulation, pictures and planning.",
)
class CreateRobot(Statement):
    """Describe a new robot."""

    name: str = slot(SlotKind.ROBOT_NAME, "what the robot is called, and its file")
    variable: str = slot(SlotKind.NEW_ROBOT, "what the program calls the robot")


@statement(
    "load_robot_statement",
    "load_robot {source} as {variable} [setting {settings}]",
    summary="Read the description of a robot, to change it.",
    example="load_robot 'urdf/rover.urdf' as rover",
    purpose="change the description of a robot that exists",
    ros_term="robot description (URDF)",
    about="Only what you ask for changes; everything else stays. The macros of a xacro file are "
    "expanded in a folder that you trust, for a look; what is changed is what stands in the file. "
    "`setting` gives the file's arguments (`$(arg NAME)`) values.",
)
class LoadRobot(Statement):
    """Read the description of a robot, to change it."""

    source: str = slot(SlotKind.ROBOT_FILE, "a path from the program's folder")
    variable: str = slot(SlotKind.NEW_ROBOT, "what the program calls the robot")
    settings: SettingTexts | None = slot(
        SlotKind.ROBOT_ARGUMENTS, "arguments of a xacro file, and their values"
    )


@statement(
    "has_link_statement",
    "{robot} has_link {link} [shaped {shape} {size}] [weighing {weight}] [painted {color}]"
    " [at {position}] [turned {rotation} {unit}]",
    summary="Give a robot a link, or change one that a loaded robot has.",
    example="rover has_link 'base' shaped box 0.4, 0.3, 0.1 weighing 5 painted blue at 0, 0, 0.05",
    purpose="give it a part",
    ros_term="link",
    about="A link is a rigid part. Lengths are in metres, weights in kilograms; its inertia "
    "follows from both. Shapes are `box X, Y, Z`, `cylinder RADIUS, LENGTH`, `sphere RADIUS` and "
    '`mesh "URI"`; without one it is a place only. Of a link that a loaded robot has, only what is '
    "said changes: its colour is that of all that is seen, and `painted none` takes it away.",
)
class HasLink(Statement):
    """Give a robot a link, or change one that a loaded robot has."""

    robot: str = slot(SlotKind.ROBOT, ROBOT_HELP)
    link: str = slot(SlotKind.LINK, LINK_HELP)
    shape: str | None = slot(SlotKind.SHAPE, "box, cylinder, sphere or mesh")
    size: Input | None = slot(SlotKind.SIZE, "how large it is, in metres; of a mesh its URI")
    weight: int | float | None = slot(SlotKind.WEIGHT, "what it weighs, in kilograms")
    color: str | Nothing | None = slot(
        SlotKind.COLOR, 'a colour by its name, or its code: "#3060ff"'
    )
    position: Vector | None = slot(SlotKind.POSITION, "where the middle of its shape is, in metres")
    rotation: Vector | None = slot(SlotKind.ROTATION, "how its shape is turned: roll, pitch, yaw")
    unit: str | None = slot(SlotKind.ANGLE_UNIT, UNIT_HELP)


@statement(
    "no_longer_has_link_statement",
    "{robot} no_longer_has_link {link}",
    summary="Take a link away from a robot.",
    example="rover no_longer_has_link 'mast'",
    purpose="no longer have a part",
    ros_term="link",
    about="Takes a link away again. The joints that hold it have to go as well.",
    undoes=HasLink,
)
class NoLongerHasLink(Statement):
    """Take a link away from a robot."""

    robot: str = slot(SlotKind.ROBOT, ROBOT_HELP)
    link: str = slot(SlotKind.LINK, LINK_HELP)


@statement(
    "has_joint_statement",
    "{robot} has_joint {joint} [of joint_type {type}] [from {parent} to {child}] [at {position}]"
    " [turned {rotation} {unit}] [with axis {axis}] [mimicking {mimicked} [times {factor}]]",
    summary="Give a robot a joint, or change one that a loaded robot has.",
    example="rover has_joint 'left_wheel_joint' of joint_type continuous from 'base' to"
    " 'left_wheel' at 0, 0.2, 0 with axis 0, 1, 0",
    purpose="hold two parts together",
    ros_term="joint",
    about="A joint holds a link to its parent: `fixed`, `revolute` (turns between two angles), "
    "`continuous` (turns without end), `prismatic` (slides), `planar`, `floating`. `at` and "
    "`turned` say where the child is, seen from the parent. A new one has a type, and says what it "
    "holds. Of a joint that a loaded robot has, only what is said changes; `mimicking none` lets "
    "it follow no other.",
)
class HasJoint(Statement):
    """Give a robot a joint, or change one that a loaded robot has."""

    robot: str = slot(SlotKind.ROBOT, ROBOT_HELP)
    joint: str = slot(SlotKind.JOINT, JOINT_HELP)
    type: str | None = slot(SlotKind.JOINT_TYPE, "how the child moves")
    parent: str | None = slot(SlotKind.LINK, "the link that holds the other one")
    child: str | None = slot(SlotKind.LINK, "the link that is held")
    position: Vector | None = slot(SlotKind.POSITION, "where the child is, in metres")
    rotation: Vector | None = slot(SlotKind.ROTATION, "how the child is turned: roll, pitch, yaw")
    unit: str | None = slot(SlotKind.ANGLE_UNIT, UNIT_HELP)
    axis: Vector | None = slot(SlotKind.AXIS, "what it turns around, or slides along")
    mimicked: str | Nothing | None = slot(SlotKind.FOLLOWED, "the joint that it follows")
    factor: int | float | None = slot(SlotKind.FACTOR, "how far it moves for each unit of that one")


@statement(
    "no_longer_has_joint_statement",
    "{robot} no_longer_has_joint {joint}",
    summary="Take a joint away from a robot.",
    example="rover no_longer_has_joint 'mast_joint'",
    purpose="no longer hold two parts together",
    ros_term="joint",
    about="Takes a joint away again.",
    undoes=HasJoint,
)
class NoLongerHasJoint(Statement):
    """Take a joint away from a robot."""

    robot: str = slot(SlotKind.ROBOT, ROBOT_HELP)
    joint: str = slot(SlotKind.JOINT, JOINT_HELP)


@statement(
    "limits_joint_statement",
    "{robot} limits_joint {joint} [between {minimum} and {maximum} {unit}]"
    " [with effort {effort} and velocity {velocity}]"
    " [with damping {damping} and friction {friction}]",
    summary="Say how far, how strongly and how fast a joint moves.",
    example="arm limits_joint 'elbow' between -90 and 90 deg with effort 20 and velocity 1.5",
    purpose="say how far a joint moves",
    ros_term="joint limit",
    about="`revolute` and `prismatic` need limits. Effort is in N m or N, velocity in rad/s or "
    "m/s; damping and friction are for simulation.",
)
class LimitsJoint(Statement):
    """Say how far, how strongly and how fast a joint moves."""

    robot: str = slot(SlotKind.ROBOT, ROBOT_HELP)
    joint: str = slot(SlotKind.JOINT, JOINT_HELP)
    minimum: int | float | None = slot(SlotKind.BOUND, "the least angle, or place")
    maximum: int | float | None = slot(SlotKind.BOUND, "the greatest angle, or place")
    unit: str | None = slot(SlotKind.LIMIT_UNIT, "what both are in: deg, rad or m")
    effort: int | float | None = slot(SlotKind.BOUND, "the greatest torque, or force")
    velocity: int | float | None = slot(SlotKind.BOUND, "the greatest speed")
    damping: int | float | None = slot(SlotKind.BOUND, "what slows it the more the faster it is")
    friction: int | float | None = slot(SlotKind.BOUND, "what holds it at rest")


@statement(
    "generate_robot_statement",
    "generate_robot {robot}",
    summary="Write the description of a robot.",
    example="generate_robot rover",
    purpose="write the description of a robot",
    ros_term="robot description (URDF)",
    about="The file is one that robot_state_publisher, RViz and simulators take.",
    writes_file=True,
)
class GenerateRobot(Statement):
    """Write the description of a robot."""

    robot: str = slot(SlotKind.ROBOT, ROBOT_HELP)
