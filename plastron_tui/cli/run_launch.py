"""`plastron run` of a launch file."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.terminal import drawn_on, visible

from .common import Report, finish
from .run_options import refuse

if TYPE_CHECKING:
    from plastron_tui.diagnostics import LineIndex
    from plastron_tui.runtime.launch import Options
    from plastron_tui.sources.launch.xml_reader import LaunchRead


def run_launch(file: Path, words: Sequence[str], options: Options, others: Sequence[str]) -> None:
    """Start what a launch file says, until it has ended or is stopped.

    Args:
        file: the launch file.
        words: the arguments, as `NAME:=VALUE`.
        options: how to run.
        others: options of programs that were given, and that say nothing to a launch file.
    """
    from plastron_tui.regular_files import read_regular, reason
    from plastron_tui.runtime.build_progress import ProgressLine
    from plastron_tui.runtime.environment import find_environments
    from plastron_tui.runtime.launch import run_nodes
    from plastron_tui.runtime.launch_run import prepare
    from plastron_tui.sources.launch.reader import LARGEST, read_launch

    report = Report()
    refuse(_wrong_usage(words, others))
    try:
        source = read_regular(file, LARGEST)
    except (OSError, ValueError) as error:
        found = Diagnostic(codes.UNREADABLE_FILE, f"cannot read `{file.name}`: {reason(error)}")
        report.unreadable([found])
        finish(report)
        return
    read = read_launch(source, file)
    report.add(read.diagnostics, _lines)
    if read.launch is not None and not report.status:
        environment, diagnostics = find_environments().choose(read.format.ros_version)
        report.add(diagnostics, _lines)
        if environment is not None:
            arguments = dict(_pair(word) for word in words)
            with ProgressLine(drawn_on(sys.stderr)) as line:
                prepared = prepare(read.launch, file, arguments, environment, tell=line.tell)
            told = (*prepared.diagnostics, *_differences(read, source, file, arguments))
            report.add(told, _lines)
            if prepared.nodes and not report.status:
                click.echo(visible(f"running {file.name} on {environment.words}"), err=True)
                out, err = drawn_on(sys.stdout), drawn_on(sys.stderr)
                result = run_nodes(prepared.nodes, options, out=out, err=err)
                report.add(result.diagnostics, _lines, file)
                report.status = max(report.status, result.status)
    finish(report)


def _lines(path: Path | None) -> LineIndex | None:
    """Return the lines of a launch file that something is said of."""
    from plastron_tui.project.program_file import lines_of

    return None if path is None else lines_of(path)


def _differences(
    read: LaunchRead, source: bytes, file: Path, arguments: Mapping[str, str]
) -> tuple[Diagnostic, ...]:
    """Return how what is started differs from what the file's program said."""
    from plastron_tui.project.launch_comparison import differences

    if read.launch is None:
        return ()
    return differences(read.launch, source, file, read.format.ros_version, arguments)


def _wrong_usage(words: Sequence[str], others: Sequence[str]) -> str | None:
    for each in others:
        return f"{each} is for programs; a launch file says so itself"
    for word in words:
        if ":=" not in word[1:]:
            return f"{word!r} is no argument of a launch file; one is written like 'name:=value'"
    return None


def _pair(word: str) -> tuple[str, str]:
    name, _, value = word.partition(":=")
    return name, value
