"""Robots, as programs describe them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.robots.description import Description, Joint, Link, Material, Vector
from plastron_tui.ros.robots.macros import Arguments, Macros

if TYPE_CHECKING:
    from .source import TextOrigin

T = TypeVar("T")


class RobotSource(NamedTuple):
    """A robot's file.

    Attributes:
        path: where it is.
        text: what the program starts from: what the file holds, without what it wrote itself.
        description: what that text says.
        origin: where the text comes from if it is not simply what the file holds.
        expanded: what the file's macros make of it, None for a file without macros, or where they
            are not expanded; then it is only looked at.
        macros: what the file leaves to macros, None for a file without them. A file with macros
            may have links and joints besides those of its description.
        spans: where the names of its links and joints stand in the text, by `link` or `joint` and
            the name.
        arguments: what the program gives its macros.
        opened: the files that its macros were expanded with.
        computed: what macros compute of its links and joints: the value as it is written and its
            line, by `link` or `joint` and the name, and where it is: `limit/lower`.
    """

    path: Path
    text: bytes
    description: Description
    origin: TextOrigin | None = None
    expanded: Description | None = None
    macros: Macros | None = None
    spans: Mapping[tuple[str, str], Span] = {}
    arguments: Arguments = ()
    opened: tuple[Path, ...] = ()
    computed: Mapping[tuple[str, str], Mapping[str, tuple[str, int]]] = {}

    @property
    def whole(self) -> Description | None:
        """The whole robot, None where nobody knows what macros make of it."""
        return self.description if self.macros is None else self.expanded

    @property
    def present(self) -> bytes:
        """What the file holds."""
        return self.text if self.origin is None else self.origin.present


class LoadedRobot(NamedTuple):
    """What a reader made of the path of a robot's file; None with the reason.

    Attributes:
        source: the robot.
        diagnostics: what is wrong with it, or the reason.
        asked: the arguments that its macros asked for, those that they give defaults among them.
        unused: the arguments that it was given, and that its macros did not ask for; () where
            they are not expanded.
    """

    source: RobotSource | None
    diagnostics: tuple[Diagnostic, ...] = ()
    asked: tuple[str, ...] = ()
    unused: tuple[str, ...] = ()


RobotReader = Callable[[str, Arguments], LoadedRobot]
"""Reads a robot by the path of its file, and what its macros are given."""


def no_robot(source: str, _: Arguments) -> LoadedRobot:
    """Find no robot: where a program has no folder, there is none."""
    found = Diagnostic(codes.FILE_NOT_FOUND, f"no file `{source}` beside the program")
    return LoadedRobot(None, (found,))


class Places(NamedTuple):
    """The statements that say something of a robot's part, the last of each.

    Attributes:
        made: the one that made it, None for what a file has.
        changed: the one that changed it last.
        limited: the one that limits it, of a joint.
    """

    made: Span | None = None
    changed: Span | None = None
    limited: Span | None = None


@dataclass(slots=True)
class Robot:
    """A robot, as the program has it so far.

    Attributes:
        variable: the program's variable for it.
        span: the statement that created or loaded it.
        description: what it consists of by now. What the program changes in a loaded one is what
            differs from the source's.
        source: what a loaded one came from, None for one that was created.
        links: where the program speaks of its links, by name.
        joints: where it speaks of its joints, by name.
        home: the package that the program puts it into, "" for none.
        own_materials: the materials that a loaded one has, those too that stand in its links.
        meshes: points that its meshes are between, by their URIs, where somebody has measured
            them: two for the box around a mesh, more for the hull around it.
        taken: the statements that take links and joints away, by `link` or `joint` and the name.
    """

    variable: str
    span: Span
    description: Description
    source: RobotSource | None = None
    links: dict[str, Places] = field(default_factory=dict)
    joints: dict[str, Places] = field(default_factory=dict)
    home: str = ""
    own_materials: Mapping[str, Material] = field(default_factory=dict)
    meshes: Mapping[str, tuple[Vector, ...]] = field(default_factory=dict)
    taken: dict[tuple[str, str], Span] = field(default_factory=dict)
    # Its own, so that a statement changes one entry of them, not all.
    _links: dict[str, Link] = field(init=False, repr=False)
    _joints: dict[str, Joint] = field(init=False, repr=False)
    # The joints that need a link or a joint, by both names; found where that is first asked for.
    _users: dict[tuple[str, str], dict[str, None]] | None = field(init=False, repr=False)

    def __post_init__(self) -> None:
        """Take the description's parts over."""
        self._links, self._joints = dict(self.description.links), dict(self.description.joints)
        self._users = None
        self.description = replace(self.description, links=self._links, joints=self._joints)

    @property
    def name(self) -> str:
        """What it is called."""
        return self.description.name

    def put_link(self, link: Link) -> None:
        """Give the robot a link, in place of the one of its name."""
        self._links[link.name] = link

    def take_link(self, name: str, where: Span) -> None:
        """Take a link away from the robot, as a statement asks."""
        del self._links[name]
        self.taken["link", name] = where
        self.links.pop(name, None)

    def put_joint(self, joint: Joint) -> None:
        """Give the robot a joint, in place of the one of its name."""
        self._forget_uses(joint.name)
        self._joints[joint.name] = joint
        if self._users is not None:
            _note_uses(self._users, joint)

    def take_joint(self, name: str, where: Span) -> None:
        """Take a joint away from the robot, as a statement asks."""
        self._forget_uses(name)
        del self._joints[name]
        self.taken["joint", name] = where
        self.joints.pop(name, None)

    def holding(self, link: str) -> Iterator[Joint]:
        """Yield the joints that hold a link, or hang on it."""
        yield from self._users_of("link", link)

    def following(self, joint: str) -> Iterator[Joint]:
        """Yield the joints that follow a joint."""
        yield from self._users_of("joint", joint)

    def _users_of(self, what: str, name: str) -> Iterator[Joint]:
        if self._users is None:
            self._users = {}
            for joint in self._joints.values():
                _note_uses(self._users, joint)
        yield from (self._joints[each] for each in self._users.get((what, name), ()))

    def _forget_uses(self, joint: str) -> None:
        if self._users is not None and joint in self._joints:
            for used in _uses(self._joints[joint]):
                self._users[used].pop(joint, None)

    @property
    def whole(self) -> Description | None:
        """The robot with what macros make of its file, None where nobody knows that."""
        source = self.source
        if source is None or source.macros is None or source.expanded is None:
            is_known = source is None or source.macros is None
            return self.description if is_known else None
        before, now, all_ = source.description, self.description, source.expanded
        return replace(
            all_,
            links=_with_changes(before.links, now.links, all_.links),
            joints=_with_changes(before.joints, now.joints, all_.joints),
        )

    @property
    def shown(self) -> Description:
        """What there is to see of it: with its macros expanded, where they are."""
        return self.whole or self.description

    @property
    def stem(self) -> str:
        """What its file is called, without its ending."""
        return self.name if self.source is None else file_stem(self.source.path.name)

    def snapshot(self) -> Robot:
        """Return the robot as it is now, untouched by what later statements do to it."""
        links, joints = dict(self.links), dict(self.joints)
        return replace(self, links=links, joints=joints, taken=dict(self.taken))


def _with_changes(
    before: Mapping[str, T], now: Mapping[str, T], parts: Mapping[str, T]
) -> dict[str, T]:
    """Return parts with what changed of some of them."""
    kept = {name: part for name, part in parts.items() if name not in before or name in now}
    return kept | {name: part for name, part in now.items() if before.get(name) != part}


def _uses(joint: Joint) -> Iterator[tuple[str, str]]:
    """Yield what a joint needs: two links, and the joint that it follows."""
    yield "link", joint.parent
    yield "link", joint.child
    if joint.mimic is not None:
        yield "joint", joint.mimic.joint


def _note_uses(users: dict[tuple[str, str], dict[str, None]], joint: Joint) -> None:
    for used in _uses(joint):
        users.setdefault(used, {})[joint.name] = None


def file_stem(name: str) -> str:
    """Return the name of a robot's file without its endings: `rover` of `rover.urdf.xacro`."""
    for ending in (".xml", ".xacro", ".urdf"):
        name = name.removesuffix(ending) or name
    return name


class RobotGeneration(NamedTuple):
    """A `generate_robot`: the robot as it was then."""

    robot: Robot
    span: Span
