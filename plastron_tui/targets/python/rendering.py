"""Python source from a node, through a template."""

from __future__ import annotations

from pathlib import Path

from plastron_tui.model.source import FileSet
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.base import Rendered
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.sources.python.layout import fit
from plastron_tui.targets.rendering import CannotRenderError, render_text

from .planner import Planner

NODE_TEMPLATE = "node.py.j2"
MANAGED_TEMPLATE = "managed.py.j2"


def render_python(
    node: Node, catalog: Catalog, dialect: Dialect, template_folder: Path | None = None
) -> Rendered:
    """Write a created node as a Python file.

    Args:
        node: the node.
        catalog: the interface types of the distribution that the file is for.
        dialect: the client library.
        template_folder: a folder of the user's with a folder for each client library; a template
            that is not there is Plastron's own.
    """
    planner = Planner(node, catalog, dialect)
    plan = planner.plan()
    if plan is None:
        return Rendered(None, tuple(planner.diagnostics))
    template = MANAGED_TEMPLATE if plan.is_managed else NODE_TEMPLATE
    try:
        text = render_text((dialect.library,), template, {"node": plan}, fit, template_folder)
    except CannotRenderError as error:
        return Rendered(None, (error.diagnostic,))
    return Rendered(FileSet.single(".py", text.encode()))
