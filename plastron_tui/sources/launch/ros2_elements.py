"""The elements of ROS 2's launch files in XML.

Sources: `launch_xml`; what `parse` takes in the actions of `launch` and `launch_ros`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from plastron_tui.ros.launch import (
    Argument,
    Container,
    Group,
    Include,
    Item,
    Namespace,
    Parameter,
    ParameterFile,
    Remap,
    SetParameter,
    StartedNode,
    Variable,
)
from plastron_tui.ros.launch_text import Text, text
from plastron_tui.sources.xml.document import Element

from .elements import Words, remaps_of, value_of

ONLY = frozenset(
    ("let", "node_container", "composable_node", "load_composable_node", "push_ros_namespace",
     "set_remap", "set_parameter", "executable", "set_env", "declare_argument")
)  # fmt: skip


def item_of(element: Element) -> Item | None:
    """Return what an element says, None where that is not understood."""
    words = Words(element, 2)
    match element.name.replace("-", "_"):
        case "node":
            return node_of(words, "exec")
        case "node_container":
            return _container(words)
        case "load_composable_node":
            target = words.get("target")
            if target is None:
                return None
            return Container(
                None, target, _components(element), condition=words.condition, place=words.place
            )
        case "arg":
            return _argument(words)
        case "let":
            name, value = words.get("name"), words.get("value")
            if name is None or name.literal is None or value is None:
                return None
            return Variable(name.literal, value, condition=words.condition, place=words.place)
        case "include":
            return _include(words)
        case "group":
            is_scoped = element.get("scoped") not in ("false", "0", "False")
            return Group((), is_scoped, condition=words.condition, place=words.place)
        case "push_ros_namespace":
            namespace = words.get("namespace")
            if namespace is None:
                return None
            return Namespace(namespace, condition=words.condition, place=words.place)
        case "set_remap":
            old, new = words.get("from"), words.get("to")
            if old is None or new is None:
                return None
            return Remap(old, new, condition=words.condition, place=words.place)
        case "set_parameter":
            found = list(_parameters(element, text()))
            if len(found) != 1:
                return None
            return SetParameter(found[0], condition=words.condition, place=words.place)
        case _:
            return None


def node_of(words: Words, executable: str) -> StartedNode | None:
    """Return the node that an element starts."""
    element = words.element
    package, started = words.get("pkg"), words.get(executable)
    if package is None or started is None:
        return None
    known = ("name", "namespace", "remap", "param", "env", "composable_node", "extra_arg")
    if any(child.name not in known for child in element.children):
        return None
    nested = ((f"{child.name} {child.get('name') or ''}", child.get("value") or "")
              for child in element.named("env", "extra_arg"))  # fmt: skip
    return StartedNode(
        package,
        started,
        words.get("name"),
        words.get("namespace"),
        tuple(remaps_of(element, 2)),
        tuple(p for child in element.named("param") for p in _parameters(child, text())),
        (
            *words.others("pkg", executable, "name", "namespace"),
            *((name, text(value)) for name, value in nested),
        ),
        condition=words.condition,
        place=words.place,
    )


def _parameters(element: Element, before: Text) -> Iterator[Parameter]:
    """Yield the parameters that an element sets; nested ones have a dot between their names."""
    words = Words(element, 2)
    file, name, value = words.get("from"), words.get("name"), element.get("value")
    if file is not None:
        yield ParameterFile(file)
    elif name is not None:
        whole = replace(text(before, "." if before.parts else "", name), span=name.span)
        if value is not None:
            yield value_of(whole, value, element.get("type"), 2)
        for child in element.named("param"):
            yield from _parameters(child, whole)


def _container(words: Words) -> Container | None:
    node = node_of(words, "exec")
    if node is None:
        return None
    return Container(
        StartedNode(
            node.package,
            node.executable,
            node.name,
            node.namespace,
            node.remaps,
            node.parameters,
            node.others,
        ),
        None,
        _components(words.element),
        condition=words.condition,
        place=words.place,
    )


def _components(element: Element) -> tuple[StartedNode, ...]:
    found = (node_of(Words(each, 2), "plugin") for each in element.named("composable_node"))
    return tuple(each for each in found if each is not None)


def _argument(words: Words) -> Item | None:
    name = words.element.get("name")
    if name is None:
        return None
    if words.get("value") is not None:
        return None
    return Argument(
        name,
        words.get("default"),
        words.element.get("description") or "",
        condition=words.condition,
        place=words.place,
    )


def _include(words: Words) -> Include | None:
    file = words.get("file")
    if file is None:
        return None
    arguments = []
    for child in words.element.named("arg", "let"):
        name, value = child.get("name"), Words(child, 2).get("value")
        if name is None or value is None:
            return None
        arguments.append((name, value))
    return Include(
        file,
        tuple(arguments),
        None,
        words.others("file"),
        condition=words.condition,
        place=words.place,
    )
