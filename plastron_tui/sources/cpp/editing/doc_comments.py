"""Comments for documentation above functions, as a file has them.

Source: the page "Documenting the code" of Doxygen's manual.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from tree_sitter import Node

from plastron_tui.sources.splices import line_start

from ..scopes import CppFile

_LINE = re.compile(r"[ \t]*(//[/!])(?!/)")
_OPEN = re.compile(r"[ \t]*(/\*[*!])(?!\*)")
_BRIEF = re.compile(r"[@\\]brief\s+")
_PARAMETER = re.compile(r"[@\\]param(?:\[\w+\])?\s")
_RETURN = re.compile(r"[@\\]returns?\s")


def comment_above(file: CppFile, node: Node) -> list[str]:
    """Return the lines of the comment for documentation that stands right above a function."""
    text = file.syntax.text
    lines: list[str] = []
    offset = line_start(text, node.start_byte)
    is_block = False
    while (start := line_start(text, max(offset - 1, 0))) < offset:
        line = text[start:offset].decode(file.syntax.encoding, "replace").rstrip()
        if not lines and line.endswith("*/"):
            is_block = True
        elif not is_block and not _LINE.match(line):
            break
        lines.insert(0, line)
        offset = start
        if is_block and "/*" in line:
            return lines if _OPEN.match(line) else []
    return [] if is_block else lines


def is_apart(file: CppFile, node: Node) -> bool:
    """Tell whether an empty line stands above a function, or above the comment on it."""
    text = file.syntax.text
    offset = line_start(text, node.start_byte)
    for _ in comment_above(file, node):
        offset = line_start(text, offset - 1)
    return offset > 0 and not text[line_start(text, offset - 1) : offset].strip()


def _what(parameter: str) -> str:
    """Return what a parameter of a callback is, by its name."""
    word = parameter.lower()
    if word.startswith("req"):
        return "the request"
    if word.startswith("res"):
        return "the response"
    return "the goal" if word.startswith("goal") else "the message"


def comment_like(
    file: CppFile, nodes: Sequence[Node], said: str, parameters: Iterable[str], *, returns: bool
) -> list[str]:
    """Return a comment in the form of those above most of some functions; none for none.

    Args:
        file: the file that has them.
        nodes: the functions.
        said: what the new function is for, a sentence with its full stop.
        parameters: the names of its parameters.
        returns: whether it returns anything.
    """
    found = [lines for node in nodes if (lines := comment_above(file, node))]
    if not found or len(found) * 2 <= len(nodes):
        return []
    model = found[-1]
    whole = "\n".join(model)
    mark = "\\" if re.search(r"\\(?:brief|param|return)", whole) else "@"
    brief = f"{mark}brief " if _BRIEF.search(whole) else ""
    if not any(line.strip(" \t*/!").endswith(".") for line in model):
        said = said.removesuffix(".")
    lines = [f"{brief}{said}"]
    if _PARAMETER.search(whole):
        lines += [f"{mark}param {name} {_what(name)}" for name in parameters]
    if returns and _RETURN.search(whole):
        lines.append(f"{mark}return whether the request was answered")
    line = _LINE.match(model[0])
    if line is not None:
        return [f"{line[1]} {each}" for each in lines]
    opening = _OPEN.match(model[0])
    assert opening is not None, "it is one or the other"
    if len(model) == 1 and len(lines) == 1:
        return [f"{opening[1]} {lines[0]} */"]
    star = " * " if len(model) == 1 or model[1].lstrip().startswith("*") else "   "
    if model[0].strip() != opening[1]:
        first, *more = lines
        return [f"{opening[1]} {first}", *(f"{star}{each}" for each in more), " */"]
    return [opening[1], *(f"{star}{each}" for each in lines), " */"]
