"""The names that no node file gets, because something runs files of these names by itself.

A loaded node keeps its file's name, and its text is somebody's: under another name, or in another
folder, the text would run without being asked for.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Container
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic

_AT_START = frozenset({"sitecustomize.py", "usercustomize.py"})
_PACKAGES = frozenset({"__init__.py", "__main__.py"})
_PYTEST = re.compile(r"conftest\.py|test_.*\.py|.*_test\.py")
_TOOLS = frozenset(
    {
        "conanfile.py", "conf.py", "dodo.py", "fabfile.py", "hatch_build.py", "manage.py",
        "noxfile.py", "sconstruct", "setup.py", "tasks.py", "toxfile.py", "wscript",
    }
)  # fmt: skip
_GIT_HOOKS = frozenset(
    {
        "applypatch-msg", "commit-msg", "fsmonitor-watchman", "p4-changelist",
        "p4-post-changelist", "p4-pre-submit", "p4-prepare-changelist", "post-applypatch",
        "post-checkout", "post-commit", "post-index-change", "post-merge", "post-receive",
        "post-rewrite", "post-update", "pre-applypatch", "pre-auto-gc", "pre-commit",
        "pre-merge-commit", "pre-push", "pre-rebase", "pre-receive", "prepare-commit-msg",
        "proc-receive", "push-to-checkout", "reference-transaction", "sendemail-validate",
        "update",
    }
)  # fmt: skip
"""The hooks of githooks(5): a repository may keep them in any folder (`core.hooksPath`)."""

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


def refuse_name(
    name: str, packages: Container[str], *, is_own: bool, is_in_place: bool
) -> Diagnostic | None:
    """Say why a node file cannot get a name, None where it can.

    Args:
        name: the file's name.
        packages: the packages whose types the node imports.
        is_own: whether Plastron makes the whole text: pytest may then import it.
        is_in_place: whether the node is written over the file that it comes from.
    """
    what = None if is_in_place else _runner(name.lower(), packages, is_own=is_own)
    if what is None:
        return None
    remedy = "give the node another name"
    if not is_own:
        remedy = "give the loaded file another name, or write the node over it with `--in-place`"
    return Diagnostic("runs-by-itself", f"no node is written to `{name}`: {what}", help=remedy)


def _runner(name: str, packages: Container[str], *, is_own: bool) -> str | None:
    """Tell what runs a file of a name, None where nothing does."""
    if name.startswith("."):
        return "shells and other programs read hidden files by themselves"
    if name in _AT_START or name.endswith(".pth"):
        return "Python runs it whenever it starts"
    if name in _PACKAGES:
        return "Python runs it when the folder is imported or started"
    if name == "conftest.py" or (not is_own and _PYTEST.fullmatch(name)):
        return "pytest runs it"
    if name in _TOOLS:
        return "tools run a file of this name"
    if name in _GIT_HOOKS:
        return "git runs a file of this name"
    stem = name.removesuffix(".py")
    if stem != name and (stem in _MODULES or stem in packages or _INTERFACES.fullmatch(stem)):
        return f"other nodes in the folder would import it in the place of the module `{stem}`"
    return None


def is_same_path(path: Path, other: Path) -> bool:
    """Tell whether two paths lead to one file, which need not be there."""
    return os.path.realpath(path) == os.path.realpath(other)
