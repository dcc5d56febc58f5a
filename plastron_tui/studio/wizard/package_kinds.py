"""Packages: their names, what they say of themselves, what they contain."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.language import SlotKind
from plastron_tui.model.packages import Package
from plastron_tui.ros.names import mended_node_name

from ..folder_files import found_files, path_text
from .ask import Ask, Choice
from .context import free_name
from .kind import OF_THE_LIST, Kind
from .parameter_kinds import TextKind
from .trials import closed_by, first_that_works

_LICENSES = (
    ("Apache-2.0", "as ROS 2 itself: use, change and sell it, with the notices"),
    ("BSD-3-Clause", "as most of ROS 1: nearly everything, with the notices"),
    ("MIT", "short, and nearly everything, with the notice"),
    ("GPL-3.0-only", "who passes it on passes on the sources, under the same license"),
    ("LGPL-3.0-only", "as that, but other programs may use it"),
    ("MPL-2.0", "changed files stay open, others need not"),
    ("BSL-1.0", "as MIT, without the notice in what is built"),
    ("CC0-1.0", "everything, without conditions"),
    ("Proprietary", "closed code: all rights reserved"),
)
"""Licenses that packages of ROS have most often, by their SPDX names, and closed code."""


class PackageNameKind(Kind):
    """The name of a new package."""

    def suggest(self, ask: Ask) -> str:
        """Return what the program is called, or a word for a robot's software."""
        path = ask.scene.session.path
        stem = "" if path is None else (mended_node_name(path.stem, 2) or path.stem).lower()
        taken = {each.name for each in ask.scene.workspace.packages.values()}
        is_name = len(stem) > 1 and stem.isascii() and stem.isidentifier()
        return free_name(stem if is_name else "my_robot", taken)

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not text:
            return "a package needs a name, such as `my_robot`"
        if any(each.name == text for each in ask.scene.workspace.packages.values()):
            return f"a package is called `{text}` already: choose another name"
        return None


class PackageKind(Kind):
    """A package of the program."""

    def suggest(self, ask: Ask) -> str:
        """Return the last one for which the statement makes sense."""
        names = list(reversed(ask.scene.workspace.packages))
        if ask.form.declaration.writes_file:
            written = {each.package.variable for each in ask.scene.workspace.written_packages}
            names.sort(key=lambda name: name in written)
        return first_that_works(ask, names) or next(iter(names), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all, the last one first."""
        packages = ask.scene.workspace.packages
        names = list(reversed(packages))
        reasons = closed_by(ask, names)
        return [Choice(name, packages[name].name, closed=reasons.get(name, "")) for name in names]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not ask.scene.workspace.packages:
            return "there is no package yet: make one first"
        return None if text in ask.scene.workspace.packages else f"no such package: {OF_THE_LIST}"


class PackageFolderKind(Kind):
    """The folder of a package that exists."""

    def suggest(self, ask: Ask) -> str:
        """Return the first that is found."""
        return next((each.text for each in self.choices(ask, "")), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the folders with a package.xml below the program's folder."""
        folder = ask.scene.session.folder

        def find() -> tuple[Path, ...]:
            return found_files({".xml"}, folder, lambda name: name == "package.xml")

        found = ask.scene.surroundings.once("packages", find)
        return [Choice(path_text(path.parent, folder)) for path in found]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text else "no package is beside the program: write the path of its folder"


class MaintainerKind(TextKind):
    """Who looks after a package."""

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text is no name with an address."""
        name, opening, mail = text.rstrip().partition("<")
        if name.strip() and opening and mail.endswith(">") and "@" in mail[1:-2]:
            return None
        return "it is a name and an address, such as `Ann <ann@example.org>`"


class LicenseKind(TextKind):
    """The license of a package."""

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return those that most packages have."""
        return [Choice(name, "", about) for name, about in _LICENSES]


class ItemKind(Kind):
    """A node, a launch file or a robot that a package is to contain."""

    def suggest(self, ask: Ask) -> str:
        """Return the first that no package contains."""
        names = _items(ask)
        return first_that_works(ask, names) or next(iter(names), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return the nodes, launch files and robots, and close those that have a place."""
        names = _items(ask)
        reasons = closed_by(ask, names)
        workspace = ask.scene.workspace
        return [
            Choice(name, f"a {what[0]}", closed=reasons.get(name, ""))
            for name in names
            if (what := workspace.what(name)) is not None
        ]

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        if not _items(ask):
            return "there is no node yet: make one first"
        if text in _items(ask):
            return None
        return f"no node, launch file or robot: {OF_THE_LIST}"


def _items(ask: Ask) -> list[str]:
    workspace = ask.scene.workspace
    held = {name for each in workspace.packages.values() for name in each.contents}
    names = [*workspace.nodes, *workspace.launches, *workspace.robots]
    return sorted(names, key=lambda name: name in held)


class HeldKind(Kind):
    """What a package contains; what the program did not put there is in quotes."""

    def suggest(self, ask: Ask) -> str:
        """Return the last one."""
        return next((each.text for each in reversed(self.choices(ask, ""))), "")

    def choices(self, ask: Ask, query: str) -> list[Choice]:
        """Return all."""
        package = _package(ask)
        if package is None:
            return []
        there = () if package.source is None else package.source.executables
        return [*map(Choice, package.contents), *map(Choice, there)]

    def written(self, ask: Ask, text: str) -> str:
        """Return it as the program has it."""
        package = _package(ask)
        is_variable = package is not None and text in package.contents
        return text if is_variable else f"'{text}'"

    def problem(self, ask: Ask, text: str) -> str | None:
        """Tell why a text cannot stand there."""
        return None if text else "the package contains nothing that could be taken out"


def _package(ask: Ask) -> Package | None:
    return ask.scene.workspace.packages.get(ask.text(SlotKind.PACKAGE))
