"""Packages of one name: `colcon` and `catkin` refuse to build a workspace that has several."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Label, codes
from plastron_tui.lint.tree import PackageFacts

_IGNORING = {1: "CATKIN_IGNORE", 2: "COLCON_IGNORE"}


def by_name(packages: Iterable[PackageFacts]) -> dict[str, PackageFacts]:
    """Return packages by their names: of several one that is built, and of these the last."""
    return {each.name: each for each in sorted(packages, key=lambda each: each.build is not None)}


def namesakes_of(
    packages: Iterable[PackageFacts],
) -> dict[str, Mapping[Path, PackageFacts]]:
    """Return the packages whose name another one has, too, by their folders."""
    found: dict[str, dict[Path, PackageFacts]] = {}
    for each in packages:
        found.setdefault(each.name, {})[each.folder] = each
    return {name: several for name, several in found.items() if len(several) > 1}


def same_names(packages: Iterable[PackageFacts], root: Path) -> Iterator[Diagnostic]:
    """Yield the packages that have the name of another one of their workspace.

    `catkin` builds what is below a folder `src`, `colcon` also what is beside it. Several such
    folders are several workspaces, and nobody builds for both generations of ROS at once.
    """
    built = [each for each in packages if each.build is not None]
    workspaces = {_workspace(each.folder, root) for each in built}
    has_src, has_several = workspaces != {None}, len(workspaces - {None}) > 1
    found: dict[tuple[object, ...], list[PackageFacts]] = defaultdict(list)
    for each in built:
        is_below_src = has_several or (has_src and 1 in each.ros_versions)
        workspace = _workspace(each.folder, root) if is_below_src else root
        if workspace is not None:
            found[each.name, each.ros_versions, workspace].append(each)
    for first, *others in found.values():
        for each in others:
            assert first.build is not None and each.build is not None
            yield Diagnostic(
                codes.PACKAGE_EXISTS,
                f"two packages of this workspace are called `{each.name}`",
                each.build.name_span,
                each.folder / "package.xml",
                help="rename one, or put a file `"
                + _IGNORING[each.ros_versions[0]]
                + "` into the folder that is not to be built",
                labels=(Label(first.build.name_span, "the other", first.folder / "package.xml"),),
            )


def _workspace(folder: Path, root: Path) -> Path | None:
    """Return the folder `src` below a root that a package is in, None where it is in none."""
    above = [each for each in folder.parents if each.is_relative_to(root)]
    return next((each for each in reversed(above) if each.name == "src"), None)
