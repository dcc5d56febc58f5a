"""Launch files of ROS 2 in Python, as people write them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from plastron_tui.ros.launch import (
    Argument,
    Container,
    Group,
    Include,
    Item,
    LaunchFile,
    Namespace,
    Parameter,
    ParameterFile,
    ParameterValue,
    Remap,
    StartedNode,
    Variable,
)
from plastron_tui.ros.launch_text import Kind, Substitution, Text
from plastron_tui.ros.launch_values import typed
from plastron_tui.ros.parameters import Scalar, Setting
from plastron_tui.sources.launch.new_elements import CannotWriteError

_MODULES = {
    "launch": ("LaunchDescription",),
    "launch.actions": (
        "DeclareLaunchArgument",
        "GroupAction",
        "IncludeLaunchDescription",
        "SetLaunchConfiguration",
    ),
    "launch.conditions": ("IfCondition", "UnlessCondition"),
    "launch.substitutions": (
        "Command",
        "EnvironmentVariable",
        "FileContent",
        "LaunchConfiguration",
        "ThisLaunchFileDir",
    ),
    "launch_ros.actions": (
        "ComposableNodeContainer",
        "LoadComposableNodes",
        "Node",
        "PushRosNamespace",
        "SetRemap",
    ),
    "launch_ros.descriptions": ("ComposableNode",),
    "launch_ros.parameter_descriptions": ("ParameterValue",),
    "launch_ros.substitutions": ("FindPackageShare",),
}
_WIDTH = 99
_Argument = tuple[str, str]


def write_python(launch: LaunchFile) -> str:
    """Return the text of a launch file.

    Raises:
        CannotWriteError: Python has other words for something in it.
    """
    from plastron_tui.sources.python.ament_style import ament_style  # loads tree-sitter-python
    from plastron_tui.sources.python.layout import Brackets, fit

    writer = _Writer()
    items = [writer.item(item, "        ") for item in launch.items]
    body = "".join(f"        {item},\n" for item in items)
    description = f"LaunchDescription([\n{body}    ])" if items else "LaunchDescription([])"
    writer.names.add("LaunchDescription")
    imports = "".join(
        _import(module, used)
        for module, names in _MODULES.items()
        if (used := [name for name in names if name in writer.names])
    )
    text = f"{imports}\n\ndef generate_launch_description():\n    return {description}\n"
    return ament_style(fit(text, Brackets(_WIDTH)).encode()).decode()


def _import(module: str, names: list[str]) -> str:
    line = f"from {module} import {', '.join(names)}\n"
    if len(line) <= _WIDTH:
        return line
    return f"from {module} import (\n" + "".join(f"    {name},\n" for name in names) + ")\n"


class _Writer:
    """Writes items, and remembers what has to be imported.

    Attributes:
        names: what is used.
    """

    def __init__(self) -> None:
        self.names: set[str] = set()

    def item(self, item: Item, indent: str) -> str:
        """Return the expression of an item; its further lines are indented more than `indent`."""
        inner = indent + "    "
        match item:
            case Argument():
                found = [("", repr(item.name))]
                if item.default is not None:
                    found.append(("default_value", self._text(item.default)))
                if item.description:
                    found.append(("description", repr(item.description)))
                return self._action("DeclareLaunchArgument", found, item, indent)
            case Variable(name=name, value=value):
                found = [("", repr(name)), ("", self._text(value))]
                return self._action("SetLaunchConfiguration", found, item, indent)
            case Namespace(namespace=namespace):
                found = [("", self._text(namespace))]
                return self._action("PushRosNamespace", found, item, indent)
            case Remap(old=old, new=new):
                found = [("src", self._text(old)), ("dst", self._text(new))]
                return self._action("SetRemap", found, item, indent)
            case StartedNode():
                return self._action("Node", self._node(item, inner), item, indent)
            case Container():
                return self._container(item, indent)
            case Include():
                return self._include(item, indent)
            case Group():
                found = [
                    ("", self._list((self.item(x, inner + "    ") for x in item.items), inner))
                ]
                if not item.is_scoped:
                    found.append(("scoped", "False"))
                return self._action("GroupAction", found, item, indent)
            case _:
                raise CannotWriteError(f"`{type(item).__name__}`")

    def _action(self, name: str, found: list[_Argument], item: Item, indent: str) -> str:
        if item.condition is not None:
            condition = "UnlessCondition" if item.condition.is_negated else "IfCondition"
            self.names.add(condition)
            found = [*found, ("condition", f"{condition}({self._text(item.condition.value)})")]
        return self._call(name, found, indent)

    def _call(self, name: str, found: list[_Argument], indent: str) -> str:
        self.names.add(name)
        words = [f"{key}={value}" if key else value for key, value in found]
        line = f"{name}({', '.join(words)})"
        if len(found) < 3 and "\n" not in line and len(indent) + len(line) < _WIDTH:
            return line
        inner = indent + "    "
        return f"{name}(\n" + "".join(f"{inner}{word},\n" for word in words) + f"{indent})"

    def _list(self, items: Iterable[str], indent: str) -> str:
        found = list(items)
        line = f"[{', '.join(found)}]"
        if "\n" not in line and len(indent) + len(line) < _WIDTH - 20:
            return line
        return "[\n" + "".join(f"{indent}    {each},\n" for each in found) + f"{indent}]"

    def _node(
        self, item: StartedNode, indent: str, executable: str = "executable"
    ) -> list[_Argument]:
        found = [("package", self._text(item.package)), (executable, self._text(item.executable))]
        if item.name is not None:
            found.append(("name", self._text(item.name)))
        if item.namespace is not None:
            found.append(("namespace", self._text(item.namespace)))
        for key, value in item.others:
            if key not in ("output", "emulate_tty", "respawn"):
                raise CannotWriteError(f"`{key}`")
            word = value.literal
            is_flag = key != "output" and word in ("true", "false")
            found.append((key, str(word == "true") if is_flag else self._text(value)))
        if item.remaps:
            pairs = (f"({self._text(each.old)}, {self._text(each.new)})" for each in item.remaps)
            found.append(("remappings", self._list(pairs, indent)))
        if item.parameters:
            found.append(("parameters", self._list(self._parameters(item.parameters), indent)))
        return found

    def _parameters(self, parameters: tuple[Parameter, ...]) -> Iterator[str]:
        """Yield files and dictionaries; values that follow each other share one.

        A dictionary keeps one value of a name, so that a second one starts another.
        """
        together: dict[str, str] = {}
        for each in parameters:
            name = None if isinstance(each, ParameterFile) else self._text(each.name)
            if together and (name is None or name in together):
                yield _dictionary(together)
                together = {}
            if isinstance(each, ParameterFile):
                yield self._text(each.file)
            elif name is not None:
                together[name] = self._parameter(each)
        if together:
            yield _dictionary(together)

    def _parameter(self, parameter: ParameterValue) -> str:
        if not isinstance(parameter.value, Text):
            return self._value(parameter.value)
        shown = self._text(parameter.value)
        if parameter.is_float:
            return self._as_type(shown, "float")
        return self._as_type(shown, "str") if parameter.is_text else shown

    def _value(self, value: Setting) -> str:
        if isinstance(value, tuple):
            return f"[{', '.join(map(_scalar, value))}]"
        # A text is read as YAML, unless its type is said.
        is_text = isinstance(value, str) and typed(value, 2) != value
        return self._as_type(repr(value), "str") if is_text else _scalar(value)

    def _as_type(self, value: str, type_: str) -> str:
        self.names.add("ParameterValue")
        return f"ParameterValue({value}, value_type={type_})"

    def _container(self, item: Container, indent: str) -> str:
        inner = indent + "    "
        deeper = inner + "    "
        written = [
            self._action(
                "ComposableNode", self._node(each, deeper + "    ", "plugin"), each, deeper
            )
            for each in item.components
        ]
        parts = self._list(written, inner)
        held = ("composable_node_descriptions", parts)
        if item.node is None:
            target = self._text(item.target) if item.target is not None else "''"
            found = [("target_container", target), held]
            return self._action("LoadComposableNodes", found, item, indent)
        own = self._node(item.node, inner)
        return self._action("ComposableNodeContainer", [*own, held], item, indent)

    def _include(self, item: Include, indent: str) -> str:
        if item.namespace is not None or item.others:
            raise CannotWriteError("a namespace of an included file")
        found = [("", self._text(item.file))]
        if item.arguments:
            pairs = ", ".join(f"({name!r}, {self._text(value)})" for name, value in item.arguments)
            found.append(("launch_arguments", f"[{pairs}]"))
        return self._action("IncludeLaunchDescription", found, item, indent)

    def _text(self, of: Text) -> str:
        parts = [repr(part) if isinstance(part, str) else self._part(part) for part in of.parts]
        if len(parts) == 1:
            return parts[0]
        return f"[{', '.join(parts)}]" if parts else "''"

    def _part(self, part: Substitution) -> str:
        if part.kind is Kind.FOLDER:
            return self._call("ThisLaunchFileDir", [], "")
        if part.kind is Kind.OTHER:
            raise CannotWriteError(f"`$({part.argument})`")
        name = {
            Kind.ARGUMENT: "LaunchConfiguration",
            Kind.PACKAGE: "FindPackageShare",
            Kind.ENVIRONMENT: "EnvironmentVariable",
            Kind.CONTENT: "FileContent",
            Kind.COMMAND: "Command",
        }[part.kind]
        found = [("", self._text(part.argument))]
        if part.default is not None:
            found.append(("default_value", self._text(part.default)))
        return self._call(name, found, "")


def _dictionary(items: dict[str, str]) -> str:
    return "{" + ", ".join(f"{key}: {value}" for key, value in items.items()) + "}"


def _scalar(value: Scalar) -> str:
    if isinstance(value, float) and (value != value or value in (float("inf"), -float("inf"))):
        return f"float('{value}')"
    return repr(value)
