"""What fills the slots of sentences, and how it is written."""

from __future__ import annotations

from enum import Enum, auto


class Form(Enum):
    """How what fills a slot is written: what is matched, lowered and explained alike."""

    VARIABLE = auto()
    WORD = auto()
    QUOTED = auto()
    TYPE = auto()
    FILE = auto()
    NUMBER = auto()
    RATE = auto()
    TEXT = auto()
    FLAG = auto()
    VALUE = auto()
    VALUES = auto()
    QOS = auto()
    CONDITION = auto()
    NAMED = auto()
    FIELDS = auto()
    REMAPS = auto()
    SETTINGS = auto()
    VECTOR = auto()
    COLOR = auto()

    @property
    def is_open(self) -> bool:
        """Whether it goes on until another clause begins, or the line ends."""
        return self in _OPEN_FORMS


_OPEN_FORMS = frozenset(
    {
        Form.VALUE,
        Form.VALUES,
        Form.QOS,
        Form.CONDITION,
        Form.FIELDS,
        Form.REMAPS,
        Form.SETTINGS,
        Form.VECTOR,
    }
)


class SlotKind(Enum):
    """What fills a slot; a new kind is an entry here, with the form that it is written in.

    Attributes:
        placeholder: how it is written in a usage line.
        words: what it is called in a message.
        form: how it is written in a program.
    """

    NODE_NAME = "'NODE_NAME'", "a node name in single quotes", Form.QUOTED
    NODE_OF_FILE = "'NODE_NAME'", "the name of a node of the file, in single quotes", Form.QUOTED
    NEW_NODE = "VARIABLE", "a variable for the node", Form.VARIABLE, "NODE"
    NEW_MESSAGE = "MESSAGE", "a variable for the message", Form.VARIABLE, "MESSAGE"
    NODE = "VARIABLE", "the variable of a node", Form.VARIABLE
    MESSAGE = "MESSAGE", "the variable of a message", Form.VARIABLE
    TOPIC = "'TOPIC_NAME'", "a topic name in single quotes", Form.QUOTED
    SERVICE = "'SERVICE_NAME'", "a service name in single quotes", Form.QUOTED
    ACTION = "'ACTION_NAME'", "an action name in single quotes", Form.QUOTED
    PARAMETER = "'PARAMETER_NAME'", "a parameter name in single quotes", Form.QUOTED
    MESSAGE_TYPE = "MESSAGE_TYPE", "a message type", Form.TYPE
    SERVICE_TYPE = "SERVICE_TYPE", "a service type", Form.TYPE
    ACTION_TYPE = "ACTION_TYPE", "an action type", Form.TYPE
    PARAMETER_TYPE = "PARAMETER_TYPE", "a parameter type, such as `float`", Form.WORD
    NAMED = "topic | service | action | parameter", "what is renamed, such as `topic`", Form.WORD
    OLD_NAME = "'OLD_NAME'", "a name in single quotes", Form.QUOTED
    NEW_NAME = "'NEW_NAME'", "a name in single quotes", Form.QUOTED
    INPUT = "VALUES | none", "values, or `none`", Form.VALUES
    ANSWER = "VALUES | none", "values of the answer, or `none`", Form.VALUES
    DEFAULT = "VALUE", "a value", Form.VALUE
    BOUND = "NUMBER", "a number", Form.NUMBER
    RATE = "RATE", "a number, or `parameter` and a name", Form.RATE
    ONCE = "once", "`once`", Form.FLAG
    MANAGED = "managed", "`managed`", Form.FLAG
    TRIGGER = "'TOPIC_NAME'", "the name of a topic in single quotes", Form.QUOTED
    CONDITION = "CONDITION", "a condition, such as `received.data > 5`", Form.CONDITION
    QOS = "QOS", "words of quality of service, such as `sensor_data`", Form.QOS
    TEXT = '"TEXT"', "a text in double quotes", Form.TEXT
    FUNCTION = "FUNCTION", "the name of a function", Form.WORD
    TIMER = "FUNCTION", "the name of a function that is repeated", Form.WORD
    LIBRARY = "CLIENT_LIBRARY", "a client library", Form.WORD
    FILE = "FILE_NAME | 'RELATIVE/PATH.py'", "a file name, or a path in single quotes", Form.FILE
    TYPE_NAME = "TYPE", "a name for the type", Form.TYPE, "OWN_TYPE"
    NEW_TYPE = "TYPE", "a name for the type", Form.VARIABLE, "OWN_TYPE"
    OWN_TYPE = "TYPE", "a type of the program", Form.VARIABLE
    TYPE_FILE = "'RELATIVE/PATH.msg'", "the path of a definition, in single quotes", Form.QUOTED
    FIELDS = "FIELDS | none", "fields, such as `float64 x, float64 y`, or `none`", Form.FIELDS
    DEFINITION = '"TYPE NAME"', 'a field in double quotes, such as "float64 x"', Form.TEXT
    FIELD = "'FIELD'", "the name of a field in single quotes", Form.QUOTED
    SECTION = "SECTION", "`request`, `response`, `goal`, `result` or `feedback`", Form.WORD
    PACKAGE_NAME = "'PACKAGE_NAME'", "a package name in single quotes", Form.QUOTED
    NEW_PACKAGE = "PACKAGE", "a variable for the package", Form.VARIABLE, "PACKAGE"
    PACKAGE = "PACKAGE", "the variable of a package", Form.VARIABLE
    PACKAGE_FOLDER = "'FOLDER'", "the folder of a package, in single quotes", Form.QUOTED
    MAINTAINER = (
        '"NAME <MAIL>"',
        'a name and an address, such as "Ann <ann@example.org>"',
        Form.TEXT,
    )
    LICENSE = (
        '"LICENSE"',
        'the SPDX name of a license, such as "Apache-2.0", or "Proprietary"',
        Form.TEXT,
    )
    ITEM = "VARIABLE", "the variable of a node or of a launch file", Form.VARIABLE
    EXECUTABLE = "'EXECUTABLE'", "the name of an executable, in single quotes", Form.QUOTED
    HELD = (
        "VARIABLE | 'EXECUTABLE'",
        "the variable of a node or of a launch file, or an executable in single quotes",
        Form.NAMED,
    )
    LAUNCH_NAME = "'LAUNCH_NAME'", "the name of a launch file, in single quotes", Form.QUOTED
    NEW_LAUNCH = "LAUNCH", "a variable for the launch file", Form.VARIABLE, "LAUNCH"
    LAUNCH = "LAUNCH", "the variable of a launch file", Form.VARIABLE
    LAUNCH_FILE = "'RELATIVE/PATH'", "the path of a launch file, in single quotes", Form.QUOTED
    ARGUMENT = "'ARGUMENT'", "the name of an argument, in single quotes", Form.QUOTED
    STARTED = (
        "VARIABLE | 'PACKAGE/EXECUTABLE'",
        "the variable of a node, or a package and an executable in single quotes",
        Form.NAMED,
    )
    RUN_NAME = "'NAME'", "a node name in single quotes", Form.QUOTED
    NAMESPACE = "'NAMESPACE'", "a namespace in single quotes", Form.QUOTED
    CONTAINER = "'CONTAINER'", "the name of a container, in single quotes", Form.QUOTED
    REMAPS = (
        "'FROM' to 'TO', …",
        "names in single quotes, such as 'scan' to 'front/scan'",
        Form.REMAPS,
    )
    SETTINGS = "'PARAMETER' = VALUE, …", "parameters, such as 'speed' = 0.5", Form.SETTINGS
    PARAMS_FILE = "'FILE.yaml'", "a parameter file in single quotes", Form.QUOTED
    INCLUDED = "'PACKAGE/FILE'", "a package and a launch file, in single quotes", Form.QUOTED
    ROBOT_NAME = "'ROBOT_NAME'", "the name of a robot, in single quotes", Form.QUOTED
    NEW_ROBOT = "ROBOT", "a variable for the robot", Form.VARIABLE, "ROBOT"
    ROBOT = "ROBOT", "the variable of a robot", Form.VARIABLE
    ROBOT_FILE = "'RELATIVE/PATH.urdf'", "the path of a URDF file, in single quotes", Form.QUOTED
    ROBOT_ARGUMENTS = "'ARGUMENT' = VALUE, …", "arguments, such as 'width' = 0.5", Form.SETTINGS
    LINK = "'LINK'", "the name of a link, in single quotes", Form.QUOTED
    JOINT = "'JOINT'", "the name of a joint, in single quotes", Form.QUOTED
    FOLLOWED = "'OTHER_JOINT' | none", "the name of a joint, in single quotes", Form.QUOTED
    SHAPE = "SHAPE", "`box`, `cylinder`, `sphere` or `mesh`", Form.WORD
    SIZE = "VALUES", "sizes in metres, such as `0.4, 0.3, 0.1`", Form.VALUES
    WEIGHT = "KG", "a number of kilograms", Form.NUMBER
    COLOR = "COLOR | none", 'a colour, such as `blue` or "#3060ff"', Form.COLOR
    POSITION = "X, Y, Z", "three numbers of metres, such as `0, 0.2, 0`", Form.VECTOR
    ROTATION = "ROLL, PITCH, YAW", "three angles, such as `90, 0, 0`", Form.VECTOR
    ANGLE_UNIT = "deg | rad", "`deg` or `rad`", Form.WORD
    JOINT_TYPE = "JOINT_TYPE", "a joint type, such as `revolute`", Form.WORD
    AXIS = "X, Y, Z", "three numbers, such as `0, 0, 1`", Form.VECTOR
    FACTOR = "FACTOR", "a number", Form.NUMBER
    LIMIT_UNIT = "deg | rad | m", "`deg`, `rad` or `m`", Form.WORD

    def __init__(self, placeholder: str, words: str, form: Form, makes: str = "") -> None:
        self.placeholder = placeholder
        self.words = words
        self.form = form
        self._makes = makes

    @property
    def makes(self) -> SlotKind | None:
        """The kind of slot that may name, further down, what this one gives a name to."""
        return SlotKind[self._makes] if self._makes else None

    @property
    def is_variable(self) -> bool:
        """Whether a variable fills the slot, or can; another name than one is in quotes then."""
        return self.form in (Form.VARIABLE, Form.NAMED)

    @property
    def may_be_none(self) -> bool:
        """Whether the word `none` may stand there: for no values or no fields at all, say."""
        if self in (SlotKind.COLOR, SlotKind.FOLLOWED):
            return True
        return self.form in (Form.VALUES, Form.FIELDS) and self is not SlotKind.SIZE

    @property
    def is_quoted(self) -> bool:
        """Whether single quotes are around what fills the slot."""
        return self.form is Form.QUOTED
