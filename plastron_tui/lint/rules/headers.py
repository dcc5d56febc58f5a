"""What is wrong with the headers of messages that are sent."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity, Span
from plastron_tui.lint.message_fields import Messages, described, units_of
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import SourceTree, UnitFacts
from plastron_tui.model.code_facts import REMOVING, MessageType, Sent
from plastron_tui.model.kinds import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName

from .message_examples import scanner

_HEADERS = frozenset({InterfaceName("std_msgs", "Header"), InterfaceName("roslib", "Header")})

_NO_STAMP = frozenset(
    {
        # There 0 means at once.
        InterfaceName("trajectory_msgs", "JointTrajectory"),
        InterfaceName("trajectory_msgs", "MultiDOFJointTrajectory"),
        # There 0 means the newest transform.
        InterfaceName("visualization_msgs", "Marker"),
        InterfaceName("visualization_msgs", "InteractiveMarker"),
    }
)
_FRAMED = frozenset({"geometry_msgs", "nav_msgs", "sensor_msgs", "visualization_msgs"})
_STAMPED = _FRAMED | {"diagnostic_msgs", "stereo_msgs"}
_PICTURES = frozenset({InterfaceName("sensor_msgs", name) for name in ("CompressedImage", "Image")})
_NO_FRAME = frozenset(
    {
        # A command for a robot's speed is in the frame of the robot.
        InterfaceName("geometry_msgs", "TwistStamped"),
        InterfaceName("sensor_msgs", "BatteryState"),
        InterfaceName("sensor_msgs", "JointState"),
        InterfaceName("sensor_msgs", "Joy"),
        InterfaceName("sensor_msgs", "MultiDOFJointState"),
        InterfaceName("sensor_msgs", "TimeReference"),
        *_PICTURES,
    }
)
_SETPOINT = re.compile(r"(?:^|/)setpoint_(?:accel|attitude|position|raw|velocity)/[a-z_]+$")
"""The topics of mavros whose headers nobody reads."""

_Place = tuple[UnitFacts, Sent]


@rule(
    "RM205",
    "missing-stamp",
    "A message with a header is sent, and its stamp stays 0.",
    severity=Severity.WARNING,
    why="Filters that bring messages of several topics together, and transforms, go by the stamp: "
    "a message of the year 1970 is dropped, mostly without a word. Types for which 0 has a "
    "meaning, those of one's own whose stamp nothing in the workspace reads, and messages that may "
    "get their stamp where nobody sees it, are not told.",
    bad={"scanner.py": scanner(has_stamp=False)},
    good={"scanner.py": scanner()},
)
def missing_stamp(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find messages that are sent without a stamp."""
    read = _read_stamps(tree)

    def is_told(sent: Sent) -> bool:
        name = sent.type.name
        # There are types of people's own whose header nobody reads.
        is_used = name.package in _STAMPED or name in read or _touches_header(sent)
        return is_used and name not in _NO_STAMP

    found = (each for each in _without(tree, "stamp") if is_told(each[1]))
    yield from _told(code, found, "stamp", "stays 0")


@rule(
    "RM206",
    "missing-frame-id",
    "A message that stands in a frame is sent, and says no frame.",
    severity=Severity.WARNING,
    why="Whoever wants to know where it is looks the frame up by its name, and there is no frame "
    "that is called ``. What is in no frame, such as states of joints, and pictures that people "
    "only look at, are not told. Where the stamp lacks too, RM205 tells both.",
    bad={"scanner.py": scanner(has_frame=False)},
    good={"scanner.py": scanner()},
    told_by="RM205",
)
def missing_frame_id(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find messages that are sent without the name of their frame."""
    found = (each for each in _without(tree, "frame_id") if _has_frame(each[1]))
    yield from _told(code, found, "frame_id", "stays empty")


def _has_frame(sent: Sent) -> bool:
    """Tell whether a message stands in a frame."""
    name = sent.type.name
    # What takes a marker away goes by its number.
    is_removed = name.package == "visualization_msgs" and REMOVING in sent.paths
    return name.package in _FRAMED and name not in _NO_FRAME and not is_removed


def _read_stamps(tree: SourceTree) -> set[InterfaceName]:
    """Return the messages whose stamp is read anywhere in the workspace, or handed on."""
    return {
        use.type.name
        for unit in tree.units
        for use in unit.code.fields
        if use.path[:2] in (("header",), ("header", "stamp")) and not use.is_set
    }


def _without(tree: SourceTree, field: str) -> Iterator[_Place]:
    """Yield the messages that are sent without a field of their header."""
    for unit, messages in units_of(tree):
        for sent in () if unit.is_test else unit.code.sent:
            if not _has_header(messages, sent.type) or _may_have(sent, field):
                continue
            if sent.type.name in _PICTURES and not _touches_header(sent):
                # Whoever only looks at pictures does without their header.
                continue
            if _is_setpoint(unit, sent.type):
                continue
            yield unit, sent


def _has_header(messages: Messages, type_: MessageType) -> bool:
    fields = messages.fields(type_)
    return any(each.name == "header" and each.type.message in _HEADERS for each in fields)


def _may_have(sent: Sent, field: str) -> bool:
    return any(path[:2] in (("header",), ("header", field)) for path in sent.paths)


def _touches_header(sent: Sent) -> bool:
    return any(path[0] == "header" for path in sent.paths if path)


def _is_setpoint(unit: UnitFacts, type_: MessageType) -> bool:
    """Tell whether all that the files publish of a type are setpoints for mavros."""
    topics = [
        endpoint.name or ""
        for node in unit.nodes
        for endpoint in node.endpoints
        if endpoint.kind is EndpointKind.PUBLISHER and endpoint.type == type_.name
    ]
    return bool(topics) and all(map(_SETPOINT.search, topics))


def _told(code: Code, found: Iterable[_Place], field: str, state: str) -> Iterator[Diagnostic]:
    """Tell once of a message that is sent at several places."""
    objects: dict[tuple[Path, int, Span | None], list[Sent]] = defaultdict(list)
    for unit, sent in found:
        span = sent.span if sent.made < 0 else None
        objects[unit.file(sent.file), sent.made, span].append(sent)
    for (file, _, _), places in objects.items():
        first, *others = sorted(places, key=lambda each: each.span.start)
        message, lacking = f"`header.{field}` of {described(first.type)} {state}", field
        if field == "stamp" and _has_frame(first) and not _may_have(first, "frame_id"):
            message, lacking = f"{message}, and its `frame_id` empty", "stamp` and `frame_id"
        yield Diagnostic(
            code,
            message,
            first.span,
            file,
            help=f"give `header.{lacking}` a value before it is sent",
            labels=tuple(
                Label(each.span, "it is sent here, too", file)
                for each in others
                if each.span != first.span
            ),
        )
