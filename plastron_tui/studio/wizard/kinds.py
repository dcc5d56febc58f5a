"""What each kind of slot offers: a suggestion, choices, and why a text cannot stand there."""

from __future__ import annotations

from collections.abc import Mapping

from plastron_tui.language import SlotKind
from plastron_tui.language import statements as st
from plastron_tui.language.keywords import KEYWORDS
from plastron_tui.model.graph import NOUNS
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.motion import COMMAND_TOPIC, LASER_TOPIC
from plastron_tui.ros.names import check_service_name, check_topic_name

from .ask import Ask, Choice
from .context import Meeting, free_name
from .definition_kinds import (
    DefinitionKind,
    FieldKind,
    FieldsKind,
    OwnTypeKind,
    SectionKind,
    TypeFileKind,
    TypeNameKind,
    own_type_to_send,
)
from .form import NEW
from .goals import maker_of
from .kind import OF_THE_LIST, Kind, name_problem
from .launch_kinds import (
    ArgumentKind,
    IncludedKind,
    LaunchFileKind,
    LaunchKind,
    LaunchNameKind,
    RemapsKind,
    RunNameKind,
    SettingsKind,
    StartedKind,
)
from .libraries import LibraryKind
from .message_kinds import MessageKind
from .node_files import FileKind, NewNodeKind, NodeOfFileKind
from .node_names import NodeNameKind
from .obstacles import (
    is_laser_wanted,
    is_to_drive,
    measures_distance,
)
from .package_kinds import (
    HeldKind,
    ItemKind,
    LicenseKind,
    MaintainerKind,
    PackageFolderKind,
    PackageKind,
    PackageNameKind,
)
from .parameter_kinds import DefaultKind, ParameterKind, ParameterTypeKind, TextKind
from .rename_kinds import NamedKind, NewNameKind, OldNameKind
from .robot_kinds import (
    FollowedKind,
    JointKind,
    JointTypeKind,
    LinkKind,
    RobotFileKind,
    RobotKind,
    RobotNameKind,
)
from .robot_value_kinds import (
    AngleUnitKind,
    AxisKind,
    ColorKind,
    FactorKind,
    LimitKind,
    LimitUnitKind,
    PositionKind,
    RotationKind,
    ShapeKind,
    SizeKind,
    WeightKind,
)
from .sending_kinds import ConditionKind, FlagKind, QosKind, RateKind, TriggerKind
from .taken_back import nothing_to_take, taken_back
from .trials import closed_by, first_that_works, trials
from .type_kinds import NAMES, TypeKind, name_for_type, usual_topics
from .variable_kinds import NewVariableKind


class NodeKind(Kind):
    """A node of the program."""

    def suggest(self, ask: Ask) -> str:
        """Return what fits the rest of the form and of the program."""
        held = ask.held
        nodes = sorted(_last_first(ask), key=lambda variable: variable in held)
        working = first_that_works(ask, nodes)
        if working is not None:
            return working
        if nodes:
            return nodes[0]
        return NEW if _can_make(ask) else ""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return what there is, and what is closed."""
        found = []
        nodes = _last_first(ask)
        reasons = closed_by(ask, nodes)
        for variable in nodes:
            node = ask.scene.workspace.nodes[variable]
            closed = reasons.get(variable, "")
            note = f"'{node.name}'" if node.source is None else node.source.path.name
            found.append(Choice(variable, note, closed=closed))
        if _can_make(ask):
            found.append(Choice(NEW, "", "the next screen asks for its name", label="a new node"))
        return found

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not ask.scene.workspace.nodes:
            return "there is no node yet: make one first"
        if not text:
            return f"a node is needed: {OF_THE_LIST}"
        if text not in ask.scene.workspace.nodes:
            return f"there is no node `{text}`: {OF_THE_LIST}"
        return None


def _last_first(ask: Ask) -> list[str]:
    """Return the nodes, the last one first; of those to be written, the ones that are not yet."""
    nodes = list(reversed(ask.scene.workspace.nodes))
    if not ask.form.declaration.writes_file:
        return nodes
    generated = {made.node.variable for made in ask.scene.workspace.generations}
    return sorted(nodes, key=lambda variable: variable in generated)


def _can_make(ask: Ask) -> bool:
    """Tell whether one that does not exist yet would do."""
    if maker_of(ask.slot.kind) is None:
        return False
    return first_that_works(ask, [NEW]) is not None


class MeetingKind(Kind):
    """The name of a topic, of a service or of an action."""

    def _names(self, ask: Ask) -> list[Meeting]:
        """Return what can be named, the lonely ones first."""
        known = ask.scene.meetings(ask.interface, ask.version).values()
        return sorted(known, key=lambda each: not each.is_lonely)

    def suggest(self, ask: Ask) -> str:
        """Return what fits the rest of the form and of the program."""
        if ask.form.declaration.undoes is not None:
            return next((each.text for each in taken_back(ask) if not each.closed), "")
        if ask.slot.kind is SlotKind.TOPIC and is_laser_wanted(ask):
            lasers = (x.name for x in self._names(ask) if measures_distance(x.type))
            return next(lasers, LASER_TOPIC)
        if ask.slot.kind is SlotKind.TOPIC and is_to_drive(ask):
            return COMMAND_TOPIC
        # Who sends something of its own seeks who lacks it; who takes it, what there is.
        sends = ask.form.slot_of(SlotKind.MESSAGE, SlotKind.INPUT) is not None
        held = ask.held
        # What a node has itself it is not to hear, or to ask, of its own accord.
        there = [
            each
            for each in self._names(ask)
            if each.name not in held and ask.node not in (*each.senders, *each.takers)
        ]
        met = {} if ask.is_trial else {each.name: each for each in there}
        for name, tried in trials(ask, list(met)):
            helps = tried.lonely < ask.scene.lonely or not (sends or met[name].is_lonely)
            if tried.reason is None and helps:
                return name
        known = ask.scene.meetings(ask.interface, ask.version)
        message = ask.scene.workspace.messages.get(ask.text(SlotKind.MESSAGE))
        own = None if message is not None else own_type_to_send(ask)
        type_ = own if message is None else message.value.type
        wanted = name_for_type(ask.interface, type_)
        return free_name(wanted, {name.strip("/") for name in (*known, *held)})

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return what there is, and what is closed."""
        if ask.form.declaration.undoes is not None:
            return taken_back(ask)
        found = []
        names = self._names(ask)
        reasons = closed_by(ask, [each.name for each in names])
        for meeting in names:
            closed = reasons.get(meeting.name, "")
            type_ = "" if meeting.type is None else str(meeting.type)
            found.append(Choice(meeting.name, type_, _who(meeting), closed))
        if ask.slot.kind is SlotKind.TOPIC:
            there = {each.name.strip("/") for each in names}
            found += [each for each in usual_topics(ask) if each.text not in there]
        return found

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            if ask.form.declaration.undoes is not None:
                return nothing_to_take(ask)
            what = NOUNS[ask.interface]
            article = "an" if what[0] in "aeiou" else "a"
            return f"{article} {what} needs a name, such as `{NAMES[ask.interface]}`"
        is_topic = ask.slot.kind is SlotKind.TOPIC
        check = check_topic_name if is_topic else check_service_name
        return name_problem(check(text, ask.version))


def unanswered(ask: Ask) -> str:
    """Return what is said of a service or an action that would be asked and nobody has, or ""."""
    meeting = ask.meeting
    if ask.form.slot_of(SlotKind.INPUT) is None or (meeting is not None and meeting.takers):
        return ""
    if ask.interface is InterfaceKind.ACTION:
        return "; no node of the program does it yet: let another one do the task"
    return "; no node of the program answers it yet: let another one answer questions"


def _who(meeting: Meeting) -> str:
    parts = []
    if meeting.senders:
        parts.append(f"from {', '.join(meeting.senders)}")
    if meeting.takers:
        parts.append(f"to {', '.join(meeting.takers)}")
    return " ".join(parts)


class FunctionKind(Kind):
    """A function of the node's file."""

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not (text.isascii() and text.isidentifier()):
            return "a function has letters, digits and `_`, no digit first, and no space"
        if text in KEYWORDS:
            return f"`{text}` is a word of the language: choose another one"
        return None


class TimerKind(FunctionKind):
    """A function that is called again and again."""

    def suggest(self, ask: Ask) -> str:
        """Return a name for it; of those that are to end, the first."""
        if ask.form.declaration.undoes is not None:
            return next((each.text for each in taken_back(ask) if not each.closed), "")
        known = ask.scene.ended_by(ask.node, st.StopRepeating)
        node = ask.scene.workspace.nodes.get(ask.node)
        # Who changes a file that has one timer mostly wants another rate for that.
        if node is not None and node.source is not None and len(known) == 1:
            return known[0]
        return free_name("tick", known)

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those that are called already: to end one, or to call it at another rate."""
        if ask.form.declaration.undoes is not None:
            return taken_back(ask)
        names = ask.scene.ended_by(ask.node, st.StopRepeating)
        return [Choice(name, "is called already: change how often") for name in names]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if text:
            return super().problem(ask, text)
        if ask.form.declaration.undoes is not None:
            return nothing_to_take(ask)
        return "a function is needed, such as `tick`"


class InputKind(Kind):
    """The values of a message, a request or an answer; they have a form of their own."""


KINDS: Mapping[SlotKind, Kind] = {
    SlotKind.NODE_NAME: NodeNameKind(),
    SlotKind.NEW_NODE: NewNodeKind(),
    SlotKind.NEW_MESSAGE: NewVariableKind(),
    SlotKind.NODE: NodeKind(),
    SlotKind.MESSAGE: MessageKind(),
    SlotKind.TOPIC: MeetingKind(),
    SlotKind.SERVICE: MeetingKind(),
    SlotKind.ACTION: MeetingKind(),
    SlotKind.PARAMETER: ParameterKind(),
    SlotKind.MESSAGE_TYPE: TypeKind(),
    SlotKind.SERVICE_TYPE: TypeKind(),
    SlotKind.ACTION_TYPE: TypeKind(),
    SlotKind.PARAMETER_TYPE: ParameterTypeKind(),
    SlotKind.INPUT: InputKind(),
    SlotKind.ANSWER: InputKind(),
    SlotKind.DEFAULT: DefaultKind(),
    SlotKind.BOUND: LimitKind(),
    SlotKind.RATE: RateKind(),
    SlotKind.ONCE: FlagKind(),
    SlotKind.MANAGED: FlagKind(),
    SlotKind.TRIGGER: TriggerKind(),
    SlotKind.CONDITION: ConditionKind(),
    SlotKind.QOS: QosKind(),
    SlotKind.TEXT: TextKind(),
    SlotKind.FUNCTION: FunctionKind(),
    SlotKind.TIMER: TimerKind(),
    SlotKind.LIBRARY: LibraryKind(),
    SlotKind.FILE: FileKind(),
    SlotKind.NODE_OF_FILE: NodeOfFileKind(),
    SlotKind.NAMED: NamedKind(),
    SlotKind.OLD_NAME: OldNameKind(),
    SlotKind.NEW_NAME: NewNameKind(),
    SlotKind.TYPE_NAME: TypeNameKind(),
    SlotKind.NEW_TYPE: NewVariableKind(),
    SlotKind.OWN_TYPE: OwnTypeKind(),
    SlotKind.TYPE_FILE: TypeFileKind(),
    SlotKind.FIELDS: FieldsKind(),
    SlotKind.DEFINITION: DefinitionKind(),
    SlotKind.FIELD: FieldKind(),
    SlotKind.SECTION: SectionKind(),
    SlotKind.PACKAGE_NAME: PackageNameKind(),
    SlotKind.NEW_PACKAGE: NewVariableKind(),
    SlotKind.PACKAGE: PackageKind(),
    SlotKind.PACKAGE_FOLDER: PackageFolderKind(),
    SlotKind.MAINTAINER: MaintainerKind(),
    SlotKind.LICENSE: LicenseKind(),
    SlotKind.ITEM: ItemKind(),
    SlotKind.EXECUTABLE: Kind(),
    SlotKind.HELD: HeldKind(),
    SlotKind.LAUNCH_NAME: LaunchNameKind(),
    SlotKind.NEW_LAUNCH: NewVariableKind(),
    SlotKind.LAUNCH: LaunchKind(),
    SlotKind.LAUNCH_FILE: LaunchFileKind(),
    SlotKind.ARGUMENT: ArgumentKind(),
    SlotKind.STARTED: StartedKind(),
    SlotKind.RUN_NAME: RunNameKind(),
    SlotKind.NAMESPACE: Kind(),
    SlotKind.CONTAINER: Kind(),
    SlotKind.REMAPS: RemapsKind(),
    SlotKind.SETTINGS: SettingsKind(),
    SlotKind.ROBOT_ARGUMENTS: SettingsKind(),
    SlotKind.PARAMS_FILE: Kind(),
    SlotKind.INCLUDED: IncludedKind(),
    SlotKind.ROBOT_NAME: RobotNameKind(),
    SlotKind.NEW_ROBOT: NewVariableKind(),
    SlotKind.ROBOT: RobotKind(),
    SlotKind.ROBOT_FILE: RobotFileKind(),
    SlotKind.LINK: LinkKind(),
    SlotKind.JOINT: JointKind(),
    SlotKind.FOLLOWED: FollowedKind(),
    SlotKind.SHAPE: ShapeKind(),
    SlotKind.SIZE: SizeKind(),
    SlotKind.WEIGHT: WeightKind(),
    SlotKind.COLOR: ColorKind(),
    SlotKind.POSITION: PositionKind(),
    SlotKind.ROTATION: RotationKind(),
    SlotKind.ANGLE_UNIT: AngleUnitKind(),
    SlotKind.JOINT_TYPE: JointTypeKind(),
    SlotKind.AXIS: AxisKind(),
    SlotKind.FACTOR: FactorKind(),
    SlotKind.LIMIT_UNIT: LimitUnitKind(),
}
"""What each kind of slot offers."""
