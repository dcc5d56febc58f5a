"""The rows of the live panel: what is known of running nodes, as data."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import Protocol, TypeVar

from plastron_tui.diagnostics.terminal import visible
from plastron_tui.diagnostics.wording import counted
from plastron_tui.runtime.live_graph import (
    LiveAction,
    LiveGraph,
    LiveTopic,
    NodeEnd,
)
from plastron_tui.runtime.live_parts import LiveGoal, LiveParameter

from .live_ends import doing_rows, end_rows
from .live_row import WIDEST, Answer, Kind, LiveRow, one_line

WAITING = "waiting for the first message…"
NOBODY = "nobody publishes here yet"
FOREIGN = "not in this program"
UNSERVED = "nobody provides it now"
ENDED = "ended: this was seen last"
_USUAL_DOMAIN = ("", "0")
_MOST_GOALS = 5
"""So many goals of an action are shown that are over; those that are not all are."""
UNCOUNTED = (Kind.HEADING, Kind.NOTE)
"""What is there besides topics, services, actions and nodes."""


def live_rows(
    graphs: Sequence[LiveGraph],
    unfolded: AbstractSet[str],
    answers: Mapping[str, Answer],
    now: float = 0.0,
) -> list[LiveRow]:
    """Return the rows about running nodes.

    Args:
        graphs: what is known, of each generation of ROS.
        unfolded: the keys of the rows that are unfolded.
        answers: the last answer of services, by the key of their rows.
        now: the time by the clock of `monotonic`.
    """
    rows: list[LiveRow] = []
    for graph in graphs:
        words = f"ROS {graph.ros_version} " if len(graphs) > 1 else ""
        domain = f", domain {visible(graph.domain)}" if graph.domain not in _USUAL_DOMAIN else ""
        if graph.problem:
            key = f"{graph.ros_version} problem"
            rows.append(LiveRow(key, Kind.NOTE, visible(graph.problem), tone="error"))
        if graph.has_ended:
            rows.append(LiveRow(f"{graph.ros_version} ended", Kind.NOTE, ENDED, tone="quiet"))
        parts = (
            ("topics", _topics(graph, unfolded, now)),
            ("services", _services(graph, answers, now)),
            ("actions", _actions(graph, now)),
            ("nodes", _nodes(graph, unfolded, now)),
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


class _Named(Protocol):
    """What has a name, and nodes that have it."""

    @property
    def name(self) -> str: ...
    @property
    def nodes(self) -> frozenset[str]: ...


_N = TypeVar("_N", bound=_Named)


def _shown(graph: LiveGraph, kind: str, known: Iterable[_N], now: float) -> list[_N]:
    """Return what is shown of a kind, what others have besides behind."""
    there = [each for each in known if not graph.is_past(f"{kind} {each.name}", each.nodes, now)]
    return sorted(there, key=lambda each: not graph.is_own(each.nodes))


def _topics(graph: LiveGraph, unfolded: AbstractSet[str], now: float) -> Iterator[LiveRow]:
    for topic in _shown(graph, "topic", graph.topics.values(), now):
        key = f"{graph.ros_version} topic {topic.name}"
        is_open = key in unfolded
        value, tone = _topic_value(topic, has_ended=graph.has_ended)
        is_old = graph.has_ended or not graph.is_watched
        is_foreign = not graph.is_own(topic.nodes)
        sending = graph.sendings.get(topic.name)
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
            is_sent_to=sending is not None and not sending.problem,
            is_foreign=is_foreign,
            is_old=is_old,
        )
        if sending is not None:
            words = f"sending at {sending.rate:g} hz: {one_line(sending.text) or 'no values'}"
            if sending.problem:
                words = f"not sent any more: {one_line(sending.problem)}"
            yield LiveRow(
                f"{key} sending",
                Kind.SENDING,
                "⚠" if sending.problem else "▶",
                topic.name,
                graph.ros_version,
                topic.type,
                value=words,
                tone="warning" if sending.problem else "success",
                depth=1,
                is_sent_to=not sending.problem,
            )
        if is_open:
            yield from _fields(key, topic, graph.ros_version, is_foreign=is_foreign)


def _fields(key: str, topic: LiveTopic, version: int, *, is_foreign: bool) -> Iterator[LiveRow]:
    # The type has no column in a narrow panel.
    ends = f"{counted(topic.publishers, 'publisher')}, {counted(topic.subscribers, 'subscriber')}"
    about = _with_foreign(f"{visible(topic.type)}, {ends}", is_foreign=is_foreign)
    yield LiveRow(f"{key} about", Kind.NOTE, about, topic.name, version, depth=1, tone="quiet")
    yield from end_rows(key, topic, version)
    for path, text in topic.fields:
        yield LiveRow(
            f"{key} field {path}",
            Kind.FIELD,
            visible(path),
            topic.name,
            version,
            value=one_line(text),
            samples=tuple(topic.field_samples.get(path, ())),
            depth=1,
        )


def said_now(topic: LiveTopic) -> str:
    """Return how often a message comes, and what is in the last one; "" before the first."""
    return ", ".join(filter(None, (_rate(topic), one_line(topic.text)))) if topic.text else ""


def _rate(topic: LiveTopic) -> str:
    if topic.is_gone:
        return "gone"
    if topic.rate >= 1000:
        return f"{topic.rate / 1000:.1f} kHz"
    if topic.rate > 0:
        return f"{topic.rate:.1f} Hz"
    return "" if topic.count < 2 else "silent"


def _topic_value(topic: LiveTopic, *, has_ended: bool) -> tuple[str, str]:
    """Return the last message, or what there is to say before it, and its tone."""
    if topic.text:
        is_quiet = topic.is_gone or (topic.rate == 0 and topic.count >= 2)
        return one_line(topic.text), "quiet" if is_quiet else ""
    if topic.is_gone or has_ended:
        return "", "quiet"
    return (WAITING if topic.publishers else NOBODY), "quiet"


def _services(graph: LiveGraph, answers: Mapping[str, Answer], now: float) -> Iterator[LiveRow]:
    for service in _shown(graph, "service", graph.services.values(), now):
        key = f"{graph.ros_version} service {service.name}"
        is_foreign = not graph.is_own(service.nodes)
        yield LiveRow(
            key,
            Kind.SERVICE,
            visible(service.name),
            service.name,
            graph.ros_version,
            service.type,
            value="gone"
            if service.is_gone
            else _with_foreign(visible(service.type), is_foreign=is_foreign),
            tone="quiet",
            is_foreign=is_foreign,
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
                value=one_line(answer.text),
                tone="error" if answer.is_failure else "",
                depth=1,
            )


def _actions(graph: LiveGraph, now: float) -> Iterator[LiveRow]:
    for action in _shown(graph, "action", graph.actions.values(), now):
        key = f"{graph.ros_version} action {action.name}"
        goals = [each for each in graph.goals.values() if each.action == action.name]
        is_foreign = not graph.is_own(action.nodes)
        yield LiveRow(
            key,
            Kind.ACTION,
            visible(action.name),
            action.name,
            graph.ros_version,
            action.type,
            value=_with_foreign(_action_value(action), is_foreign=is_foreign),
            tone="quiet",
            goal=next((each.number for each in reversed(goals) if not each.is_over), 0),
            is_foreign=is_foreign,
        )
        over = [each.number for each in goals if each.is_over][:-_MOST_GOALS]
        for goal in goals:
            if goal.number not in over:
                yield _goal(key, action, goal, graph.ros_version)


def _action_value(action: LiveAction) -> str:
    if action.is_gone:
        return "gone"
    type_ = visible(action.type)
    return type_ if action.servers else f"{type_}, {UNSERVED}"


def _goal(key: str, action: LiveAction, goal: LiveGoal, version: int) -> LiveRow:
    sign, tone = ("–" if goal.is_over else "▶"), ("" if goal.is_over else "success")
    if goal.state == "succeeded":
        sign = "✓"
    if goal.is_failure:
        sign, tone = "✗", "error"
    text = f", {one_line(goal.text)}" if goal.text else ""
    return LiveRow(
        f"{key} goal {goal.number}",
        Kind.GOAL,
        sign,
        action.name,
        version,
        action.type,
        value=f"{one_line(goal.sent) or 'no values'} → {visible(goal.state)}{text}",
        tone=tone,
        depth=1,
        goal=0 if goal.is_over else goal.number,
    )


def _with_foreign(text: str, *, is_foreign: bool) -> str:
    return f"{text}, {FOREIGN}" if is_foreign else text


def _nodes(graph: LiveGraph, unfolded: AbstractSet[str], now: float) -> Iterator[LiveRow]:
    nodes = sorted(graph.nodes.items(), key=lambda each: not graph.is_own([each[0]]))
    for name, is_there in nodes:
        if graph.is_past(f"node {name}", [name], now):
            continue
        is_foreign = not graph.is_own([name])
        key = f"{graph.ros_version} node {name}"
        end = graph.ended.get(name)
        runs = is_there and end is None and not graph.has_ended
        found = graph.parameters.get(name)
        # Of one that was stopped the last values stay.
        is_branch = runs or (graph.has_ended and found is not None)
        is_open = key in unfolded and is_branch
        value, tone = _node_state(end, is_there=is_there, has_ended=graph.has_ended)
        if is_foreign:
            value, tone = FOREIGN if is_there or graph.has_ended else f"gone, {FOREIGN}", "quiet"
        yield LiveRow(
            key,
            Kind.NODE,
            visible(name),
            name,
            graph.ros_version,
            value=value,
            tone=tone,
            is_branch=is_branch,
            is_open=is_open,
            is_foreign=is_foreign,
            is_old=not graph.is_watched or not runs,
        )
        if not is_open:
            continue
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
        yield from doing_rows(key, name, graph)


def _node_state(end: NodeEnd | None, *, is_there: bool, has_ended: bool) -> tuple[str, str]:
    """Return what there is to say of a node, and its tone: what nobody wanted is loud."""
    if end is not None:
        words = f"{end.how}: {end.said}" if end.said else end.how
        return one_line(words), "error" if end.is_failure else "quiet"
    if has_ended:
        return "ended", "quiet"
    return ("", "quiet") if is_there else ("gone", "warning")


def _parameter_value(parameter: LiveParameter) -> str:
    value = parameter.value
    shown = _list(value) if isinstance(value, tuple) else str(value)[: WIDEST + 1]
    limits = parameter.range
    parts = [shown if value is not None else "not set"]
    if limits is not None:
        parts.append(f"{limits[0]:g}…{limits[1]:g}")
    if parameter.is_read_only:
        parts.append("cannot be set")
    if parameter.about:
        parts.append(parameter.about)
    return one_line("  ".join(parts))


def _list(values: tuple[object, ...]) -> str:
    """Return a list as text, as much of it as a line may show."""
    more = ", …" if len(values) > WIDEST else ""
    return f"[{', '.join(str(each)[:WIDEST] for each in values[:WIDEST])}{more}]"
