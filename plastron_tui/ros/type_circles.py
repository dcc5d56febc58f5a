"""Circles of types: messages that contain themselves."""

from __future__ import annotations

from collections.abc import Mapping

from .interfaces import Interface, InterfaceName


def find_circle(messages: Mapping[InterfaceName, Interface]) -> tuple[InterfaceName, ...]:
    """Return the messages of a circle in their order, () when no message contains itself."""
    done: set[InterfaceName] = set()
    for start in messages:
        path: list[InterfaceName] = []
        stack = [iter((start,))]
        while stack:
            name = next(stack[-1], None)
            if name is None:
                stack.pop()
                if path:
                    done.add(path.pop())
            elif name in path:
                return tuple(path[path.index(name) :])
            elif name in messages and name not in done:
                path.append(name)
                stack.append(iter(_nested(messages[name])))
    return ()


def _nested(interface: Interface) -> tuple[InterfaceName, ...]:
    fields = (field for section in interface.sections for field in section.fields)
    return tuple(field.type.message for field in fields if field.type.message is not None)
