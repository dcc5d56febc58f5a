"""Where an include goes, and how it is written."""

from __future__ import annotations

import re
from itertools import pairwise

from plastron_tui.sources.splices import BYTE_ORDER_MARK, Splice, line_end, newline_of

from ..preprocessing import Include
from ..scopes import CppFile
from ..unit import Unit
from .plans import Plan

_INTERFACE = re.compile(r"[\w.+-]+/(?:msg|srv|action)/\w+\.hpp|\w+_(?:msgs|srvs)/[A-Z]\w*\.h")
_STANDARD = re.compile(
    r"\w+|(?:assert|c?math|errno|float|limits|signal|stdio|stdint|stdlib|string|time|unistd)\.h"
)
_CONDITION = re.compile(rb"^[ \t]*#[ \t]*(if|endif)", re.MULTILINE)
_TOP = re.compile(rb"^[ \t]*#[ \t]*(?:pragma[ \t]+once|define[ \t]+\w+)[ \t]*\r?\n", re.MULTILINE)
_CODE = frozenset({"namespace_definition", "class_specifier", "struct_specifier"}) | frozenset(
    {"function_definition", "template_declaration"}
)


def is_included(unit: Unit, file: CppFile, header: str) -> bool:
    """Tell whether a file includes a header, itself or by a header of its unit."""
    files = [file, *(each for each in unit.files if each.name)] if not file.name else [file]
    return any(include.path == header for each in files for include in each.syntax.includes)


def add_include(plan: Plan, unit: Unit, file: CppFile, header: str, ros_version: int) -> None:
    """Include a header, beside those that are like it; the unit's own headers are like none."""
    text = file.syntax.text
    newline = newline_of(text).decode()
    every = _unconditional(file)
    includes = [each for each in every if not _is_own(unit, each)]
    is_standard = "/" not in header
    like = [each for each in includes if _is_like(each, header)]
    first = next((each for each in includes if "/" in each.path), None)
    if is_standard and not like and ros_version == 2 and first is not None:
        # The style of ROS 2 has them before those of packages.
        offset = max(first.start, _start_of(file))
        plan.replace(file, offset, offset, f"#include <{header}>{newline}{newline}")
        return
    # Two services of one package stand together, wherever the messages are.
    package = header.split("/")[0] + "/"
    own = [each for each in like if each.path.startswith(package) and not is_standard]
    near = own or like or _beside(includes, is_standard=is_standard)
    if not near:
        _add_alone(plan, file, every, _written(header, is_standard or ros_version == 1))
        return
    is_angled = is_standard or header.startswith("boost/") or near[-1].is_angled
    run = _runs(file, near)[-1]
    around = next(each for each in _runs(file, every) if run[-1] in each)
    if _is_sorted(around):
        run = around
    if (like or run is around) and _is_sorted(run):
        after = [each for each in run if each.path < header]
        if not after:
            offset = max(run[0].start, _start_of(file))
            plan.replace(file, offset, offset, _written(header, is_angled) + newline)
            return
        last = after[-1]
    else:
        last = run[-1]
    offset = line_end(text, last.end)
    written = _written(header, is_angled) + newline
    if not text[:offset].endswith(b"\n"):
        written = newline + written
    plan.replace(file, offset, offset, written)


def order_includes(splices: list[Splice]) -> None:
    """Order what is written at one place: headers of the standard, those of packages, the rest."""
    splices.sort(key=_order)
    for at, (splice, following) in enumerate(pairwise(splices)):
        is_same = splice.start == following.start and splice.end == following.end
        if is_same and _order(splice)[0] == _order(following)[0] == 0:
            # One empty line behind all of them.
            text = splice.text.rstrip() + newline_of(splice.text)
            splices[at] = Splice(splice.start, splice.end, text)


def _order(splice: Splice) -> tuple[int, bytes]:
    text = splice.text.lstrip()
    if not text.startswith(b"#include"):
        return 2, b""
    return int(b"/" in text.split(b"\n")[0]), text


def _beside(includes: list[Include], *, is_standard: bool) -> list[Include]:
    """Return the includes that one of a kind that a file has not yet goes with."""
    if is_standard:
        return [each for each in includes if each.is_angled] or includes
    of_ros = [each for each in includes if each.path.startswith(("ros/", "rclcpp/", "nodelet/"))]
    return of_ros or [each for each in includes if "/" in each.path] or includes


def _add_alone(plan: Plan, file: CppFile, every: list[Include], written: str) -> None:
    """Include the first header that is not the unit's own: below these, or else at the top."""
    newline = newline_of(file.syntax.text).decode()
    if every:
        offset = line_end(file.syntax.text, every[-1].end)
        before = newline if file.syntax.text[:offset].endswith(b"\n") else newline * 2
        plan.replace(file, offset, offset, f"{before}{written}{newline}")
        return
    found = _TOP.search(file.syntax.text)
    offset = found.end() if found is not None else _start_of(file)
    plan.replace(file, offset, offset, written + newline)


def _is_own(unit: Unit, include: Include) -> bool:
    """Tell whether an include names a header of the unit."""
    parts = include.path.split("/")
    for file in unit.files:
        # `{}` stands for the name of the source.
        own = file.name.split("/")[-len(parts) :]
        if file.name and len(own) == len(parts):
            pairs = zip(own, parts, strict=True)
            if all(a == b or (a.startswith("{}") and b.endswith(a[2:])) for a, b in pairs):
                return True
    return False


def _is_sorted(includes: list[Include]) -> bool:
    paths = [each.path for each in includes]
    return paths == sorted(paths)


def _start_of(file: CppFile) -> int:
    """Return where a file begins, in bytes: a byte order mark stays before all."""
    return len(BYTE_ORDER_MARK) if file.syntax.text.startswith(BYTE_ORDER_MARK) else 0


def _written(header: str, is_angled: bool) -> str:
    return f"#include <{header}>" if is_angled else f'#include "{header}"'


def _is_like(include: Include, header: str) -> bool:
    path = include.path
    if _INTERFACE.fullmatch(header) is not None:
        return _INTERFACE.fullmatch(path) is not None
    if "/" not in header:
        # `<apriltag.h>` is the header of a package.
        return "/" not in path and include.is_angled and _STANDARD.fullmatch(path) is not None
    return "/" in path


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
