"""Taking an endpoint out of a file: its statements, and all that only served them."""

from __future__ import annotations

from .analysis import Analysis, Site
from .creation import Removal, parameters_in, remove_creation
from .dead_values import dead_targets, dead_values
from .emptied_blocks import bare_conditions, emptied_blocks
from .function_place import rulers_above
from .imports import unused_imports
from .leftovers import placeholders, remove_idle, sending_logs, stub_callbacks
from .own_removal import executing, quieted_threads, unused_helpers
from .references import Variable
from .removal import remove_uses, waits
from .splices import around, delete_statements
from .unused_attributes import unused_attributes
from .unused_locals import unused_locals


def plan_removal(analysis: Analysis, sites: list[Site]) -> Removal:
    """Plan what taking some call sites of one endpoint out of a file deletes."""
    removal = Removal(sites=list(sites))
    variables: dict[Variable, None] = {}
    for site in sites:
        for variable in remove_creation(analysis, site, removal):
            variables[variable] = None
    removal.statements += executing(analysis, sites)
    for variable in variables:
        remove_uses(analysis, variable, sites, removal)
    if removal.lines:
        return removal
    helpers = unused_helpers(analysis, removal)
    removal.statements += helpers
    removal.sites += [
        site
        for site in analysis.sites
        if any(each.start_byte <= site.call.start_byte < each.end_byte for each in helpers)
    ]
    for found in waits(analysis, sites).values():
        removal.statements += [statement for statement, _ in found]
    removal.statements += sending_logs(analysis, removal)
    remove_what_served(analysis, removal)
    while remove_idle(analysis, removal):
        removal.statements += sending_logs(analysis, removal)
        remove_what_served(analysis, removal)
    for variable in variables:
        removal.statements += placeholders(analysis, variable, removal)
    remove_what_served(analysis, removal)
    removal.statements += quieted_threads(analysis, removal)
    _keep_conditions(analysis, removal)
    gone = delete_statements(analysis.syntax.text, removal.statements) + removal.splices
    callbacks = stub_callbacks(analysis, removal.sites, gone)
    removal.statements += callbacks
    removal.statements += rulers_above(analysis, removal.statements)
    gone = delete_statements(analysis.syntax.text, removal.statements) + removal.splices
    imports, names = unused_imports(analysis, gone)
    # A block that all of these empty together needs one `pass`.
    removal.statements += imports
    gone = delete_statements(analysis.syntax.text, removal.statements) + removal.splices
    removal.splices = gone + names
    removal.statements = []
    removal.sites += parameters_in(analysis, removal.splices)
    return removal


def _keep_conditions(analysis: Analysis, removal: Removal) -> None:
    """Leave `f()` of `if f():` with nothing in it."""
    for statement, part in bare_conditions(analysis, removal.statements):
        start, end = statement.start_byte, statement.end_byte
        removal.statements = [
            each for each in removal.statements if not start <= each.start_byte < end
        ]
        removal.splices += around(statement, part)


def remove_what_served(analysis: Analysis, removal: Removal) -> None:
    """Remove the blocks, the local variables and the attributes that only served what is gone."""
    count = (-1, -1)
    while count != (len(removal.statements), len(set(removal.splices))):
        removal.statements += emptied_blocks(analysis, removal.statements)
        count = (len(removal.statements), len(set(removal.splices)))
        gone = delete_statements(analysis.syntax.text, removal.statements) + removal.splices
        unused = unused_locals(analysis, gone)
        removal.statements += unused.statements
        removal.statements += unused_attributes(analysis, gone)
        removal.splices += unused.splices
        gone = delete_statements(analysis.syntax.text, removal.statements) + removal.splices
        removal.statements += dead_values(analysis, gone)
    gone = delete_statements(analysis.syntax.text, removal.statements) + removal.splices
    removal.splices += dead_targets(analysis, gone)
