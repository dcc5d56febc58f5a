"""Giving endpoints other names, where the file says the names they have."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.names import name_as_written

from .analysis import Analysis, Site
from .constants import Known
from .conventions import conventions_of
from .imports import unused_imports
from .name_uses import NameUses
from .parameter_calls import item_of
from .references import identifiers, is_member
from .removal import waits
from .runs import EVERYWHERE
from .scopes import BindingKind, Scope
from .splices import Splice, apply, delete_statements
from .syntax import parts_of
from .told_names import retell
from .unused_locals import unused_locals

# What stands in a string as it is, whatever its quotes and its prefix.
_PLAIN = re.compile(r"[A-Za-z0-9_/~.\-]+")


class NotNamedError(Exception):
    """A call site whose name the file decides in a way that no edit can follow."""

    def __init__(self, site: Site) -> None:
        super().__init__()
        self.site = site


class Renaming(NamedTuple):
    """Other names on their way into a file.

    Attributes:
        splices: what writes them.
        lost: the call sites that a reader no longer finds as they were.
        names: what a reader finds as the name of each instead.
    """

    splices: list[Splice]
    lost: list[Site]
    names: list[str]


@dataclass(frozen=True, slots=True)
class _Said:
    """An expression that gives a call site its name, or one that waits for it.

    Attributes:
        site: the call site.
        node: the expression.
        new: the name that it is to give.
        is_own: whether the expression may say the name itself instead: no parameter, of the node
            or of a function, decides it.
        literals: the strings that decide it.
        handed: the variables that hand it on, where they do so.
        calls: the calls that give it.
        items: what takes it out of a list or a dictionary.
    """

    site: Site
    node: Node
    new: str
    is_own: bool
    literals: tuple[Node, ...]
    handed: tuple[Node, ...]
    calls: tuple[Node, ...]
    items: tuple[Node, ...]


def plan_names(analysis: Analysis, wanted: Mapping[Site, str]) -> Renaming:
    """Plan other names for call sites.

    The strings that decide a name are changed where nothing else of the file uses them, but to tell
    them; elsewhere the call says the new name itself. Logs that spell the name out say the new one.

    Raises:
        NotNamedError: a name comes from a parameter, and its default serves others as well.
    """
    waiting = waits(analysis, wanted)
    said: list[_Said] = []
    for site, new in wanted.items():
        is_client = site.endpoint.kind is EndpointKind.CLIENT
        waits_for = waiting.get(site.endpoint.name, []) if is_client else []
        said += _said(analysis, site, new, [node for _, node in waits_for])
    own = _deciding_alone(analysis, said)
    texts: dict[tuple[int, int], bytes] = {}
    for each in said:
        is_literal = each in own
        if not is_literal and not each.is_own:
            raise NotNamedError(each.site)
        for node in each.literals if is_literal else (_source(analysis, each.node),):
            texts[node.start_byte, node.end_byte] = _written(analysis, node, each.new, is_literal)
    splices = [Splice(start, end, text) for (start, end), text in texts.items()]
    unused = _unused(analysis, [each for each in splices if not _is_string(analysis, each)])
    names = [_found_as(analysis, site, new, splices) for site, new in wanted.items()]
    literals = {literal.id for each in said for literal in (*each.literals, each.node)}
    told = retell(analysis, wanted, literals)
    ends = [(each.start, each.end) for each in unused]
    splices += [each for each in told if not any(start <= each.start < end for start, end in ends)]
    return Renaming([*splices, *unused], list(wanted), names)


def _is_string(analysis: Analysis, splice: Splice) -> bool:
    node = analysis.syntax.root.descendant_for_byte_range(splice.start, splice.end)
    return node is not None and node.type == "string"


def _unused(analysis: Analysis, replaced: Sequence[Splice]) -> list[Splice]:
    """Return what takes out the variables and the imports that only gave the old names."""
    unused = unused_locals(analysis, replaced)
    gone = delete_statements(analysis.syntax.text, unused.statements) + unused.splices
    imports, names = unused_imports(analysis, [*replaced, *gone])
    statements = [*unused.statements, *imports]
    return delete_statements(analysis.syntax.text, statements) + unused.splices + names


def _said(analysis: Analysis, site: Site, new: str, waiting: Sequence[Node]) -> Iterable[_Said]:
    given = site.arguments.get(site.shape.name)
    if (item := item_of(analysis, site)) is not None:
        given = parts_of(item)[0]
        folded = analysis.resolver.fold(given, site.scope)
        # A namespace of the list stands before it.
        if folded is not None and folded.value != site.endpoint.name:
            raise NotNamedError(site)
    places = [(given, site.scope)]
    # A node that waited for a service of the old name would wait for ever.
    places += [(node, analysis.scopes.at(node.start_byte)) for node in waiting]
    for node, scope in places:
        if node is None:
            raise NotNamedError(site)
        for world in site.passes or (EVERYWHERE,):
            with analysis.resolver.during(world):
                yield _traced(analysis, site, new, node, scope)


def _traced(analysis: Analysis, site: Site, new: str, node: Node, scope: Scope) -> _Said:
    folded = analysis.resolver.fold(node, scope)
    if folded is None or not isinstance(folded.value, str):
        raise NotNamedError(site)
    read = {each.id: each for each in analysis.resolver.read_for(node, scope)}.values()
    strings = [each for each in read if each.type == "string"]
    literals = tuple(each for each in strings if _content(analysis, each) == folded.value)
    is_given = any(_is_variable(each) and _is_parameter(analysis, each) for each in read)
    handing = [each for each in read if _gives(analysis, each, literals)]
    return _Said(
        site,
        node,
        new,
        isinstance(folded, Known) and not is_given and not site.passes,
        literals,
        tuple(each for each in handing if _is_variable(each)),
        tuple(each for each in handing if each.type == "call"),
        tuple(each for each in handing if each.type == "subscript"),
    )


def _gives(analysis: Analysis, node: Node, literals: Sequence[Node]) -> bool:
    """Whether one of some strings decides an expression, and is not beside it in a text."""
    scope = analysis.scopes.at(node.start_byte)
    decided = {each.id for each in analysis.resolver.read_for(node, scope)}
    return any(each.id in decided for each in literals)


def _is_variable(node: Node) -> bool:
    """Whether an expression that was read is a variable, and not the value of a parameter."""
    holder = node.child_by_field_name("object")
    return node.type == "identifier" or (
        node.type == "attribute" and holder is not None and holder.type != "call"
    )


def _is_parameter(analysis: Analysis, node: Node) -> bool:
    found = analysis.scopes.at(node.start_byte).lookup(analysis.syntax.slice(node))
    return found is not None and any(b.kind is BindingKind.PARAMETER for b in found[1])


def _deciding_alone(analysis: Analysis, said: Sequence[_Said]) -> list[_Said]:
    """Return those whose strings give nothing else its name, nor another one to each other."""
    names: dict[int, set[str]] = defaultdict(set)
    for each in said:
        for literal in each.literals:
            names[literal.id].add(each.new)
    read = {
        node.id
        for each in said
        for node in (each.node, *each.literals, *each.handed, *each.calls, *each.items)
    }
    return [
        each
        for each in said
        if each.literals
        and all(len(names[literal.id]) == 1 for literal in each.literals)
        and _serves_only(NameUses(analysis, read), each)
    ]


def _serves_only(uses: NameUses, said: _Said) -> bool:
    """Whether what decides a name harms nothing else of the file with another one."""
    return (
        all(uses.is_handed_alone(each) for each in said.handed)
        and all(uses.is_given_alone(call) for call in said.calls)
        and all(uses.is_held_alone(literal) for literal in said.literals)
    )


def _source(analysis: Analysis, node: Node) -> Node:
    """Return the expression that gives a name, behind a variable that nothing else reads."""
    while node.type == "identifier":
        name = analysis.syntax.slice(node)
        found = analysis.scopes.at(node.start_byte).lookup(name)
        uses = [each for each in identifiers(name, analysis) if not is_member(each)]
        if found is None or len(found[1]) != 1 or len(uses) != 2:
            break
        left = found[1][0].node.child_by_field_name("left")
        if left is None or left.type != "identifier" or found[1][0].value is None:
            break
        node = found[1][0].value
    return node


def _content(analysis: Analysis, string: Node) -> str | None:
    if string.child_count < 2 or any(child.type == "interpolation" for child in string.children):
        return None
    return analysis.syntax.between(string.children[0].end_byte, string.children[-1].start_byte)


def _written(analysis: Analysis, node: Node, new: str, is_literal: bool) -> bytes:
    """Return an expression with the new name; the quotes of a literal stay."""
    new = name_as_written(new, analysis.library.ros_version)
    encode, between = analysis.syntax.encode, analysis.syntax.between
    if is_literal and _PLAIN.fullmatch(new):
        start, end = node.children[0], node.children[-1]
        opening = between(node.start_byte, start.end_byte)
        return encode(f"{opening}{new}{between(end.start_byte, node.end_byte)}")
    return encode(conventions_of(analysis).string(new))


def _found_as(analysis: Analysis, site: Site, new: str, splices: list[Splice]) -> str:
    """Return what a reader finds as the name: the expression, where a default is in it."""
    given = site.arguments.get(site.shape.name)
    if site.endpoint.name is not None or given is None:
        return new
    syntax = analysis.syntax
    inside = [
        Splice(each.start - given.start_byte, each.end - given.start_byte, each.text)
        for each in splices
        if given.start_byte <= each.start and each.end <= given.end_byte
    ]
    text = syntax.text[given.start_byte : given.end_byte]
    return apply(text, inside).decode(syntax.encoding)
