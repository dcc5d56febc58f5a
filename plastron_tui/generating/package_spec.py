"""From a package of a program to what its files follow from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING

from plastron_tui.model.workspace import Node
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.package_keys import find_license, find_own_license
from plastron_tui.ros.packages import parse_maintainer
from plastron_tui.targets.packages.spec import PackagedNode, PackageSpec

if TYPE_CHECKING:
    from plastron_tui.diagnostics import Span
    from plastron_tui.model.packages import Package

    from .apply_changes import Library
    from .generation import Generated


def packaged_node(
    executable: str, generated: Generated, libraries: Mapping[str, Library], span: Span
) -> PackagedNode:
    """Return a node as a package has it, by the files that are made for it.

    Args:
        executable: what one starts it by.
        generated: its files.
        libraries: the client libraries, by name.
        span: the statement that puts it into the package.
    """
    assert generated.files is not None, "it can be written"
    (_, main), *others = generated.files.files.texts
    name, library = PurePath(generated.files.name), generated.generation.library
    stem = name.stem
    target, node = libraries[library].target, generated.generation.node
    return PackagedNode(
        executable,
        stem,
        main,
        node,
        target.language,
        library,
        span,
        tuple((each.replace("{}", stem), text) for each, text in others),
        target.plugin_class(node),
        name.suffix if target.language.is_built else "",
    )


def package_spec(
    package: Package,
    made: Sequence[Generated],
    libraries: Mapping[str, Library],
    default: Library,
) -> PackageSpec | None:
    """Return what a created package holds, None where one of its nodes cannot be written.

    A node counts with the text that its file gets, handwork and all: what is imported there is
    what the package depends on.

    Args:
        package: the package.
        made: the files of the nodes that the program generates.
        libraries: the client libraries, by name.
        default: the client library of a package without nodes.
    """
    by_variable = {each.generation.node.variable: each for each in made}
    nodes = []
    for variable, contained in package.contents.items():
        if not isinstance(contained.item, Node):
            continue
        generated = by_variable.get(variable)
        if generated is None or generated.files is None or generated.files.files.main is None:
            return None
        nodes.append(packaged_node(contained.name, generated, libraries, contained.span))
    first = libraries[nodes[0].library] if nodes else default
    maintainer, _ = parse_maintainer(package.maintainer)
    catalog = first.catalog
    return PackageSpec(
        package.name,
        first.target.ros_version,
        package.description,
        maintainer,
        find_license(package.license) or find_own_license(package.license) or None,
        distribution=catalog.distribution,
        nodes=tuple(nodes),
        packages=frozenset(each for kind in InterfaceKind for each in catalog.packages(kind)),
        span=package.span,
    )
