"""Launch files, and what they start."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code

from .programs import TALKING

_BRINGUP = f"{TALKING}create_launch 'bringup' as bringup\n"
_ARGUMENT = f"{_BRINGUP}bringup has_argument 'robot' with default \"rover\"\n"
_PACKAGE = """\
create_package 'demo' as demo described_as "Says hello." maintained_by "Ada <ada@example.com>" \
licensed_under "MIT"
demo contains talker
generate_package demo
"""
_FULL = f"{_BRINGUP}bringup starts talker\n"

IN_NO_PACKAGE = Code(
    "in-no-package",
    "A launch file is to start a node that is in no package: it starts what packages install.",
    bad=f"{_FULL}generate_launch bringup\n",
    good=f"{_FULL}{_PACKAGE}generate_launch bringup\n",
)

LAUNCH_EXISTS = Code(
    "launch-exists",
    "Two launch files of a program have one name.",
    bad="create_launch 'bringup' as first\ncreate_launch 'bringup' as second\n",
    good="create_launch 'bringup' as first\ncreate_launch 'robot' as second\n",
)

UNKNOWN_LAUNCH = Code(
    "unknown-launch",
    "No launch file has this variable: it is misspelt, or the launch file is made further down.",
    bad=f"{_BRINGUP}bringpu starts talker\n",
    good=_FULL,
)

ALREADY_STARTED = Code(
    "already-started",
    "A launch file starts a node of this name already, or has such an argument, or includes the "
    "file: two nodes of one name cannot run together.",
    bad=f"{_FULL}bringup starts talker\n",
    good=f"{_FULL}bringup starts talker as 'second_talker'\n",
)

NOT_STARTED = Code(
    "not-started",
    "A launch file does not have what is to be taken out of it.",
    bad=f"{_BRINGUP}bringup no_longer_starts 'talker'\n",
    good=f"{_FULL}bringup no_longer_starts 'talker'\n",
)

BAD_LAUNCH_NAME = Code(
    "bad-launch-name",
    "A name that a launch file uses cannot be one: an argument has letters, digits and `_`, a node "
    "is started as `'PACKAGE/EXECUTABLE'`, a file is included as `'PACKAGE/FILE'`.",
    bad=f"{_BRINGUP}bringup starts 'talker'\n",
    good=f"{_BRINGUP}bringup starts 'demo/talker'\n",
)

UNKNOWN_ARGUMENT = Code(
    "unknown-argument",
    "A launch file has no argument of this name, or is to lose one that it uses.",
    bad=f"{_ARGUMENT}bringup starts talker in '$(var robt)'\n",
    good=f"{_ARGUMENT}bringup starts talker in '$(var robot)'\n",
)

NOT_IN_PACKAGE = Code(
    "not-in-package",
    "A launch file starts an executable, or includes a launch file, that a package of the program "
    "does not have. Of a package that is loaded it is only likely: it may install the file from "
    "another folder.",
    bad=f"{_BRINGUP}{_PACKAGE}bringup starts 'demo/takler'\n",
    good=f"{_BRINGUP}{_PACKAGE}bringup starts 'demo/talker'\n",
)

NOT_A_COMPONENT = Code(
    "not-a-component",
    "A container is to have a node that it cannot load: it loads components, classes of C++ that "
    "packages of ROS 2 install. A node in Python runs in a process of its own.",
    bad=f"{_BRINGUP}bringup starts talker inside 'eyes'\n",
    good=f"{_BRINGUP}bringup starts 'image_proc/image_proc::RectifyNode' inside 'eyes'\n",
)

BROKEN_LAUNCH = Code(
    "broken-launch",
    "A file is no launch file, or says what `roslaunch` and `ros2 launch` do not take.",
)

UNRESOLVED_LAUNCH = Code(
    "unresolved-launch",
    "Something in a launch file is only known when it is started, or by code: an argument without "
    "a value, a condition that is computed, a package that is not here. What hangs on it is left "
    "out.",
)

LAUNCH_DIFFERS = Code(
    "launch-differs",
    "A launch file starts something else than the program wrote that made it: it was changed by "
    "hand since. What the file says is started; to have it in the program too, say it there.",
)
"""No program shows the last ones: what a launch file says is not said in a program."""
