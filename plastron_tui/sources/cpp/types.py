"""What the types of a file stand for: aliases, namespaces, pointers, and interfaces of ROS.

Source: `rosidl_generator_cpp` (`pkg::msg::Name`, in the header `pkg/msg/name.hpp`, with the
pointers that `rosidl_runtime_cpp` and rclcpp give it), `gencpp` of ROS 1 (`pkg::Name`, in the
header `pkg/Name.h`, with `NamePtr` and `NameConstPtr`).
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from functools import cached_property

from plastron_tui.ros.catalog import usual_distribution
from plastron_tui.ros.catalog.data import index
from plastron_tui.ros.interfaces import InterfaceKind, InterfaceName

from .arguments import Call
from .scopes import Scope, type_text
from .type_texts import template_arguments, without_pointer
from .unit import Unit

MOST_EXPANSIONS = 12

_EVENT = re.compile(r"(?:ros|message_filters)::(?:Message|Service)Event<(.+)>")
_ADAPTER = re.compile(r"rclcpp::TypeAdapter<(.+)>|rclcpp::adapt_type<.+>::(?:template)?as<(.+)>")
_PART = re.compile(r"::(?:Request|Response|Goal|Result|Feedback|Impl)\Z")
KNOWN = {
    **dict.fromkeys(
        (
            "NodeHandle",
            "Duration",
            "WallDuration",
            "Rate",
            "WallRate",
            "SubscribeOptions",
            "AdvertiseOptions",
            "init",
        ),
        ("ros",),
    ),
    **dict.fromkeys(("Node", "QoS", "KeepLast", "KeepAll", "SensorDataQoS"), ("rclcpp",)),
    "LifecycleNode": ("rclcpp_lifecycle", "nav2_util"),
    "Nodelet": ("nodelet",),
    "ImageTransport": ("image_transport",),
    "SubscriberFilter": ("image_transport",),
    "Subscriber": ("message_filters",),
    "RealtimePublisher": ("realtime_tools",),
    **dict.fromkeys(
        ("SimpleActionServer", "SimpleActionClient", "ActionServer", "ActionClient"),
        ("actionlib",),
    ),
    "TransformListener": ("tf2_ros", "tf"),
    "TransformBroadcaster": ("tf2_ros", "tf"),
    "StaticTransformBroadcaster": ("tf2_ros",),
}
"""The namespaces of the classes of ROS that say what a node is, by short name."""

_FIRST = re.compile(r"\w+")
_NO_PACKAGES = frozenset(
    {"std", "boost", "cv", "ros", "Eigen", "message_filters", "rclcpp", "tf2", "YAML", "Json"}
)
_POINT_CLOUD = InterfaceName("sensor_msgs", "PointCloud2")
_KINDS = ("msg", "srv", "action")


class Types:
    """What the types of the files of a unit stand for."""

    def __init__(self, unit: Unit, ros_version: int) -> None:
        self._unit = unit
        self._ros = ros_version
        self._expanded: dict[tuple[str, int], str] = {}

    @cached_property
    def _aliases(self) -> dict[str, str | None]:
        """The aliases outside of classes and functions, None where there are two of a name."""
        found: dict[str, str | None] = {}
        for scope in self._unit.scopes():
            if scope.kind in ("file", "namespace"):
                for name, text in scope.aliases.items():
                    found[name] = text if found.get(name, text) == text else None
        return found

    @cached_property
    def _short(self) -> set[str]:
        """The names that may stand for another type, or for a part of one."""
        found = {*KNOWN, *self._unit.defines, *self._namespaces, *self._unit.classes}
        for scope in self._unit.scopes():
            found.update(scope.aliases)
            found.update(scope.template_names)
        return found

    @cached_property
    def _included(self) -> dict[str, set[tuple[str, ...]]]:
        """The interfaces whose headers are included, by bare name in small letters."""
        found: dict[str, set[tuple[str, ...]]] = {}
        for file in self._unit.files:
            for include in file.syntax.includes:
                parts = include.path.rpartition(".")[0].split("/")
                if self._ros == 2 and len(parts) == 3 and parts[1] in _KINDS:
                    bare = parts[2].replace("_", "").lower()
                    found.setdefault(bare, set()).add((parts[0], parts[1]))
                elif self._ros == 1 and len(parts) == 2:
                    found.setdefault(parts[1], set()).add((parts[0],))
        return found

    @cached_property
    def _namespaces(self) -> set[str]:
        scopes = self._unit.scopes()
        return {scope.name for scope in scopes if scope.kind == "namespace" and scope.name}

    def expand(self, text: str, scope: Scope) -> str:
        """Return a type with its aliases resolved."""
        first = _FIRST.match(text)
        if first is not None and first[0] not in self._short:
            return text
        key = text, id(scope)
        if not self._unit.bindings and key in self._expanded:
            return self._expanded[key]
        found = self._expand(text, scope)
        if not self._unit.bindings:
            self._expanded[key] = found
        return found

    def _expand(self, text: str, scope: Scope) -> str:
        seen = set()
        for _ in range(MOST_EXPANSIONS):
            if text in seen or len(text) > 2_000:
                break
            seen.add(text)
            head, bracket, rest = text.partition("<")
            first, colons, others = head.partition("::")
            bound = self._bound(first, scope)
            if bound is not None:
                text, scope = bound[0] + colons + others + bracket + rest, bound[1]
                continue
            target = self._alias(first, scope)
            if target is None and colons:
                second, more, tail = others.partition("::")
                owner = self._unit.find_class(first, scope)
                inner = owner.aliases.get(second) if owner is not None else None
                if inner is not None and owner is not None:
                    text, scope = inner + more + tail + bracket + rest, owner
                    continue
                qualified = self._aliases.get(second) if first in self._namespaces else None
                if qualified is not None:
                    text = qualified + more + tail + bracket + rest
                    continue
            if target is None or target == first:
                break
            if bracket and target.endswith(">"):
                # The arguments of a template that is an alias are not put in.
                text = target + (colons + others if colons else "")
            else:
                text = target + colons + others + bracket + rest
        return self._in_namespace(text.removeprefix("::"), scope)

    def _in_namespace(self, text: str, scope: Scope) -> str:
        """Return the full name of a class of ROS that `using namespace` lets be short."""
        head = text.partition("<")[0]
        for space in KNOWN.get(head, ()):
            if space in self._spaces(scope):
                return f"{space}::{text}"
        return text

    def _spaces(self, scope: Scope) -> set[str]:
        found = {name for each in scope.chain for name in each.usings}
        return found | self._used_outside

    @cached_property
    def _used_outside(self) -> set[str]:
        """The namespaces whose names are used outside of classes and functions."""
        outside = (each for each in self._unit.scopes() if each.kind in ("file", "namespace"))
        return {name for each in outside for name in each.usings}

    def _bound(self, name: str, scope: Scope) -> tuple[str, Scope] | None:
        """Return what a template parameter is in the call that is looked at."""
        for each in scope.chain:
            if name in each.template_names:
                position = each.template_names.index(name)
                for function, (call, _) in self._unit.bindings.items():
                    if call is None:
                        continue
                    if function.place is each or function.place.parent is each:
                        given = _template_of(call)
                        if position < len(given):
                            return given[position], call.scope
                return None
        return None

    def may_be(self, name: str, wanted: Collection[str]) -> bool:
        """Tell whether a short name is one of some, or may stand for one."""
        return name in wanted or name in self._renamed

    @cached_property
    def _renamed(self) -> set[str]:
        found = set(self._unit.defines)
        for scope in self._unit.scopes():
            found.update(scope.aliases)
            found.update(scope.template_names)
        return found

    def is_parameter(self, text: str, scope: Scope) -> bool:
        """Whether a type is, or begins with, a parameter of a template around it."""
        first = re.split(r"::|<", text)[0]
        return any(first in each.template_names for each in scope.chain)

    def _alias(self, name: str, scope: Scope) -> str | None:
        for each in scope.chain:
            if name in each.aliases:
                return each.aliases[name]
            owner = None
            if each.kind == "class":
                owner = each
            elif each.kind == "function" and each.function is not None:
                owner = self._unit.class_of_function(each.function)
            for base in self._unit.bases(owner) if owner is not None else ():
                if name in base.aliases:
                    return base.aliases[name]
        if name in self._aliases:
            return self._aliases[name]
        texts = self._unit.defines.get(name, [])
        return type_text(texts[0]) if len(set(texts)) == 1 and "(" not in texts[0] else None

    def interface(self, text: str, scope: Scope, is_part: bool = False) -> InterfaceName | None:
        """Return the interface that a type is, or points to, None for none.

        Args:
            text: the type as it is written.
            scope: where it is written.
            is_part: whether it may be the request or the response of a service.
        """
        for _ in range(6):
            text = self.expand(text.removeprefix("::"), scope)
            if found := _EVENT.fullmatch(text):
                text = template_arguments(found[1])[0]
            elif found := _ADAPTER.fullmatch(text):
                text = template_arguments(found[1])[-1] if found[1] else found[2]
            elif (bare := without_pointer(text)) != text:
                text = bare
            else:
                break
        if is_part:
            text = _PART.sub("", text)
        if "<" in text:
            is_cloud = self._ros == 1 and text.startswith("pcl::PointCloud<")
            return _POINT_CLOUD if is_cloud else None
        if self._is_own(text, scope):
            return None
        if self._ros == 2:
            return self._of_ros2(text, scope)
        return self._of_ros1(text, scope, is_part)

    def _is_own(self, text: str, scope: Scope) -> bool:
        """Whether a name is that of a class of the files, or a parameter of a template."""
        return self._unit.find_class(text, scope) is not None or self.is_parameter(text, scope)

    def _of_ros2(self, text: str, scope: Scope) -> InterfaceName | None:
        parts = text.split("::")
        if len(parts) == 3 and parts[1] in _KINDS:
            return InterfaceName(parts[0], parts[2])
        if len(parts) > 2 or (len(parts) == 2 and parts[0] not in _KINDS):
            return None
        bare = parts[-1]
        included = self._included.get(bare.replace("_", "").lower(), set())
        places = {tuple(each.split("::")) for each in self._usings(scope)}
        found = [
            (package, kind)
            for package, kind in included
            if ((package, kind) in places and len(parts) == 1)
            or ((package,) in places and len(parts) == 2 and parts[0] == kind)
        ]
        if len(found) == 1:
            return InterfaceName(found[0][0], bare)
        known = {
            InterfaceName(place[0], bare)
            for place in places
            if len(place) == 2 and place[1] in _KINDS and self._is_known(place[0], bare, place[1])
        }
        return known.pop() if len(known) == 1 and not found and len(parts) == 1 else None

    def _is_known(self, package: str, bare: str, kind: str) -> bool:
        names = index(usual_distribution(self._ros)).names[InterfaceKind(kind)]
        return InterfaceName(package, bare) in names

    def _of_ros1(self, text: str, scope: Scope, is_part: bool) -> InterfaceName | None:
        parts = text.split("::")
        if len(parts) == 2 and parts[0] not in _NO_PACKAGES:
            package, bare = parts[0], _bare(parts[1], is_part)
            is_included = (package,) in self._included.get(bare, ())
            # A header may declare messages ahead, `namespace std_msgs { class String; }`.
            is_of_messages = package.endswith("_msgs")
            if package in self._namespaces and not is_included and not is_of_messages:
                return None
            return InterfaceName(package, bare)
        if len(parts) != 1:
            return None
        bare = _bare(text, is_part)
        places = set(self._usings(scope))
        found = {each[0] for each in self._included.get(bare, ()) if each[0] in places}
        if not found:
            found = {
                place
                for place in places
                if any(self._is_known(place, bare, kind) for kind in ("msg", "srv"))
            }
        return InterfaceName(found.pop(), bare) if len(found) == 1 else None

    def _usings(self, scope: Scope) -> Iterator[str]:
        for each in scope.chain:
            yield from (self.expand(name, each.file.root) for name in each.usings)
            if each.kind == "namespace":
                yield each.name
        yield from self._usings_of_all

    @cached_property
    def _usings_of_all(self) -> tuple[str, ...]:
        scopes = (each for each in self._unit.scopes() if each.kind in ("file", "namespace"))
        return tuple(name for each in scopes for name in each.usings)


def _template_of(call: Call) -> list[str]:
    """Return the template arguments that a call gives, or the class of what it makes."""
    syntax = call.scope.file.syntax
    return list(call.types) or [type_text(syntax.word(each)) for each in call.type_nodes]


def _bare(name: str, is_part: bool) -> str:
    """Return the name of a message without what makes it a pointer, or a part of a service."""
    for suffix in ("ConstPtr", "Ptr"):
        if name.endswith(suffix) and name != suffix:
            name = name.removesuffix(suffix)
            break
    for suffix in ("Request", "Response") if is_part else ():
        if name.endswith(suffix) and name != suffix:
            return name.removesuffix(suffix)
    return name
