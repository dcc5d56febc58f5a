"""Nodes that have to be built, in a package that the output folder is, or is in.

Its CMakeLists.txt and package.xml get what they lack, and nothing new is begun.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, codes, has_errors
from plastron_tui.model.package_source import PackageSource
from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.interfaces import InterfaceKind

from .loaded_nodes import with_node
from .package_spec import packaged_node
from .text_files import changed_files

if TYPE_CHECKING:
    from .apply_changes import Library
    from .generation import Generated

_COMPILING = ("catkin", "ament_cmake")


def package_files_around(
    source: PackageSource,
    made: Sequence[Generated],
    libraries: Mapping[str, Library],
    output: Path,
) -> tuple[list[OutputFile], list[Diagnostic]]:
    """Return the files of a package that change for the nodes in it; none where one is refused.

    Args:
        source: the package.
        made: the files of the nodes that the program generates.
        libraries: the client libraries, by name.
        output: the output folder.
    """
    texts: dict[str, bytes] = dict(source.texts)
    found: list[Diagnostic] = []
    for each in made:
        home, span = each.generation.node.home, each.generation.span
        if home is None or home.above is None or each.files is None:
            continue
        refused = _refused(source, each, libraries)
        if refused is not None:
            found.append(refused)
            continue
        file = os.path.relpath(output / each.files.name, source.folder).replace(os.sep, "/")
        node = packaged_node(PurePath(file).stem, each, libraries, span)
        catalog = libraries[node.library].catalog
        known = frozenset(name for kind in InterfaceKind for name in catalog.packages(kind))
        changed, unknown = with_node(source, texts, node, file, known)
        told = (*changed.diagnostics, *unknown)
        found += (x if x.file or x.span else x._replace(span=span) for x in told)
        texts = texts if changed.texts is None else changed.texts
    if has_errors(found):
        return [], found
    return changed_files(source, texts), found


def _refused(
    source: PackageSource, generated: Generated, libraries: Mapping[str, Library]
) -> Diagnostic | None:
    """Say why a package cannot have a node, None where it can."""
    node, span = generated.generation.node, generated.generation.span
    version = libraries[generated.generation.library].target.ros_version
    help_ = "name another output folder with `-o`"
    if version != source.ros_version:
        message = (
            f"the output folder is in the package `{source.name}`, which is for ROS "
            f"{source.ros_version}, and `{node.variable}` is a node for ROS {version}"
        )
        return Diagnostic(codes.OTHER_ROS, message, span, help=help_)
    if source.build_type not in _COMPILING:
        message = (
            f"the output folder is in the package `{source.name}` of `{source.build_type}`, which "
            "compiles nothing"
        )
        return Diagnostic(codes.EDIT_REFUSED, message, span, help=help_)
    return None
