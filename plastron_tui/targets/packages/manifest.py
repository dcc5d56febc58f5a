"""The `package.xml` of a package (REP 149)."""

from __future__ import annotations

from collections.abc import Sequence
from xml.sax.saxutils import escape, quoteattr

from .built import PLUGINS_FILE
from .dependencies import Dependency
from .plugins import NODELET, has_plugins
from .spec import BuildType, PackageSpec

_HEAD = """\
<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" \
schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
"""


def package_xml(
    spec: PackageSpec, dependencies: Sequence[Dependency], groups: Sequence[str] = ()
) -> bytes:
    """Return the text of a `package.xml`.

    Args:
        spec: the package.
        dependencies: what it depends on; a blank line stands between tags of different names.
        groups: the groups that it is a member of.
    """
    person = spec.person
    lines = [
        f"<name>{spec.name}</name>",
        f"<version>{spec.version}</version>",
        f"<description>{escape(spec.summary)}</description>",
        f"<maintainer email={quoteattr(person.mail)}>{escape(person.name)}</maintainer>",
        f"<license>{escape(spec.licensed)}</license>",
    ]
    last = ""
    for tag, key in dependencies:
        if tag != last:
            lines.append("")
        lines.append(f"<{tag}>{key}</{tag}>")
        last = tag
    if groups:
        lines += ["", *(f"<member_of_group>{group}</member_of_group>" for group in groups)]
    if spec.ros_version == 2:
        built = "ament_python" if spec.builds is BuildType.AMENT_PYTHON else "ament_cmake"
        lines += ["", "<export>", f"  <build_type>{built}</build_type>", "</export>"]
    elif has_plugins(spec):
        plugin = f'  <{NODELET} plugin="${{prefix}}/{PLUGINS_FILE}"/>'
        lines += ["", "<export>", plugin, "</export>"]
    body = "".join(f"  {line}\n" if line else "\n" for line in lines)
    return f"{_HEAD}{body}</package>\n".encode()
