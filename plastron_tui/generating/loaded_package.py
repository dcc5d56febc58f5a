"""The files of a package that exists, as a program changes it.

A package is changed from what its files hold when the program runs, each time anew: what is there
already is not added again, and what is not there is not taken out. So no layers are remembered.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.diagnostics.severity import Severity
from plastron_tui.model.launches import Launch
from plastron_tui.model.workspace import Node
from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.ros.launch_names import launch_stem
from plastron_tui.sources.packages import (
    PACKAGE_XML,
    Changed,
    Needs,
    add_definition,
    add_launch,
    finds_scripts,
    named_elsewhere,
    remove_built_node,
    remove_executable,
    remove_launch,
    staying,
)
from plastron_tui.targets.packages.dependencies import needs_of_definitions
from plastron_tui.targets.packages.rendering import URDF_FOLDER
from plastron_tui.targets.packages.spec import PackagedLaunch, PackageSpec

from .built_in_place import Memory, loaded_from, remember, remembered, with_needs
from .loaded_memory import DEPENDS, FOUND, INSTALLED, TAGS, FileMemory
from .loaded_needs import known_packages, needs_in
from .loaded_nodes import with_node
from .loaded_notes import file_stays, script_elsewhere
from .own_definitions import own_definitions
from .package_parts import PackagedRobot, Parts, is_within, name_within
from .package_spec import packaged_node
from .renamed_nodes import renamed_nodes

if TYPE_CHECKING:
    from plastron_tui.model.own_types import OwnType
    from plastron_tui.model.package_source import PackageSource
    from plastron_tui.model.packages import Contained, Package
    from plastron_tui.output.manifest import Manifest

    from .apply_changes import Library
    from .generation import Generated


_LAUNCH = "launch"
_DEFINITIONS = tuple(f".{each.value}" for each in InterfaceKind)
_NO_PARTS = Parts()
_MOST_TOLD = 3


class LoadedFiles(NamedTuple):
    """The files that a program changes in a loaded package, or none with the reason.

    Attributes:
        files: those that are written; empty where something is refused.
        nodes: the names of node files that `files` has in place of the nodes' own.
        diagnostics: what there is to say.
    """

    files: tuple[OutputFile, ...]
    nodes: frozenset[str] = frozenset()
    diagnostics: tuple[Diagnostic, ...] = ()


def loaded_package_files(
    package: Package,
    made: Sequence[Generated],
    libraries: Mapping[str, Library],
    output: Path,
    manifest: Manifest,
    parts: Parts = _NO_PARTS,
    types: Iterable[OwnType] = (),
    *,
    in_place: bool,
) -> LoadedFiles:
    """Change a loaded package; nothing of it is written where a part is refused.

    Args:
        package: the package, which was loaded.
        made: the files of the nodes that the program generates.
        libraries: the client libraries, by name.
        output: the output folder, which gets the changed and the new files.
        manifest: what is remembered of its files.
        parts: the launch files and the robots that it contains.
        types: the types that the program makes for it.
        in_place: whether they are written where the package is instead.
    """
    source = package.source
    assert source is not None, "the package was loaded"
    memory = FileMemory(source, output, manifest, in_place)
    work = _Change(package, source, libraries, output, memory, dict(source.texts))
    work.take_out(renamed_nodes(package, made, output, manifest) if in_place else {})
    work.take_out_launches()
    for own in types:
        work.put_type(own)
    by_variable = {each.generation.node.variable: each for each in made}
    for variable, contained in package.contents.items():
        generated = by_variable.get(variable)
        if isinstance(contained.item, Node) and generated is not None:
            work.put(contained, generated)
        elif isinstance(contained.item, Launch) and variable in parts.launches:
            work.put_launch(contained, contained.item, parts.launches[variable])
        elif variable in parts.robots:
            work.put_robot(parts.robots[variable])
    work.put_needs([each for each in made if each.generation.node.variable not in package.contents])
    if any(each.severity is Severity.ERROR for each in work.found):
        return LoadedFiles((), frozenset(), tuple(work.found))
    return LoadedFiles((*work.files(), *work.written), frozenset(work.moved), tuple(work.found))


@dataclass
class _Change:
    package: Package
    source: PackageSource
    libraries: Mapping[str, Library]
    output: Path
    memory: FileMemory
    texts: dict[str, bytes]
    found: list[Diagnostic] = field(default_factory=list)
    written: list[OutputFile] = field(default_factory=list)
    _needs: tuple[Memory, Memory] = ({}, {})
    moved: list[str] = field(default_factory=list)

    def take_out(self, renamed: Mapping[str, Span]) -> None:
        """Take out what the program takes out of the package, or calls otherwise now.

        A dependency that the package had before the node came stays, where the manifest tells.
        """
        for name, span in {**renamed, **self.package.removed}.items():
            known = self.source.installed(name)
            file = known.file or next(iter(known.sources), None)
            added = None if file is None else self.memory.added(file)
            ours = {each for each in self.source.texts if self.memory.added(each) is not None}
            was_there = file is not None and self.memory.remembered(file, INSTALLED) is False
            of, came = needs_in(self.source, self.libraries, file), self.memory.found(file)
            needs = Needs(of, added, ours, came, self.memory.tags(file))
            if known.built:
                changed = remove_built_node(
                    self.source, self.texts, name, needs, is_built_elsewhere=was_there
                )
                stay = list(staying(self.source, name))
            else:
                changed = remove_executable(
                    self.source, self.texts, name, needs, is_installed_elsewhere=was_there
                )
                stay = [file] if file is not None and file in self.source.texts else []
            if not self._take(changed, span) or file is None:
                continue
            names = {name, PurePath(file).stem} if known.built else {name}
            is_back = any(each.name in names for each in self.package.contents.values())
            if not is_back:
                installed = known if was_there else None
                self.found += (file_stays(self.source, x, span, installed) for x in stay)

    def take_out_launches(self) -> None:
        """Take out the launch files that the program takes out of the package.

        The description of a robot goes with the launch file that starts it.
        """
        back = [each.name for each in self.package.contents.values()]
        removed = dict(self.package.removed_launches)
        for file, span in self.package.removed_launches.items():
            robot = f"{URDF_FOLDER}/{launch_stem(file.rpartition('/')[2])}.urdf"
            if self.memory.added(robot) is not None:
                removed[robot] = span
        for file, span in removed.items():
            stays = self.memory.remembered(file, INSTALLED) is False
            keys = self.memory.added(file) or {}
            changed = remove_launch(
                self.source, self.texts, file, keys, is_installed_elsewhere=stays
            )
            name = file.rpartition("/")[2]
            if self._take(changed, span) and launch_stem(name.removesuffix(".urdf")) not in back:
                self.found.append(file_stays(self.source, file, span))

    def put(self, contained: Contained, generated: Generated) -> None:
        """Put a node into the package."""
        if generated.files is None or generated.files.files.main is None:
            return
        file = self._inner(generated.files.name)
        text = generated.files.files.main
        known = self.source.texts.get(file)
        if known not in (None, text) and not self.memory.is_own(file):
            help_ = "name it otherwise: `contains … as 'other_name'`"
            self.found.append(self._taken(file, contained.span, help_))
            return
        node = packaged_node(contained.name, generated, self.libraries, contained.span)
        before = self.texts
        packages = known_packages(self.libraries[node.library])
        changed, unknown = with_node(self.source, before, node, file, packages)
        self.found += unknown
        if (
            self._take(changed, contained.span)
            and not node.is_built
            and not finds_scripts(self.source)
        ):
            self.found.append(script_elsewhere(self.source, contained))
        is_new = self._begins_to_install(before, file)
        for each in generated.files.output_files():
            base = None if each.base is None else {**each.base, INSTALLED: is_new}
            self._write_node(replace(each, base=base), changed.added, changed.found)

    def put_needs(self, made: Sequence[Generated]) -> None:
        """Let the package build what nodes of its files, each loaded by itself, come to need."""
        nodes = list(loaded_from(self.source, made, self.libraries))
        known = (
            remembered(self.source, self.output, self.memory.manifest)
            if self.memory.in_place
            else {}
        )
        needed = with_needs(self.source, self.texts, nodes, self.libraries, known)
        self.found += needed.diagnostics
        self.texts, self._needs = dict(needed.texts), (known, needed.memory)

    def _begins_to_install(self, before: Mapping[str, bytes], file: str) -> bool:
        """Tell whether it is with a file that the package begins to install it, or did before."""
        is_new = any(before[name] != self.texts[name] for name in before if name != PACKAGE_XML)
        return is_new or (
            self.memory.remembered(file, INSTALLED) is True and self.memory.is_own(file)
        )

    def put_type(self, own: OwnType) -> None:
        """Put a type into the package, which builds it."""
        [definition] = own_definitions([own], self.source.ros_version)[self.source.name]
        file = definition.path
        known = self.source.texts.get(file)
        if known not in (None, definition.text) and not self.memory.is_own(file):
            help_ = f"change it where it is: `load_type '…/{file}' as {own.name}`"
            taken = self._taken(file, own.span, help_)
            self.found.append(taken._replace(code=codes.TYPE_EXISTS))
            return
        spec = PackageSpec(self.source.name, self.source.ros_version, definitions=(definition,))
        needs = needs_of_definitions(spec)
        if self._take(add_definition(self.source, self.texts, file, sorted(needs)), own.span):
            self.texts.pop(file, None)
            made = OutputFile(f"{self.source.name}/{file}", definition.text, is_executable=False)
            if self.memory.is_in_place(file):
                path, entry = self.source.folder / file, self.memory.entry(file)
                made = replace(made, path=path, entry=entry)
            self.written.append(made)

    def put_launch(self, contained: Contained, item: Launch, launch: PackagedLaunch) -> None:
        """Put a launch file into the package's folder `launch`, or leave it where it is in it."""
        is_there = is_within(self.package, item)
        inner = name_within(self.package, item).partition("/")[2] if is_there else None
        help_ = f"change it with `load_launch`, or call this one another name than `{item.name}`"
        self._put_launch(launch, inner, contained.span, help_)

    def _put_launch(
        self, launch: PackagedLaunch, inner: str | None, span: Span, help_: str
    ) -> None:
        tool = "roslaunch" if self.source.ros_version == 1 else "ros2launch"
        file = inner or f"{_LAUNCH}/{launch.name}"
        text = None if inner is not None else launch.text
        self._share(file, text, {*launch.needs, tool}, span, help_)

    def put_robot(self, robot: PackagedRobot) -> None:
        """Put a robot's description into the package's folder `urdf`, with what starts it."""
        text = None if robot.file is None else robot.file.text
        help_ = "change it with `load_robot`, or call this one another name"
        self._share(robot.path, text, (), robot.span, help_)
        self._put_launch(robot.launch, None, robot.span, help_)
        missing = [
            each.path
            for each in robot.companions
            if each.file is not None and not (self.source.folder / each.path).is_file()
        ]
        for path in missing[:_MOST_TOLD]:
            message = f"the package `{self.source.name}` has no `{path}`, which the robot needs"
            help_ = "put it there by hand, and let the package install it"
            self.found.append(Diagnostic(codes.NOT_COPIED, message, robot.span, help=help_))

    def _share(
        self, file: str, text: bytes | None, keys: Iterable[str], span: Span, help_: str
    ) -> None:
        """Let the package install a file for others to read, and depend on what that needs.

        Args:
            file: its path in the package.
            text: what it holds; None for one that is in the package, and changed as what is
                loaded by itself.
            keys: what it needs.
            span: the statement that asks for it.
            help_: what to do where the package has another such file.
        """
        known = self.source.texts.get(file)
        if text is not None and known not in (None, text) and not self.memory.is_own(file):
            self.found.append(self._taken(file, span, help_))
            return
        before = self.texts
        changed = add_launch(self.source, before, file, sorted(keys))
        self._take(changed, span)
        if text is None:
            self.texts.pop(file, None)
            return
        is_new = self._begins_to_install(before, file)
        made = OutputFile(
            f"{self.source.name}/{file}", text, is_executable=False, base={INSTALLED: is_new}
        )
        self._write_node(made, changed.added)

    def _taken(self, file: str, span: Span, help_: str) -> Diagnostic:
        message = f"the package `{self.source.name}` has a file `{file}` already"
        for there in self.source.executables.values():
            if there.file == file:
                message += f": line {there.line} of `{there.where}` installs it"
                break
        if not self.memory.is_in_place(file) and self.memory.entry(file) in self.memory.manifest:
            help_ = "write over it with `--in-place`, as the run did that made it"
        return Diagnostic(codes.ALREADY_CONTAINED, message, span, help=help_)

    def _take(self, changed: Changed, span: Span) -> bool:
        self.found += [
            each if each.file is not None or each.span is not None else each._replace(span=span)
            for each in changed.diagnostics
        ]
        if changed.texts is not None:
            self.texts = changed.texts
        return changed.texts is not None

    def _inner(self, name: str) -> str:
        """Return the path in the package of a file of the output folder."""
        return name.removeprefix(f"{self.source.name}/")

    def _write_node(
        self, file: OutputFile, added: Mapping[str, Sequence[str]], found: Sequence[str] = ()
    ) -> None:
        """Write a file of a node, and remember which dependencies came with it."""
        inner = self._inner(file.name)
        others = {
            name: text
            for name, text in self.source.texts.items()
            if name not in (inner, PACKAGE_XML)
        }
        modules = needs_in(self.source, self.libraries, inner)(file.text)
        came = {key: any(named_elsewhere(others, (key, *modules.get(key, ())))) for key in added}
        tags = {key: list(each) for key, each in added.items()}
        self.moved.append(file.name)
        if self.memory.is_in_place(inner):
            came.update(self.memory.added(inner) or {})
            for key, each in self.memory.tags(inner).items():
                tags[key] = list(dict.fromkeys((*each, *tags.get(key, ()))))
            found = sorted({*found, *(self.memory.found(inner) or ())})
            path, entry = self.source.folder / inner, self.memory.entry(inner)
            file = replace(file, path=path, entry=entry, merged_from=None, layers=None)
        if file.base is not None:
            remembered = {DEPENDS: came, TAGS: tags, FOUND: list(found)}
            file = replace(file, base={**file.base, **remembered})
        self.written.append(file)

    def files(self) -> list[OutputFile]:
        """Return the files that were there and are changed."""
        found = []
        for name, text in self.texts.items():
            original = self.source.texts.get(name)
            is_over = self.memory.is_in_place(name)
            # What an earlier run changed is as it was before when nothing of it is left. What it
            # copied has a base.
            there, manifest = f"{self.source.name}/{name}", self.memory.manifest
            is_left = not is_over and there in manifest and there not in manifest.bases
            # What becomes of a definition that is there is said by who loads it.
            is_left = is_left and not name.endswith(_DEFINITIONS)
            if text == original and not is_left:
                continue
            found.append(
                OutputFile(
                    f"{self.source.name}/{name}",
                    text,
                    is_executable=False,
                    merged_from=original if is_over else None,
                    path=self.source.folder / name if is_over else None,
                )
            )
        before, needs = self._needs
        return (
            remember(found, self.source, needs, before, self.output)
            if self.memory.in_place
            else found
        )
