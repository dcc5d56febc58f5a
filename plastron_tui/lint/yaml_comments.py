"""Where a text of YAML has comments."""

from __future__ import annotations

import re
from collections.abc import Iterator

from plastron_tui.diagnostics import Span
from plastron_tui.ros.yaml_text import YamlText

_LINE_ENDS = "\r\n\x85\u2028\u2029"
_COMMENT = re.compile(f"#[^{_LINE_ENDS}]*")
_LINE = re.compile(f"[^{_LINE_ENDS}]*")


def yaml_comments(source: bytes) -> Iterator[Span]:
    """Yield the places of the comments: whatever begins with their sign between two tokens.

    Whether a sign is within a scalar only the scanner of YAML knows. It tells nothing of what
    follows a mistake, nor of a file that is not UTF-8.
    """
    try:
        yaml_text = YamlText(source)
    except UnicodeDecodeError:
        return
    text = yaml_text.text
    for start, end in _gaps(text):
        for found in _COMMENT.finditer(text, start, end):
            yield Span(yaml_text.byte(found.start()), yaml_text.byte(found.end()))


def _gaps(text: str) -> Iterator[tuple[int, int]]:
    """Yield where nothing but blanks and comments is, as far as a text is YAML."""
    import yaml

    loader = yaml.CBaseLoader if yaml.__with_libyaml__ else yaml.BaseLoader
    at = 0
    try:
        for token in yaml.scan(text, Loader=loader):
            yield at, token.start_mark.index
            at = token.end_mark.index
            if isinstance(token, yaml.ScalarToken) and token.style in ("|", ">"):
                # The line that a block scalar begins in may end with a comment.
                start = token.start_mark.index
                line = _LINE.match(text, start)
                yield start, start if line is None else min(line.end(), at)
    except (yaml.YAMLError, ValueError):
        return
