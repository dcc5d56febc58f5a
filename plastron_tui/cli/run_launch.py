"""`plastron run` of a launch file."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.diagnostics.terminal import drawn_on, visible

from .common import Report, finish
from .run_options import refuse

if TYPE_CHECKING:
    from plastron_tui.runtime.launch import Options


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
    report.add(read.diagnostics, lambda _: None)
    if read.launch is not None and not report.status:
        environment, diagnostics = find_environments().choose(read.format.ros_version)
        report.add(diagnostics, lambda _: None)
        if environment is not None:
            arguments = dict(_pair(word) for word in words)
            with ProgressLine(drawn_on(sys.stderr)) as line:
                prepared = prepare(read.launch, file, arguments, environment, tell=line.tell)
            report.add(prepared.diagnostics, lambda _: None)
            if prepared.nodes and not report.status:
                told = f"running {file.name} on {environment.words}"
                click.echo(visible(told), err=True)
                out, err = drawn_on(sys.stdout), drawn_on(sys.stderr)
                result = run_nodes(prepared.nodes, options, out=out, err=err)
                report.add(result.diagnostics, lambda _: None, file)
                report.status = max(report.status, result.status)
    finish(report)


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
