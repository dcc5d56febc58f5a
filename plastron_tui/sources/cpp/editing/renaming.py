"""Giving endpoints of a unit other names: the texts that decide them say the new ones."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from tree_sitter import Node

from plastron_tui.model.source import Rename
from plastron_tui.ros.names import name_as_read, name_as_written

from .. import literals
from ..analysis import Analysis, Site
from ..scopes import Scope, scope_at
from .origins import SAME, Origin, name_argument, origin_of
from .plans import Plan
from .refusals import RefusedError, not_there, refuse_parts
from .statements import is_inside
from .units import key_of, labels_of, sites_of
from .uses import uses_of, word

_WRITTEN = {
    "assignment_expression": "left",
    "init_declarator": "declarator",
    "field_initializer": "",
}
_TELLING = ("LOG", "INFO", "WARN", "ERROR", "DEBUG", "FATAL", "print", "cout", "cerr")


def plan_renames(analysis: Analysis, changes: Sequence[Rename]) -> Plan:
    """Plan renames, all at once.

    Raises:
        RefusedError: one cannot be made.
    """
    plan = Plan()
    labels = labels_of(analysis)
    wanted: dict[Site, Rename] = {}
    for change in changes:
        sites = sites_of(analysis, change)
        if not sites:
            raise not_there(analysis, change)
        refuse_parts(change, sites)
        wanted.update(dict.fromkeys(sites, change))
    written: dict[tuple[str, int, int], str] = {}
    for site, change in wanted.items():
        origin = _origin(analysis, site, change, wanted)
        text = _new_text(analysis, site, change, origin)
        place = origin.file.name, origin.start, origin.end
        if written.setdefault(place, text) != text:
            raise _not_alone(site, change)
        plan.lost.append(site)
        kind, _, type_, callback = key_of(site.endpoint)
        plan.added.append((labels.get(site, ""), (kind, change.to, type_, callback)))
    for (name, start, end), text in written.items():
        file = next(each for each in analysis.unit.files if each.name == name)
        plan.replace(file, start, end, text)
    return plan


def _origin(analysis: Analysis, site: Site, change: Rename, wanted: dict[Site, Rename]) -> Origin:
    """Return the text to change: what decides the name, or the argument of the call itself."""
    found = origin_of(analysis, site)
    if found is not None and not found.file.is_beside and not _is_shared(found):
        same = [each for each, other in wanted.items() if other.to == change.to]
        if all(_serves(analysis, uses, same, found) for uses in _uses(analysis, found)):
            return found
    given = name_argument(site)
    is_alone = sum(each.call is site.call for each in analysis.sites) == 1
    if given is None or site.endpoint.name is None or site.bindings or not is_alone:
        raise _not_alone(site, change)
    if depends_on_parameter(analysis, given, site.place):
        raise _not_alone(site, change)
    return Origin(site.file, given.start_byte, given.end_byte)


def _is_shared(origin: Origin) -> bool:
    """Tell whether a text is a constant of a header that other nodes may include as well."""
    name = origin.file.name
    if not name or "{}" in name:
        return False
    defines = origin.file.syntax.defines
    is_macro = any(each.start <= origin.start < each.end for each in defines)
    return is_macro or (bool(origin.variables) and origin.variables[-1].kind == "global")


def depends_on_parameter(analysis: Analysis, node: Node, scope: Scope) -> bool:
    """Tell whether callers of a function decide what an expression is."""
    stack = [node]
    while stack:
        each = stack.pop()
        stack += each.named_children
        if each.type == "identifier":
            name = scope.file.syntax.word(each)
            found = analysis.unit.lookup(name, scope, each.start_byte)
            if found is not None and found.kind in ("parameter", "loop"):
                return True
    return False


def _uses(analysis: Analysis, origin: Origin) -> Iterable[list[tuple[Node, Scope]]]:
    for variable in origin.variables:
        yield [(node, scope) for _, node, scope in uses_of(analysis, variable)]
    for define in origin.file.syntax.defines:
        if define.start <= origin.start < define.end:
            yield list(_macro_uses(analysis, define.name))


def _macro_uses(analysis: Analysis, name: str) -> Iterator[tuple[Node, Scope]]:
    for file in analysis.unit.files:
        for found in word(name).finditer(file.syntax.code):
            node = file.syntax.root.named_descendant_for_byte_range(*found.span())
            if node is not None:
                yield node, scope_at(file, found.start())


def _serves(
    analysis: Analysis, uses: Sequence[tuple[Node, Scope]], sites: Sequence[Site], origin: Origin
) -> bool:
    """Tell whether uses of a variable name endpoints that are renamed alike, or only tell them."""
    for node, scope in uses:
        if any(site.file is scope.file and is_inside(node, name_argument(site)) for site in sites):
            continue
        if any(
            site.file is scope.file and is_inside(node, name_argument(site))
            for site in analysis.sites
        ):
            return False
        if not _only_tells(analysis, node, scope, origin):
            return False
    return True


def _only_tells(analysis: Analysis, node: Node, scope: Scope, origin: Origin) -> bool:
    """Tell whether a use hands a text on to a variable that decides the name as well, or logs it.

    So does what writes such a variable.
    """
    syntax = scope.file.syntax
    names = {each.name for each in origin.variables}
    inner: Node | None = node
    for _ in range(12):
        if inner is None:
            return False
        outer = _WRITTEN.get(inner.type)
        if outer is not None:
            target = inner.child_by_field_name(outer) if outer else inner.named_children[0]
            text = "" if target is None else syntax.word(target)
            return re.split(r"->|\.", text)[-1].lstrip("*&") in names
        if inner.type == "call_expression":
            called = inner.child_by_field_name("function")
            name = "" if called is None else syntax.word(called)
            if any(each in name for each in _TELLING) or "param" in name:
                return True
            if _hands_on(analysis, inner, node, origin):
                return True
            if re.split(r"::|\.|->", name)[-1] not in SAME:
                return False
        if inner.type.endswith("statement"):
            text = syntax.word(inner).lstrip()
            return text.startswith(("std::cout", "std::cerr", "cout", "cerr"))
        inner = inner.parent
    return False


def _hands_on(analysis: Analysis, call: Node, node: Node, origin: Origin) -> bool:
    """Tell whether a call gives a text to a parameter that decides the name as well."""
    for variable in origin.variables:
        function = variable.scope.function if variable.kind == "parameter" else None
        if function is None:
            continue
        position = next((at for at, each in enumerate(function.parameters) if each is variable), 0)
        for caller in analysis.callers.of(function):
            if caller.node.id == call.id and is_inside(node, caller.argument(position)):
                return True
    return False


def _new_text(analysis: Analysis, site: Site, change: Rename, origin: Origin) -> str:
    """Return the literal that says a new name, in the namespace that the call adds to it."""
    version = analysis.ros_version
    known = site.endpoint.name or site.endpoint.default or ""
    text = origin.file.syntax.between(origin.start, origin.end)
    said = literals.string_value(text)
    if said is None:
        return literals.quoted(name_as_written(change.to, version))
    prefix = ""
    if known not in (said, name_as_read(said, version)):
        if not known.endswith(said):
            raise _not_alone(site, change)
        prefix = known[: len(known) - len(said)]
    if not change.to.startswith(prefix):
        message = f"line {site.endpoint.line} puts the name into `{prefix.rstrip('/')}`"
        raise RefusedError(message, change.span, f"give it a name that begins with `{prefix}`")
    bare = change.to[len(prefix) :]
    return literals.quoted(bare if prefix else name_as_written(bare, version))


def _not_alone(site: Site, change: Rename) -> RefusedError:
    endpoint = site.endpoint
    kind, line = endpoint.kind.word, endpoint.line
    message = f"line {line} does not say the name of the {kind} `{change.name}` itself"
    return RefusedError(message, change.span, f"change by hand what `{endpoint.expression}` is")
