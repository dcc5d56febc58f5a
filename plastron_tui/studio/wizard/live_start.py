"""What a form for a running node begins with: its values, and the field that has the focus."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from plastron_tui.model.kinds import Publisher, Subscription
from plastron_tui.model.workspace import Workspace
from plastron_tui.ros.names import resolved_name
from plastron_tui.runtime.live_graph import LiveField

from .values import NUMBER, Entry, Heading, Path, first_value, pieces

_NOTHING = ("0", "0.0", "-0", "False", "[]")
"""Values that a field has by itself."""
_LISTED = re.compile(rf"{NUMBER.pattern}|[+-]?inf|nan", re.ASCII)

_CUT = re.compile(r"\d+ numbers\b", re.ASCII)
"""What a monitor says of a list that is too long to be shown."""


def first_values(form: Sequence[Entry | Heading], seen: Iterable[LiveField]) -> dict[Path, str]:
    """Return what a message that was never sent begins with.

    That is the last one that came, as far as it is known: of a text or a long list only the
    beginning is. Lists of numbers that are not known, and a message of which none came yet, have
    the values that the wizard suggests.
    """
    texts = {field.path: field.text for field in seen}
    found: dict[Path, str] = {}
    for entry in form:
        if isinstance(entry, Heading):
            continue
        text = texts.get(entry.name)
        taken = None if text is None else _entered(entry, text)
        is_cut = text is not None and _CUT.match(text) is not None
        value = first_value(entry) if is_cut or not texts else taken
        if value:
            found[entry.path] = value
    return found


def _entered(entry: Entry, text: str) -> str | None:
    """Return a value that came as it is entered, "" for what needs not be; None where it is cut."""
    if text in _NOTHING:
        return ""
    if entry.python not in (bool, int, float) or entry.is_time:
        return None
    if not entry.type.is_array:
        return text
    inner = text.removeprefix("[").removesuffix("]")
    is_whole = all(_LISTED.fullmatch(each) for each in pieces(inner))
    return inner if is_whole and inner != text else None


def conditioned_fields(workspace: Workspace, topic: str, type_: str) -> Iterator[Path]:
    """Yield the fields of a topic's messages that decide in a program whether something is sent.

    Args:
        workspace: what the program has built.
        topic: the topic's full name; its nodes may run in a namespace.
        type_: its type.
    """
    for node in workspace.nodes.values():
        heard = node.of(Subscription)
        for publisher in node.of(Publisher).values():
            for each in publisher.publications:
                if each.reaction is None or each.reaction.condition is None:
                    continue
                subscription = heard.get(each.reaction.topic)
                name = resolved_name(node.name, each.reaction.topic)
                if subscription and str(subscription.type) == type_ and topic.endswith(name):
                    yield each.reaction.condition.source.path


def start_of(form: Sequence[Entry | Heading], wanted: Iterable[Path]) -> Path | None:
    """Return the first of the wanted fields that is in a form, None for the form's first."""
    there = {entry.path for entry in form if isinstance(entry, Entry)}
    return next((path for path in wanted if path in there), None)
