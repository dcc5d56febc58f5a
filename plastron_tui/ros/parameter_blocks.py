"""Parameter files of ROS 2 with the places of all that they say, for who tells what is wrong there.

The text is taken event by event, so that nothing of it is nested deeper than is looked at.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

from plastron_tui.diagnostics import Span

from .parameter_values import MIXED_LIST, SECTION, Mistake, is_node_pattern, value_of
from .parameters import Setting
from .yaml_text import YamlText

_DEEPEST = 40
_MOST_EVENTS = 50_000
_STRING = "tag:yaml.org,2002:str"

_Node = Any
"""A node of PyYAML's tree."""


class KeyPart(NamedTuple):
    """A key as it is written, and its place; with dots where it is written so."""

    text: str
    span: Span


class ParameterKey(NamedTuple):
    """A parameter that gets a value.

    Attributes:
        parts: the keys that lead to it, the outermost first.
        value: its value, None where that is none, or one that no parameter can hold.
        span: the value.
        problem: what is wrong with a list of several types, "" for nothing.
    """

    parts: tuple[KeyPart, ...]
    value: Setting | None
    span: Span
    problem: str = ""

    @property
    def name(self) -> str:
        """Its name, such as `pid.kp`."""
        return ".".join(part.text for part in self.parts)


class ParameterBlock(NamedTuple):
    """The parameters of the nodes of a pattern, such as `/**` or `/talker`.

    Attributes:
        pattern: the pattern.
        name: its last part, as it is written, and its place.
        keys: the parameters.
    """

    pattern: str
    name: KeyPart
    keys: tuple[ParameterKey, ...]

    @property
    def last(self) -> str:
        """The last part of the pattern: the name of a node, or a wildcard."""
        return self.pattern.rpartition("/")[2]

    @property
    def is_for_any(self) -> bool:
        """Whether nodes of any name get them."""
        return "*" in self.last


def read_blocks(text: bytes) -> tuple[ParameterBlock, ...] | None:
    """Return what a parameter file says, None where it is none that a node can take."""
    import yaml

    try:
        yaml_text = YamlText(text)
        root = _tree(yaml_text.text)
    except (ValueError, OverflowError, yaml.YAMLError):
        return None
    if root is None:
        return None
    reader = _Reader(yaml_text)
    reader.nodes(root, "", None)
    return tuple(reader.found) if reader.is_right else None


def _tree(text: str) -> _Node:
    """Return the tree of the one document of a text, None where it is too deep, or has aliases.

    Raises:
        yaml.YAMLError: it is no YAML.
    """
    import yaml

    loader = yaml.CBaseLoader if yaml.__with_libyaml__ else yaml.BaseLoader
    root: _Node = None
    open_nodes: list[_Node] = []
    for count, event in enumerate(yaml.parse(text, Loader=loader)):
        if count > _MOST_EVENTS or len(open_nodes) > _DEEPEST:
            return None
        if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None) is not None:
            return None
        if isinstance(event, yaml.CollectionEndEvent):
            open_nodes.pop().end_mark = event.end_mark
            continue
        if not isinstance(event, (yaml.ScalarEvent, yaml.CollectionStartEvent)):
            continue
        node = _node(event)
        if open_nodes:
            open_nodes[-1].value.append(node)
        elif root is not None:
            return None
        else:
            root = node
        if node.id != "scalar":
            open_nodes.append(node)
    return root


def _node(event: Any) -> _Node:
    """Return the node that an event begins."""
    import yaml

    tag = getattr(event, "tag", None) or _STRING
    start, end = event.start_mark, event.end_mark
    if isinstance(event, yaml.ScalarEvent):
        # The parser of libyaml says "" for a scalar without quotes.
        return yaml.ScalarNode(tag, event.value, start, end, event.style or None)
    if isinstance(event, yaml.SequenceStartEvent):
        return yaml.SequenceNode(tag, [], start, end)
    return yaml.MappingNode(tag, [], start, end)


class _Reader:
    """Goes over the tree; whatever ROS does not take ends it, since the file is then never used."""

    def __init__(self, text: YamlText) -> None:
        self.found: list[ParameterBlock] = []
        self.is_right = True
        self._text = text

    def nodes(self, node: _Node, pattern: str, name: KeyPart | None) -> None:
        """Read what stands below a part of a node's name."""
        for key, value in self._pairs(node):
            part = self._part(key)
            bare = key.value.strip("/")
            if bare == SECTION and name is not None:
                self.found.append(ParameterBlock(pattern, name, tuple(self._keys(value, ()))))
            elif is_node_pattern(bare):
                self.nodes(value, f"{pattern}/{bare}", part)
            else:
                self.is_right = False

    def _keys(self, node: _Node, before: tuple[KeyPart, ...]) -> Iterator[ParameterKey]:
        for key, value in self._pairs(node):
            parts = (*before, self._part(key))
            if value.id == "mapping" and value.value:
                yield from self._keys(value, parts)
            else:
                found = value_of(value, self._text.text)
                is_nothing = value.id == "scalar" and value.value in ("", "~", "null")
                if isinstance(found, Mistake):
                    problem = MIXED_LIST if found.message == MIXED_LIST else ""
                    yield ParameterKey(parts, None, self._text.span(value), problem)
                elif is_nothing and value.style is None:
                    yield ParameterKey(parts, None, self._text.span(value))
                else:
                    yield ParameterKey(parts, found, self._text.span(value))

    def _pairs(self, node: _Node) -> Iterator[tuple[_Node, _Node]]:
        if node.id != "mapping":
            # A node without parameters has nothing behind its name.
            self.is_right = self.is_right and node.id == "scalar" and not node.value
            return
        for key, value in zip(node.value[::2], node.value[1::2], strict=False):
            if key.id == "scalar":
                yield key, value
            else:
                self.is_right = False

    def _part(self, key: _Node) -> KeyPart:
        return KeyPart(key.value, self._text.span(key))
