"""Nodelets in a manager, components in a container; with the stand-in, as programs."""

from __future__ import annotations

import os
import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

from cpp_builds import STAND_IN, CppLibrary
from cpp_corpus import PACKAGE, Built, generate, program_with, written
from cpp_nodes import MANAGER, CppGraph, CppProcess, plugin_environ

_CONTAINER = Path("lib/rclcpp_components/component_container")
_INDEX = Path("share/ament_index/resource_index/rclcpp_components") / PACKAGE
_PLUGIN = "{}_plugin"


def load_nodelet(graph: CppGraph, built: Built, node: str) -> CppProcess:
    """Load a node into a manager of its own, `NODE_manager`, and return the manager's process."""
    plugins = ElementTree.parse(built.package / "nodelet_plugins.xml").getroot().iter("class")
    class_ = _class(node, [each.attrib["name"] for each in plugins])
    env = {**graph.env, **graph.program_env, **plugin_environ(built.package, built.prefix)}
    manager, *_ = [
        _started(replace(graph, env=env), name, *arguments)
        for name, arguments in (
            ("manager", ("manager", f"__name:={node}_manager")),
            ("load", ("load", class_, f"{node}_manager", "--no-bond", f"__name:={node}")),
        )
    ]
    return manager


def _started(graph: CppGraph, name: str, *arguments: str) -> CppProcess:
    process = CppProcess([MANAGER, *arguments], graph.env, graph.folder / f"{name}.log")
    graph.started.append(process)
    return process


def load_component(graph: CppGraph, built: Built, node: str) -> CppProcess:
    """Load a node into a container, and return the container's process."""
    assert built.library is not None
    index = (built.prefix / _INDEX).read_text(encoding="utf-8")
    class_ = _class(node, [line.partition(";")[0] for line in index.splitlines()])
    [container, *_] = [
        prefix / _CONTAINER for prefix in built.library.prefixes if (prefix / _CONTAINER).is_file()
    ]
    before = built.library.environ["LD_LIBRARY_PATH"]
    there = graph.env.get("AMENT_PREFIX_PATH", "")
    environ = {
        "LD_LIBRARY_PATH": os.pathsep.join([str(built.prefix / "lib"), before]),
        "AMENT_PREFIX_PATH": os.pathsep.join([str(built.prefix), there]),
    }
    process = replace(graph, program_env=environ).run(container)
    # The service of a container is of a package that is where rclcpp is.
    modules = [
        str(folder)
        for prefix in built.library.prefixes
        for folder in prefix.glob("lib/python3*/site-packages")
        if (folder / "composition_interfaces").is_dir()
    ]
    path = os.pathsep.join([*modules, graph.env.get("PYTHONPATH", "")])
    loader = replace(graph, env={**graph.env, **environ, "PYTHONPATH": path})
    assert loader.load_component("ComponentManager", PACKAGE, class_, node) == f"/{node}"
    return process


def component_program(node: str, folder: Path, rclcpp: CppLibrary) -> Path:
    """Compile a component with the stand-in, which makes a program of its class."""
    package = folder / PACKAGE
    text = program_with(node).read_text(encoding="utf-8")
    generate(written(text, "component"), package)
    [source] = (package / "src").glob(f"{node}_*.cpp")
    headers = (package / "include", STAND_IN / "components")
    return rclcpp.compile(folder / f"{node}_component", source, headers=headers)


def _class(node: str, classes: list[str]) -> str:
    """Return the class of a node that is a plugin."""
    wanted = re.sub("_", "", _PLUGIN.format(node)) + "node"
    [found] = [each for each in classes if re.split("::|/", each)[-1].lower() == wanted]
    return found
