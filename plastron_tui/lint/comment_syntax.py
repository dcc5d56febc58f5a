"""How comments are written in the files of a workspace, and where a text has them."""

from __future__ import annotations

import re
from enum import Enum
from functools import lru_cache
from pathlib import Path

from plastron_tui.diagnostics import Span
from plastron_tui.targets import language_of

from .python_comments import python_comments
from .yaml_comments import yaml_comments

# A backslash takes a line break along, which is of two characters in some files.
_STRINGS = rb"\"(?:\\(?:\r\n|.)|[^\"\\\n])*\"?|'(?:\\(?:\r\n|.)|[^'\\\n])*'?"
_RAW_STRING = rb"(?<!\w)(?:u8|[uUL])?R\"(?P<raw>[^()\\\s]{0,16})\(.*?(?:\)(?P=raw)\"|\Z)"
# Quotes between the digits of a number begin nothing.
_NUMBER = rb"(?<!\w)\.?\d(?:'?[\w.]|(?<=[eEpP])[+-])*"

# All of a line is the value of a constant that is a string, signs of comments included.
_STRING_CONSTANT = rb"^(?:\xef\xbb\xbf)?[ \t]*w?string(?:[ \t]*<=[ \t]*\d+)?[ \t]+\w+[ \t]*=[^\n]*"

_TAG = rb"<(?:[^\"'<>]|\"[^\"]*(?:\"|\Z)|'[^']*(?:'|\Z))*>?"


class CommentStyle(Enum):
    """What a file's comments look like."""

    CPP = "cpp"
    PYTHON = "python"
    YAML = "yaml"
    CMAKE = "cmake"
    XML = "xml"
    DEFINITION = "definition"
    PROGRAM = "plastron"

    def comment(self, codes: str) -> str:
        """Return the comment that says that what breaks rules is meant."""
        if self is CommentStyle.CPP:
            return f"// NOLINT({codes})"
        if self is CommentStyle.XML:
            return f"<!-- noqa: {codes} -->"
        return f"{'//' if self is CommentStyle.PROGRAM else '#'} noqa: {codes}"


# Each begins at the first match, so that a sign in a string begins no comment. What has no end
# goes on to the end of the text, so that a text is passed over once.
_PARTS = {
    CommentStyle.CPP: rb"|".join((_RAW_STRING, _STRINGS, _NUMBER))
    + rb"|(?P<comment>//(?:\\[ \t\r\f\v]*\n|[^\n])*|/\*.*?(?:\*/|\Z))",
    # A bracket within a word begins no argument, nor does what is behind a backslash.
    CommentStyle.CMAKE: rb"(?P<comment>#\[(?P<c>=*)\[.*?(?:\](?P=c)\]|\Z)|#[^\n]*)|\\[^\n]"
    rb"|\"(?:\\.|[^\"\\])*\"?|(?<![^\s()\"])\[(?P<b>=*)\[.*?(?:\](?P=b)\]|\Z)",
    CommentStyle.XML: rb"(?P<comment><!--.*?(?:-->|\Z))|<!\[CDATA\[.*?(?:\]\]>|\Z)|"
    rb"<\?.*?(?:\?>|\Z)|" + _TAG,
    CommentStyle.DEFINITION: _STRING_CONSTANT + rb"|\"(?:\\[^\n]|[^\"\\\n])*\"?|"
    rb"'(?:\\[^\n]|[^'\\\n])*'?|(?P<comment>#[^\n]*)",
    CommentStyle.PROGRAM: rb"\"(?:\\[^\n]|[^\"\\\n])*\"?|/\*.*?(?:\*/|\Z)|(?P<comment>//[^\n]*)",
}  # fmt: skip
_LEXERS = {style: re.compile(parts, re.S | re.M) for style, parts in _PARTS.items()}

_STYLES = {
    ".py": CommentStyle.PYTHON,
    ".yaml": CommentStyle.YAML,
    ".yml": CommentStyle.YAML,
    ".cmake": CommentStyle.CMAKE,
    ".xml": CommentStyle.XML,
    ".launch": CommentStyle.XML,
    ".xacro": CommentStyle.XML,
    ".urdf": CommentStyle.XML,
    ".test": CommentStyle.XML,
    ".msg": CommentStyle.DEFINITION,
    ".srv": CommentStyle.DEFINITION,
    ".action": CommentStyle.DEFINITION,
    ".plastron": CommentStyle.PROGRAM,
} | dict.fromkeys((".cpp", ".cc", ".cxx", ".hpp", ".hxx", ".hh", ".h"), CommentStyle.CPP)


def style_of(file: Path, text: bytes = b"") -> CommentStyle | None:
    """Return what the comments of a file look like, None where none can say anything of rules.

    Its name tells it, or, of a file without a suffix, its text: a script begins with what runs it.
    """
    if file.name == "CMakeLists.txt":
        return CommentStyle.CMAKE
    if not file.suffix:
        return CommentStyle.PYTHON if language_of(file, text) is not None else None
    return _STYLES.get(file.suffix)


_NEXT_TAG = re.compile(rb"\s*(" + _TAG + rb")")


def tag_behind(text: bytes, offset: int) -> Span | None:
    """Return the tag of an XML text that follows an offset behind blanks alone, None for none."""
    found = _NEXT_TAG.match(text, offset)
    return None if found is None else Span(*found.span(1))


def tag_at(text: bytes, offset: int) -> Span | None:
    """Return the tag of an XML text that an offset is in, None where it is in none."""
    for match in _LEXERS[CommentStyle.XML].finditer(text):
        if match.start() <= offset < match.end():
            is_tag = text[match.start() + 1 : match.start() + 2].isalpha()
            return Span(*match.span()) if is_tag else None
    return None


@lru_cache(maxsize=4)
def comment_spans(style: CommentStyle, text: bytes) -> tuple[Span, ...]:
    """Return the places of the comments of a text."""
    if style is CommentStyle.YAML:
        found = yaml_comments(text)
    elif style is CommentStyle.PYTHON:
        found = python_comments(text)
    else:
        matches = _LEXERS[style].finditer(text)
        found = (Span(*each.span("comment")) for each in matches if each["comment"] is not None)
    return tuple(Span(start, start + len(text[start:end].rstrip())) for start, end in found)
