"""From the call sites of the files of a unit to its nodes."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, codes
from plastron_tui.model.source import FileSet, SourceUnit
from plastron_tui.sources.base import ReadResult
from plastron_tui.sources.not_text import not_utf_8

from .analysis import Analysis
from .beside import sources_beside
from .last_read import keep_analysis
from .mentioned import is_component, is_nodelet
from .nesting import is_nested_too_deep
from .node_sites import nodelets
from .nodes import group
from .sites import MOST_SITES, find_sites
from .structure import outline
from .syntax import parse
from .unit import Unit

MOST_BYTES = 4_000_000
"""Beyond this size a file is data, not a node that a person wrote."""

MOST_NODES = 1_000_000
"""A tree of more nodes is that of a generated file; what people write has some ten in a line."""

_MOST_TEXTS = 64

# What an include says comes first: it is looked for by its `#`, which there are few of.
_MENTIONS = {
    1: (
        re.compile(
            rb'#[ \t]*include[ \t]*[<"]'
            rb"(?:(?:ros|nodelet|tf|actionlib|dynamic_reconfigure)/|[\w/]+_msgs/[A-Z])"
        ),
        re.compile(rb"ros::(?:NodeHandle|init|Publisher|Subscriber|param|Timer)\b"),
        re.compile(rb"getPrivateNodeHandle\b"),
    ),
    2: (
        re.compile(rb'#[ \t]*include[ \t]*[<"](?:rclcpp|[\w/]+/(?:msg|srv|action)/\w+\.hpp)'),
        re.compile(rb"rclcpp(?:_\w+)?::"),
        re.compile(rb"create_(?:publisher|subscription|service|client)[ \t]*<"),
    ),
}

LIBRARIES = {"roscpp": 1, "nodelet": 1, "rclcpp": 2, "component": 2}
"""The generations of ROS of the client libraries for C++."""


def read_cpp(path: Path, files: FileSet, library: str | None = None) -> ReadResult:
    """Read the nodes of a C++ file, the main one of a set."""
    text = files.main
    if len(text) > MOST_BYTES:
        return _refuse(path, codes.FILE_TOO_LARGE, "the file is larger than 4 MB and is not read")
    if b"\x00" in text and (found := not_utf_8(text, path)) is not None:
        return ReadResult(None, (found,))
    versions = [LIBRARIES[library]] if library in LIBRARIES else _mentioned(files)
    if not versions:
        return _refuse(path, codes.NO_NODE, "the file includes neither ROS 1 nor ROS 2")
    if is_nested_too_deep(text):
        problem = "the file is nested deeper than people write, and is not read"
        return _refuse(path, codes.FILE_TOO_LARGE, problem)
    parsed = [
        ("" if at == 0 else name, parse(each))
        for at, (name, each) in enumerate(files.texts)
        if len(each) <= MOST_BYTES and b"\x00" not in each
    ]
    if parsed[0][1].root.descendant_count > MOST_NODES:
        return _refuse(
            path, codes.FILE_TOO_LARGE, "the file is too long a program, and is not read"
        )
    outlines = [
        outline(name, syntax)
        for name, syntax in parsed
        if syntax.root.descendant_count <= MOST_NODES
    ]
    others, paths = sources_beside(path, outlines)
    analyses = [analyze(Unit(outlines, others), version) for version in versions]
    best = max(analyses, key=lambda analysis: analysis.calls_found)
    if best.calls_found > MOST_SITES:
        problem = f"the file creates more than {MOST_SITES} endpoints, and is not read"
        return _refuse(path, codes.FILE_TOO_LARGE, problem)
    source = SourceUnit(path, files, _library(best), group(best))
    keep_analysis(source, best)
    return ReadResult(source, beside=paths)


def analyze(unit: Unit, ros_version: int) -> Analysis:
    """Return what is known of the files of a unit."""
    analysis = Analysis(unit, ros_version)
    find_sites(analysis)
    return analysis


def _mentioned(files: FileSet) -> list[int]:
    """Return the generations of ROS that files mention."""
    found = {version for _, text in files.texts for version in _versions(text)}
    return sorted(found)


@lru_cache(_MOST_TEXTS)
def _versions(text: bytes) -> tuple[int, ...]:
    """Return the generations of ROS that a text mentions; that of a header is asked for often."""
    return tuple(
        version
        for version, patterns in _MENTIONS.items()
        if any(pattern.search(text) for pattern in patterns)
    )


def _library(analysis: Analysis) -> str:
    files = analysis.unit.files
    if analysis.ros_version == 1:
        says_so = any(is_nodelet(file.syntax.text) for file in files[:1])
        return "nodelet" if says_so or nodelets(analysis) else "roscpp"
    registers = any(map(is_component, (file.syntax.text for file in files[:1])))
    return "component" if registers else "rclcpp"


def _refuse(path: Path, code: Code, message: str) -> ReadResult:
    return ReadResult(None, (Diagnostic(code, message, file=path),))
