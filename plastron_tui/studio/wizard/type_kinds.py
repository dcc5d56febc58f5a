"""The type of a topic, a message, a service or an action."""

from __future__ import annotations

from collections.abc import Sequence

from plastron_tui.language import SlotKind
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.ros.motion import COMMAND_TOPIC, LASER_TOPIC
from plastron_tui.ros.search import FoundType, search_types

from .ask import MEETINGS, Ask, Choice
from .definition_kinds import own_type_to_send
from .form import Cell
from .kind import OF_THE_LIST, Kind
from .obstacles import is_laser_wanted, measures_distance

MOST_TYPES = 80
"""The most types that a search lists."""

_MOST_SHOWN = 6

_DEFAULTS = {
    InterfaceKind.MESSAGE: "String",
    InterfaceKind.SERVICE: "SetBool",
    InterfaceKind.ACTION: "Fibonacci",
}
NAMES = {
    InterfaceKind.MESSAGE: "chatter",
    InterfaceKind.SERVICE: "switch",
    InterfaceKind.ACTION: "count",
}
"""What is an example of a name, for each kind of interface."""

# The names that most robots use for what they send (ROS REP 105 and the packages' own defaults).
_USUAL = {
    InterfaceKind.MESSAGE: {
        "chatter": "std_msgs/String",
        COMMAND_TOPIC: "geometry_msgs/Twist",
        "odom": "nav_msgs/Odometry",
        LASER_TOPIC: "sensor_msgs/LaserScan",
        "imu": "sensor_msgs/Imu",
        "image_raw": "sensor_msgs/Image",
        "camera_info": "sensor_msgs/CameraInfo",
        "joint_states": "sensor_msgs/JointState",
        "battery_state": "sensor_msgs/BatteryState",
        "range": "sensor_msgs/Range",
        "fix": "sensor_msgs/NavSatFix",
        "map": "nav_msgs/OccupancyGrid",
        "path": "nav_msgs/Path",
        "pose": "geometry_msgs/Pose",
        "goal_pose": "geometry_msgs/PoseStamped",
        "initialpose": "geometry_msgs/PoseWithCovarianceStamped",
        "joy": "sensor_msgs/Joy",
        "tf": "tf2_msgs/TFMessage",
    },
    # The package of these is another one in each generation of ROS.
    InterfaceKind.SERVICE: {"add": "AddTwoInts", "add_two_ints": "AddTwoInts"},
    InterfaceKind.ACTION: {},
}


_OFFERED = {
    COMMAND_TOPIC: "how fast a robot is to go, and to turn",
    LASER_TOPIC: "the distances that a laser measures",
    "odom": "where a robot is by its wheels, and how fast",
    "image_raw": "what a camera sees",
    "imu": "how a robot turns and leans",
    "joy": "the sticks and buttons of a joystick",
    "battery_state": "how full the battery is",
    "range": "the distance that a sonar measures",
    "joint_states": "the angles of a robot's joints",
    "goal_pose": "where a robot is to go",
    "map": "what is free and what is not",
}
"""The topics that are offered where a program has them not yet, and what is sent there."""


def usual_topics(ask: Ask) -> list[Choice]:
    """Return the topics that most robots have, with their types."""
    usual = ((name, _USUAL[InterfaceKind.MESSAGE][name], about) for name, about in _OFFERED.items())
    return [
        Choice(name, type_, about)
        for name, type_, about in usual
        if ask.scene.resolve(type_, InterfaceKind.MESSAGE, ask.version) is not None
    ]


def name_for_type(kind: InterfaceKind, type_: InterfaceName | None) -> str:
    """Return what a topic, a service or an action of a type is usually called."""
    if type_ is None:
        return NAMES[kind]
    usual = (name for name, full in _USUAL[kind].items() if full in (str(type_), type_.name))
    return next(usual, _snake(type_.name))


def _snake(name: str) -> str:
    parts = ("_" + char.lower() if char.isupper() else char for char in name)
    return "".join(parts).strip("_").replace("__", "_")


class TypeKind(Kind):
    """The type of a topic, a message or a service."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return the type that a message, a topic or a service has already."""
        if ask.form.parent is not None and not is_laser_wanted(ask):
            text = ask.parent_text(ask.slot.kind)
            name = ask.parent_text(SlotKind.TOPIC)
            return Cell(text, f"what `{name}` carries") if text else None
        version = ask.version
        cell = ask.cell(SlotKind.MESSAGE)
        message = ask.scene.workspace.messages.get(cell.text) if cell is not None else None
        if message is not None:
            written = ask.scene.written(message.value.type, ask.interface, version)
            return Cell(written, f"because `{message.variable}` is one")
        meeting = ask.meeting
        if meeting is None or meeting.type is None:
            return None
        written = ask.scene.written(meeting.type, ask.interface, version)
        return Cell(written, f"because `{meeting.name}` has it already")

    def suggest(self, ask: Ask) -> str:
        """Return the type that a topic of the name usually has, or a simple one."""
        name = ask.text(*MEETINGS).rpartition("/")[2]
        usual = _USUAL[ask.interface].get(name, "")
        found = ask.scene.resolve(usual, ask.interface, ask.version) if usual else None
        if found is None:
            own = own_type_to_send(ask)
            if own is not None:
                return ask.scene.written(own, ask.interface, ask.version)
            return _DEFAULTS[ask.interface]
        return ask.scene.written(found.name, ask.interface, ask.version)

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the types that a search finds, each with its fields and a line about it."""
        catalog = ask.scene.catalog(ask.version)
        found = []
        for each in search_types(catalog, ask.interface, query)[:MOST_TYPES]:
            about = f"{each.line}\n  {_fields(each)}"
            found.append(Choice(each.written, each.package, about))
        return found

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no type: only then is the statement itself of use."""
        if not text:
            return f"a type is needed: write what it is for, and {OF_THE_LIST}"
        is_name = all(part.isascii() and part.isidentifier() for part in text.split("/"))
        if not is_name or self._is_purpose(ask, text):
            return f"no type is called that: {OF_THE_LIST}"
        if is_laser_wanted(ask):
            found = ask.scene.resolve(text, ask.interface, ask.version)
            if found is not None and not measures_distance(found.name):
                return f"`{text}` does not say how far away things are: take LaserScan or Range"
        return None

    def _is_purpose(self, ask: Ask, text: str) -> bool:
        """Tell whether a text says what a type is for, and leads to some."""
        catalog, bare = ask.scene.catalog(ask.version), text.rpartition("/")[2]
        if not text.islower() or catalog.candidates(bare, ask.interface):
            return False
        return bool(search_types(catalog, ask.interface, text, is_lenient=False))


def _fields(found: FoundType) -> str:
    """Return the fields of a type on a line; of a service or an action those of its answer, too."""
    told = _listed(found.fields)
    return f"{told} → {_listed(found.answer)}" if found.answer else told


def _listed(fields: Sequence[tuple[str, str]]) -> str:
    shown = ", ".join(f"{name} {type_}" for name, type_ in fields[:_MOST_SHOWN])
    return (f"{shown}, …" if len(fields) > _MOST_SHOWN else shown) or "no fields"
