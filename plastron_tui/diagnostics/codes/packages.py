"""Packages, and what they contain."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code
from plastron_tui.diagnostics.severity import Severity

from .programs import TALKING

_ROVER = f"{TALKING}create_package 'rover' as rover\n"
_FULL = f"{_ROVER}rover contains talker\n"

PACKAGE_EXISTS = Code(
    "package-exists",
    "Two packages of a program, or of a workspace, have one name: a workspace takes only one of "
    "them.",
    bad="create_package 'rover' as first\ncreate_package 'rover' as second\n",
    good="create_package 'rover' as first\ncreate_package 'rover_tools' as second\n",
)

UNKNOWN_PACKAGE = Code(
    "unknown-package",
    "No package has this variable: it is misspelt, or the package is made further down.",
    bad=f"{_ROVER}rovr contains talker\n",
    good=_FULL,
)

UNKNOWN_ITEM = Code(
    "unknown-item",
    "A package contains nodes and launch files, by their variables.",
    bad=f"{_ROVER}rover contains greeting\n",
    good=_FULL,
)

ALREADY_CONTAINED = Code(
    "already-contained",
    "A node or a launch file is in a package already, or the package has another one of its "
    "name: what a package contains is started by its name.",
    bad=f"{_FULL}rover contains talker\n",
    good=_FULL,
)

NOT_CONTAINED = Code(
    "not-contained",
    "A package does not contain what is to be taken out of it. Of a package that is loaded this is "
    "a warning: an earlier run may have taken it out.",
    bad=f"{_ROVER}rover no_longer_contains talker\n",
    good=f"{_FULL}rover no_longer_contains talker\n",
)

BAD_PACKAGE_NAME = Code(
    "bad-package-name",
    "The name of a package has lower case letters, digits and single underscores, and starts with "
    "a letter (REP 144). The help line has a name that is allowed.",
    bad="create_package 'My-Rover' as rover\n",
    good="create_package 'my_rover' as rover\n",
)

TAKEN_PACKAGE_NAME = Code(
    "taken-package-name",
    "The name of a package is another's: of a package of ROS, of a module of Python, or of what a "
    "build makes. It can be built, but one of the two hides the other. Choose another name.",
    severity=Severity.WARNING,
    bad="create_package 'std_msgs' as rover\n",
    good="create_package 'rover' as rover\n",
)

BAD_MAINTAINER = Code(
    "bad-maintainer",
    "A maintainer is a name and an address that the build tools take: `Ada <ada@example.com>`.",
    bad="create_package 'rover' as rover maintained_by \"Ada\"\n",
    good="create_package 'rover' as rover maintained_by \"Ada <ada@example.com>\"\n",
)

MAINTAINER_MISSING = Code(
    "maintainer-missing",
    "Every package has a maintainer with an address (REP 149), and the program names none; the "
    "package gets one at `example.com`, which is nobody's. Add `maintained_by`.",
    severity=Severity.WARNING,
)

UNKNOWN_LICENSE = Code(
    "unknown-license",
    "A license is named by its identifier in the SPDX License List, such as `Apache-2.0`, `MIT` or "
    "`BSD-3-Clause`. The help line has the nearest one. Closed code is `Proprietary`, and a "
    "license with a text of its own `LicenseRef-NAME`.",
    bad="create_package 'rover' as rover licensed_under \"Apache-2\"\n",
    good="create_package 'rover' as rover licensed_under \"Apache-2.0\"\n",
)

LICENSE_MISSING = Code(
    "license-missing",
    "Every package says its license (REP 149), and the program names none; the package then says "
    "`Proprietary`: nobody else may use it. Add `licensed_under`.",
    severity=Severity.WARNING,
)

BAD_PACKAGE_TEXT = Code(
    "bad-package-text",
    "The description or the version of a package cannot be in its files: a description is one line "
    "of text, a version is three numbers.",
    bad="create_package 'rover' as rover described_as \"two\\nlines\"\n",
    good="create_package 'rover' as rover described_as \"one line\"\n",
)

BAD_PACKAGE_FILE = Code(
    "bad-package-file",
    "A file or an executable of a package has a name that it cannot have there, or that another "
    "one has already. Give it another name with `as`.",
)

OTHER_ROS = Code(
    "other-ros",
    "A package is for one generation of ROS, and a node for the other is put into it. A package "
    "of `catkin` is for ROS 1, one of `ament_python` or `ament_cmake` for ROS 2.",
)

FILE_STAYS = Code(
    "file-stays",
    "An executable was taken out of a package, or has another name, and its file is left there: "
    "something else may need it. Remove it by hand where nothing does.",
    severity=Severity.WARNING,
)

STILL_STARTED = Code(
    "still-started",
    "An executable was taken out of a package, and a launch file of the package starts it still. "
    "Take it out there too, with `load_launch` and `no_longer_starts`, or by hand.",
    severity=Severity.WARNING,
)

NOT_COPIED = Code(
    "not-copied",
    "The output folder gets a loaded package as a whole, so that it is built from there, and here "
    "something of it is missing: the package has more than 2,000 files or 32 MB, or something of "
    "it cannot be read, or is a link that leads out of the project. With `--in-place` the package "
    "is changed where it is. What a robot's file names (meshes, files that it includes) is copied "
    "into a package that the program creates, from within the project; the rest is told.",
    severity=Severity.WARNING,
)

SCRIPT_ELSEWHERE = Code(
    "script-elsewhere",
    "A package of `ament_python` installs its executables where `ros2 run` does not look for them: "
    "it looks into `lib/PACKAGE`, and without an `install_scripts` in `setup.cfg` they go to "
    "`bin`. Add it there.",
    severity=Severity.WARNING,
)

UNKNOWN_IMPORT = Code(
    "unknown-import",
    "A node imports a module, and no package is known to bring it: `package.xml` says nothing of "
    "it. Add the dependency there by hand.",
    severity=Severity.WARNING,
)

MIXED_PACKAGE = Code(
    "mixed-package",
    "A package contains nodes of both generations of ROS: each has a build of its own.",
    bad=f"{_FULL}create_node 'old' as old using rospy\n"
    "create_node 'new' as new using rclpy\nrover contains old\nrover contains new\n",
    good=_FULL,
)
