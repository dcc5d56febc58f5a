"""What a callback says of the type of its messages, which is to be another one."""

from __future__ import annotations

import re
from collections.abc import Iterator

from tree_sitter import Node

from plastron_tui.ros.interfaces import Interface, InterfaceName

from .analysis import Analysis
from .functions import callback_scope
from .generated import body_of
from .log_uses import is_only_told
from .references import Variable, references
from .replacing import Replacement
from .scopes import BindingKind, Scope
from .splices import Splice

# What takes anything.
_KEEPING = frozenset(
    {"append", "appendleft", "deepcopy", "id", "isinstance", "len", "print", "put", "put_nowait"}
    | {"repr", "set_result", "str", "type"}
)
_NAMES = frozenset({"attribute", "identifier"})


def retype_callback(update: Replacement, interface: Interface) -> None:
    """Let a callback say another type of what it is called with.

    That are the annotations, the type comment and the docstring of a function that calls of no
    other endpoint name.
    """
    analysis, old = update.analysis, update.site.endpoint.type
    function = callback_scope(analysis, update.site)
    if function is None or old is None or _serves_others(update, function):
        return
    for node in _annotated(analysis, function, old):
        text = update.added.messages.type_class(interface)
        if node.type == "string":
            text = re.sub(_word(old), text, analysis.syntax.slice(node))
        update.put(node, text)
    update.splices += _documented(analysis, function, old, interface.name)


def needs_type(update: Replacement, interface: Interface) -> bool:
    """Whether a callback cannot do with messages of another type.

    It uses fields that they have not, or hands a message to what may look into it.
    """
    if missing_fields(update, interface):
        return True
    analysis, function = update.analysis, _taker(update)
    name = _message(function) if function is not None else ""
    if function is None or not name:
        return False
    return any(
        _is_handed_on(analysis, reference.node)
        for reference in references(Variable(function, name, False), analysis)
    )


def _is_handed_on(analysis: Analysis, node: Node) -> bool:
    """Whether a message is an argument of a call that does more than to tell or to keep it."""
    arguments = node.parent
    if arguments is not None and arguments.type == "keyword_argument":
        arguments = arguments.parent
    call = arguments.parent if arguments is not None else None
    if call is None or call.type != "call" or is_only_told(analysis, node):
        return False
    return analysis.syntax.called_name(call) not in _KEEPING


def missing_fields(update: Replacement, interface: Interface) -> list[str]:
    """Return the fields that a callback uses of its messages, and their new type has not."""
    analysis, function = update.analysis, _taker(update)
    name = _message(function) if function is not None else ""
    if function is None or not name or not interface.fields:
        return []
    slice_ = analysis.syntax.slice
    used: dict[str, None] = {}
    for reference in references(Variable(function, name, False), analysis):
        attribute = reference.node.parent
        field = attribute.child_by_field_name("attribute") if attribute is not None else None
        user = attribute.parent if attribute is not None else None
        if field is not None and user is not None and user.type != "call":
            used[slice_(field)] = None
    has = {field.name for field in interface.fields}
    return [each for each in used if each not in has and not each.startswith("_")]


def _taker(update: Replacement) -> Scope | None:
    """Return the function of the file, or the lambda, that an endpoint calls."""
    analysis, site = update.analysis, update.site
    given = site.arguments.get(site.shape.callback) if site.shape.callback is not None else None
    if given is None or given.type != "lambda":
        return callback_scope(analysis, site)
    return next((each for each in analysis.scopes.all if each.node.id == given.id), None)


def _serves_others(update: Replacement, function: Scope) -> bool:
    """Whether another endpoint calls a function as well."""
    return any(
        site is not update.site and callback_scope(update.analysis, site) is function
        for site in update.analysis.sites
    )


def _message(function: Scope) -> str:
    """Return the name of the parameter that gets the messages; "" where none is sure to."""
    names = [
        name
        for name, bindings in function.bindings.items()
        if name != function.self_name
        and bindings[0].kind is BindingKind.PARAMETER
        and bindings[0].value is None
    ]
    return names[0] if len(names) == 1 else ""


def _annotated(analysis: Analysis, function: Scope, old: InterfaceName) -> Iterator[Node]:
    """Yield what names a type, or has the requests and the responses of one, in a signature."""
    fields = ("parameters", "return_type")
    pending = [each for name in fields if (each := function.node.child_by_field_name(name))]
    while pending:
        node = pending.pop(0)
        scope = function.parent or function
        is_name = node.type in _NAMES and analysis.resolver.interface(node, scope) == old
        is_quoted = node.type == "string" and re.search(_word(old), analysis.syntax.slice(node))
        if is_name or is_quoted:
            yield node
        elif node.type != "identifier":
            pending += node.named_children


def _word(name: InterfaceName) -> str:
    return rf"(?<![\w.]){re.escape(name.name)}\b"


def _documented(
    analysis: Analysis, function: Scope, old: InterfaceName, new: InterfaceName
) -> Iterator[Splice]:
    """Yield what changes in `# type: (String) -> None` and in `:type msg: std_msgs.msg.String`."""
    block, body = function.node.child_by_field_name("body"), body_of(function)
    if block is None:
        return
    syntax, name = analysis.syntax, re.escape(old.name)
    package = rf"(?:\b({re.escape(old.package)})(?:\.msg\.|/))?"
    start, first = function.node.start_byte, block.start_byte
    text = syntax.between(start, body[0].start_byte if body else block.end_byte)
    patterns = [rf"#\s*type:\s*\([^()\n]*?{package}\b({name})\b"]
    if message := _message(function):
        patterns.append(rf"(?<!\w){message}(?:\s*:|\s\()\s*{package}\b({name})\b")
    for found in (each for pattern in patterns for each in re.finditer(pattern, text)):
        for group, written in ((1, new.package), (2, new.name)):
            at = start + len(syntax.encode(text[: found.start(group)]))
            if found[group] is not None and (at >= first or found[0].startswith("#")):
                end = at + len(syntax.encode(found[group]))
                yield Splice(at, end, syntax.encode(written))
