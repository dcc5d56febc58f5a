"""What nothing needs any more once an endpoint is gone: callbacks and includes."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName
from plastron_tui.sources.splices import line_end, line_start

from .. import interface_types
from ..analysis import Analysis, Site
from ..scopes import CppFile, Function, Variable, statements_in
from .deletions import Deletions
from .lambdas import handed_functions, lambda_of
from .uses import hidden_uses, uses_of, word

_LOGS = re.compile(r"(?:ROS|NODELET|RCLCPP)_(?:INFO|DEBUG|WARN|ERROR)\w*\s*\(")
_VOID = re.compile(r"\(void\)\s*\w+|static_cast<void>\(\w+\)")
_PLACEHOLDER = re.compile(r"_[1-9]")
_KINDS = {
    EndpointKind.PUBLISHER: InterfaceKind.MESSAGE,
    EndpointKind.SUBSCRIPTION: InterfaceKind.MESSAGE,
    EndpointKind.SERVICE: InterfaceKind.SERVICE,
    EndpointKind.CLIENT: InterfaceKind.SERVICE,
    EndpointKind.ACTION_SERVER: InterfaceKind.ACTION,
    EndpointKind.ACTION_CLIENT: InterfaceKind.ACTION,
}

_ACTIONLIB = "actionlib/{}/simple_action_{}.h"
_DURATION = rb"\b\d[\d.']*(?:ns|us|ms|s|min|h)\b"
_BIND = re.compile(rb"\bboost::(?:placeholders|bind)\b|(?<![\w:])bind\s*\(")
_HEADERS = {
    _ACTIONLIB.format("client", "client"): re.compile(rb"\bSimple(?:Action)?Client"),
    _ACTIONLIB.format("server", "server"): re.compile(rb"\bSimpleActionServer\b"),
    "boost/bind.hpp": _BIND,
    "boost/bind/bind.hpp": _BIND,
    "chrono": re.compile(rb"\bchrono|" + _DURATION),
    "functional": re.compile(
        rb"\b(?:not_fn|mem_fn|function|invoke|c?ref|hash|less|greater|equal_to|plus|minus"
        rb"|multiplies|divides|modulus|negate|bit_\w+|logical_\w+|reference_wrapper)\b"
        rb"|\bbind|\bplaceholders\b"
    ),
    "memory": re.compile(
        rb"\b(?:make|allocate)_(?:shared|unique)\b|\b(?:shared|unique|weak)_ptr\b"
        rb"|\benable_shared_from_this\b|\b\w+_pointer_cast\b|\baddressof\b|\ballocator"
    ),
    "rcl_interfaces/msg/parameter_descriptor.hpp": re.compile(rb"\bParameterDescriptor\b"),
    "ros/callback_queue.h": re.compile(rb"\bCallbackQueue"),
    "rclcpp_action/rclcpp_action.hpp": re.compile(rb"\brclcpp_action\b"),
    "string": re.compile(
        rb"\b(?:w|u8|u16|u32|basic_)?string\b|\bto_w?string\b|\bsto(?:i|l|ll|ul|ull|f|d|ld)\b"
        rb"|\bgetline\b|\bchar_traits\b"
    ),
    "thread": re.compile(rb"\bthread\b|\bthis_thread\b"),
    "vector": re.compile(rb"\bvector\b"),
}
"""What a header is for, as far as it can tell: it goes with the last use of that."""


def functions_of(analysis: Analysis, site: Site) -> Iterator[list[Function]]:
    """Yield the functions that an endpoint calls, each with all its declarations."""
    owner = analysis.unit.class_of(site.call.scope)
    called = site.callback.functions or (*handed_functions(analysis, site, owner),)
    named = [each for each in called if not each.file.is_beside]
    if not named:
        return
    yield analysis.unit.with_declarations(named[0])


def take_held_lambdas(analysis: Analysis, lost: Sequence[Site], gone: Deletions) -> None:
    """Take out the local variables whose lambdas nothing calls any more, where they are stubs."""
    for site in lost:
        found = lambda_of(analysis, site)
        if found is None or found.variable is None or found.function is None:
            continue
        used = uses_of(analysis, found.variable)
        is_free = all(gone.covers(file, node.start_byte) for file, node, _ in used)
        if is_free and is_stub(found.function):
            gone.statement(found.variable.file, found.variable.node)


def has_uses(analysis: Analysis, functions: Sequence[Function], gone: Deletions) -> bool:
    """Tell whether anything that stays names a function, but for itself."""
    name = functions[0].name
    own = {(each.file.name, each.declarator.start_byte) for each in functions}
    bodies = [(each.file, each.node.start_byte, each.node.end_byte) for each in functions]
    pattern = re.compile(rb"(?<![A-Za-z0-9_])" + re.escape(name.encode()) + rb"(?!\w)")
    if any(hidden_uses(analysis, name, gone)):
        return True
    for file in analysis.unit.all_files:
        for found in pattern.finditer(file.syntax.code):
            if gone.covers(file, found.start()):
                continue
            node = file.syntax.root.named_descendant_for_byte_range(found.start(), found.end())
            if node is None or not node.type.endswith("identifier"):
                continue
            if any(each is file and start <= found.start() < end for each, start, end in bodies):
                continue
            if not _is_declarator(node, file, own):
                return True
    return False


def _is_declarator(node: Node, file: CppFile, own: set[tuple[str, int]]) -> bool:
    inner: Node | None = node
    for _ in range(4):
        if inner is None:
            return False
        if inner.type == "function_declarator":
            return (file.name, inner.start_byte) in own
        inner = inner.parent
    return False


def is_stub(function: Function) -> bool:
    """Tell whether a function does nothing but log, as a new one does."""
    return all(_is_log(each, function) for each in function.statements)


def is_idle(function: Function, gone: Deletions) -> bool:
    """Tell whether nothing is left of what a function did."""
    body = function.statements
    return bool(body) and all(gone.covers(function.file, each.start_byte) for each in body)


def _is_log(node: Node, of: Function | Variable) -> bool:
    text = of.file.syntax.word(node).strip().rstrip(";")
    is_answer = text in ("return true", "return")
    return is_answer or logs(text) or _VOID.fullmatch(text) is not None


def logs(text: str) -> bool:
    """Tell whether the text of a statement logs."""
    return _LOGS.match(text) is not None


def take_callbacks(analysis: Analysis, sites: Sequence[Site], gone: Deletions) -> None:
    """Take out the stubs that call sites called, where nothing else uses them."""
    for site in sites:
        for functions in functions_of(analysis, site):
            is_gone = all(gone.covers(each.file, each.node.start_byte) for each in functions)
            if is_gone or has_uses(analysis, functions, gone):
                continue
            if all(is_stub(each) for each in functions if each.scope is not None):
                for each in functions:
                    remove_function(each, gone)
        for variable in _given_lambdas(analysis, site):
            uses = uses_of(analysis, variable)
            if all(gone.covers(file, node.start_byte) for file, node, _ in uses):
                gone.statement(variable.file, variable.node)


def _given_lambdas(analysis: Analysis, site: Site) -> Iterator[Variable]:
    """Yield the local variables that hold a stub which a call gets."""
    for given in site.call.arguments:
        if given.type != "identifier":
            continue
        name = site.file.syntax.word(given)
        variable = analysis.unit.lookup(name, site.call.scope, given.start_byte)
        if variable is None or variable.kind != "local" or variable.value is None:
            continue
        if variable.value.type != "lambda_expression":
            continue
        body = variable.value.child_by_field_name("body")
        if all(_is_log(each, variable) for each in statements_in(body)):
            yield variable


def remove_function(function: Function, gone: Deletions) -> None:
    """Take out a definition or a declaration."""
    node = function.node
    if node.parent is not None and node.parent.type == "template_declaration":
        node = node.parent
    gone.statement(function.file, node)


def take_types(analysis: Analysis, sites: Sequence[Site], gone: Deletions) -> None:
    """Take out the names for types, and the includes of them, that nothing needs any more."""
    for type_, kind in dict.fromkeys(
        (site.endpoint.type, _KINDS.get(site.endpoint.kind)) for site in sites
    ):
        if type_ is None or kind is None:
            continue
        _take_aliases(analysis, type_.name, gone)
        if _is_named(analysis, type_.name, gone):
            continue
        for file in analysis.unit.files:
            # What a header includes, and does not need itself, may be for other sources.
            is_own = not file.name or any(
                gone.covers(file, found.start())
                for found in named(type_.name).finditer(gone.written(file))
            )
            text = file.syntax.text
            for include in file.syntax.includes if is_own else ():
                if include.path in headers_of(type_, kind, analysis.ros_version):
                    start = line_start(text, include.start)
                    gone.line(file, start, line_end(text, start))


def take_literals(analysis: Analysis, gone: Deletions) -> None:
    """Take out `using namespace std::chrono_literals;` where what had such literals goes."""
    for file in analysis.unit.files:
        nodes = [] if file.is_beside else _aliases(file)
        for node in nodes:
            if node.type != "using_declaration" or not _LITERALS.search(file.syntax.word(node)):
                continue
            if _only_in_gone(analysis, re.compile(_DURATION), gone):
                gone.statement(file, node)


_LITERALS = re.compile(r"namespace\s+std::(?:literals::)?chrono_literals")


def _only_in_gone(analysis: Analysis, pattern: re.Pattern[bytes], gone: Deletions) -> bool:
    """Tell whether all that a pattern finds goes, and that it finds something."""
    uses = [
        gone.covers(each, found.start())
        for each in analysis.unit.files
        for found in pattern.finditer(gone.written(each))
    ]
    return bool(uses) and all(uses)


def take_headers(analysis: Analysis, gone: Deletions) -> None:
    """Take out the includes of what only code that goes has used, such as `<chrono>`."""
    for file in analysis.unit.files:
        if file.is_beside:
            continue
        text = file.syntax.text
        for include in file.syntax.includes:
            pattern = _HEADERS.get(include.path)
            if pattern is not None and _only_in_gone(analysis, pattern, gone):
                start = line_start(text, include.start)
                gone.line(file, start, line_end(text, start))


def take_placeholders(analysis: Analysis, gone: Deletions) -> None:
    """Take out `using std::placeholders::_1;` where what said `_1` goes."""
    for file in analysis.unit.files:
        if file.is_beside:
            continue
        for node in _aliases(file):
            own = _alias_name(node, file)
            if not _PLACEHOLDER.fullmatch(own) or node.type != "using_declaration":
                continue
            was_said = any(
                gone.covers(each, found.start())
                for each in analysis.unit.all_files
                for found in word(own).finditer(each.syntax.code)
            )
            if was_said and not _is_said(analysis, own, file, node, gone):
                gone.statement(file, node)


def headers_of(type_: InterfaceName, kind: InterfaceKind, ros_version: int) -> set[str]:
    """Return the headers that define a type; in ROS 1 an action has several."""
    if kind is InterfaceKind.ACTION and ros_version == 1:
        parts = ("Action", "Goal", "Result", "Feedback")
        return {interface_types.header(type_, kind, 1, part) for part in parts}
    return {interface_types.header(type_, kind, ros_version)}


def _take_aliases(analysis: Analysis, name: str, gone: Deletions) -> None:
    """Take out `using T = a::msg::Name;` and its like where nothing that stays says `T`."""
    for file in analysis.unit.files:
        if file.is_beside:
            continue
        for node in _aliases(file):
            said = file.syntax.word(node).encode(file.syntax.encoding)
            if gone.covers(file, node.start_byte) or not named(name).search(said):
                continue
            own = _alias_name(node, file)
            if own and not _is_said(analysis, own, file, node, gone):
                gone.statement(file, node)


def _aliases(file: CppFile) -> Iterator[Node]:
    pending = [file.root.node]
    while pending:
        node = pending.pop()
        if node.type in ("alias_declaration", "using_declaration", "type_definition"):
            yield node
        elif node.type in _HOLDING:
            pending += node.named_children


_HOLDING = frozenset(
    {"translation_unit", "namespace_definition", "declaration_list", "class_specifier"}
    | {"struct_specifier", "field_declaration_list", "declaration", "field_declaration"}
)


def _alias_name(node: Node, file: CppFile) -> str:
    if node.type == "using_declaration":
        said = file.syntax.word(node)
        return "" if "namespace" in said else said.rstrip("; \t\n").rpartition("::")[2]
    field = "name" if node.type == "alias_declaration" else "declarator"
    name = node.child_by_field_name(field)
    return "" if name is None else file.syntax.word(name)


def _is_said(analysis: Analysis, name: str, file: CppFile, node: Node, gone: Deletions) -> bool:
    """Tell whether code that stays says a name, but for its declaration."""
    return any(
        not gone.covers(each, found.start())
        and not (each is file and node.start_byte <= found.start() < node.end_byte)
        for each in analysis.unit.all_files
        for found in word(name).finditer(gone.written(each))
    )


def named(name: str) -> re.Pattern[bytes]:
    """Return what matches the name of a type, and those that ROS 1 makes of it."""
    parts = rb"(?:Action)?(?:Goal|Result|Feedback|Request|Response)?(?:Const)?(?:Ptr)?(?!\w)"
    return re.compile(rb"(?<![A-Za-z0-9_])" + re.escape(name.encode()) + parts)


def _is_named(analysis: Analysis, name: str, gone: Deletions) -> bool:
    """Tell whether code that stays has a word for a type, or for what is made of it."""
    pattern = named(name)
    return any(
        not gone.covers(file, found.start())
        for file in analysis.unit.all_files
        for found in pattern.finditer(gone.written(file))
    )
