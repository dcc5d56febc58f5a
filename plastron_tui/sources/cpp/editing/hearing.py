"""What a subscription or a service calls: how it is named, what it takes, how it is handed on."""

from __future__ import annotations

import re
from dataclasses import dataclass

from plastron_tui.model.kinds import Service
from plastron_tui.model.source import EndpointKind

from ..analysis import Site
from ..scopes import Function, Variable
from .adding import Addition
from .deletions import Deletions
from .lambdas import Lambda, called_functions, handed_functions
from .leftovers import has_uses
from .manner import split_words
from .members import respelled

K = EndpointKind

_POINTER = re.compile(r"Ptr\b|_ptr\s*<|\*")
_COMMENT = re.compile(r"/\*.*?\*/", re.S)
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


def message_parameter(added: Addition, class_: str, like: Lambda | None = None) -> Parameter:
    """Return how a callback takes its message, as the file's others do, or as one of them."""
    sites = [like.site] if like is not None else _with_callbacks(added, K.SUBSCRIPTION)
    for site in sites:
        for function in _models(added, site, like):
            if len(function.parameters) != 1 or site.endpoint.type is None:
                continue
            given = _parameter(added, function.parameters[0], site, class_, "msg")
            if given is None:
                continue
            name = given.name
            if _is_called_after(name, site) and given.text.endswith(name):
                # It is called after what the other one hears.
                return Parameter(f"{given.text.removesuffix(name)}msg", "msg", given.is_pointer)
            return given
    reference = added.style(added.place.file).reference
    if not added.is_ros2:
        return Parameter(f"const {class_}::ConstPtr{reference}msg", "msg", True)
    return Parameter(f"const {class_}::SharedPtr msg", "msg", True)


def _is_called_after(name: str, site: Site) -> bool:
    """Tell whether a parameter is named for what its own callback hears: `js` for `JointState`."""
    assert site.endpoint.type is not None, "it was asked before"
    type_ = split_words(site.endpoint.type.name)
    said = {*type_, *split_words((site.endpoint.name or "").replace("/", "_"))}
    said |= {each.rstrip("0123456789") for each in said} - {""}
    said |= {f"{each}s" for each in said}
    if not said.isdisjoint(split_words(name)):
        return True
    short = name.strip("_").lower()
    is_start = len(short) < 4 and any(each.startswith(short) for each in said)
    return is_start or short == "".join(each[0] for each in type_)


def service_parameters(
    added: Addition, class_: str, like: Lambda | None = None
) -> tuple[Parameter, Parameter]:
    """Return how a handler takes its request and response, as the file's others do."""
    sites = [like.site] if like is not None else _with_callbacks(added, K.SERVICE)
    for site in sites:
        for function in _models(added, site, like):
            if len(function.parameters) != 2 or site.endpoint.type is None:
                continue
            names = ("request", "response") if added.is_ros2 else ("req", "res")
            found = [
                _parameter(added, parameter, site, class_, name)
                for parameter, name in zip(function.parameters, names, strict=True)
            ]
            if found[0] is not None and found[1] is not None:
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


def _models(added: Addition, site: Site, like: Lambda | None) -> list[Function]:
    """Return the functions whose parameters are those of a new one."""
    if like is None:
        handed = [*handed_functions(added.analysis, site, added.owner)]
        return handed or called_functions(added.analysis, site)
    return [like.function] if like.function is not None else []


def _parameter(
    added: Addition, parameter: Variable, site: Site, class_: str, usual: str
) -> Parameter | None:
    """Return a parameter as it is for another type, None where it does not show its type."""
    assert site.endpoint.type is not None, "it was asked before"
    syntax = parameter.file.syntax
    text = _COMMENT.sub("", syntax.slice(parameter.node))
    is_auto = re.search(r"\bauto\b", text) is not None
    respelt = text if is_auto else respelled(text, site.endpoint.type, class_)
    if respelt is None or "Event<" in respelt:
        return None
    respelt = re.sub(r"\s+", " ", respelt).strip()
    name = parameter.name or usual
    if not parameter.name:
        reference = added.style(parameter.file).reference
        respelt = re.sub(r"\s*&$", reference, respelt)
        respelt += name if respelt != respelt.rstrip() or respelt.endswith("&") else f" {name}"
    is_pointer = _POINTER.search(respelt) is not None or parameter.is_pointer
    if is_auto:
        # A message of ROS 1 comes in a pointer, as all of ROS 2 does; a request of ROS 1 does not.
        is_pointer = added.is_ros2 or usual == "msg"
    return Parameter(respelt, name, is_pointer)


def _with_callbacks(added: Addition, kind: EndpointKind) -> list[Site]:
    """Return the call sites of a kind that call a function, the one beside the place first."""
    found = [each for each in added.like(kind) if called_functions(added.analysis, each)]
    model = added.model(kind)
    found.reverse()
    return sorted(found, key=lambda each: each is not model)


def hearing_functions(added: Addition, site: Site) -> list[Function]:
    """Return the functions of the files that hear what a subscription gets.

    A lambda that does nothing but hand its message to a method stands for that method.
    """
    handed = [*handed_functions(added.analysis, site, added.owner)]
    found = handed or called_functions(added.analysis, site)
    return [each for each in found if each.scope is not None and not each.file.is_beside]


def bound(added: Addition, name: str, arguments: int) -> list[str]:
    """Write what calls a function, as the file's others are handed on.

    Returns:
        The arguments: ROS 1 takes the object behind the method.
    """
    if added.owner is None:
        return [_plain(added, name)]
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
            return [f"&{class_}::{name}", "this"]
    binder, placeholder = bind_manner(added, arguments)
    listed = "".join(f", {placeholder}{at + 1}" for at in range(arguments))
    return [f"{binder}(&{class_}::{name}, this{listed})"]


def bind_manner(added: Addition, arguments: int) -> tuple[str, str]:
    """Return what binds a method, and what its placeholders begin with, as the file has them.

    A file without has what declares `std::bind` included.
    """
    texts = _callback_texts(added)
    binds = [each for each in texts if re.match(r"(?:std::|boost::)?bind\b", each)]
    if not binds:
        if added.is_ros2:
            added.include(added.place.file, "functional")
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
