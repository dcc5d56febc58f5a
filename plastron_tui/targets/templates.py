"""The templates of nodes: where they are found, and what they may do.

A project's own templates come with a repository that somebody else may have made. They can do no
more than write text (Jinja's sandbox), and are read from regular files of the template folder
only: a link that leads out of it is refused.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

from jinja2 import ChoiceLoader, FunctionLoader, StrictUndefined, TemplateError, TemplateNotFound
from jinja2.loaders import split_template_path
from jinja2.sandbox import ImmutableSandboxedEnvironment

from plastron_tui.regular_files import read_regular, reason

if TYPE_CHECKING:
    from jinja2 import Environment


LARGEST_TEMPLATE = 1024**2
"""The largest template that is read, in bytes; Plastron's own have about 5 kB."""


class UnusableTemplateError(TemplateError):
    """A template that is not read; `name` is its path in the folder of its client library."""

    def __init__(self, name: str, reason: str) -> None:
        super().__init__(reason)
        self.name = name


def render_template(
    folders: tuple[str, ...], folder: Path | None, name: str, values: Mapping[str, object]
) -> str:
    """Fill in a template of a client library.

    Args:
        folders: the client library, and the other folders of Plastron's own templates that it
            takes what it has not itself from.
        folder: the user's template folder, with a folder for each client library; a template
            that is not there is Plastron's own.
        name: the template.
        values: what it is given, by the names that it has for it.

    Raises:
        Exception: whatever a template does wrong, a division by zero, say.
    """
    return _environment(folders, folder).get_template(name).render(values)


@cache  # of Plastron's own in practice: a user's are compiled once in each process that has limits
def _environment(folders: tuple[str, ...], folder: Path | None) -> Environment:
    """Return what finds the templates of a client library, and confines them."""
    own = resources.files("plastron_tui") / "templates"

    def load_own(name: str) -> str | None:
        files = (own.joinpath(each, *split_template_path(name)) for each in folders)
        found = next((file for file in files if file.is_file()), None)
        return None if found is None else found.read_text(encoding="utf-8")

    def load_users(name: str) -> str | None:
        assert folder is not None
        return _read_inside(folder, folders[0], name)

    users = [FunctionLoader(load_users)] if folder is not None else []
    return ImmutableSandboxedEnvironment(
        loader=ChoiceLoader([*users, FunctionLoader(load_own)]),
        undefined=StrictUndefined,
        autoescape=False,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def path_of(name: str, folder: Path) -> Path | None:
    """Return where a template lies in the folder of its client library; None for no name of one."""
    try:
        return folder.joinpath(*split_template_path(name))
    except TemplateNotFound:
        return None


def _read_inside(folder: Path, library: str, name: str) -> str | None:
    """Return a template of the user's, None where there is none of that name.

    Raises:
        UnusableTemplateError: it lies outside of the folder, or cannot be read.
    """
    try:
        # A name that has `..` is not found.
        path = folder.joinpath(library, *split_template_path(name)).resolve(strict=True)
        if not path.is_relative_to(folder.resolve()):
            raise UnusableTemplateError(name, "it is a link that leads out of the template folder")
        return read_regular(path, LARGEST_TEMPLATE).decode()
    except FileNotFoundError:
        return None
    # RuntimeError: links that lead to each other (up to Python 3.12).
    except (OSError, ValueError, RuntimeError) as error:
        raise UnusableTemplateError(name, reason(error)) from error
