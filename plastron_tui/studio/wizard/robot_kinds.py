"""Robots: their names and files, their links and joints."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.sentence import NOTHING
from plastron_tui.ros.robots.description import Description, Joint, JointType
from plastron_tui.ros.robots.names import FILE_ENDINGS
from plastron_tui.ros.robots.tree import holders, roots

from ..folder_files import found_files, path_text
from ..robot_words import JOINT_TYPES
from .ask import Ask, Choice
from .context import free_name
from .form import NEW, Cell
from .goals import maker_of
from .kind import OF_THE_LIST, Kind

if TYPE_CHECKING:
    from plastron_tui.model.robots import Robot

_NAMES = ("rover", "arm", "robot")
_LINK_NAMES = ("body", "part")


class RobotNameKind(Kind):
    """The name of a new robot."""

    def suggest(self, ask: Ask) -> str:
        """Return one that no robot has."""
        robots = ask.scene.workspace.robots.values()
        taken = {*(each.name for each in robots), *ask.scene.taken}
        return next((name for name in _NAMES if name not in taken), free_name("robot", taken))

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            return "a robot needs a name, such as `rover`"
        if any(each.name == text for each in ask.scene.workspace.robots.values()):
            return f"a robot is called `{text}` already: choose another name"
        return None


class RobotFileKind(Kind):
    """The file of a robot."""

    def suggest(self, ask: Ask) -> str:
        """Return the first that is not loaded yet."""
        return next((each.text for each in self.choices(ask, "") if not each.closed), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those below the program's folder."""
        folder = ask.scene.session.folder
        found = ask.scene.surroundings.once("robots", lambda: found_files(FILE_ENDINGS, folder))
        robots = ask.scene.workspace.robots.values()
        loaded = {each.source.path for each in robots if each.source is not None}
        return [
            Choice(path_text(path, folder), closed="it is loaded already" * (path in loaded))
            for path in found
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text else "no robot's file is beside the program: write the path of one"


class RobotKind(Kind):
    """A robot of the program."""

    def fixed(self, ask: Ask) -> Cell | None:
        """Return the robot of the joint that a link is made for."""
        robot = ask.parent_text(SlotKind.ROBOT)
        return Cell(robot, "as the joint") if robot else None

    def suggest(self, ask: Ask) -> str:
        """Return the last one for which the statement makes sense, those not written yet first."""
        robots = list(reversed(ask.scene.workspace.robots))
        if ask.form.declaration.writes_file:
            written = {each.robot.variable for each in ask.scene.workspace.written_robots}
            robots.sort(key=lambda name: name in written)
        known = ask.scene.workspace.robots
        fitting = (name for name in robots if _has_something(known[name], ask))
        return next(fitting, None) or next(iter(robots), NEW if _can_make(ask) else "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all, the last one first."""
        robots = ask.scene.workspace.robots
        found = [Choice(name, _said(robots[name])) for name in reversed(robots)]
        if _can_make(ask):
            found.append(Choice(NEW, "", "the next screen asks for its name", label="a new robot"))
        return found

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not ask.scene.workspace.robots:
            return "there is no robot yet: describe one first"
        return None if text in ask.scene.workspace.robots else f"no such robot: {OF_THE_LIST}"


def _said(robot: Robot) -> str:
    return f"'{robot.name}'" if robot.source is None else robot.source.path.name


def _has_something(robot: Robot, ask: Ask) -> bool:
    """Tell whether a robot has what the statement is about."""
    declaration = ask.form.declaration.type
    if declaration is st.NoLongerHasLink:
        return not all(links_in_use(robot).values())
    if declaration in (st.NoLongerHasJoint, st.LimitsJoint):
        return not all(_closed_joints(robot, declaration).values())
    return True


def links_in_use(robot: Robot) -> dict[str, str]:
    """Return why the links of a robot cannot be taken away, "" where they can."""
    found = dict.fromkeys(robot.description.links, "")
    for joint in robot.description.joints.values():
        found |= dict.fromkeys((joint.parent, joint.child), f"`{joint.name}` holds it")
    return found


def _closed_joints(robot: Robot, declaration: type[Statement]) -> dict[str, str]:
    """Return why joints cannot be limited, or taken away; "" where they can."""
    joints = robot.description.joints
    if declaration is st.LimitsJoint:
        types = {each for each in JointType if each.is_limited or each is JointType.CONTINUOUS}
        moving = (name for name, joint in joints.items() if joint.type in types)
        places = robot.joints
        return {
            name: "it is limited already" if name in places and places[name].limited else ""
            for name in moving
        }
    found = dict.fromkeys(joints, "")
    for joint in joints.values():
        if joint.mimic is not None:
            found[joint.mimic.joint] = f"`{joint.name}` follows it"
    return found


def _can_make(ask: Ask) -> bool:
    return ask.form.declaration.type in (st.HasLink, st.HasJoint) and bool(maker_of(ask.slot.kind))


class LinkKind(Kind):
    """A link: a new one, one to be changed or taken away, or one that a joint holds or is on."""

    def suggest(self, ask: Ask) -> str:
        """Return what fits: a free name, a link that nothing holds yet, or the last one.

        A joint that is changed keeps its links.
        """
        robot = description_of(ask)
        if ask.form.declaration.type is st.HasLink:
            return new_link_name(robot.links)
        if ask.form.declaration.type is st.NoLongerHasLink:
            open_ = [each.text for each in self.choices(ask, "") if not each.closed]
            return next(reversed(open_), "")
        if _joint_there(ask) is not None:
            return ""
        names = _free_children(ask) if ask.slot.name == "child" else parents(robot)
        return next(iter(names), NEW)

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the links of the robot that are meant, and a new one for a joint."""
        robot = description_of(ask)
        if ask.form.declaration.type is st.HasLink:
            return [Choice(name, "change it") for name in _untouched(ask, robot.links)]
        if ask.form.declaration.type is st.NoLongerHasLink:
            known = robot_of(ask)
            used = {} if known is None else links_in_use(known)
            return [Choice(name, closed=reason) for name, reason in used.items()]
        new = Choice(NEW, "", "a later screen asks what it is like", label="a new link")
        held = holders(robot)
        if ask.slot.name != "child":
            return [*map(Choice, parents(robot)), new]
        own = ask.text(SlotKind.JOINT)
        taken = [each for each in held.values() if each.child != ask.text_of("parent")]
        return [
            *(Choice(name, "nothing holds it yet") for name in _free_children(ask)),
            new,
            *(
                Choice(each.child, closed=f"`{each.name}` holds it" * (each.name != own))
                for each in taken
            ),
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        robot = description_of(ask)
        if ask.form.declaration.type is st.HasLink:
            return None if text else "a link needs a name, such as `base_link`"
        if text in robot.links:
            return None
        if not robot.links:
            return "the robot has no link yet: give it one first"
        if not text:
            return "a joint holds each link: take that away first, and the link goes along"
        return f"the robot has no link `{text}`: {OF_THE_LIST}"


def new_link_name(taken: Collection[str]) -> str:
    """Return a name for a new link: the first one is what all others hang on."""
    if not taken:
        return "base_link"
    free = (name for name in _LINK_NAMES if name not in taken)
    return next(free, free_name(_LINK_NAMES[-1], taken))


def _child_to_be(ask: Ask) -> str:
    """Return the link that a joint will hold, as far as that is known before it is asked for."""
    child = ask.form.entered.get("child") or next(iter(_free_children(ask)), NEW)
    maker = ask.form.makers.get("child")
    if child != NEW:
        return child
    if maker is not None and "link" in maker.entered:
        return maker.entered["link"]
    links = description_of(ask).links
    # What holds it is made before it, where there is nothing yet.
    return new_link_name(links or {new_link_name(())})


def parents(robot: Description) -> list[str]:
    """Return the links that can hold another one, those that most would take first."""
    carried = Counter(joint.parent for joint in robot.joints.values())

    def rank(name: str) -> tuple[bool, int]:
        # A root that is a place, and carries one link, stands for that link.
        stands_for = carried[name] == 1 and not robot.links[name].visuals
        return stands_for, -carried[name]

    return sorted(robot.links, key=rank)


def _free_children(ask: Ask) -> list[str]:
    """Return the links that no joint holds: but for the first one, and for the parent."""
    others = roots(description_of(ask))[1:]
    return [name for name in others if name != ask.text_of("parent")]


class JointKind(Kind):
    """A joint: a new one, one to be changed, limited or taken away, or one to be followed."""

    def suggest(self, ask: Ask) -> str:
        """Return a name after the child; of those that there are, the last one that is open."""
        robot = description_of(ask)
        if ask.form.declaration.type is st.HasJoint:
            return free_name(f"{_child_to_be(ask)}_joint", robot.joints)
        open_ = [each.text for each in self.choices(ask, "") if not each.closed]
        return next(reversed(open_), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the joints of the robot that are meant."""
        joints = description_of(ask).joints
        if ask.form.declaration.type is st.HasJoint:
            return [Choice(name, "change it") for name in _untouched(ask, joints)]
        robot = robot_of(ask)
        reasons = {} if robot is None else _closed_joints(robot, ask.form.declaration.type)
        return [
            Choice(name, joints[name].type.value, closed=reason) for name, reason in reasons.items()
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        joints = description_of(ask).joints
        if ask.form.declaration.type is st.HasJoint and ask.slot.name == "joint":
            return None if text else "a joint needs a name, such as `wheel_joint`"
        if text in joints:
            return None
        if ask.form.declaration.type is st.LimitsJoint and not text:
            return "the robot has no joint that moves and has no limits yet"
        if not joints:
            return "the robot has no joint yet: hold two parts together first"
        if not text:
            return "all joints are needed: others follow them"
        return f"the robot has no joint `{text}`: {OF_THE_LIST}"


NONE = "none"
"""What is entered for a joint that is to follow no other."""


class FollowedKind(Kind):
    """A joint that another one follows; none for one that follows a joint so far."""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the joints that move, and none."""
        joints = description_of(ask).joints
        own = ask.text(SlotKind.JOINT)
        moving = (each for each in joints.values() if each.type.has_axis and each.name != own)
        found = [Choice(each.name, each.type.value) for each in moving]
        there = joints.get(own)
        if there is None or there.mimic is None or NONE in joints:
            return found
        return [*found, Choice(NONE, f"it no longer follows {there.mimic.joint}")]

    def written(self, ask: Ask, text: str) -> str:
        """Return a name; the word for none is not in quotes."""
        return NOTHING if text == NONE and NONE not in description_of(ask).joints else text

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        joints = description_of(ask).joints
        is_right = text in joints or text == NONE
        return None if is_right else f"the robot has no joint `{text}`: {OF_THE_LIST}"


class JointTypeKind(Kind):
    """How a joint moves."""

    def suggest(self, ask: Ask) -> str:
        """Return the one that most joints have; a joint that is changed keeps its own."""
        return JointType.FIXED.value if _joint_there(ask) is None else ""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all."""
        return [Choice(name, about) for name, about in JOINT_TYPES.items()]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text in JOINT_TYPES else f"no such joint type: {OF_THE_LIST}"


def robot_of(ask: Ask) -> Robot | None:
    """Return the robot that the form is about."""
    return ask.scene.workspace.robots.get(ask.text(SlotKind.ROBOT))


def description_of(ask: Ask) -> Description:
    """Return what the robot of the form consists of."""
    robot = robot_of(ask)
    return Description("") if robot is None else robot.description


def joint_of(ask: Ask) -> Joint | None:
    """Return the joint that the form is about, None for a new one."""
    return description_of(ask).joints.get(ask.text(SlotKind.JOINT))


def _joint_there(ask: Ask) -> Joint | None:
    """Return the joint that the form changes."""
    return joint_of(ask) if ask.form.declaration.type is st.HasJoint else None


def _untouched(ask: Ask, names: Collection[str]) -> Iterator[str]:
    """Yield the parts of a loaded robot that the program does not speak of."""
    robot = robot_of(ask)
    if robot is not None:
        spoken = {*robot.links, *robot.joints}
        yield from (name for name in names if name not in spoken)
