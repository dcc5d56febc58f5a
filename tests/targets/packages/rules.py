"""Rules of packages, each of which says where it is from, and a reader that breaks none of them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

# REP 149, "Data structure" and "Dependency tags": what a package.xml of format 3 may hold.
_ONE = ("name", "version", "description")
_SOME = ("maintainer", "license")
_DEPENDENCIES = {
    "buildtool_depend", "buildtool_export_depend", "build_depend", "build_export_depend",
    "exec_depend", "depend", "doc_depend", "test_depend", "conflict", "replace",
    "group_depend", "member_of_group",
}  # fmt: skip
_OTHER = {"url", "author", "export"}


def broken_rules(folder: Path) -> list[str]:
    """Return the rules that a package breaks; none is empty."""
    return [*_manifest(folder), *_files(folder)]


def _manifest(folder: Path) -> Iterator[str]:
    text = (folder / "package.xml").read_bytes()
    root = ElementTree.fromstring(text)
    if not text.startswith(b'<?xml version="1.0"?>\n<?xml-model '):
        yield "REP 149 shows the schema in a line of its own"
    if root.tag != "package" or root.get("format") != "3":
        yield "REP 149: the root is <package format='3'>"
    tags = [child.tag for child in root]
    if any(tags.count(tag) != 1 for tag in _ONE):
        yield "REP 149: one name, version and description"
    if any(tag not in tags for tag in _SOME):
        yield "REP 149: a maintainer and a license"
    if set(tags) - {*_ONE, *_SOME} - _DEPENDENCIES - _OTHER:
        yield "REP 149: no other tags"
    if any("@" not in (each.get("email") or "") for each in root.findall("maintainer")):
        yield "REP 149: a maintainer has an address"
    depends = [(child.tag, child.text) for child in root if child.tag in _DEPENDENCIES]
    if len(set(depends)) != len(depends):
        yield "a dependency stands once"
    twice = {key for tag, key in depends if tag == "depend"}
    if any(key in twice for tag, key in depends if tag in ("exec_depend", "build_depend")):
        yield "REP 149: depend is build_depend, build_export_depend and exec_depend"
    if root.findtext("name") in {key for _, key in depends}:
        yield "catkin_pkg: a package does not depend on itself"
    is_interfaces = "rosidl_interface_packages" in {
        each.text for each in root.findall("member_of_group")
    }
    if is_interfaces and ("exec_depend", "rosidl_default_runtime") not in depends:
        yield "tutorial 'Creating custom msg and srv files': rosidl_default_runtime"


def _files(folder: Path) -> Iterator[str]:
    root = ElementTree.fromstring((folder / "package.xml").read_bytes())
    name = root.findtext("name") or ""
    built = root.findtext("export/build_type") or "catkin"
    if built == "ament_python":
        yield from _ament_python(folder, name)
    elif not (folder / "CMakeLists.txt").is_file():
        yield "the wiki page 'catkin/CMakeLists.txt': CMake builds the package"
    for path in folder.glob("**/*"):
        if path.is_file():
            text = path.read_bytes()
            if b"\r" in text or (text and not text.endswith(b"\n")) or b" \n" in text:
                yield f"{path.name}: lines end in one newline, and in no blank"
            if path.suffix == ".py":
                ast.parse(text)
    for script in folder.glob("scripts/*"):
        if not script.stat().st_mode & 0o111:
            yield "the wiki page 'rospy_tutorials': scripts are executable"


def _ament_python(folder: Path, name: str) -> Iterator[str]:
    if not (folder / "resource" / name).is_file():
        yield "design page 'ament_resource_index': a marker of the package's name"
    if not (folder / name / "__init__.py").is_file():
        yield "ROS 2 guide 'Developing a ROS 2 package': a module of the package's name"
    settings = (folder / "setup.cfg").read_text(encoding="utf-8")
    if f"install_scripts=$base/lib/{name}\n" not in settings:
        yield "ROS 2 guide 'Developing a ROS 2 package': executables are in lib/NAME"
    setup = next(
        node
        for node in ast.walk(ast.parse((folder / "setup.py").read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "setup"
    )
    told = {each.arg: ast.unparse(each.value) for each in setup.keywords}
    root = ElementTree.fromstring((folder / "package.xml").read_bytes())
    for keyword, tag in {"version": "version", "description": "description"}.items():
        if ast.literal_eval(told[keyword]) != root.findtext(tag):
            yield f"colcon compares the {keyword} of setup.py with package.xml"
    for kind in "launch", "config":
        if (folder / kind).is_dir() and f"/{kind}" not in told["data_files"]:
            yield "ROS 2 guide 'Integrating launch files into ROS 2 packages': data_files"
