"""Python source from a node, through a template."""

from __future__ import annotations

from functools import cache
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog

from .base import Rendered
from .dialect import Dialect
from .layout import fit
from .planning import Planner

if TYPE_CHECKING:
    from jinja2 import Environment

_TEMPLATE = "node.py.j2"


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
        template = _environment(dialect.library, template_folder).get_template(_TEMPLATE)
        text = template.render(node=plan)
    # What a template of a user's does wrong may be anything: a division by zero, say.
    except Exception as error:
        return Rendered(None, (_template_error(dialect.library, template_folder, error),))
    return Rendered(fit(text).encode())


@cache
def _environment(library: str, folder: Path | None) -> Environment:
    from jinja2 import ChoiceLoader, FileSystemLoader, FunctionLoader, StrictUndefined
    from jinja2.sandbox import ImmutableSandboxedEnvironment

    own = resources.files("plastron_tui") / "templates" / library

    def load_own(name: str) -> str | None:
        file = own / name
        return file.read_text(encoding="utf-8") if file.is_file() else None

    loaders = [FunctionLoader(load_own)]
    users = [FileSystemLoader(folder / library)] if folder is not None else []
    # A project's own templates come with a repository of somebody else's: they are no programs.
    return ImmutableSandboxedEnvironment(
        loader=ChoiceLoader([*users, *loaders]),
        undefined=StrictUndefined,
        autoescape=False,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def _template_error(library: str, folder: Path | None, error: Exception) -> Diagnostic:
    name = getattr(error, "name", None) or _TEMPLATE
    line = getattr(error, "lineno", None)
    place = f"{library}/{name}" + (f", line {line}" if line is not None else "")
    return Diagnostic(
        "template-error",
        f"the template {place} cannot be used: {error}",
        file=folder / library / name if folder is not None else None,
    )
