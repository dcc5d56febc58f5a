"""Python source from a node, through a template."""

from __future__ import annotations

import os
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.source import FileSet
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.base import Rendered
from plastron_tui.sources.python.dialect import Dialect
from plastron_tui.sources.python.layout import fit

from .plan import NodePlan
from .planning import Planner

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
    try:
        text = _text(plan, dialect.library, template_folder)
    # A template may fail in any way; a user's does so in a process of its own.
    except Exception as error:
        failure = _template_error(dialect.library, template_folder, _template(plan), error)
        return Rendered(None, (failure,))
    return Rendered(FileSet.single(".py", text.encode()))


def _text(plan: NodePlan, library: str, folder: Path | None) -> str:
    """Fill in the user's template where there is one, else Plastron's own."""
    name = _template(plan)
    from plastron_tui.targets.templates import render_template

    values = {"node": plan}
    if folder is not None and os.path.lexists(folder / library / name):
        from plastron_tui.targets.template_process import render_apart

        return render_apart(library, folder, name, values, fit)
    return fit(render_template(library, None, name, values))


def _template(plan: NodePlan) -> str:
    return MANAGED_TEMPLATE if plan.is_managed else NODE_TEMPLATE


def _template_error(
    library: str, folder: Path | None, template: str, error: Exception
) -> Diagnostic:
    from jinja2 import TemplateError

    from plastron_tui.targets.template_process import TemplateFailedError
    from plastron_tui.targets.templates import path_of

    # A module or an attribute that is missing has a name as well.
    is_told = isinstance(error, TemplateError | TemplateFailedError)
    name = (is_told and getattr(error, "name", None)) or template
    line = getattr(error, "lineno", None)
    place = f"{library}/{name}" + (f", line {line}" if line is not None else "")
    return Diagnostic(
        codes.TEMPLATE_ERROR,
        f"the template {place} cannot be used: {error}",
        file=path_of(name, folder / library) if folder is not None else None,
    )
