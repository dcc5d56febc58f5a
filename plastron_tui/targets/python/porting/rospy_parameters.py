"""From rclpy to rospy: parameters, which nobody declares there; each reader names the default."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.sources.python.arguments import Arguments
from plastron_tui.sources.python.calls import Argument
from plastron_tui.sources.python.references import statement_of
from plastron_tui.sources.python.syntax import parts_of

from .port_state import Work, walk

_LITERALS = frozenset({"integer", "float", "true", "false", "string"})
_SCALARS = ("bool", "integer", "double", "string")
_TYPED = frozenset(f"{each}{kind}_value" for each in _SCALARS for kind in ("", "_array"))
_OF_ALL = frozenset({"use_sim_time"})
_CHANGES = (b"set_parameters", b"add_on_set_parameters_callback", b"undeclare_parameter")


@dataclass(frozen=True, slots=True)
class _Declared:
    """A parameter of a literal name, and the source of its default.

    Attributes:
        node: the call, or the item of a list, that declares it.
        name: the name.
        quote: the quote of the name.
        default: the source of the default.
    """

    node: Node
    name: str
    quote: str
    default: str


def port_rospy_parameters(work: Work) -> None:
    """Rewrite what reads a parameter whose one declaration has a literal for its default."""
    calls = [each for each in work.analysis.captures.get("call", []) if not work.is_gone(each)]
    if any(each in work.analysis.syntax.text for each in _CHANGES):
        return
    lists = {each.id: _listed(work, each) for each in calls}
    declared = [one for call in calls if (one := _declared(work, call)) is not None]
    declared += [one for listed in lists.values() for one in listed]
    counts = Counter(each.name for each in declared)
    known = {each.name: each for each in declared if counts[each.name] == 1}
    reads = {
        call.id: (call, name)
        for call in calls
        if (name := _read(work, call)) is not None and name in known
    }
    # A parameter that is read in a way that rospy has not stays with all that is said of it.
    open_names = {name for call, name in reads.values() if _value_of(work, call) is None}
    for call, name in reads.values():
        value = _value_of(work, call)
        if name not in open_names and value is not None:
            _replace(work, value, known[name])
    for call in calls:
        one = known.get(next((each.name for each in declared if each.node.id == call.id), ""))
        if one is not None and one.name not in open_names:
            _port_declaration(work, call, one)
        elif lists[call.id] and _is_alone(call):
            names = {each.name for each in lists[call.id]}
            if names <= set(known) - open_names:
                work.delete(statement_of(call))


def _port_declaration(work: Work, call: Node, declared: _Declared) -> None:
    value = _value_of(work, call)
    if value is not None:
        _replace(work, value, declared)
    elif _is_alone(call):
        work.delete(statement_of(call))


def _replace(work: Work, value: Node, declared: _Declared) -> None:
    name, quote, default = declared.name.replace(".", "/"), declared.quote, declared.default
    around = _quote_around(work, value)
    if around == quote:
        quote = "'" if quote == '"' else '"'
    if around is not None and around in default:
        if default[0] != around or quote in default or "\\" in default:
            return
        default = quote + default[1:-1] + quote
    work.done.update(each.id for each in walk(value))
    work.replace(value, f"rospy.get_param({quote}~{name}{quote}, {default})")


def _quote_around(work: Work, value: Node) -> str | None:
    """Return the quote of the text that a value is written into, which Python has not inside."""
    outer = value.parent
    while outer is not None and outer.type != "interpolation":
        outer = outer.parent
    if outer is None or outer.parent is None:
        return None
    return work.slice(outer.parent).lstrip("rRfF")[0]


def _is_alone(call: Node) -> bool:
    """Tell whether a call is a statement, beside others in its block or not."""
    return statement_of(call).named_children == [call]


def _method(work: Work, call: Node) -> str:
    callee = call.child_by_field_name("function")
    part = callee.child_by_field_name("attribute") if callee is not None else None
    return work.slice(part) if part is not None else ""


def _read(work: Work, call: Node) -> str | None:
    """Return the name of the parameter that a call of `get_parameter` is of."""
    arguments = Arguments.of(call, work.analysis.syntax)
    given = arguments.get(Argument(0, "name"))
    if _method(work, call) != "get_parameter" or arguments.is_open or given is None:
        return None
    return _name(work, given) if len(parts_of(call.child_by_field_name("arguments"))) == 1 else None


def _declared(work: Work, call: Node) -> _Declared | None:
    """Return what a call of `declare_parameter` declares, None where it says more."""
    arguments = Arguments.of(call, work.analysis.syntax)
    if _method(work, call) != "declare_parameter" or arguments.is_open:
        return None
    name, default = arguments.get(Argument(0, "name")), arguments.get(Argument(1, "value"))
    if name is None or default is None:
        return None
    found = _name(work, name)
    is_all = len(parts_of(call.child_by_field_name("arguments"))) == 2
    if found is None or not is_all or not _is_literal(work, default):
        return None
    return _Declared(call, found, work.slice(name)[0], work.slice(default))


def _listed(work: Work, call: Node) -> list[_Declared]:
    """Return what a call of `declare_parameters` declares, nothing where it says more."""
    if _method(work, call) != "declare_parameters":
        return []
    arguments = Arguments.of(call, work.analysis.syntax)
    space = arguments.get(Argument(0, "namespace"))
    items = arguments.get(Argument(1, "parameters"))
    count = len(parts_of(call.child_by_field_name("arguments")))
    if arguments.is_open or space is None or items is None or count != 2:
        return []
    if work.slice(space)[1:-1] or items.type not in ("list", "tuple"):
        return []
    found = []
    for each in parts_of(items):
        parts = parts_of(each) if each.type == "tuple" else []
        name = _name(work, parts[0]) if len(parts) == 2 else None
        if name is None or not _is_literal(work, parts[1]):
            return []
        found.append(_Declared(each, name, work.slice(parts[0])[0], work.slice(parts[1])))
    return found


def _name(work: Work, given: Node) -> str | None:
    """Return the name in a plain literal, None for another, and for a parameter of all nodes."""
    text = work.slice(given)
    name = text[1:-1]
    is_name = name not in _OF_ALL and all(part.isidentifier() for part in name.split("."))
    return name if given.type == "string" and text[0] in "\"'" and is_name else None


def _is_literal(work: Work, value: Node) -> bool:
    """Tell whether a default is the same wherever it stands, in one line."""
    if value.type in ("list", "tuple"):
        parts = parts_of(value)
        return value.start_point.row == value.end_point.row and all(
            _is_literal(work, each) for each in parts
        )
    if value.type == "unary_operator":
        argument = value.child_by_field_name("argument")
        return argument is not None and argument.type in ("integer", "float")
    is_formatted = value.type == "string" and work.slice(value)[0] in "fF"
    return value.type in _LITERALS and not is_formatted


def _value_of(work: Work, call: Node) -> Node | None:
    """Return the value that is asked of a parameter: `.value`, or one by its type."""
    outer = call.parent
    if outer is None or outer.type != "attribute" or outer.child_by_field_name("object") != call:
        return None
    part = outer.child_by_field_name("attribute")
    if part is not None and work.slice(part) == "value":
        return outer
    asked, last = outer.parent, None
    if part is not None and work.slice(part) == "get_parameter_value" and asked is not None:
        last = asked.parent
    if asked is None or asked.type != "call" or last is None or last.type != "attribute":
        return None
    type_ = last.child_by_field_name("attribute")
    return last if type_ is not None and work.slice(type_) in _TYPED else None
