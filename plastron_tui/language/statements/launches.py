"""The statements about launch files."""

from __future__ import annotations

from ..declaration import SlotKind, Statement, slot, statement
from ..definitions import RemapTexts, SettingTexts
from ..inputs import InputValue

LAUNCH_HELP = "the launch file"
ARGUMENT_HELP = "the argument"
INCLUDED_HELP = "a package, and the launch file in it"


@statement(
    "create_launch_statement",
    "create_launch {name} as {variable}",
    summary="Make a new launch file.",
    example="create_launch 'bringup' as bringup",
    purpose="start several nodes together",
    ros_term="launch file",
    about="A launch file starts nodes together, each with its names and parameters.",
)
class CreateLaunch(Statement):
    """Make a new launch file."""

    name: str = slot(SlotKind.LAUNCH_NAME, "what the file is called, without its ending")
    variable: str = slot(SlotKind.NEW_LAUNCH, "what the program calls the launch file")


@statement(
    "load_launch_statement",
    "load_launch {source} as {variable}",
    summary="Read a launch file, to change it.",
    example="load_launch 'launch/bringup.launch.xml' as bringup",
    purpose="change a launch file that exists",
    ros_term="launch file",
    about="Only what you ask for changes; everything else stays.",
)
class LoadLaunch(Statement):
    """Read a launch file, to change it."""

    source: str = slot(SlotKind.LAUNCH_FILE, "a path from the program's folder")
    variable: str = slot(SlotKind.NEW_LAUNCH, "what the program calls the launch file")


@statement(
    "has_argument_statement",
    "{launch} has_argument {argument} [with default {default}]",
    summary="Let who starts a launch file give it a value.",
    example="bringup has_argument 'robot' with default \"rover\"",
    purpose="take a value when it is started",
    ros_term="launch argument",
    about="An argument is set when the launch file is started; without a default it has to be. "
    "What it brings is `$(var NAME)` in the names, the namespace, the new topics and the texts of "
    "`starts`, for both ROS: `in '$(var robot)'`, `setting 'speed' = \"$(var speed)\"`.",
)
class HasArgument(Statement):
    """Let who starts a launch file give it a value."""

    launch: str = slot(SlotKind.LAUNCH, LAUNCH_HELP)
    argument: str = slot(SlotKind.ARGUMENT, ARGUMENT_HELP)
    default: InputValue | None = slot(SlotKind.DEFAULT, "its value where none is given")


@statement(
    "no_longer_has_argument_statement",
    "{launch} no_longer_has_argument {argument}",
    summary="Take an argument away from a launch file.",
    example="bringup no_longer_has_argument 'robot'",
    purpose="no longer take a value",
    ros_term="launch argument",
    about="Takes an argument away again.",
    undoes=HasArgument,
)
class NoLongerHasArgument(Statement):
    """Take an argument away from a launch file."""

    launch: str = slot(SlotKind.LAUNCH, LAUNCH_HELP)
    argument: str = slot(SlotKind.ARGUMENT, ARGUMENT_HELP)


@statement(
    "starts_statement",
    "{launch} starts {started} [as {name}] [in {namespace}] [inside {container}]"
    " [remapping {remaps}] [setting {settings}] [with parameters {parameters}]",
    summary="Let a launch file start a node.",
    example="bringup starts driver in 'front' remapping 'scan' to 'laser' setting 'speed' = 0.5",
    purpose="start a node",
    ros_term="node action",
    about="The node may get another name, a namespace, other topics, and parameters. Nodes of one "
    "name in two namespaces are two. A parameter file is looked for from the program's folder; "
    "the package that contains the launch file gets a copy in `config`, and installs it. A "
    "container (ROS 2) holds components: `starts 'PACKAGE/NAMESPACE::CLASS' inside 'CONTAINER'`; "
    "a node in Python runs in a process of its own.",
)
class Starts(Statement):
    """Let a launch file start a node."""

    launch: str = slot(SlotKind.LAUNCH, LAUNCH_HELP)
    started: str = slot(SlotKind.STARTED, "the node, or the package and the executable of another")
    name: str | None = slot(SlotKind.RUN_NAME, "the name that it runs under; else its own")
    namespace: str | None = slot(SlotKind.NAMESPACE, "what stands before its name and its topics")
    container: str | None = slot(SlotKind.CONTAINER, "the process that it shares with others")
    remaps: RemapTexts | None = slot(SlotKind.REMAPS, "names of its own, and those that they get")
    settings: SettingTexts | None = slot(SlotKind.SETTINGS, "its parameters, and their values")
    parameters: str | None = slot(SlotKind.PARAMS_FILE, "a file with values of its parameters")


@statement(
    "no_longer_starts_statement",
    "{launch} no_longer_starts {name}",
    summary="Let a launch file no longer start a node.",
    example="bringup no_longer_starts 'driver'",
    purpose="no longer start a node",
    ros_term="node action",
    about="Takes a node out of a launch file again. One whose name another one has as well goes by "
    "its namespace too: `'front/driver'`.",
    undoes=Starts,
)
class NoLongerStarts(Statement):
    """Let a launch file no longer start a node."""

    launch: str = slot(SlotKind.LAUNCH, LAUNCH_HELP)
    name: str = slot(SlotKind.RUN_NAME, "the name that the node runs under")


@statement(
    "includes_statement",
    "{launch} includes {file}",
    summary="Let a launch file start another one.",
    example="bringup includes 'rover/sensors.launch.xml'",
    purpose="start another launch file",
    ros_term="include",
    about="All that the other one starts is started too.",
)
class Includes(Statement):
    """Let a launch file start another one."""

    launch: str = slot(SlotKind.LAUNCH, LAUNCH_HELP)
    file: str = slot(SlotKind.INCLUDED, INCLUDED_HELP)


@statement(
    "no_longer_includes_statement",
    "{launch} no_longer_includes {file}",
    summary="Let a launch file no longer start another one.",
    example="bringup no_longer_includes 'rover/sensors.launch.xml'",
    purpose="no longer start another launch file",
    ros_term="include",
    about="Takes a launch file out of another one again.",
    undoes=Includes,
)
class NoLongerIncludes(Statement):
    """Let a launch file no longer start another one."""

    launch: str = slot(SlotKind.LAUNCH, LAUNCH_HELP)
    file: str = slot(SlotKind.INCLUDED, INCLUDED_HELP)


@statement(
    "generate_launch_statement",
    "generate_launch {launch}",
    summary="Write a launch file.",
    example="generate_launch bringup",
    purpose="write a launch file",
    ros_term="launch file",
    about="The file is one that `roslaunch` or `ros2 launch` takes.",
    writes_file=True,
)
class GenerateLaunch(Statement):
    """Write a launch file."""

    launch: str = slot(SlotKind.LAUNCH, LAUNCH_HELP)
