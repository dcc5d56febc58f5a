"""The statements about interface types of the program's own."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from ..definitions import FieldTexts

TYPE_HELP = "what the type is called, alone or with its package: `rover_msgs/WheelSpeed`"
OWN_HELP = "the type, by the name that the program has for it"
SECTION_HELP = "which part of a service or an action; without it the request, or the goal"


@statement(
    "create_message_type_statement",
    "create_message_type {type} with {fields}",
    summary="Make a type of messages.",
    example="create_message_type WheelSpeed with float64 left, float64 right",
    purpose="make a type of message",
    ros_term="message definition",
    about="Where no type that exists has the fields that you need, you make one that has.",
)
class CreateMessageType(Statement):
    """Make a type of messages."""

    type: str = slot(SlotKind.TYPE_NAME, TYPE_HELP)
    fields: FieldTexts = slot(
        SlotKind.FIELDS,
        "its fields and constants, in their order: `float64 x`, `int32[] ids`, `uint8 OK = 1`",
    )


@statement(
    "create_service_type_statement",
    "create_service_type {type} with {request} returning {response}",
    summary="Make a type of services.",
    example="create_service_type Reset with bool hard returning bool done",
    purpose="make a type of service",
    ros_term="service definition",
    about="A service has two parts: what is asked, and what is answered.",
)
class CreateServiceType(Statement):
    """Make a type of services."""

    type: str = slot(SlotKind.TYPE_NAME, TYPE_HELP)
    request: FieldTexts = slot(SlotKind.FIELDS, "what is asked")
    response: FieldTexts = slot(SlotKind.FIELDS, "what is answered")


@statement(
    "create_action_type_statement",
    "create_action_type {type} with {goal} returning {result} reporting {feedback}",
    summary="Make a type of actions.",
    example="create_action_type Dock with int32 bay returning bool docked reporting float32 left",
    purpose="make a type of action",
    ros_term="action definition",
    about="An action has three parts: the goal, its result, and what is told on the way.",
)
class CreateActionType(Statement):
    """Make a type of actions."""

    type: str = slot(SlotKind.TYPE_NAME, TYPE_HELP)
    goal: FieldTexts = slot(SlotKind.FIELDS, "what is to be done")
    result: FieldTexts = slot(SlotKind.FIELDS, "what came of it")
    feedback: FieldTexts = slot(SlotKind.FIELDS, "what is told on the way")


@statement(
    "load_type_statement",
    "load_type {source} as {variable}",
    summary="Read a definition, to change it.",
    example="load_type 'msg/WheelSpeed.msg' as WheelSpeed",
    purpose="change a definition that exists",
    ros_term="definition file",
    about="Only what you ask for changes; comments and everything else stay.",
)
class LoadType(Statement):
    """Read a definition, to change it."""

    source: str = slot(SlotKind.TYPE_FILE, "a path from the program's folder")
    variable: str = slot(SlotKind.NEW_TYPE, "what the program calls the type")


@statement(
    "has_field_statement",
    "{type} has_field {definition} [in {section}]",
    summary="Give a type a field, or a field another type.",
    example='WheelSpeed has_field "float64 slip"',
    purpose="have a field more",
    ros_term="field",
    about="A field is a part of a message that has a name and a type.",
)
class HasField(Statement):
    """Give a type a field, or a field another type."""

    type: str = slot(SlotKind.OWN_TYPE, OWN_HELP)
    definition: str = slot(SlotKind.DEFINITION, "a line as definition files have it")
    section: str | None = slot(SlotKind.SECTION, SECTION_HELP)


@statement(
    "no_longer_has_field_statement",
    "{type} no_longer_has_field {field} [in {section}]",
    summary="Take a field away from a type.",
    example="WheelSpeed no_longer_has_field 'slip'",
    purpose="have a field less",
    ros_term="field",
    about="Takes a field away again.",
    undoes=HasField,
)
class NoLongerHasField(Statement):
    """Take a field away from a type."""

    type: str = slot(SlotKind.OWN_TYPE, OWN_HELP)
    field: str = slot(SlotKind.FIELD, "the field or the constant")
    section: str | None = slot(SlotKind.SECTION, SECTION_HELP)


@statement(
    "drop_type_statement",
    "drop_type {type}",
    summary="Take a type of the program away.",
    example="drop_type WheelSpeed",
    purpose="no longer have a type",
    ros_term="interface definition",
    about="Takes a type away again that nothing uses any more.",
)
class DropType(Statement):
    """Take a type of the program away."""

    type: str = slot(SlotKind.OWN_TYPE, OWN_HELP)


@statement(
    "generate_type_statement",
    "generate_type {type}",
    summary="Write a type to its definition file.",
    example="generate_type WheelSpeed",
    purpose="write a type to its file",
    ros_term="definition file",
    about="It is written with the nodes and packages that use it, without this too.",
    writes_file=True,
)
class GenerateType(Statement):
    """Write a type to its definition file."""

    type: str = slot(SlotKind.OWN_TYPE, OWN_HELP)
