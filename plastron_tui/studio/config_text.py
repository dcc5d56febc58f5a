"""Reads the text of the configuration file: settings with their lines, whatever the YAML is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import shortened

if TYPE_CHECKING:
    import yaml

_TRUE = frozenset({"true", "yes", "on"})
_FALSE = frozenset({"false", "no", "off"})
_LONGEST = 80
"""Bytes of a name or a value that are looked at: no setting has more."""
_MOST = 500
"""The most lines of a mapping that are looked at."""


class NotSettingsError(Exception):
    """The text is no mapping of settings; the message says why.

    Attributes:
        line: where that is seen, counted from 1; None where it is all of it.
    """

    def __init__(self, words: str, line: int | None = None) -> None:
        super().__init__(words)
        self.line = line


@dataclass(frozen=True, slots=True)
class Setting:
    """One line of a mapping.

    Attributes:
        name: what stands before the colon.
        line: its line, counted from 1.
        node: what stands behind the colon.
    """

    name: str
    line: int
    node: yaml.Node

    @property
    def word(self) -> str | None:
        """What stands behind the colon, as it is written; None where that is not one value."""
        import yaml

        is_one = isinstance(self.node, yaml.ScalarNode)
        return shortened(self.node.value, _LONGEST) if is_one else None

    @property
    def switch(self) -> bool | None:
        """Whether it is on; None where that is not what it says."""
        import yaml

        is_plain = isinstance(self.node, yaml.ScalarNode) and self.node.style is None
        word = str(self.node.value).lower() if is_plain else ""
        return True if word in _TRUE else False if word in _FALSE else None

    @property
    def words(self) -> tuple[str, ...] | None:
        """One value, or a list of them; None where it is neither, or has nothing in it."""
        import yaml

        nodes = self.node.value if isinstance(self.node, yaml.SequenceNode) else [self.node]
        if not nodes or not all(isinstance(node, yaml.ScalarNode) for node in nodes):
            return None
        words = tuple(shortened(node.value, _LONGEST) for node in nodes[:_MOST])
        return words if all(word.strip() for word in words) else None

    @property
    def settings(self) -> tuple[Setting, ...] | None:
        """The lines of a mapping; None where it is none."""
        return _settings_of(self.node)


def read_settings(data: bytes) -> tuple[Setting, ...]:
    """Return the settings of a text, in its order.

    Nothing is made of what stands there: a value such as `!!int ''` is a text like any other.

    Raises:
        NotSettingsError: if it is not YAML, or no mapping.
    """
    import yaml

    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise NotSettingsError(
            "this is not UTF-8 text", data.count(b"\n", 0, error.start) + 1
        ) from None
    try:
        node = yaml.compose(text, yaml.SafeLoader)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        place = getattr(error, "position", None)
        line: int | None
        if mark is not None:
            line = mark.line + 1
        else:
            line = text.count("\n", 0, place) + 1 if isinstance(place, int) else None
        raise NotSettingsError("this is not YAML", line) from None
    except (ValueError, RecursionError):
        raise NotSettingsError("this is not YAML") from None
    if node is None:
        return ()
    found = _settings_of(node)
    if found is None:
        raise NotSettingsError("this is not a mapping of settings")
    return found


def _settings_of(node: yaml.Node) -> tuple[Setting, ...] | None:
    import yaml

    if not isinstance(node, yaml.MappingNode):
        is_empty = isinstance(node, yaml.ScalarNode) and not str(node.value).strip()
        return () if is_empty else None
    return tuple(
        Setting(
            shortened(key.value, _LONGEST) if isinstance(key, yaml.ScalarNode) else "?",
            key.start_mark.line + 1,
            value,
        )
        for key, value in node.value[:_MOST]
    )
