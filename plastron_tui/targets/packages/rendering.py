"""The files of a package, from what it holds.

Sources: for catkin the wiki pages "catkin/CMakeLists.txt" and "rospy_tutorials/Tutorials/Makefile";
for ROS 2 what `ros2 pkg create` makes, the guides "ament_cmake user documentation", "ament_cmake
Python packages" and "Developing a ROS 2 package", and REP 149 for `package.xml`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import PurePosixPath
from posixpath import normpath

from plastron_tui.model.packages import BUILT_FOLDER
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.package_keys import PROPRIETARY, find_license, find_own_license, licenses
from plastron_tui.targets.templates import render_template

from .built import PLUGINS_FILE, built_nodes, found_packages
from .checks import check_package, is_refused
from .dependencies import Dependency, dependencies_of, needs_of_definitions
from .literals import python_argument, python_string
from .manifest import package_xml
from .plugins import has_plugins, plugin_name, plugins_xml
from .smoke_tests import expected_of
from .spec import (
    BuildType,
    PackagedNode,
    PackageFile,
    PackageSpec,
    RenderedPackage,
    interfaces_name,
)

URDF_FOLDER = "urdf"
"""Where packages have the descriptions of robots (ROS wiki, "urdf/Tutorials")."""

_WITH_TYPES = "rosidl_interface_packages"
"""The group of the packages of ROS 2 that build types (REP 149; rosidl_default_generators)."""

_CONSOLE_MAIN = "main"
"""The function of a node's file that starts it; rclpy's and rospy's templates have it."""

# Licenses of which the text is not among the templates are told of in README.md.
_WITH_TEXT = frozenset(
    {
        "0BSD", "Apache-2.0", "BSD-2-Clause", "BSD-3-Clause", "BSL-1.0", "ISC", "MIT", "MIT-0",
    }
)  # fmt: skip


def render_package(spec: PackageSpec) -> RenderedPackage:
    """Write the files of a package; paths are below the package's folder, with slashes.

    The types of a ROS 2 package are in the package that `interfaces_of` says.
    """
    if spec.ros_version == 2 and not spec.builds_types:
        spec = replace(spec, definitions=())
    problems = check_package(spec)
    if is_refused(problems):
        return RenderedPackage(None, problems)
    dependencies, unknown = dependencies_of(spec)
    build = spec.builds
    files = {
        "package.xml": package_xml(spec, dependencies, [_WITH_TYPES] if spec.builds_types else ()),
        **({} if spec.is_bare else _about(spec)),
        **{f"launch/{each.name}": each.text for each in spec.launches},
        **{f"config/{each.name}": each.text for each in spec.configs},
        **{f"{URDF_FOLDER}/{each.name}": each.text for each in spec.robots},
    }
    if build is BuildType.AMENT_PYTHON:
        files |= {
            "setup.py": _filled(spec, "ament_python/setup.py.j2"),
            "setup.cfg": _filled(spec, "ament_python/setup.cfg.j2"),
            f"resource/{spec.name}": b"",
        }
    elif build is BuildType.CATKIN:
        files["CMakeLists.txt"] = _filled(spec, "catkin/CMakeLists.txt.j2")
        if has_plugins(spec):
            files[PLUGINS_FILE] = plugins_xml(spec)
        files |= {each.path: each.text for each in spec.definitions}
    else:
        files["CMakeLists.txt"] = _filled(spec, "ament_cmake/CMakeLists.txt.j2")
        files |= {each.path: each.text for each in spec.definitions}
    if build in (BuildType.AMENT_PYTHON, BuildType.AMENT_CMAKE_PYTHON):
        files[f"{spec.modules}/__init__.py"] = b""
    if not spec.is_bare:
        files |= _tests(spec)
    rendered = {path: PackageFile(text) for path, text in files.items()}
    for node in spec.nodes:
        path = node_path(spec, node)
        rendered[path] = PackageFile(node.text, node.language.is_executable)
        for other, (_, text) in zip(node_paths(spec, node)[1:], node.others, strict=True):
            rendered[other] = PackageFile(text)
    return RenderedPackage(dict(sorted(rendered.items())), (*problems, *unknown))


def node_path(spec: PackageSpec, node: PackagedNode) -> str:
    """Return where the file of a node stands in its package."""
    folder = BUILT_FOLDER if node.is_built else spec.modules
    return str(PurePosixPath(folder, node.file))


def node_paths(spec: PackageSpec, node: PackagedNode) -> tuple[str, ...]:
    """Return where all files of a node stand in its package, the one of `node_path` first."""
    path = node_path(spec, node)
    folder = PurePosixPath(path).parent
    return (path, *(normpath(f"{folder}/{name}") for name, _ in node.others))


def interfaces_of(spec: PackageSpec) -> PackageSpec | None:
    """Return the package with the types of a ROS 2 package, None where it needs none."""
    if spec.ros_version == 1 or spec.builds_types or not spec.definitions:
        return None
    return replace(
        spec,
        name=interfaces_name(spec.name),
        description=f"Interface types of {spec.name}",
        nodes=(),
        launches=(),
        configs=(),
        robots=(),
        build_type=BuildType.AMENT_CMAKE,
    )


def render_interfaces(spec: PackageSpec) -> RenderedPackage:
    """Write the files of a ROS 2 package that has types and nothing else.

    Source: the ROS 2 tutorial "Creating custom msg and srv files", and rosidl_default_generators.
    """
    problems = check_package(spec)
    if is_refused(problems):
        return RenderedPackage(None, problems)
    needed = sorted(needs_of_definitions(spec))
    dependencies = [
        Dependency("buildtool_depend", "ament_cmake"),
        Dependency("buildtool_depend", "rosidl_default_generators"),
        *(Dependency("depend", package) for package in needed),
        Dependency("exec_depend", "rosidl_default_runtime"),
        Dependency("test_depend", "ament_cmake_lint_cmake"),
        Dependency("test_depend", "ament_cmake_xmllint"),
        Dependency("test_depend", "ament_lint_auto"),
    ]
    values = {
        "name": spec.name,
        "needed": needed,
        "definitions": sorted(each.path for each in spec.definitions),
    }
    files = {
        "package.xml": package_xml(spec, dependencies, [_WITH_TYPES]),
        "CMakeLists.txt": _render("interfaces/CMakeLists.txt.j2", values),
        **_about(spec),
        **{each.path: each.text for each in spec.definitions},
    }
    rendered = {path: PackageFile(text) for path, text in sorted(files.items())}
    return RenderedPackage(rendered, problems)


def _about(spec: PackageSpec) -> dict[str, bytes]:
    """Return the README and, where its text is known, the license."""
    identifier = find_license(spec.licensed)
    has_text = identifier in _WITH_TEXT
    values = {
        "name": spec.name,
        "summary": spec.summary,
        "nodes": [
            {"started": _started(spec, each), "name": each.node.name, "entries": _entries(each)}
            for each in spec.nodes
        ],
        "launches": [each.name for each in spec.launches],
        "definitions": [each.path for each in spec.definitions],
        "robots": [f"{URDF_FOLDER}/{each.name}" for each in spec.robots],
        "launch": "roslaunch" if spec.ros_version == 1 else "ros2 launch",
        "build": "catkin_make"
        if spec.ros_version == 1
        else f"colcon build --packages-up-to {spec.name}",
        "setup": "devel/setup.bash" if spec.ros_version == 1 else "install/setup.bash",
        "license": None if identifier is None else licenses()[identifier],
        "identifier": identifier,
        "own": None if spec.license is None else find_own_license(spec.license),
        "has_text": has_text,
    }
    files = {"README.md": _render("README.md.j2", values)}
    if spec.license == PROPRIETARY:
        text = _render(f"licenses/{PROPRIETARY}.j2", {"holder": spec.person.name})
        files["LICENSE"] = text
    if identifier is not None and has_text:
        files["LICENSE"] = _render(f"licenses/{identifier}.j2", {"holder": spec.person.name})
    return files


def _started(spec: PackageSpec, node: PackagedNode) -> str:
    if spec.ros_version == 2:
        return f"ros2 run {spec.name} {node.executable}"
    if node.plugin is not None:
        return f"rosrun nodelet nodelet standalone {plugin_name(spec, node)}"
    return f"rosrun {spec.name} {node.executable if node.is_built else node.file}"


def _entries(node: PackagedNode) -> list[str]:
    entries = []
    for (kind, name), endpoint in node.node.endpoints.items():
        if endpoint.type is not None:
            entries.append(f"{kind.word} `{name}` of `{endpoint.type}`")
    return entries


def _filled(spec: PackageSpec, template: str) -> bytes:
    """Return a file that says how a package is built."""
    folders = [
        *(["launch"] if spec.launches else []),
        *(["config"] if spec.configs else []),
        *([URDF_FOLDER] if spec.robots else []),
    ]
    data = sorted(spec.data)

    def of(kind: InterfaceKind) -> list[str]:
        return [PurePosixPath(each.path).name for each in spec.definitions if each.kind is kind]

    values = {
        "name": spec.name,
        "version": spec.version,
        "scripts": [
            {
                "executable": each.executable,
                "module": each.module,
                "path": node_path(spec, each),
            }
            for each in spec.scripts
        ],
        "tested": _tested(spec),
        "folders": list(dict.fromkeys((*folders, *(each.partition("/")[0] for each in data)))),
        "data": [each for each in data if each not in folders],
        "main": _CONSOLE_MAIN,
        "maintainer": python_argument("maintainer", spec.person.name, 4),
        "maintainer_email": python_argument("maintainer_email", spec.person.mail, 4),
        "description": python_argument("description", spec.summary, 4),
        "license": python_string(spec.licensed),
        "launches": sorted(spec.launches),
        "configs": bool(spec.configs),
        "robots": bool(spec.robots),
        "messages": of(InterfaceKind.MESSAGE),
        "services": of(InterfaceKind.SERVICE),
        "actions": of(InterfaceKind.ACTION),
        "definitions": sorted(each.path for each in spec.definitions),
        "has_tests": not spec.is_bare,
        **_built_values(spec),
        "modules": spec.modules,
        "with_python": spec.builds is BuildType.AMENT_CMAKE_PYTHON,
    }
    return _render(template, values)


def _built_values(spec: PackageSpec) -> dict[str, object]:
    """Return what a CMakeLists.txt is filled with: of nodes that are built, and of definitions."""
    built = built_nodes(spec)
    by_target = sorted(built, key=lambda each: each.target)
    plugins = [each for each in by_target if each.plugin is not None]
    needed = sorted(needs_of_definitions(spec)) if spec.definitions else []
    found = {*needed, *found_packages(spec)}
    has_types = spec.ros_version == 1 and spec.definitions
    return {
        "needed": needed,
        "components": sorted(found | {"message_generation"} if has_types else found),
        "exported": sorted(found | {"message_runtime"} if has_types else found),
        "built": built,
        "programs": [each for each in by_target if each.plugin is None],
        "plugins": plugins,
        "plugin_packages": sorted({name for each in plugins for name in each.packages}),
        "plugins_file": PLUGINS_FILE,
        "has_headers": any(each.has_header for each in built),
        "exports_headers": any(each.installs_header for each in plugins),
    }


def _tests(spec: PackageSpec) -> dict[str, bytes]:
    """Return the tests of a package: of its nodes, and in ROS 2 of its style."""
    files: dict[str, bytes] = {}
    shared = {
        "package": spec.name,
        "has_localhost_only": spec.for_distribution in ("foxy", "galactic", "humble"),
        "is_managed": any(each.node.is_managed for each in spec.nodes),
        "has_scripts": bool(spec.scripts),
        "has_programs": bool(spec.built),
    }
    folder = "ros1" if spec.ros_version == 1 else "ros2"
    if spec.nodes:
        files["test/conftest.py"] = _render(f"tests/{folder}_conftest.py.j2", shared)
    for node in spec.nodes:
        values = shared | {
            "node": python_string(node.node.name),
            "label": node.node.name,
            "test": _test_of(node),
            "running": _running(spec, node),
            "is_managed": node.node.is_managed,
            "expected": [
                ", ".join(python_string(part) for part in each if part)
                for each in expected_of(node.node, spec.ros_version)
            ],
        }
        files[f"test/test_{_test_of(node)}.py"] = _render(f"tests/{folder}_node.py.j2", values)
    if spec.builds is BuildType.AMENT_PYTHON:
        for name in ("flake8", "pep257"):
            files[f"test/test_{name}.py"] = _render(f"tests/{name}.py.j2", {})
    return files


def _tested(spec: PackageSpec) -> list[dict[str, str | None]]:
    """Return the tests of the nodes, and the target that has to be built before each."""
    targets = {each.node.module: each.target for each in built_nodes(spec)}
    return [
        {"test": _test_of(each), "target": targets.get(each.module) if each.is_built else None}
        for each in spec.nodes
    ]


def _running(spec: PackageSpec, node: PackagedNode) -> str:
    """Return the call of the fixture that starts a node."""
    if not node.is_built:
        is_file = spec.ros_version == 1
        started = node_path(spec, node) if is_file else f"{spec.modules}.{node.module}"
        return f"running({python_string(started)})"
    words = [spec.name, node.executable]
    if node.plugin is not None and spec.ros_version == 1:
        named = f"__name:={node.node.name}"
        words = ["nodelet", "nodelet", "standalone", plugin_name(spec, node), named]
    return f"running_program({', '.join(map(python_string, words))})"


def _test_of(node: PackagedNode) -> str:
    """Return what the test of a node is called; no linter's, `flake8` say, is called so."""
    return f"{node.module}_node"


def _render(name: str, values: Mapping[str, object]) -> bytes:
    return render_template(("package",), None, name, values).encode()
