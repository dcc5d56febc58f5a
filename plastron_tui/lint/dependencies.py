"""What packages depend on over others, and in which words a package.xml says so."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.model.package_facts import BuildFacts, Declared, Used
from plastron_tui.ros.name_slips import is_slip

from .tree import PackageFacts, SourceTree

_BRINGING: dict[str, frozenset[str]] = {
    "common_interfaces": frozenset(
        {"actionlib_msgs", "builtin_interfaces", "diagnostic_msgs", "geometry_msgs", "nav_msgs",
         "sensor_msgs", "shape_msgs", "std_msgs", "std_srvs", "stereo_msgs", "trajectory_msgs",
         "visualization_msgs"}
    ),
    "common_msgs": frozenset(
        {"actionlib_msgs", "diagnostic_msgs", "geometry_msgs", "nav_msgs", "sensor_msgs",
         "shape_msgs", "stereo_msgs", "trajectory_msgs", "visualization_msgs"}
    ),
}  # fmt: skip
"""What packages bring that are there for nothing else: the metapackages of messages."""

LIBRARIES = frozenset({"rclcpp", "rclpy", "roscpp", "rospy"})

TYPES_ALONE = frozenset(
    {"ackermann_msgs", "can_msgs", "control_msgs", "controller_manager_msgs", "geographic_msgs",
     "gps_msgs", "map_msgs", "move_base_msgs", "moveit_msgs", "nav2_msgs",
     "object_recognition_msgs", "pcl_msgs", "px4_msgs", "radar_msgs", "ros_gz_interfaces",
     "rosapi_msgs", "rosbridge_msgs", "ur_dashboard_msgs", "ur_msgs", "uuid_msgs", "vision_msgs"}
)  # fmt: skip
"""Packages that have types and nothing else, and that the catalog does not list."""


TYPE_ENDINGS = ("_msgs", "_srvs", "_interfaces", "_msg", "_srv", "_actions", "_action", "_messages")
"""How the names end that people give packages of types."""


def is_umbrella(tree: SourceTree, package: PackageFacts) -> bool:
    """Tell whether a package of the workspace is there to bring others, and makes nothing."""
    build = package.build
    if build is None or package.executables or build.targets or build.entries:
        return False
    return not any(unit.package == package.name for unit in tree.units)


def brought(tree: SourceTree, package: PackageFacts) -> Iterator[str]:
    """Yield the packages that come with those which a package depends on for nothing else."""
    waiting = [] if package.build is None else [each.name for each in package.build.dependencies]
    seen: set[str] = set()
    while waiting:
        name = waiting.pop()
        if name in seen:
            continue
        seen.add(name)
        yield from _BRINGING.get(name, ())
        other = tree.packages.get(name)
        if other is None or other.build is None or other.build.has_code or has_types(other):
            continue
        own = [each.name for each in other.build.dependencies if {"build", "exec"} & each.covers]
        yield from own
        waiting += own


def has_types(package: PackageFacts) -> bool:
    """Tell whether a package has definitions of types."""
    return any(
        each.endswith((".msg", ".srv", ".action"))
        for each in (() if package.build is None else package.build.files)
    )


def depends_on(tree: SourceTree, name: str, wanted: str) -> bool:
    """Tell whether a package of the workspace depends on another one, over others or itself."""
    waiting, seen = [name], set[str]()
    while waiting:
        current = waiting.pop()
        package = tree.packages.get(current)
        if current in seen or package is None or package.build is None:
            continue
        seen.add(current)
        names = [each.name for each in package.build.dependencies if "test" not in each.tag]
        if wanted in names:
            return True
        waiting += names
    return False


def remedy_for(
    tree: SourceTree, package: PackageFacts, used: Used, name: str, needs: frozenset[str]
) -> str:
    """Return what to write so that a package depends on another one.

    Args:
        tree: the workspace.
        package: the package.
        used: what it needs of the other one first.
        name: the other one.
        needs: for what it needs it in all, `build` or `exec`.
    """
    build, version = package.build, package.ros_versions[0]
    assert build is not None
    catalog = tree.catalogs.get(version)
    is_known = name in TYPES_ALONE or name in tree.packages
    is_known = is_known or catalog is None or catalog.has_package(name)
    if used.package and not is_known:
        return f"no package is called `{name}`: the folder of its definitions has no package.xml"
    remedy = _declaring(name, needs, build, version, misnamed(tree, package, name))
    is_found = name in build.found or build.finds_declared
    if "build" not in needs or build.build_type == "ament_python" or is_found:
        return remedy
    finding = f"find_package(catkin REQUIRED COMPONENTS … {name})"
    if build.build_type != "catkin":
        finding = f"find_package({name} REQUIRED)"
    return f"{remedy}, and `{finding}` into CMakeLists.txt"


def misnamed(tree: SourceTree, package: PackageFacts, name: str) -> list[Declared]:
    """Return the dependencies of a package that are meant for another one, and not called like it.

    One tag has the names of several, a name has hyphens, which no package of ROS has, or it is
    one slip from that of the package, and nobody has a package of it.
    """
    others = () if package.build is None else package.build.dependencies
    return [
        each
        for each in others
        if each.name != name
        and (
            name in each.name.split()
            or each.name.replace("-", "_") == name
            or (is_slip(each.name, name) and not is_package(tree, package, each.name))
        )
    ]


def is_package(tree: SourceTree, package: PackageFacts, name: str) -> bool:
    """Tell whether a package may be called so: one without types only where it is in use."""
    build, catalog = package.build, tree.catalogs.get(package.ros_versions[0])
    is_known = name in TYPES_ALONE or name in LIBRARIES or name in tree.packages
    is_known = is_known or catalog is None or catalog.has_package(name)
    return is_known or (build is not None and name in build.mentioned)


def _declaring(
    name: str, needs: frozenset[str], build: BuildFacts, version: int, others: list[Declared]
) -> str:
    """Return what to write into package.xml, such that it still is valid (REP 127, 140, 149)."""
    declared = [each for each in build.dependencies if each.name == name]
    if not declared and others:
        if " " in others[0].name:
            return f"write a tag for each name of `{others[0].name}`"
        return f"write `{name}` in place of `{others[0].name}`"
    if declared and not any(version in each.versions for each in declared):
        return f"write a condition of `<{declared[0].tag}>` that holds for ROS {version}, too"
    tags = " and ".join(f"`<{tag}>{name}</{tag}>`" for tag in _tags(declared, needs, build))
    remedy = f"write {tags} into package.xml"
    if build.format == 1 and any(each.tag == "test_depend" for each in declared):
        return f"{remedy} in place of the `<test_depend>`"
    return remedy


def _tags(declared: list[Declared], needs: frozenset[str], build: BuildFacts) -> tuple[str, ...]:
    """Return the tags that are missing; what one tag says, no other one may say again."""
    covered = frozenset[str]().union(*(each.covers for each in declared))
    # What is built is linked with it, or made of its types, and needs it when it runs.
    missing = [each for each in ("build", "exec") if each in {*needs, "exec"} - covered]
    if build.format == 1:
        return tuple("run_depend" if each == "exec" else f"{each}_depend" for each in missing)
    if covered & {"build", "build_export", "exec"}:
        return tuple(f"{each}_depend" for each in missing)
    tags = {each.tag for each in build.dependencies}
    is_run = "build" not in needs and (
        build.build_type == "ament_python" or tags.isdisjoint({"depend", "build_depend"})
    )
    return ("exec_depend",) if is_run else ("depend",)
