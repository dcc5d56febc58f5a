"""Where an include goes, and how it is written."""

from __future__ import annotations

import re

from plastron_tui.sources.splices import BYTE_ORDER_MARK, line_end

from ..preprocessing import Include
from ..scopes import CppFile
from ..unit import Unit
from .plans import Plan

_INTERFACE = re.compile(r"[\w.+-]+/(?:msg|srv|action)/\w+\.hpp|\w+_(?:msgs|srvs)/[A-Z]\w*\.h")
_CONDITION = re.compile(rb"^[ \t]*#[ \t]*(if|endif)", re.MULTILINE)
_TOP = re.compile(rb"^[ \t]*#[ \t]*(?:pragma[ \t]+once|define[ \t]+\w+)[ \t]*\r?\n", re.MULTILINE)
_CODE = frozenset({"namespace_definition", "class_specifier", "struct_specifier"}) | frozenset(
    {"function_definition", "template_declaration"}
)


def is_included(unit: Unit, file: CppFile, header: str) -> bool:
    """Tell whether a file includes a header, itself or by a header of its unit."""
    files = [file, *(each for each in unit.files if each.name)] if not file.name else [file]
    return any(include.path == header for each in files for include in each.syntax.includes)


def add_include(plan: Plan, file: CppFile, header: str, ros_version: int) -> None:
    """Include a header, beside those that are like it."""
    includes = _unconditional(file)
    is_standard = "/" not in header
    like = [each for each in includes if _is_like(each, header)]
    if not like:
        like = [each for each in includes if ("/" in each.path) != is_standard]
    if is_standard and not any("/" not in each.path and each.is_angled for each in includes):
        first = next((each for each in includes if "/" in each.path), None)
        if ros_version == 2 and first is not None:
            # The style of ROS 2 has them before those of packages.
            newline = "\r\n" if b"\r\n" in file.syntax.text[:4096] else "\n"
            text = f"#include <{header}>{newline}{newline}"
            offset = max(first.start, _start_of(file))
            plan.replace(file, offset, offset, text)
            return
    near = like or includes
    newline = "\r\n" if b"\r\n" in file.syntax.text[:4096] else "\n"
    if not near:
        found = _TOP.search(file.syntax.text)
        offset = found.end() if found is not None else _start_of(file)
        plan.replace(file, offset, offset, _written(header, ros_version == 1) + newline)
        return
    is_angled = is_standard or (
        near[-1].is_angled if "/" in near[-1].path or not near[-1].is_angled else ros_version == 1
    )
    run = _runs(file, near)[-1]
    paths = [each.path for each in run]
    if like and paths == sorted(paths):
        after = [each for each in run if each.path < header]
        if not after:
            offset = max(run[0].start, _start_of(file))
            plan.replace(file, offset, offset, _written(header, is_angled) + newline)
            return
        last = after[-1]
    else:
        last = run[-1]
    offset = line_end(file.syntax.text, last.end)
    text = _written(header, is_angled) + newline
    if not file.syntax.text[:offset].endswith(b"\n"):
        text = newline + text
    plan.replace(file, offset, offset, text)


def _start_of(file: CppFile) -> int:
    """Return where a file begins, in bytes: a byte order mark stays before all."""
    return len(BYTE_ORDER_MARK) if file.syntax.text.startswith(BYTE_ORDER_MARK) else 0


def _written(header: str, is_angled: bool) -> str:
    return f"#include <{header}>" if is_angled else f'#include "{header}"'


def _is_like(include: Include, header: str) -> bool:
    path = include.path
    if _INTERFACE.fullmatch(header) is not None:
        return _INTERFACE.fullmatch(path) is not None
    return ("/" in path) == ("/" in header) and (include.is_angled or "/" in path)


def _runs(file: CppFile, includes: list[Include]) -> list[list[Include]]:
    """Return includes in groups of lines one after the other."""
    text = file.syntax.text
    runs: list[list[Include]] = []
    for each in includes:
        if runs and not text[line_end(text, runs[-1][-1].end) : each.start].strip(b" \t"):
            runs[-1].append(each)
        else:
            runs.append([each])
    return runs


def _unconditional(file: CppFile) -> list[Include]:
    """Return the includes that no condition of their own guards."""
    marks = [(found.start(), found[1]) for found in _CONDITION.finditer(file.syntax.text)]
    depths = []
    for include in file.syntax.includes:
        before = [word for at, word in marks if at < include.start]
        depths.append(sum(1 if word == b"if" else -1 for word in before))
    least = min(depths, default=0)
    pairs = zip(file.syntax.includes, depths, strict=True)
    found = [each for each, depth in pairs if depth == least]
    # What registers a component is often included at the end, behind what needs the header.
    first = next((each for each in file.root.node.named_children if each.type in _CODE), None)
    begins = [each for each in found if first is None or each.start < first.start_byte]
    return begins or found
