"""The names of a program, to find what it says of one: each with what it names, and where."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Span
from plastron_tui.language.statements import StopRepeating
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.names import resolved_name

from .panels.entry import Entry, Subject
from .panels.entry_signs import HUBS, SIGNS
from .panels.robot_places import place_of

if TYPE_CHECKING:
    from plastron_tui.language import Program
    from plastron_tui.model.robots import Places, Robot
    from plastron_tui.model.workspace import Workspace

_FUNCTION = ("↻", "success")
_WORDS = {Subject.SERVICE_NAME: "service", Subject.ACTION_NAME: "action"}
"""What is called otherwise than its subject."""


class ProgramName(NamedTuple):
    """A name of a program.

    Attributes:
        entry: what it names, as an entry of a panel: the same can be done with it.
        kind: what that is, in a word or two.
        where: its line, `line 12`, or the file that it is in.
        line: the text of that line; "" where it is in another file.
    """

    entry: Entry
    kind: str
    where: str
    line: str = ""


def names_of(text: bytes, program: Program, workspace: Workspace) -> tuple[ProgramName, ...]:
    """Return the names of a program, in the order of its text, those of other files last.

    Args:
        text: the program.
        program: its statements.
        workspace: what it builds.
    """
    found = [
        *_variables(workspace),
        *_endpoints(workspace),
        *_functions(program),
        *(each for robot in workspace.robots.values() for each in _parts(robot)),
    ]
    end = len(text)
    found.sort(key=lambda each: end if each[0].span is None else each[0].span.start)
    return tuple(_placed(text, found))


def _placed(text: bytes, found: Iterable[tuple[Entry, str]]) -> Iterator[ProgramName]:
    """Say where entries are, which come in the order of the text."""
    number, counted = 1, 0
    for entry, kind in found:
        if entry.span is None:
            yield ProgramName(entry, kind, entry.place)
            continue
        number += text.count(b"\n", counted, entry.span.start)
        counted = entry.span.start
        end = text.find(b"\n", counted)
        line = text[counted : len(text) if end < 0 else end]
        yield ProgramName(entry, kind, f"line {number}", line.decode("utf-8", "replace"))


def _variables(workspace: Workspace) -> Iterator[tuple[Entry, str]]:
    """Yield what variables stand for."""
    named: tuple[tuple[Subject, Mapping[str, object]], ...] = (
        (Subject.NODE, workspace.nodes),
        (Subject.MESSAGE, workspace.messages),
        (Subject.PACKAGE, workspace.packages),
        (Subject.LAUNCH, workspace.launches),
        (Subject.TYPE, workspace.types),
        (Subject.ROBOT, workspace.robots),
    )
    for subject, things in named:
        for variable, thing in things.items():
            span = getattr(thing, "span", None)
            name = getattr(thing, "name", variable)
            text = name if isinstance(name, str) and name else variable
            node = variable if subject is Subject.NODE else None
            entry = Entry(
                f"{subject.value} {variable}",
                text,
                "" if text == variable else variable,
                *SIGNS[subject],
                span=span,
                subject=subject,
                node=node,
                name=variable,
            )
            yield entry, subject.word


def _endpoints(workspace: Workspace) -> Iterator[tuple[Entry, str]]:
    """Yield the topics, services and actions, each once, and the parameters of each node."""
    hubs: dict[tuple[Subject, str], Entry] = {}
    for variable, node in workspace.nodes.items():
        file = "" if node.source is None else node.source.path.name
        for kind, endpoints in node.by_kind.items():
            for written, endpoint in endpoints.items():
                span = endpoint.span
                place = file if span is None else ""
                if kind is EndpointKind.PARAMETER:
                    name = kind.written(written)
                    key = f"parameter {variable} {name}"
                    yield Entry(
                        key, name, "", *SIGNS[kind],
                        span=span, subject=kind, node=variable, name=name, place=place,
                    ), f"parameter of {variable}"  # fmt: skip
                elif kind.facts.interface is not None:
                    subject = HUBS[kind.facts.interface]
                    name = resolved_name(node.name, written)
                    before = hubs.get((subject, name))
                    if before is None or _is_before(span, before.span):
                        hubs[subject, name] = Entry(
                            f"{subject.value} {name}", name, "", *SIGNS[subject],
                            span=span, subject=subject, name=name, place=place,
                        )  # fmt: skip
    for (subject, _), entry in hubs.items():
        yield entry, _WORDS.get(subject, subject.word)


def _is_before(one: Span | None, other: Span | None) -> bool:
    return one is not None and (other is None or one.start < other.start)


def _functions(program: Program) -> Iterator[tuple[Entry, str]]:
    """Yield the functions of each node, where one is first spoken of."""
    told: set[tuple[str, str]] = set()
    for statement in program.statements:
        node, name = getattr(statement, "node", None), getattr(statement, "function", None)
        if not isinstance(name, str) or not isinstance(node, str) or (node, name) in told:
            continue
        if not isinstance(statement, StopRepeating):
            told.add((node, name))
            yield Entry(
                f"function {node} {name}", name, "", *_FUNCTION,
                span=statement.span, subject=Subject.FUNCTION, node=node, name=name,
            ), f"function of {node}"  # fmt: skip


def _parts(robot: Robot) -> Iterator[tuple[Entry, str]]:
    """Yield the links and joints of a robot."""
    shown = robot.shown
    for subject, parts, places in (
        (Subject.LINK, tuple(shown.links), robot.links),
        (Subject.JOINT, tuple(shown.joints), robot.joints),
    ):
        for name in parts:
            yield (
                _part(robot, subject, name, places.get(name)),
                f"{subject.word} of {robot.variable}",
            )


def _part(robot: Robot, subject: Subject, name: str, places: Places | None) -> Entry:
    span = next((each for each in places or () if each is not None), None)
    source = robot.source
    return Entry(
        f"{subject.value} {robot.variable} {name}",
        name,
        "",
        *SIGNS[subject],
        span=span,
        subject=subject,
        name=name,
        robot=robot.variable,
        place="" if span is not None or source is None else place_of(source, (subject, name)),
    )
