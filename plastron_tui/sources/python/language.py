"""What Plastron asks of Python, without the parser that reading needs."""

from __future__ import annotations

import keyword
import re
import sys
from collections.abc import Container
from pathlib import Path
from typing import ClassVar

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.code_facts import CodeFacts
from plastron_tui.model.source import FileSet, SourceUnit
from plastron_tui.sources.base import Language, ReadResult

_LIBRARIES = (b"rospy", b"rclpy")

_AT_START = frozenset({"sitecustomize.py", "usercustomize.py"})
_PACKAGES = frozenset({"__init__.py", "__main__.py"})
_PYTEST = re.compile(r"conftest\.py|test_.*\.py|.*_test\.py")

_TOOLS = frozenset(
    {
        "conanfile.py", "conf.py", "dodo.py", "fabfile.py", "hatch_build.py", "manage.py",
        "noxfile.py", "sconstruct", "setup.py", "tasks.py", "toxfile.py", "wscript",
    }
)  # fmt: skip

_MODULES = (sys.stdlib_module_names - {"antigravity", "test", "this", "turtle"}) | {
    "actionlib", "ament_index_python", "catkin", "catkin_pkg", "cryptodome", "cv_bridge",
    "defusedxml", "distro", "em", "genmsg", "genpy", "gnupg", "image_geometry", "lark", "launch",
    "launch_ros", "message_filters", "netifaces", "numpy", "pyparsing", "rclpy", "regex",
    "rosbag", "roscpp", "rosgraph", "roslib", "roslz4", "rospkg", "rospy", "rpyutils", "six",
    "tf", "tf2_py", "tf2_ros", "typing_extensions", "yaml",
}  # fmt: skip
"""What nodes and their client libraries import; nobody imports the four that are left out."""

# What packages of interfaces are called, and what of ROS makes Python of them.
_INTERFACES = re.compile(r".+_(msgs|srvs|interfaces|pybind11)|rosidl_.+")


class Python(Language):
    """Python 3, as ROS nodes are written in it."""

    name: ClassVar[str] = "python"
    title: ClassVar[str] = "Python"
    suffixes: ClassVar[tuple[str, ...]] = (".py",)
    is_executable: ClassVar[bool] = True
    is_script: ClassVar[bool] = True

    def is_keyword(self, word: str) -> bool:
        """Tell whether a word is one of Python's keywords."""
        return keyword.iskeyword(word)

    def mentioned_library(self, text: bytes) -> str | None:
        """Return `rospy` or `rclpy` where a file has the word anywhere."""
        return next((each.decode() for each in _LIBRARIES if each in text), None)

    def read(self, path: Path, files: FileSet, library: str | None = None) -> ReadResult:
        """Read the nodes and endpoints of a Python file."""
        from .reader import read_python  # loads tree-sitter-python

        return read_python(path, files, library)

    def code_facts(self, source: SourceUnit) -> CodeFacts:
        """Return what a Python file does besides creating endpoints."""
        from .facts import code_facts

        return code_facts(source)

    def runs_by_itself(self, name: str, packages: Container[str], *, is_own: bool) -> str | None:
        """Tell what of Python or its tools runs a file of a name, or imports it unasked."""
        if name in _TOOLS:
            return "tools run a file of this name"
        if name in _AT_START or name.endswith(".pth"):
            return "Python runs it whenever it starts"
        if name in _PACKAGES:
            return "Python runs it when the folder is imported or started"
        # pytest may import a text that is wholly Plastron's.
        if name == "conftest.py" or (not is_own and _PYTEST.fullmatch(name)):
            return "pytest runs it"
        stem = name.removesuffix(".py")
        if stem != name and (stem in _MODULES or stem in packages or _INTERFACES.fullmatch(stem)):
            return f"other nodes in the folder would import it in the place of the module `{stem}`"
        return None

    def is_worse(self, text: bytes, *others: bytes) -> bool:
        """Tell whether a text is no Python, or breaks more of it, than each of the others."""
        from .compiling import syntax_error
        from .syntax import parse
        from .unresolved import lost_names, meanings_in

        if parse(text).errors > max((parse(other).errors for other in others), default=0):
            return True
        # Tabs and blanks mixed up are no error to tree-sitter.
        is_broken = syntax_error(text) is not None
        if is_broken and all(syntax_error(other) is None for other in others):
            return True
        return lost_names(meanings_in(text), *map(meanings_in, others)) != []

    def refusal(self, path: Path, text: bytes, ros_version: int = 2) -> Diagnostic | None:
        """Return why Python refuses a file for sure, None where that is not sure."""
        from .refused_text import refusal

        return refusal(path, text, ros_version)

    def definitions(self, text: bytes, name: str) -> int:
        """Count the functions and methods of a name that a Python text defines."""
        from .words import definitions

        return definitions(text, name)

    def mentions(self, text: bytes, name: str) -> bool:
        """Tell whether Python code has a name; strings and comments are no code."""
        from .words import mentions

        return mentions(text, name)

    def imports(self, text: bytes) -> frozenset[str]:
        """Return the modules that a Python text imports, but for those of the standard library."""
        from .imported_modules import imported_modules

        return imported_modules(text)
