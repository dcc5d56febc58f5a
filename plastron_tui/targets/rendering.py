"""The text of a node's file, through a template."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

from plastron_tui.diagnostics import Diagnostic, codes


class CannotRenderError(Exception):
    """A template that cannot be used; the diagnostic says why."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        self.diagnostic = diagnostic


def render_text(
    folders: tuple[str, ...],
    template: str,
    values: dict[str, Any],
    finish: Callable[[str], str],
    folder: Path | None,
) -> str:
    """Fill in the user's template where there is one, else Plastron's own.

    Args:
        folders: the client library, and the other folders of Plastron's own templates that it
            takes what it has not itself from.
        template: the template's name.
        values: what it is given.
        finish: lays the text out.
        folder: a folder of the user's with a folder for each client library; a template that is
            not there is Plastron's own.

    Raises:
        CannotRenderError: the template fails.
    """
    from .templates import render_template

    try:
        if folder is not None and os.path.lexists(folder / folders[0] / template):
            from .template_process import render_apart

            return render_apart(folders, folder, template, values, finish)
        return finish(render_template(folders, None, template, values))
    # A template may fail in any way; a user's does so in a process of its own.
    except Exception as error:
        raise CannotRenderError(_template_error(folders[0], folder, template, error)) from error


def _template_error(
    library: str, folder: Path | None, template: str, error: Exception
) -> Diagnostic:
    from jinja2 import TemplateError

    from .template_process import TemplateFailedError
    from .templates import path_of

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
