"""ROS as it is installed, and what runs. No program shows these mistakes."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code
from plastron_tui.diagnostics.severity import Severity

UNUSABLE_TYPE = Code(
    "unusable-type",
    "A type has a field whose name is a keyword of Python. ROS 2 generates a Python module "
    "for it that Python cannot read, so that no Python node can use the type, nor one that "
    "it is part of. Give the field another name, or write the node in another language.",
)

BAD_DEFINITION = Code(
    "bad-definition",
    "A `.msg`, `.srv` or `.action` file has a mistake, or cannot be read; its type counts "
    "as not there. Correct the line, or the file.",
)

NO_ROS = Code(
    "no-ros",
    "No ROS of the wanted version is on this machine. The help line has the command that "
    "installs one, or sources the one that is there.",
)

HALF_A_ROS = Code(
    "half-a-ros",
    "A ROS is installed in part: a client library without a middleware or a master, or a "
    "sourced ROS without a client library. The help line says how to add the rest.",
)

MISSING_ROS_PACKAGE = Code(
    "missing-ros-package",
    "The program uses messages or services of a package that the ROS on this machine does "
    "not have. The help line has the command that installs it.",
)

NOT_BUILT = Code(
    "not-built",
    "A package of types has to be built before the nodes of a program run: one of the program's "
    "own types, or one of the language's types that nothing installs. That failed. The help line "
    "has what is missing on this machine, or the file with what the build said.",
)

NO_MASTER = Code(
    "no-master",
    "No ROS 1 master answers at `ROS_MASTER_URI`, or none could be started there. Correct "
    "the variable, or unset it: `plastron run` then starts a master of its own.",
)

REMOTE_MASTER = Code(
    "remote-master",
    "`ROS_MASTER_URI` names another machine, but nodes speak on this machine only unless "
    "`--network` is given; a master on this machine is used instead.",
    severity=Severity.WARNING,
)

NO_GRAPH = Code(
    "no-graph",
    "The running graph could not be read; the message says why.",
)

UNMET_REMAP = Code(
    "unmet-remap",
    "A `--remap`, or the `remapping` of a launch file, is for a name that no node of the program "
    "has, so that it changes nothing: the name is misspelt, or is another node's.",
    severity=Severity.WARNING,
)

UNDECLARED_PARAMETER = Code(
    "undeclared-parameter",
    "A parameter is set that the file of the node does not read, so that its value changes "
    "nothing: the name is misspelt, or the node no longer has it.",
    severity=Severity.WARNING,
)

BAD_PARAMETERS = Code(
    "bad-parameters",
    "The parameter file of a program (`config/NAME.yaml`) has a mistake, or a value that its ROS "
    "cannot have or its node refuses; nothing is started. It is a parameter file of ROS 2: below "
    "a node's name and `ros__parameters:`, a value for each name.",
)

UNSUPPORTED_TARGET = Code(
    "unsupported-target",
    "Plastron cannot do this for the client library: a loaded node is brought from `rospy` to "
    "`rclpy` and back, and between no others. Or the client library is another distribution's, "
    "which cannot be loaded; the message says why.",
)
