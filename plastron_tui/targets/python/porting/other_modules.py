"""Python modules of other packages that only one ROS has, or that speak another way in the other.

Sources: the packages of both generations in rosdistro.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

from tree_sitter import Node

from plastron_tui.sources.python.package import MOST_MODULES, Package

from .call_graph import functions_that_reach
from .insertion_point import top_level
from .port_state import Work

_ROS_1_ONLY = "it is of ROS 1"
_TAKES_NODE = "its classes take the node in ROS 2"
_TAKES_NO_NODE = "its classes take no node in ROS 1"
_SERVER = "interactive_markers.interactive_marker_server.InteractiveMarkerServer"

_OF_ROS_1 = {
    "sensor_msgs.point_cloud2": "`sensor_msgs_py.point_cloud2`, whose `read_points` gives an array",
    "laser_geometry.laser_geometry": "`laser_geometry`",
    "moveit_commander": "`moveit.planning`, of `moveit_py`",
    "diagnostic_updater": _TAKES_NODE,
    "sound_play.libsoundplay": _TAKES_NODE,
    "interbotix_xs_modules": "`interbotix_xs_modules.xs_robot`",
    "ros_numpy": "`ros2_numpy`",
    "rospy_message_converter": "`rosidl_runtime_py`",
    "tf_conversions": "`tf_transformations`, or `PyKDL`",
    "baxter_interface": _ROS_1_ONLY,
    "baxter_external_devices": _ROS_1_ONLY,
    "intera_interface": _ROS_1_ONLY,
    "jsk_topic_tools": _ROS_1_ONLY,
    "aiorospy": _ROS_1_ONLY,
    "mavros": "the services of `mavros` itself",
    "ddynamic_reconfigure_python": "a callback of parameters",
    "rosserial_python": "`micro_ros`",
    "topic_tools": "its services are those of a node in ROS 2",
}
_OF_ROS_2 = {
    "sensor_msgs_py": "`sensor_msgs.point_cloud2`, whose `read_points` gives tuples",
    "diagnostic_updater": _TAKES_NO_NODE,
    "interactive_markers.InteractiveMarkerServer": f"`{_SERVER}`, which takes no node",
    "interactive_markers.interactive_marker_server": _TAKES_NO_NODE,
    "tf_transformations": "`tf.transformations`",
    "moveit": "`moveit_commander`",
    "ros2_numpy": "`ros_numpy`",
    "rosidl_runtime_py": "`rospy_message_converter`, or `genpy`",
    "ros2topic": "`rostopic`",
    "ros2node": "`rosnode`",
    "nav2_msgs": "`move_base_msgs`",
}


def mark_other_modules(work: Work) -> None:
    """Mark the import of a module that the other ROS has not, or has with other functions."""
    known = _OF_ROS_1 if work.catalog.ros_version == 2 else _OF_ROS_2
    for tag in ("import", "import_from"):
        for statement in work.analysis.captures.get(tag, []):
            for path in _paths(work, statement) if not work.is_gone(statement) else ():
                found = next((name for name in known if f"{path}.".startswith(f"{name}.")), None)
                if found is not None:
                    work.mark(statement, found, known[found])


def _paths(work: Work, statement: Node) -> Iterator[str]:
    """Yield the modules and names that a statement imports."""
    module = statement.child_by_field_name("module_name")
    prefix = f"{work.slice(module)}." if module is not None else ""
    for each in statement.children_by_field_name("name"):
        yield prefix + work.slice(each.child_by_field_name("name") or each)


def mark_own_modules(work: Work, path: Path) -> None:
    """Mark the import of a module of the file's own package that uses the old ROS itself."""
    package = Package(path, work.analysis.library)
    library = work.analysis.library.module
    for tag in ("import", "import_from"):
        for statement in work.analysis.captures.get(tag, []):
            for name in _modules(work, statement) if not work.is_gone(statement) else ():
                found = package.find(name, package.main)
                text = package.text(found.path) if found is not None else None
                if text is not None and _imports(text, library):
                    work.mark(statement, name, f"it uses {library}, and has to be ported too")
                    break


def mark_importers(work: Work, path: Path) -> None:
    """Mark a node that only the program makes, where another file takes what uses it."""
    functions = [each for each in work.analysis.scopes.all if each.kind == "function"]
    for init in work.analysis.nodes:
        top = top_level(init.call) if init.call is not None else None
        if init.call is None or top is None or init.scope.enclosing("function") is not None:
            continue
        is_program = top.type == "if_statement" and "__name__" in work.slice(top)
        uses = functions_that_reach(work, _calls_of_ros(work))
        other = _importer(work, path) if is_program and uses & {x.name for x in functions} else None
        if other is not None:
            remedy = f"`{other}` imports the file, and has to set its `node` first"
            work.mark(init.call, "the node", remedy)


def _calls_of_ros(work: Work) -> list[Node]:
    root = f"{work.analysis.library.module}."
    callees = (
        (call, call.child_by_field_name("function"))
        for call in work.analysis.captures.get("call", [])
    )
    return [
        call
        for call, callee in callees
        if callee is not None and any(name.startswith(root) for name in work.qualified(callee))
    ]


def _importer(work: Work, path: Path) -> str | None:
    """Return the name of a file beside one that imports it, None where there is none."""
    package = Package(path, work.analysis.library)
    others = (each for each in _beside(path) if str(each) != package.main)
    for other in islice(others, MOST_MODULES):
        text = package.text(str(other))
        if text is not None and _imports(text, path.stem):
            return other.name
    return None


def _beside(path: Path) -> list[Path]:
    try:
        return sorted(each for each in path.resolve().parent.glob("*.py") if each.is_file())
    except OSError:
        return []


def _imports(text: bytes, module: str) -> bool:
    """Tell whether a line imports a module, or something from it."""
    pattern = rb"^[ \t]*(?:from|import)[ \t]+(?:[\w.]*\.)?%s\b" % re.escape(module.encode())
    return re.search(pattern, text, re.MULTILINE) is not None


def _modules(work: Work, statement: Node) -> Iterator[str]:
    """Yield what a statement imports, as names that lead to modules."""
    module = statement.child_by_field_name("module_name")
    if module is None:
        yield from _paths(work, statement)
        return
    yield work.slice(module)
    for each in statement.children_by_field_name("name"):
        name = work.slice(each.child_by_field_name("name") or each)
        whole = work.slice(module)
        yield f"{whole}{name}" if whole.endswith(".") else f"{whole}.{name}"
