"""Files with macros (xacro), read by their XML alone: nothing is computed, and no file opened."""

from __future__ import annotations

import re
from collections.abc import Iterator

from plastron_tui.ros.robots.macros import (
    Definition,
    Include,
    Macro,
    MacroCall,
    Macros,
    Parameter,
)
from plastron_tui.sources.xml.document import Element, XmlDocument

from .values import is_computed, is_xacro

_PREFIX = "xacro:"
_CONDITIONS = frozenset({"xacro:if", "xacro:unless"})
_WORDS = _CONDITIONS | {
    "xacro:arg",
    "xacro:attribute",
    "xacro:element",
    "xacro:include",
    "xacro:insert_block",
    "xacro:macro",
    "xacro:property",
}
_TRUE = ("true", "True", "1")

# As xacro takes a parameter with a default: `name:=value`, `name:=^|value`, `name='a b'`.
_WITH_DEFAULT = re.compile(
    r"\s*([^\s:=]+?)\s*:?=\s*(\^\|?)?"
    # One character at a time: a quote that is never closed must not be looked for again and again.
    r"(\$\{.*?\}|\$\(.*?\)|(?:'[^']*'|\"[^\"]*\"|[^\s'\"])+|)(?:\s+|$)"
)
_WITHOUT = re.compile(r"\s*(\S+)")
_LONGEST_PARAMETERS = 10_000
_MOST_PARAMETERS = 200


def has_macros(document: XmlDocument) -> bool:
    """Tell whether there is anything in a file that is to be expanded.

    What xacro has expanded still names its namespace.
    """
    return is_xacro(document) and any(
        element.name.startswith(_PREFIX) or any(is_computed(x.value) for x in element.attributes)
        for element in document.root.walk()
    )


def read_macros(document: XmlDocument) -> Macros:
    """Read what a file with macros leaves to them.

    Args:
        document: the file.
    """
    macros: dict[str, Macro] = {}
    properties: list[Definition] = []
    arguments: list[Definition] = []
    calls: list[MacroCall] = []
    conditions = 0
    for element in _outside(document.root):
        if element.name == "xacro:macro":
            macro = _macro(element)
            if macro is not None:
                macros.pop(macro.name, None)
                macros[macro.name] = macro
        elif element.name == "xacro:property":
            properties.append(_definition(element, "value", "default"))
        elif element.name == "xacro:arg":
            arguments.append(_definition(element, "default"))
        elif element.name in _CONDITIONS:
            conditions += 1
        else:
            calls.extend(_calls_of(element))
    return Macros(
        tuple(include for include, _ in read_includes(document)),
        tuple(macros.values()),
        tuple(calls),
        tuple(properties),
        tuple(arguments),
        conditions,
    )


def read_includes(document: XmlDocument) -> Iterator[tuple[Include, Element]]:
    """Yield the includes of a file, wherever they stand, with their elements."""
    stack = [(document.root, False)]
    while stack:
        element, is_uncertain = stack.pop()
        if element.name == "xacro:include":
            yield _include(element, is_certain=not is_uncertain), element
        inner = is_uncertain or element.name in _CONDITIONS or element.name == "xacro:macro"
        stack += [(each, inner) for each in reversed(element.children)]


def _include(element: Element, *, is_certain: bool) -> Include:
    return Include(
        element.get("filename") or "",
        element.line,
        element.get("optional") in _TRUE,
        element.get("ns") or "",
        is_certain,
    )


def _outside(root: Element) -> Iterator[Element]:
    """Yield the elements below one that are in no macro that is defined there."""
    stack = list(reversed(root.children))
    while stack:
        element = stack.pop()
        yield element
        if element.name != "xacro:macro":
            stack.extend(reversed(element.children))


def _macro(element: Element) -> Macro | None:
    name = (element.get("name") or "").removeprefix(_PREFIX)
    if not name:
        return None
    written = list(_outside(element))
    return Macro(
        name,
        tuple(_parameters(element.get("params") or "")),
        sum(each.name == "link" and "name" in _names(each) for each in written),
        sum(each.name == "joint" and "type" in _names(each) for each in written),
        tuple(call for each in written for call in _calls_of(each)),
        element.line,
        any(each.name in _CONDITIONS or each.name == "xacro:include" for each in written),
    )


def _names(element: Element) -> set[str]:
    return {each.name for each in element.attributes}


def _parameters(text: str) -> Iterator[Parameter]:
    """Yield the parameters of a macro; a text that no person writes is not read to its end."""
    text = text[:_LONGEST_PARAMETERS]
    at = count = 0
    while count < _MOST_PARAMETERS:
        count += 1
        found = _WITH_DEFAULT.match(text, at)
        if found is not None:
            name, forwarded, default = found.groups()
            shown = default if default or not forwarded else forwarded
            yield Parameter(name.lstrip("*"), shown, name.startswith("*"))
        else:
            found = _WITHOUT.match(text, at)
            if found is None:
                return
            name = found.group(1)
            yield Parameter(name.lstrip("*"), None, name.startswith("*"))
        at = found.end()


def _calls_of(element: Element) -> Iterator[MacroCall]:
    """Yield the call that an element is, if it is one."""
    if not element.name.startswith(_PREFIX) or element.name in _WORDS:
        return
    arguments = tuple((each.name, each.value) for each in element.attributes)
    if element.name == "xacro:call":
        name = element.get("macro") or ""
        arguments = tuple(each for each in arguments if each[0] != "macro")
    else:
        name = element.name.removeprefix(_PREFIX)
    yield MacroCall(name, arguments, element.line)


def _definition(element: Element, *values: str) -> Definition:
    found = (element.get(each) for each in values)
    value = next((each for each in found if each is not None), None)
    return Definition(element.get("name") or "", value, element.line)
