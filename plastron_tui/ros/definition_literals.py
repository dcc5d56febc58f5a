"""The values in a definition: constants, default values, and where a comment starts."""

from __future__ import annotations

from .interfaces import Scalar
from .primitives import PRIMITIVES, check_scalar

_OPENERS = frozenset({"", "=", "[", ","})
_BOOLS = {"true": True, "1": True, "false": False, "0": False}
_ESCAPES = {"\\": "\\", '"': '"', "'": "'", "n": "\n", "t": "\t"}


def split_comment(text: str, ros_version: int, type_name: str = "") -> tuple[str, str]:
    """Split what follows a name into the code and the comment, which starts at a `#`.

    A string constant of ROS 1 reaches to the end of the line, `#` or not; within the quotes of
    a ROS 2 string a `#` is a character like any other.
    """
    if ros_version == 1 and type_name == "string":
        return text, ""
    if "#" not in text:
        return text, ""
    at = _comment_start(text) if ros_version == 2 else text.index("#")
    if at < 0:
        return text, ""
    return text[:at].rstrip(), text[at:].lstrip("#").strip()


def is_separator(line: str, ros_version: int) -> bool:
    """Tell whether a line ends a section: `---`, which more may follow in ROS 1."""
    return line.startswith("---") if ros_version == 1 else line == "---"


def _comment_start(text: str) -> int:
    """Return where the first `#` outside quotes is, -1 when there is none."""
    bare, is_closed = _outside_quotes(text, may_open_after=_OPENERS)
    found = next((at for at in bare if text[at] == "#"), -1)
    # A quote that nothing closes was an apostrophe.
    return found if found >= 0 or is_closed else text.find("#")


def _outside_quotes(
    text: str, may_open_after: frozenset[str] | None = None
) -> tuple[list[int], bool]:
    """Return the offsets of what is in no quotes, and whether each quote is closed.

    Args:
        text: what to look through.
        may_open_after: the characters after which a quote opens a string, spaces apart, and ""
            for the start of the text; None for any.
    """
    bare: list[int] = []
    quote = ""
    is_escaped = False
    before = ""
    for at, character in enumerate(text):
        if is_escaped:
            is_escaped = False
        elif quote:
            is_escaped = character == "\\"
            if character == quote:
                quote = ""
        elif character in "\"'" and (may_open_after is None or before in may_open_after):
            quote = character
        else:
            bare.append(at)
        if not character.isspace():
            before = character
    return bare, not quote


def parse_literal(type_name: str, text: str, ros_version: int) -> Scalar | ValueError:
    """Return the value that a literal has in a definition, or why it has none."""
    kind = PRIMITIVES[ros_version][type_name].kind
    value: Scalar
    if kind is bool and ros_version == 1:
        # `genmsg` evaluates it as a literal of Python.
        if text not in ("True", "False", "0", "1"):
            return ValueError(f"`{_cut(text)}` is not a `bool`, which is `True` or `False`")
        return text in ("True", "1")
    if kind is bool:
        if text.lower() not in _BOOLS:
            return ValueError(f"`{_cut(text)}` is not a `bool`")
        return _BOOLS[text.lower()]
    if kind is str:
        value = _unquoted(text) if ros_version == 2 else text
    else:
        try:
            value = _integer(text, ros_version) if kind is int else float(text)
        except ValueError:
            return ValueError(f"`{_cut(text)}` is not a value of `{type_name}`")
    problem = check_scalar(type_name, value, ros_version)
    return value if problem is None else ValueError(problem)


def parse_array(type_name: str, text: str, ros_version: int) -> tuple[Scalar, ...] | ValueError:
    """Return the values of a literal such as `[1, 2, 3]`, or why it has none."""
    if not (text.startswith("[") and text.endswith("]") and len(text) > 1):
        return ValueError("the default value of an array is a list in brackets")
    values: list[Scalar] = []
    for part in _split_elements(text[1:-1]):
        value = parse_literal(type_name, part.strip(), ros_version)
        if isinstance(value, ValueError):
            return value
        values.append(value)
    return tuple(values)


def _split_elements(text: str) -> list[str]:
    """Split at the commas outside quotes; no text gives no elements."""
    commas = [at for at in _outside_quotes(text)[0] if text[at] == ","]
    if not commas and not text.strip():
        return []
    starts, ends = [0, *(at + 1 for at in commas)], [*commas, len(text)]
    return [text[start:end] for start, end in zip(starts, ends, strict=True)]


def _integer(text: str, ros_version: int) -> int:
    # A leading zero is decimal, as Python's own int() reads it; `0x` needs to be asked for.
    try:
        return int(text)
    except ValueError:
        if ros_version == 1:  # `genmsg` takes decimal digits only
            raise
        return int(text, 0)


def _unquoted(text: str) -> str:
    if len(text) < 2 or text[0] not in "\"'" or text[-1] != text[0]:
        return text
    result: list[str] = []
    characters = iter(text[1:-1])
    for character in characters:
        if character != "\\":
            result.append(character)
            continue
        escaped = next(characters, "\\")
        result.append(_ESCAPES.get(escaped, f"\\{escaped}"))
    return "".join(result)


def _cut(text: str) -> str:
    return text if len(text) <= 40 else f"{text[:39]}…"
