"""The rows of the live panel: what is known of running nodes, as data."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from enum import Enum
from typing import NamedTuple

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.diagnostics.wording import counted
from plastron_tui.runtime.live_graph import LiveGraph, LiveParameter, LiveTopic, NodeEnd

WAITING = "waiting for the first message…"
NOBODY = "nobody publishes here yet"
FOREIGN = "not in this program"
_USUAL_DOMAIN = ("", "0")


_WIDEST = 500
"""So many characters of a value are looked at: more than windows show in a line."""


class Kind(Enum):
    """What a row is about."""

    HEADING = "heading"
    TOPIC = "topic"
    FIELD = "field"
    SERVICE = "service"
    ANSWER = "answer"
    NODE = "node"
    PARAMETER = "parameter"
    NOTE = "note"


UNCOUNTED = (Kind.HEADING, Kind.NOTE)
"""What is there besides topics, services and nodes."""


class Answer(NamedTuple):
    """What a service answered."""

    text: str
    is_failure: bool = False


class LiveRow(NamedTuple):
    """A line of the panel.

    Attributes:
        key: what it is, the same as long as that is there.
        kind: what it is about.
        name: what is in its first column.
        owner: the full name of the topic, service or node that it belongs to.
        ros_version: the generation of ROS.
        type: the type of a topic, a service or a parameter.
        rate: messages a second, in words.
        value: the last message, a field's or a parameter's value, an answer.
        tone: the tone of the value.
        samples: the numbers of its curve.
        depth: how far it is indented.
        is_branch: whether it can be unfolded.
        is_open: whether it is.
        parameter: what is known of a parameter.
        is_foreign: whether the program that is watched does not have it.
        is_old: whether it is what was seen last, and nobody watches any more.
    """

    key: str
    kind: Kind
    name: str
    owner: str = ""
    ros_version: int = 2
    type: str = ""
    rate: str = ""
    value: str = ""
    tone: str = ""
    samples: tuple[float, ...] = ()
    depth: int = 0
    is_branch: bool = False
    is_open: bool = False
    parameter: LiveParameter | None = None
    is_foreign: bool = False
    is_old: bool = False


def live_rows(
    graphs: Sequence[LiveGraph], unfolded: AbstractSet[str], answers: Mapping[str, Answer]
) -> list[LiveRow]:
    """Return the rows about running nodes.

    Args:
        graphs: what is known, of each generation of ROS.
        unfolded: the keys of the rows that are unfolded.
        answers: the last answer of services, by the key of their rows.
    """
    rows: list[LiveRow] = []
    for graph in graphs:
        words = f"ROS {graph.ros_version} " if len(graphs) > 1 else ""
        domain = f", domain {visible(graph.domain)}" if graph.domain not in _USUAL_DOMAIN else ""
        if graph.problem:
            key = f"{graph.ros_version} problem"
            rows.append(LiveRow(key, Kind.NOTE, visible(graph.problem), tone="error"))
        parts = (
            ("topics", _topics(graph, unfolded)),
            ("services", _services(graph, answers)),
            ("nodes", _nodes(graph, unfolded)),
        )
        for part, found in parts:
            below = list(found)
            if below:
                rows.append(
                    LiveRow(f"{graph.ros_version} {part}", Kind.HEADING, words + part + domain)
                )
                domain = ""
                rows += below
    return rows


def found_rows(rows: Sequence[LiveRow], words: Sequence[str]) -> tuple[list[LiveRow], int]:
    """Return the rows of what has all words in its name or type, and how much that is.

    What is said of the whole panel stays, and headings with something below them.
    """
    found: list[LiveRow] = []
    count = 0
    heading: LiveRow | None = None
    is_found = True
    for row in rows:
        if row.kind is Kind.HEADING:
            heading = row
            continue
        if row.depth == 0 and row.kind is not Kind.NOTE:
            text = f"{row.owner} {row.type}".lower()
            is_found = all(word in text for word in words)
            count += is_found
        if is_found or (row.kind is Kind.NOTE and row.depth == 0):
            if heading is not None and row.kind is not Kind.NOTE:
                found.append(heading)
                heading = None
            found.append(row)
    return found, count


def _topics(graph: LiveGraph, unfolded: AbstractSet[str]) -> Iterator[LiveRow]:
    # What others have besides comes behind.
    for topic in sorted(graph.topics.values(), key=lambda each: not graph.is_own(each.nodes)):
        key = f"{graph.ros_version} topic {topic.name}"
        is_open = key in unfolded
        value, tone = _topic_value(topic)
        is_old = graph.has_ended or not graph.is_watched
        yield LiveRow(
            key,
            Kind.TOPIC,
            visible(topic.name),
            topic.name,
            graph.ros_version,
            topic.type,
            _rate(topic),
            value,
            "quiet" if is_old else tone,
            tuple(topic.samples),
            is_branch=True,
            is_open=is_open,
            is_foreign=not graph.is_own(topic.nodes),
            is_old=is_old,
        )
        if is_open:
            yield from _fields(key, topic, graph.ros_version)


def _fields(key: str, topic: LiveTopic, version: int) -> Iterator[LiveRow]:
    # The type has no column in a narrow panel.
    ends = f"{counted(topic.publishers, 'publisher')}, {counted(topic.subscribers, 'subscriber')}"
    about = f"{visible(topic.type)}, {ends}"
    yield LiveRow(f"{key} about", Kind.NOTE, about, topic.name, version, depth=1, tone="quiet")
    for path, text in topic.fields:
        yield LiveRow(
            f"{key} field {path}",
            Kind.FIELD,
            visible(path),
            topic.name,
            version,
            value=_line(text),
            samples=tuple(topic.field_samples.get(path, ())),
            depth=1,
        )


def _rate(topic: LiveTopic) -> str:
    if topic.rate >= 1000:
        return f"{topic.rate / 1000:.1f} kHz"
    if topic.rate > 0:
        return f"{topic.rate:.1f} Hz"
    return "" if topic.count < 2 or topic.is_gone else "silent"


def _topic_value(topic: LiveTopic) -> tuple[str, str]:
    """Return the last message, or what there is to say before it, and its tone."""
    if topic.is_gone:
        return "gone", "quiet"
    if topic.text:
        return _line(topic.text), "" if topic.rate > 0 or topic.count < 2 else "quiet"
    return (WAITING if topic.publishers else NOBODY), "quiet"


def _services(graph: LiveGraph, answers: Mapping[str, Answer]) -> Iterator[LiveRow]:
    for service in graph.services.values():
        key = f"{graph.ros_version} service {service.name}"
        yield LiveRow(
            key,
            Kind.SERVICE,
            visible(service.name),
            service.name,
            graph.ros_version,
            service.type,
            value="gone" if service.is_gone else visible(service.type),
            tone="quiet",
        )
        answer = answers.get(key)
        if answer is not None:
            yield LiveRow(
                f"{key} answer",
                Kind.ANSWER,
                "✗" if answer.is_failure else "→",
                service.name,
                graph.ros_version,
                service.type,
                value=_line(answer.text),
                tone="error" if answer.is_failure else "",
                depth=1,
            )


def _nodes(graph: LiveGraph, unfolded: AbstractSet[str]) -> Iterator[LiveRow]:
    nodes = sorted(graph.nodes.items(), key=lambda each: not graph.is_own([each[0]]))
    for name, is_there in nodes:
        is_foreign = not graph.is_own([name])
        key = f"{graph.ros_version} node {name}"
        end = graph.ended.get(name)
        runs = is_there and end is None
        is_open = key in unfolded and runs
        value, tone = _node_state(end, is_there=is_there, has_ended=graph.has_ended)
        if is_foreign:
            value, tone = FOREIGN if is_there else f"gone, {FOREIGN}", "quiet"
        yield LiveRow(
            key,
            Kind.NODE,
            visible(name),
            name,
            graph.ros_version,
            value=value,
            tone=tone,
            is_branch=runs,
            is_open=is_open,
            is_foreign=is_foreign,
            is_old=not graph.is_watched or not runs,
        )
        if not is_open:
            continue
        found = graph.parameters.get(name)
        if not found:
            words = "asking for its parameters…" if found is None else "has no parameters"
            yield LiveRow(f"{key} none", Kind.NOTE, words, name, depth=1, tone="quiet")
        for each in found or ():
            yield LiveRow(
                f"{key} parameter {each.name}",
                Kind.PARAMETER,
                visible(each.name),
                name,
                graph.ros_version,
                each.type,
                value=_parameter_value(each),
                depth=1,
                parameter=each,
            )


def _node_state(end: NodeEnd | None, *, is_there: bool, has_ended: bool) -> tuple[str, str]:
    """Return what there is to say of a node, and its tone: what nobody wanted is loud."""
    if end is not None:
        return visible(end.how), "error" if end.is_failure else "quiet"
    if is_there:
        return "", "quiet"
    return "gone", "quiet" if has_ended else "warning"


def _parameter_value(parameter: LiveParameter) -> str:
    value = parameter.value
    shown = _list(value) if isinstance(value, tuple) else str(value)[: _WIDEST + 1]
    limits = parameter.range
    parts = [shown if value is not None else "not set"]
    if limits is not None:
        parts.append(f"{limits[0]:g}…{limits[1]:g}")
    if parameter.is_read_only:
        parts.append("cannot be set")
    if parameter.about:
        parts.append(parameter.about)
    return _line("  ".join(parts))


def _list(values: tuple[object, ...]) -> str:
    """Return a list as text, as much of it as a line may show."""
    more = ", …" if len(values) > _WIDEST else ""
    return f"[{', '.join(str(each)[:_WIDEST] for each in values[:_WIDEST])}{more}]"


def _line(text: str) -> str:
    """Return a text in one line that a terminal shows as it is; a long one is cut first."""
    return visible(text if len(text) <= _WIDEST else text[:_WIDEST] + "…")
