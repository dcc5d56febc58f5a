"""Changes of endpoints that a file only seems to have: what is told of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plastron_tui.diagnostics import Diagnostic, codes, listed
from plastron_tui.model.source import Add, Change

from .analysis import Analysis, Site
from .guesses import guessed_parameter
from .nodes import part_of
from .removal import find_sites


def tell_guessed_names(analysis: Analysis, changes: Sequence[Change]) -> Iterator[Diagnostic]:
    """Warn of each change that finds its endpoint by the default of a parameter.

    Args:
        analysis: the file as it is before the changes.
        changes: what is asked for.
    """
    has_guesses = any(site.endpoint.is_guess for site in analysis.sites)
    for change in changes if has_guesses else ():
        if isinstance(change, Add):
            continue
        sites = find_sites(part_of(analysis, change.node), change)
        guesses = {site: found for site in sites if (found := _guessed(analysis, site))}
        if not guesses:
            continue
        lines = listed(dict.fromkeys(str(site.endpoint.line) for site in guesses))
        parameters = listed(dict.fromkeys(f"`{name}`" for name, _ in guesses.values()))
        is_one = len(guesses) == 1
        message = f"the name `{change.name}` in line{'' if is_one else 's'} {lines} is the default"
        message += f" of {parameters}, for which another file may give another name"
        users = listed(dict.fromkeys(f"`{user}`" for _, user in guesses.values()))
        help_ = f"look at what other files give to {users}"
        yield Diagnostic(codes.GUESSED_NAME, message, change.span, help=help_)


def _guessed(analysis: Analysis, site: Site) -> tuple[str, str] | None:
    """Return the parameter whose default is a name, and the class or the function that has it."""
    given = site.arguments.get(site.shape.name)
    if given is None or site.endpoint.name is None or not site.endpoint.is_guess:
        return None
    found = guessed_parameter(
        given, site.scope, analysis.resolver, analysis.scopes, analysis.syntax
    )
    if found is None:
        return None
    name, function = found
    owner = function.parent
    is_made = function.name == "__init__" and owner is not None
    return name, owner.name if is_made and owner is not None else function.name
