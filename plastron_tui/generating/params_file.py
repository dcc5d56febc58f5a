"""The parameter file of a program: the defaults, for people to change."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.model.kinds import Parameter
from plastron_tui.output.plan import LARGEST_OUTPUT, OutputFile
from plastron_tui.regular_files import read_regular
from plastron_tui.ros.parameter_values import params_file
from plastron_tui.ros.parameters import Setting

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Node
    from plastron_tui.output.manifest import Manifest


def params_path(output: Path, program: Path) -> Path:
    """Return the parameter file of a program: `config/NAME.yaml` beside the output folder."""
    return output.absolute().parent / "config" / f"{program.stem}.yaml"


def params_output(
    nodes: Iterable[Node], path: Path, output: Path, manifest: Manifest
) -> OutputFile | None:
    """Return the parameter file of created nodes, None where there is none to be written.

    A file that somebody changed, or wrote, stays as it is.

    Args:
        nodes: the nodes that a program generates.
        path: the file.
        output: the output folder.
        manifest: what is remembered of the folder's files, and of this one.
    """
    text = params_file({node.name: _defaults(node) for node in nodes if node.source is None})
    if not text:
        return None
    entry = os.path.relpath(path, output).replace(os.sep, "/")
    try:
        before = read_regular(path, LARGEST_OUTPUT)
    except FileNotFoundError:
        before = None
    except (OSError, ValueError):
        return None
    if before is not None and not manifest.has(entry, before):
        return None
    name = f"{path.parent.name}/{path.name}"
    seen = ((output, manifest),)
    return OutputFile(name, text.encode(), False, path=path, seen=seen, entry=entry)


def _defaults(node: Node) -> dict[str, Setting]:
    return {
        name.removeprefix("~/"): parameter.default
        for name, parameter in node.of(Parameter).items()
        # What ROS 1 has for all nodes, `/speed`, is no node's to be given.
        if parameter.default is not None and not name.startswith("/")
    }
