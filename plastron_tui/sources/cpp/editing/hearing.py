"""What a subscription or a service calls: how it is named, what it takes, how it is handed on."""

from __future__ import annotations

import re
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.kinds import Service
from plastron_tui.model.source import EndpointKind

from ..analysis import Site
from ..scopes import Function
from .adding import Addition
from .deletions import Deletions
from .leftovers import has_uses
from .manner import split_words
from .members import respelled
from .style import Style

K = EndpointKind

_POINTER = re.compile(r"Ptr\b|_ptr\s*<|\*")
_PLACEHOLDER = re.compile(r"((?:\w+::)*_)\d")
_METHOD = re.compile(r"&\s*([\w:<>]+)::\w+")


@dataclass(frozen=True, slots=True)
class Parameter:
    """The parameter of a callback.

    Attributes:
        text: as it is declared.
        name: its name.
        is_pointer: whether it points to what it is for.
    """

    text: str
    name: str
    is_pointer: bool

    @property
    def value(self) -> str:
        """The message itself."""
        return f"*{self.name}" if self.is_pointer else self.name

    @property
    def holder(self) -> str:
        """What stands before a field of it."""
        return f"{self.name}{'->' if self.is_pointer else '.'}"


def message_parameter(added: Addition, class_: str) -> Parameter:
    """Return how a callback takes its message, as the file's others do."""
    for site in _with_callbacks(added, K.SUBSCRIPTION):
        for function in site.callback.functions:
            if len(function.parameters) != 1 or site.endpoint.type is None:
                continue
            parameter = function.parameters[0]
            syntax = function.file.syntax
            text = respelled(syntax.slice(parameter.node), site.endpoint.type, class_)
            if text is None or not parameter.name or "Event<" in text:
                continue
            text = re.sub(r"\s+", " ", text)
            is_pointer = _POINTER.search(text) is not None or parameter.is_pointer
            name = parameter.name
            said = f"{site.endpoint.name or ''}/{site.endpoint.type.name}".replace("/", "_")
            if not {*split_words(name)}.isdisjoint(split_words(said)) and text.endswith(name):
                # It is called after what the other one hears.
                text, name = f"{text.removesuffix(name)}msg", "msg"
            return Parameter(text, name, is_pointer)
    reference = added.style(added.place.file).reference
    if not added.is_ros2:
        return Parameter(f"const {class_}::ConstPtr{reference}msg", "msg", True)
    return Parameter(f"const {class_}::SharedPtr msg", "msg", True)


def service_parameters(added: Addition, class_: str) -> tuple[Parameter, Parameter]:
    """Return how a handler takes its request and response, as the file's others do."""
    for site in _with_callbacks(added, K.SERVICE):
        for function in site.callback.functions:
            if len(function.parameters) != 2 or site.endpoint.type is None:
                continue
            found = []
            for parameter in function.parameters:
                syntax = function.file.syntax
                text = respelled(syntax.slice(parameter.node), site.endpoint.type, class_)
                if text is None or not parameter.name:
                    break
                text = re.sub(r"\s+", " ", text)
                is_pointer = _POINTER.search(text) is not None or parameter.is_pointer
                found.append(Parameter(text, parameter.name, is_pointer))
            if len(found) == 2:
                return found[0], found[1]
    reference = added.style(added.place.file).reference
    if not added.is_ros2:
        return (
            Parameter(f"{class_}::Request{reference}req", "req", False),
            Parameter(f"{class_}::Response{reference}res", "res", False),
        )
    return (
        Parameter(f"const std::shared_ptr<{class_}::Request> request", "request", True),
        Parameter(f"std::shared_ptr<{class_}::Response> response", "response", True),
    )


def _with_callbacks(added: Addition, kind: EndpointKind) -> list[Site]:
    """Return the call sites of a kind that call a function, the one beside the place first."""
    found = [each for each in added.like(kind) if each.callback.functions]
    model = added.model(kind)
    found.reverse()
    return sorted(found, key=lambda each: each is not model)


def hearing_functions(added: Addition, site: Site) -> list[Function]:
    """Return the functions of the files that hear what a subscription gets.

    A lambda that does nothing but hand its message to a method stands for that method.
    """
    found = [each for each in site.callback.functions if each.scope is not None]
    position = site.shape.callback
    node = site.arguments[position] if position is not None and not found else None
    if node is not None and node.type == "lambda_expression" and added.owner is not None:
        body = node.child_by_field_name("body")
        syntax = site.place.file.syntax
        text = "" if body is None else syntax.word(body)
        handed = re.fullmatch(r"\{\s*(?:this->)?(\w+)\(\s*(?:std::move\()?\w+\)?\s*\);\s*\}", text)
        for each in added.analysis.unit.functions.get(handed[1], ()) if handed else ():
            is_own = added.analysis.unit.class_of_function(each) is added.owner
            if each.scope is not None and is_own:
                found.append(each)
    return [each for each in found if not each.file.is_beside]


def bound(added: Addition, name: str, arguments: int) -> tuple[list[str], bool]:
    """Write what calls a function, as the file's others are handed on.

    Returns:
        The arguments, of which ROS 1 takes the object behind the method; and whether what is
        called does not say its type, so that the call has to.
    """
    if added.owner is None:
        return [_plain(added, name)], False
    texts = _callback_texts(added)
    class_ = added.owner.name
    for text in texts:
        found = _METHOD.search(text)
        if found is not None and re.sub(r"<.*", "", found[1]).rpartition("::")[2] == class_:
            class_ = found[1]
            break
    binds = [each for each in texts if re.match(r"(?:std::|boost::)?bind\b", each)]
    if not added.is_ros2:
        is_method = any(each.lstrip().startswith("&") for each in texts)
        if is_method or not binds:
            return [f"&{class_}::{name}", "this"], False
    binder, placeholder = bind_manner(added, arguments)
    listed = "".join(f", {placeholder}{at + 1}" for at in range(arguments))
    return [f"{binder}(&{class_}::{name}, this{listed})"], not added.is_ros2


def bind_manner(added: Addition, arguments: int) -> tuple[str, str]:
    """Return what binds a method, and what its placeholders begin with, as the file has them."""
    texts = _callback_texts(added)
    binds = [each for each in texts if re.match(r"(?:std::|boost::)?bind\b", each)]
    if not binds:
        if added.is_ros2:
            return "std::bind", _usual_placeholder(added, arguments)
        return "boost::bind", "boost::placeholders::_"
    binder = binds[0].partition("(")[0].strip()
    placeholder = "boost::placeholders::_"
    if not binder.startswith("boost"):
        placeholder = _usual_placeholder(added, arguments)
    given = next((each[1] for text in binds for each in _PLACEHOLDER.finditer(text)), None)
    if given is not None and (given != "_" or _is_seen(added, binder, arguments)):
        placeholder = given
    return binder, placeholder


def _usual_placeholder(added: Addition, arguments: int) -> str:
    return "_" if _is_seen(added, "std::bind", arguments) else "std::placeholders::_"


def _is_seen(added: Addition, binder: str, arguments: int) -> bool:
    """Tell whether placeholders are seen under their short names."""
    if binder.startswith("boost"):
        return True
    for scope in added.place.scope.chain:
        if "std::placeholders" in scope.usings:
            return True
        if all(f"_{at + 1}" in scope.aliases for at in range(arguments)) and arguments:
            return True
    return False


def _callback_texts(added: Addition) -> list[str]:
    """Return how the node's endpoints are handed what they call, those of the kind first."""
    found = []
    for site in (*added.like(), *added.sites):
        position = site.shape.callback
        if position is not None and position < len(site.arguments):
            node = site.arguments[position]
            if node.type != "lambda_expression":
                found.append(site.place.file.syntax.slice(node))
    return found


def _plain(added: Addition, name: str) -> str:
    texts = _callback_texts(added)
    return f"&{name}" if any(re.fullmatch(r"&\s*\w+", each) for each in texts) else name


def existing(added: Addition, name: str) -> Function | None:
    """Return the function of the files that a statement names, None where there is none."""
    for function in added.analysis.unit.functions.get(name, ()):
        owner = added.analysis.unit.class_of_function(function)
        if owner is added.owner:
            return function
        if owner is None or added.owner is None:
            continue
        if added.analysis.unit.derives_from(added.owner, owner):
            return function
    return None


def idle_callback(added: Addition, name: str, class_: str) -> str | None:
    """Return the name of a callback that nothing calls any more, where it takes what it is to.

    One was left where its endpoint went, for somebody has written in it.
    """
    found = [
        each
        for each in added.analysis.unit.functions.get(name, ())
        if added.analysis.unit.class_of_function(each) is added.owner
    ]
    if not any(each.scope is not None for each in found):
        return None
    if any(each.file.is_beside for each in found) or has_uses(added.analysis, found, Deletions()):
        return None
    count = 1 if added.kind is K.SUBSCRIPTION else 2
    if isinstance(added.endpoint, Service) and added.endpoint.answer is not None:
        return None
    for each in found:
        types = [parameter.type for parameter in each.parameters]
        is_of = all(re.search(rf"(?<!\w){re.escape(class_)}(?!\w)", x) for x in types)
        if len(types) != count or not is_of:
            return None
    return name


def wrapped(head: str, arguments: list[str], tail: str, style: Style, used: int) -> list[str]:
    """Return a call in one line, or in several where it is too long for one.

    Args:
        head: what stands before the arguments, with the bracket.
        arguments: the arguments.
        tail: what stands behind them, with the bracket.
        style: the layout of the file.
        used: the columns that are taken at the place.
    """
    joined = ", ".join(arguments)
    if used + len(head) + len(joined) + len(tail) <= style.width:
        return [f"{head}{joined}{tail}"]
    inner = used + len(style.indent)
    if inner + len(joined) + len(tail) <= style.width:
        return [head, f"\t{joined}{tail}"]
    *first, last = arguments
    return [head, *(f"\t{each}," for each in first), f"\t{last}{tail}"]


def line_of(node: Node) -> int:
    """Return the line of a node, from 1."""
    return int(node.start_point.row) + 1
