"""What a launch file says, as elements of XML."""

from __future__ import annotations

from collections.abc import Iterator

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
    Remapping,
    SetParameter,
    StartedNode,
    Variable,
)
from plastron_tui.ros.launch_text import Substitution, Text, text
from plastron_tui.ros.launch_values import typed, written
from plastron_tui.ros.parameters import Setting
from plastron_tui.sources.xml.new_element import NewElement

from .ros1_elements import READ_VALUES
from .substitutions import escaped, write_text

_Attributes = tuple[tuple[str, str], ...]


class CannotWriteError(Exception):
    """A generation of ROS has no words for something; the argument says for what."""


def new_element(item: Item, ros_version: int) -> NewElement:
    """Return the element that says something.

    Raises:
        CannotWriteError: this generation of ROS has no words for it.
    """
    return _Writer(ros_version).element(item)


class _Writer:
    def __init__(self, ros_version: int) -> None:
        self._version = ros_version

    def element(self, item: Item) -> NewElement:
        match item:
            case Argument():
                return self._argument(item)
            case Variable(name=name, value=value):
                tag = "arg" if self._version == 1 else "let"
                return self._tag(item, tag, (("name", name), ("value", value)))
            case StartedNode():
                return self._node(item)
            case Container():
                return self._container(item)
            case Include():
                return self._include(item)
            case Group():
                return self._group(item)
            case Namespace(namespace=namespace) if self._version == 2:
                return self._tag(item, "push_ros_namespace", (("namespace", namespace),))
            case Remap(old=old, new=new):
                tag = "remap" if self._version == 1 else "set_remap"
                return self._tag(item, tag, (("from", old), ("to", new)))
            case SetParameter(parameter=parameter):
                found = self._parameter(
                    parameter, "param" if self._version == 1 else "set_parameter"
                )
                return found._replace(attributes=(*found.attributes, *self._condition(item)))
            case _:
                raise CannotWriteError(f"`{type(item).__name__}`")

    def _tag(
        self,
        item: Item,
        name: str,
        attributes: tuple[tuple[str, Text | str | None], ...],
        children: tuple[NewElement, ...] = (),
    ) -> NewElement:
        return NewElement(
            name, (*self._attributes(attributes), *self._condition(item)), "", children
        )

    def _attributes(self, found: tuple[tuple[str, Text | str | None], ...]) -> _Attributes:
        return tuple((name, self._text(value)) for name, value in found if value is not None)

    def _text(self, of: Text | str) -> str:
        found = write_text(text(of) if isinstance(of, str) else of, self._version)
        if found is None:
            raise CannotWriteError(f"the text `{of}`")
        return found

    def _condition(self, item: Item) -> _Attributes:
        if item.condition is None:
            return ()
        name = "unless" if item.condition.is_negated else "if"
        return ((name, self._text(item.condition.value)),)

    def _argument(self, item: Argument) -> NewElement:
        about = "doc" if self._version == 1 else "description"
        plain = ((about, item.description),) if item.description else ()
        found = self._tag(item, "arg", (("name", text(item.name)), ("default", item.default)))
        own = len(found.attributes) - len(self._condition(item))
        attributes = (*found.attributes[:own], *plain, *found.attributes[own:])
        return found._replace(attributes=attributes)

    def _node(
        self, item: StartedNode, tag: str = "node", extra: tuple[NewElement, ...] = ()
    ) -> NewElement:
        is_one = self._version == 1
        executable = "plugin" if tag == "composable_node" else "type" if is_one else "exec"
        name = item.name
        if is_one and name is None:
            # roslaunch wants one; the executable's is what a node of ROS 2 has by habit, too.
            raise CannotWriteError("a node without a name")
        plain = [(key, value) for key, value in item.others if " " not in key]
        nested = [(key, value) for key, value in item.others if " " in key]
        children = [
            *self._nested(nested),
            *(self._parameter(each, "param") for each in item.parameters),
            *(self._remap(each) for each in item.remaps),
            *extra,
        ]
        attributes: list[tuple[str, Text | str | None]] = [
            ("pkg", item.package), (executable, item.executable), ("name", name),
            ("ns" if is_one else "namespace", item.namespace), *plain,
        ]  # fmt: skip
        return self._tag(item, tag, tuple(attributes), tuple(children))

    def _nested(self, found: list[tuple[str, Text]]) -> Iterator[NewElement]:
        for key, value in found:
            tag, _, name = key.partition(" ")
            if self._version == 1:
                raise CannotWriteError(f"`<{tag}>`")
            yield NewElement(tag, (("name", name), ("value", value.literal or "")))

    def _remap(self, remap: Remapping) -> NewElement:
        return NewElement("remap", (("from", self._text(remap.old)), ("to", self._text(remap.new))))

    def _parameter(self, parameter: Parameter, tag: str) -> NewElement:
        if isinstance(parameter, ParameterFile):
            file = self._text(parameter.file)
            if self._version == 1:
                return NewElement("rosparam", (("command", "load"), ("file", file)))
            return NewElement(tag, (("from", file),))
        name = ("name", self._text(parameter.name))
        if isinstance(parameter.value, Text):
            if self._version == 1 and (read := self._read(parameter.value)) is not None:
                return NewElement(tag, (name, read))
            word = "double" if self._version == 1 else "float"
            word = "str" if parameter.is_text else word if parameter.is_float else ""
            type_ = (("type", word),) if word else ()
            return NewElement(tag, (name, ("value", self._text(parameter.value)), *type_))
        return NewElement(tag, (name, *self._value(parameter.value)))

    def _read(self, value: Text) -> tuple[str, str] | None:
        """Return the attribute that says where a value is read from, None for another value."""
        match value.parts:
            case (Substitution(kind=kind, argument=source),):
                for attribute, each in READ_VALUES.items():
                    if each is kind:
                        return attribute, self._text(source)
        return None

    def _value(self, value: Setting) -> _Attributes:
        if self._version == 2 and isinstance(value, tuple):
            value = tuple(self._escaped(x) if isinstance(x, str) else x for x in value)
        found, type_ = written(value, self._version)
        if isinstance(value, str) and type_ != "yaml":
            found = self._escaped(value)
            # The text is read as YAML before and after its escapes are.
            if self._version == 2 and typed(found, 2) != found:
                type_ = "str"
        elif self._version == 1 and "$(" in found:
            raise CannotWriteError(f"the text `{found}`")
        return (("value", found), *((("type", type_),) if type_ else ()))

    def _escaped(self, literal: str) -> str:
        found = escaped(literal, self._version)
        if found is None:
            raise CannotWriteError(f"the text `{literal}`")
        return found

    def _container(self, item: Container) -> NewElement:
        if self._version == 1:
            raise CannotWriteError("a container of components")
        inner = tuple(self._node(each, "composable_node") for each in item.components)
        if item.node is None:
            return self._tag(item, "load_composable_node", (("target", item.target),), inner)
        found = self._node(item.node, "node_container", inner)
        return found._replace(attributes=(*found.attributes, *self._condition(item)))

    def _include(self, item: Include) -> NewElement:
        # In ROS 2 a namespace is pushed, in a group.
        if item.namespace is not None and self._version == 2:
            raise CannotWriteError("a namespace of an included file")
        arguments = tuple(
            NewElement("arg", (("name", name), ("value", self._text(value))))
            for name, value in item.arguments
        )
        own = (("file", item.file), ("ns", item.namespace), *item.others)
        return self._tag(item, "include", own, arguments)

    def _group(self, item: Group) -> NewElement:
        items = item.items
        attributes: tuple[tuple[str, Text | str | None], ...] = ()
        if self._version == 1 and items and isinstance(items[0], Namespace):
            attributes, items = (("ns", items[0].namespace),), items[1:]
        if not item.is_scoped:
            attributes = (*attributes, ("scoped", "false"))
        return self._tag(item, "group", attributes, tuple(map(self.element, items)))
