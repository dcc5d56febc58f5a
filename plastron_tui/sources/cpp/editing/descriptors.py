"""The local variables that describe parameters of ROS 2, which go with these."""

from __future__ import annotations

from ..analysis import Analysis, Site
from ..read_parameters import parameter_call
from ..scopes import last_name
from .deletions import Deletions
from .statements import only_calls, only_sets, statement_of
from .uses import uses_of


def take_descriptor(analysis: Analysis, site: Site, gone: Deletions) -> None:
    """Take out the local variable that describes a parameter, and a block left empty."""
    node, scope = parameter_call(site.call).descriptor, site.call.scope
    name = "" if node is None else last_name(node, scope)
    at = site.call.node.start_byte
    variable = analysis.unit.lookup(name, scope, at) if name else None
    if variable is None or variable.kind != "local":
        return
    setting = []
    for file, use, _ in uses_of(analysis, variable):
        if gone.covers(file, use.start_byte):
            continue
        statement = statement_of(use)
        if statement is None or not (only_sets(statement, use) or only_calls(statement, use)):
            return
        setting.append(statement)
    for each in (*setting, variable.node):
        gone.statement(variable.file, each)
    block = variable.node.parent
    outer = None if block is None else block.parent
    if block is None or outer is None or outer.type != "compound_statement":
        return
    if all(gone.covers(variable.file, each.start_byte) for each in block.named_children):
        gone.statement(variable.file, block)
