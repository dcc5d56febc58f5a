"""Which card is shown for the word at a place of a program."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.language import SlotKind
from plastron_tui.language.expectations import Expectation, expected_at
from plastron_tui.language.keywords import BY_KEYWORD, WORDS
from plastron_tui.language.sentence_errors import SENTENCE_IS
from plastron_tui.model.kinds import INTERFACES, Parameter
from plastron_tui.ros.interfaces import InterfaceKind
from plastron_tui.targets import LIBRARIES

from ..editor.card import Card, CardRow
from ..editor.highlights import LONGEST
from . import nodes, other, robots, types
from .known import Known

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Node

_HUBS = {
    SlotKind.TOPIC: InterfaceKind.MESSAGE,
    SlotKind.TRIGGER: InterfaceKind.MESSAGE,
    SlotKind.SERVICE: InterfaceKind.SERVICE,
    SlotKind.ACTION: InterfaceKind.ACTION,
}
_PARTS = (SlotKind.LINK, SlotKind.JOINT, SlotKind.FOLLOWED)
_VALUES = (SlotKind.INPUT, SlotKind.ANSWER)


def card_at(known: Known, offset: int) -> Card | None:
    """Return what is said about the word at an offset, None where there is nothing to say.

    The word is that of the text as it is; what it means may be that of an older text. What is
    wrong with it comes first.
    """
    place = _place(known, offset)
    if place is None:
        return None
    card, span = _card_of(*place, known), place[0].span
    wrong = tuple(_problem_rows(known.diagnostics, span))
    if not wrong:
        return card
    if card is None:
        return Card(span, place[1], "", wrong)
    return replace(card, rows=(*wrong, *card.rows))


def _problem_rows(diagnostics: Iterable[Diagnostic], span: Span) -> Iterator[CardRow]:
    """Yield what is wrong with a word, and what mends it."""
    for found in diagnostics:
        if (
            found.file is None
            and found.span is not None
            and span.start <= found.span.start < span.end
        ):
            yield CardRow(found.message, is_warning=True)
            # How the statement is written stands below the text, and in the statement's own card.
            if found.help is not None and not found.help.startswith(SENTENCE_IS):
                yield CardRow(found.help)


def _card_of(expected: Expectation, word: str, known: Known) -> Card | None:
    span, slot = expected.span, expected.slot
    kind = None if slot is None else slot.kind
    name = word.strip("'")
    is_variable = kind is not None and kind.is_variable
    found = _variable_card(span, word, known) if is_variable else None
    if found is not None:
        return found
    # What is called as a word of the language is, such as `all`, was found already.
    if word in WORDS:
        found = _statement_card(expected, word)
    elif kind in INTERFACES:
        found = _type_card(span, word, INTERFACES[kind], known, expected.filled.get("node", ""))
    elif kind in _PARTS:
        found = _part_card(
            span, name, kind is SlotKind.LINK, expected.filled.get("robot", ""), known
        )
    elif word[:1] == "'":
        found = _name_card(expected, name, known)
    elif kind is SlotKind.FILE:
        found = _variable_card(span, name, known)
    elif kind is SlotKind.LIBRARY and word in LIBRARIES:
        found = Card(span, word, "client library", tuple(other.library_rows(LIBRARIES[word])))
    elif kind in _VALUES:
        found = _values_card(expected, known)
    return found or _statement_card(expected, word)


def _place(known: Known, offset: int) -> tuple[Expectation, str] | None:
    """Return what is expected where a word is, and the word; None between words."""
    document = known.session.document
    text = document.text
    start = text.rfind(b"\n", 0, offset) + 1
    end = text.find(b"\n", offset)
    end = len(text) if end < 0 else end
    if end - start > LONGEST:
        return None
    # A word is found from within: the one under the cursor comes before the one that ends there.
    for at in (offset + 1, offset, offset - 1):
        if start <= at <= end:
            expected = expected_at(document, at)
            span = expected.span
            if span.start < span.end and span.start <= offset <= span.end:
                return expected, text[span.start : span.end].decode("utf-8", "replace")
    return None


def _statement_card(expected: Expectation, word: str) -> Card | None:
    declaration = BY_KEYWORD.get(word, expected.declaration)
    if declaration is None:
        return None
    element = None if word in BY_KEYWORD else expected.element
    rows = tuple(other.statement_rows(declaration, element))
    return Card(expected.span, declaration.keyword, "statement", rows)


def _type_card(span: Span, word: str, kind: InterfaceKind, known: Known, node: str) -> Card | None:
    catalog = known.catalog(node)
    found = types.find_type(word, kind, catalog)
    if found is None:
        return None
    return Card(
        span, str(found.name), types.NOUNS[kind], tuple(types.type_rows(found, catalog, known))
    )


def _part_card(span: Span, name: str, is_link: bool, variable: str, known: Known) -> Card | None:
    robot = known.workspace.robots.get(variable)
    if robot is None:
        return None
    what = f"of {robot.name}"
    link, joint = robot.shown.links.get(name), robot.shown.joints.get(name)
    if is_link and link is not None:
        return Card(span, name, f"link {what}", tuple(robots.link_rows(link, robot)))
    if not is_link and joint is not None:
        return Card(span, name, f"joint {what}", tuple(robots.joint_rows(joint)))
    return None


def _name_card(expected: Expectation, name: str, known: Known) -> Card | None:
    """Return the card of what has its name in quotes."""
    span, kind = expected.span, None if expected.slot is None else expected.slot.kind
    node = known.workspace.nodes.get(expected.filled.get("node", ""))
    if kind in _HUBS:
        return _hub_card(span, name, _HUBS[kind], node, known)
    if kind is SlotKind.PARAMETER and node is not None:
        for written in (name, f"~/{name}"):
            parameter = node.of(Parameter).get(written)
            if parameter is not None:
                rows = tuple(other.parameter_rows(parameter, node.name))
                return Card(span, name, "parameter", rows)
        return None
    if kind in (SlotKind.OLD_NAME, SlotKind.NEW_NAME):
        for interface in _HUBS.values():
            if any(nodes.ends_at(nodes.hub_name(name, node), interface, known)):
                return _hub_card(span, name, interface, node, known)
        return None
    return _named_card(span, name, known)


def _hub_card(
    span: Span, written: str, interface: InterfaceKind, node: Node | None, known: Known
) -> Card | None:
    name = nodes.hub_name(written, node)
    rows = tuple(nodes.hub_rows(name, interface, known))
    return Card(span, name, nodes.noun(interface), rows) if written else None


def _named_card(span: Span, name: str, known: Known) -> Card | None:
    """Return the card of what a statement gives this name, or loads from a file of it."""
    workspace = known.workspace
    for variables in (workspace.nodes, workspace.packages, workspace.launches, workspace.robots):
        for variable, each in variables.items():
            path = getattr(each.source, "path", None)
            if name == each.name or (path is not None and path.name == name.rpartition("/")[2]):
                return _variable_card(span, variable, known)
    return None


def _variable_card(span: Span, word: str, known: Known) -> Card | None:
    """Return the card of what a variable stands for."""
    workspace = known.workspace
    if word in workspace.nodes:
        node = workspace.nodes[word]
        return Card(span, node.name, "node", tuple(nodes.node_rows(node, known)))
    if word in workspace.messages:
        rows = tuple(other.message_rows(workspace.messages[word], known))
        return Card(span, word, "message", rows)
    if word in workspace.robots:
        robot = workspace.robots[word]
        return Card(span, robot.name, "robot", tuple(robots.robot_rows(robot)))
    if word in workspace.packages:
        package = workspace.packages[word]
        return Card(span, package.name, "package", tuple(other.package_rows(package)))
    if word in workspace.launches:
        launch = workspace.launches[word]
        return Card(span, launch.name, "launch file", tuple(other.launch_rows(launch)))
    if word in workspace.types:
        return _type_card(span, word, workspace.types[word].kind, known, "")
    for node in workspace.nodes.values():
        if node.source is not None and node.source.path.stem == word:
            return Card(span, node.name, "node", tuple(nodes.node_rows(node, known)))
    return None


def _values_card(expected: Expectation, known: Known) -> Card | None:
    """Return the card of the type whose values are written."""
    filled = expected.filled
    for slot in () if expected.declaration is None else expected.declaration.slots:
        if slot.kind in INTERFACES and slot.name in filled:
            kind = INTERFACES[slot.kind]
            return _type_card(expected.span, filled[slot.name], kind, known, filled.get("node", ""))
    return None
