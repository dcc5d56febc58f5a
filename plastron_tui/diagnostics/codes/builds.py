"""What packages that exist are built with: CMakeLists.txt, setup.py. No program shows these."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code

MISSING_EXTRA = Code(
    "missing-extra",
    "A file is in a language whose parser is not installed with Plastron, as CMake is. The help "
    "line has the command that installs it.",
)

BROKEN_BUILD_FILE = Code(
    "broken-build-file",
    "A `CMakeLists.txt` or a `setup.py` of a package has a syntax error, or lacks what makes it "
    "one: a call of `setup`, or of `find_package` for catkin or ament_cmake. Nothing was changed. "
    "Correct it first.",
)

COMPUTED_BUILD_FILE = Code(
    "computed-build-file",
    "A build file computes what is to be changed in it, by a loop, a function or the files that "
    "lie in a folder, and no single place in it can be changed for sure. Nothing was changed. "
    "Make the change by hand in the line that the message names.",
)
