"""Launch files of ROS 2 in YAML: the same words as in XML, read by the same rules.

Source: `launch_yaml`: an action is a mapping of one key, its name; what has children is a list of
actions, or a mapping that has them as `children`.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import yaml

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.ros.launch import Format, LaunchFile
from plastron_tui.ros.yaml_text import YamlText
from plastron_tui.sources.xml.document import Attribute, Element

from . import ros2_elements
from .xml_reader import LaunchRead, read_items

_LARGEST = 500_000
_MOST_ELEMENTS = 20_000
"""Aliases make more of a file than it says."""
_DEEPEST = 60
_BOOL = "tag:yaml.org,2002:bool"


class _BrokenError(Exception):
    """A file that is no launch file: why, and where."""

    def __init__(self, message: str, span: Span | None = None) -> None:
        super().__init__(message)
        self.message, self.span = message, span


def read_launch_yaml(source: bytes, file: Path | None = None) -> LaunchRead:
    """Read a launch file in YAML."""
    try:
        root = _Reader(source).root()
    except _BrokenError as error:
        found = Diagnostic(codes.BROKEN_LAUNCH, error.message, error.span, file)
        return LaunchRead(None, Format.YAML, None, (found,))
    items = tuple(read_items(root, ros2_elements.item_of))
    return LaunchRead(LaunchFile(items), Format.YAML)


class _Reader:
    """Makes elements of a document; the marks of PyYAML count characters, spans bytes."""

    def __init__(self, source: bytes) -> None:
        if len(source) > _LARGEST:
            raise _BrokenError(f"the file is larger than {_LARGEST} bytes")
        try:
            self._yaml = YamlText(source)
        except UnicodeDecodeError as error:
            raise _BrokenError("the file is not UTF-8", Span(error.start, error.end)) from None
        self._count = 0

    def root(self) -> Element:
        """Return the file as the element `launch`.

        Raises:
            _BrokenError: it is no launch file.
        """
        document = self._document()
        if not isinstance(document, yaml.MappingNode) or len(document.value) != 1:
            raise _BrokenError("a launch file in YAML has one key, `launch`, and nothing beside it")
        key, value = document.value[0]
        if key.value != "launch":
            raise _BrokenError(
                "the outermost key of a launch file is `launch`", self._yaml.span(key)
            )
        return self._element(key, value, 0)

    def _document(self) -> yaml.Node | None:
        self._check_depth()
        try:
            found: yaml.Node | None = yaml.compose(self._yaml.text, Loader=yaml.SafeLoader)
        except yaml.MarkedYAMLError as error:
            mark = error.problem_mark or error.context_mark
            at = self._yaml.byte(0 if mark is None else mark.index)
            message = f"this is no YAML: {error.problem or 'it cannot be read'}"
            raise _BrokenError(message, Span(at, at)) from None
        except (yaml.YAMLError, RecursionError, ValueError):
            raise _BrokenError("this is no YAML that can be read") from None
        return found

    def _check_depth(self) -> None:
        """Refuse what would be nested deeper than Python goes, before anything is composed."""
        depth = 0
        try:
            for event in yaml.parse(self._yaml.text, Loader=yaml.SafeLoader):
                depth += isinstance(event, yaml.CollectionStartEvent)
                depth -= isinstance(event, yaml.CollectionEndEvent)
                if depth > _DEEPEST:
                    raise _BrokenError("this is nested too deep")
        except (yaml.YAMLError, RecursionError, ValueError):
            return  # Composing tells what is wrong.

    def _element(
        self, key: yaml.Node, body: yaml.Node, depth: int, *, is_listed: bool = False
    ) -> Element:
        """Return what a key has; one of several that share their key begins behind it."""
        first = body if is_listed else key
        self._count += 1
        keys = [name for name, _ in body.value] if isinstance(body, yaml.MappingNode) else []
        for each in (key, *keys):
            if not isinstance(each, yaml.ScalarNode):
                raise _BrokenError("a key is a word, and this is none", self._yaml.span(each))
        span = Span(self._yaml.span(first).start, self._yaml.span(body).end)
        if self._count > _MOST_ELEMENTS or depth > _DEEPEST:
            raise _BrokenError("the aliases make too much of the file", self._yaml.span(key))
        attributes: list[Attribute] = []
        children: list[Element] = []
        if isinstance(body, yaml.SequenceNode):
            children += self._actions(body, depth)
        elif isinstance(body, yaml.MappingNode):
            for name, value in body.value:
                if name.value == "children" and isinstance(value, yaml.SequenceNode):
                    children += self._actions(value, depth)
                elif self._is_value(value):
                    attributes.append(self._attribute(name, value))
                else:
                    children += self._nested(name, value, depth)
        elif body.value:
            raise _BrokenError(f"`{key.value}` has no attributes here", self._yaml.span(body))
        return Element(
            str(key.value),
            tuple(attributes),
            tuple(children),
            ("",) * (len(children) + 1),
            span,
            self._yaml.span(key),
            span,
            None,
            first.start_mark.line + 1,
        )

    def _actions(self, body: yaml.SequenceNode, depth: int) -> Iterator[Element]:
        for each in body.value:
            if not isinstance(each, yaml.MappingNode) or len(each.value) != 1:
                message = "an action of a launch file is one key with what belongs to it"
                raise _BrokenError(message, self._yaml.span(each))
            ((key, body),) = each.value
            yield self._element(key, body, depth + 1)

    def _nested(self, name: yaml.Node, value: yaml.Node, depth: int) -> Iterator[Element]:
        """Yield the parts of an action, such as its parameters."""
        is_list = isinstance(value, yaml.SequenceNode)
        for each in value.value if is_list else (value,):
            if not isinstance(each, yaml.MappingNode):
                raise _BrokenError(
                    f"each `{name.value}` has a name and more", self._yaml.span(each)
                )
            yield self._element(name, each, depth + 1, is_listed=is_list)

    def _is_value(self, value: yaml.Node) -> bool:
        if isinstance(value, yaml.SequenceNode):
            return all(isinstance(each, yaml.ScalarNode) for each in value.value)
        return isinstance(value, yaml.ScalarNode)

    def _attribute(self, name: yaml.Node, value: yaml.Node) -> Attribute:
        if isinstance(value, yaml.SequenceNode):
            text = f"[{', '.join(self._source(each) for each in value.value)}]"
        elif value.tag == _BOOL:
            is_true = yaml.SafeLoader.bool_values.get(value.value.lower())
            text = str(value.value) if is_true is None else str(is_true).lower()
        else:
            text = str(value.value)
        span = Span(self._yaml.span(name).start, self._yaml.span(value).end)
        start, end = self._yaml.span(value)
        is_quoted = isinstance(value, yaml.ScalarNode) and value.style in ("'", '"')
        inner = Span(start + is_quoted, end - is_quoted)
        return Attribute(str(name.value), text, span, inner)

    def _source(self, node: yaml.Node) -> str:
        return self._yaml.text[node.start_mark.index : node.end_mark.index]
