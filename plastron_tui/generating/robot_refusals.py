"""Changes of robots that their files refuse, told at the sentence that asks for them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from plastron_tui.diagnostics import Diagnostic, LineIndex, Span, codes, has_errors
from plastron_tui.model.robots import Places, Robot, RobotSource
from plastron_tui.sources.urdf.edits import edited
from plastron_tui.sources.urdf.reader import read_urdf


def told_at_sentences(robot: Robot, found: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield what is to be said of an edit of a robot's file.

    A change that is refused is told where the program asks for it, with the line of the file.

    Args:
        robot: the robot, which was loaded.
        found: what the edit has to say, at its places in the file.
    """
    source = robot.source
    for each in found:
        is_refusal = each.code == codes.EDIT_REFUSED and has_errors([each])
        sentence = None
        if is_refusal and source is not None and each.span is not None and each.file == source.path:
            sentence = _sentence(robot, source, each.span)
        if source is None or sentence is None or each.span is None:
            yield each
            continue
        where = f"`{source.path.name}`"
        if source.origin is None:
            where = f"line {LineIndex(source.text).line_at(each.span.start)} of {where}"
        message = f"{each.message} (in {where})"
        help_ = each.help or "change it in the file"
        yield each._replace(message=message, span=sentence, file=None, help=help_, labels=())


def _sentence(robot: Robot, source: RobotSource, place: Span) -> Span | None:
    """Return the sentence that changes what stands somewhere in a file, None where none is."""
    places = read_urdf(source.text).places
    for kind, parts, spoken in (
        ("link", places.links, robot.links),
        ("joint", places.joints, robot.joints),
    ):
        for name, element in parts.items():
            if element.span.start <= place.start < element.span.end:
                said = spoken.get(name, Places())
                if said.limited and said.changed and _is_of_limits(robot, source, name, place):
                    return said.limited
                said_of = said.changed or said.limited or said.made
                return said_of or robot.taken.get((kind, name))
    return None


def _is_of_limits(robot: Robot, source: RobotSource, name: str, place: Span) -> bool:
    """Tell whether a file refuses no more of a joint where its limits stay as they are."""
    before, after = source.description, robot.description
    was, now = before.joints.get(name), after.joints.get(name)
    if was is None or now is None:
        return False
    kept = now._replace(limit=was.limit, dynamics=was.dynamics)
    wanted = replace(after, joints={**after.joints, name: kept})
    again = edited(source.text, before, wanted, source.path)
    return all(each.span != place for each in again.diagnostics)
