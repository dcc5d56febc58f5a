"""Taking an endpoint out of a unit: what creates it, holds it, publishes on it, and hears it."""

from __future__ import annotations

from collections.abc import Iterable

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind, Remove
from plastron_tui.sources.splices import line_number

from ..analysis import Analysis, Site
from ..read_parameters import parameter_call
from ..scopes import CppFile, Function, Scope, Variable, last_name
from .creation import Creation, creation_of, variable_of
from .deletions import Deletions
from .lambdas import lambda_of
from .leftovers import (
    functions_of,
    has_uses,
    is_idle,
    is_stub,
    remove_function,
    take_placeholders,
    take_types,
)
from .own_functions import (
    asking_function,
    emptied_functions,
    goal_functions,
    goal_variables,
    members_of,
    mentions,
    reading_function,
    repeating_function,
    unused_helpers,
)
from .plans import Plan
from .refusals import RefusedError, in_use, not_there
from .statements import calls_method, emptied, local_of, only_calls, only_sets, statement_of
from .units import sites_of
from .uses import macro_uses, uses_of

_SENDING = frozenset({"publish", "sendTransform"})
_ENDING = frozenset(
    {"shutdown", "reset", "cancel", "stop", "on_activate", "on_deactivate", "start", "spin"}
    | {"join", "setAborted"}
)


def plan_removal(analysis: Analysis, change: Remove) -> Plan:
    """Plan the removal of an endpoint.

    Raises:
        RefusedError: the files have none such, or use it in another way.
    """
    sites = sites_of(analysis, change)
    if not sites:
        raise not_there(analysis, change)
    removal = _Removal(analysis, change, sites)
    for site in sites:
        removal.take(site)
    if removal.used:
        raise in_use(change, removal.used)
    return removal.finish()


class _Removal:
    """A removal on its way.

    Attributes:
        used: where the endpoint is used in another way, as file and line.
    """

    def __init__(self, analysis: Analysis, change: Remove, sites: list[Site]) -> None:
        self._analysis = analysis
        self._sites = sites
        self._change = change
        self._gone = Deletions()
        self._plan = Plan()
        self.used: list[tuple[CppFile, int]] = []

    def take(self, site: Site) -> None:
        """Take one call site out, with what holds it and what only served it."""
        if site in self._plan.lost:
            return
        if any(each.call is site.call and each is not site for each in self._analysis.sites):
            message = f"line {site.endpoint.line} creates it among others"
            raise RefusedError(message, self._change.span, "change the line by hand")
        self._plan.lost.append(site)
        if self._gone.covers(site.file, site.call.node.start_byte) or self._take_reading(site):
            return
        creation = creation_of(self._analysis, site)
        if creation is None:
            message = f"line {site.endpoint.line} does more than to create it"
            raise RefusedError(message, self._change.span, "change the line by hand")
        creation.delete(self._gone)
        self._check_others(site)
        if site.endpoint.kind is EndpointKind.PARAMETER:
            self._take_descriptor(site)
        if site.endpoint.kind is EndpointKind.ACTION_SERVER:
            self._take_goals(site)
        if creation.variable is not None:
            self._take_variable(creation, site)

    def _take_variable(self, creation: Creation, site: Site) -> None:
        variable = creation.variable
        assert variable is not None
        if site.endpoint.kind is EndpointKind.PARAMETER:
            if not self._pending(variable):
                self._keep_value(creation, variable)
            return
        others = [
            each
            for each in self._analysis.sites
            if each not in self._plan.lost and _holder(self._analysis, each) is variable
        ]
        if others:
            return
        left: list[tuple[CppFile, Node, Scope]] = []
        for file, node, scope in uses_of(self._analysis, variable):
            if self._gone.covers(file, node.start_byte):
                continue
            if not self._take_use(file, node, scope) and not self._take_asking(scope):
                left.append((file, node, scope))
        self._take_guards(left)
        self._note_macros(variable)
        creation.delete_declaration(self._gone)

    def _pending(self, variable: Variable) -> list[Site]:
        """Return the call sites that are yet to go and give a variable its value."""
        return [
            each
            for each in self._sites
            if each not in self._plan.lost and _holder(self._analysis, each) is variable
        ]

    def _note_macros(self, variable: Variable) -> None:
        for file, start in macro_uses(self._analysis, variable.name):
            self.used.append((file, line_number(file.syntax.text, start)))

    def _keep_value(self, creation: Creation, variable: Variable) -> None:
        """Note where the value of a parameter is used, which a removal leaves unset.

        A variable that nothing else names goes as well.
        """
        used = [
            (file, node.start_point.row + 1)
            for file, node, _ in uses_of(self._analysis, variable)
            if not self._gone.covers(file, node.start_byte)
        ]
        self.used += used
        self._note_macros(variable)
        if not used and variable.kind in ("local", "member") and not variable.file.is_beside:
            creation.delete_declaration(self._gone)

    def _take_use(self, file: CppFile, node: Node, scope: Scope) -> bool:
        """Take out a statement that does nothing but use the endpoint."""
        statement = statement_of(node)
        if statement is None or statement.type != "expression_statement":
            return False
        syntax = file.syntax
        if calls_method(statement, node, syntax, _SENDING):
            self._gone.statement(file, statement)
            self._take_message(file, statement, scope)
            return True
        if calls_method(statement, node, syntax, _ENDING) or only_sets(statement, node):
            self._gone.statement(file, statement)
            return True
        return False

    def _take_asking(self, scope: Scope) -> bool:
        """Take out a function that only asks through the endpoint, and what begins it."""
        functions = asking_function(self._analysis, scope)
        if not functions:
            return False
        for each in functions:
            remove_function(each, self._gone)
        held: list[Variable] = []
        for file, statement, place in mentions(self._analysis, functions, self._gone):
            target = statement.named_children[0].child_by_field_name("left")
            self._gone.statement(file, statement)
            if target is not None:
                found = variable_of(self._analysis, target, place)
                held += [] if found is None else [found]
            again = repeating_function(self._analysis, place, self._gone)
            for each in again:
                remove_function(each, self._gone)
            for site in self._analysis.sites if again else ():
                if again[0].name == site.endpoint.callback:
                    self.take(site)
        for variable in held:
            uses = uses_of(self._analysis, variable)
            if all(self._gone.covers(file, node.start_byte) for file, node, _ in uses):
                self._gone.statement(variable.file, variable.node)
        return True

    def _check_others(self, site: Site) -> None:
        """Refuse to take out a statement that creates other endpoints as well."""
        for each in self._analysis.sites:
            is_covered = self._gone.covers(each.file, each.call.node.start_byte)
            if is_covered and each not in self._plan.lost and each not in self._sites:
                message = f"line {site.endpoint.line} creates it among others"
                raise RefusedError(message, self._change.span, "change the line by hand")

    def _take_descriptor(self, site: Site) -> None:
        """Take out the local variable that describes a parameter, and a block left empty."""
        node, scope = parameter_call(site.call).descriptor, site.call.scope
        name = "" if node is None else last_name(node, scope)
        at = site.call.node.start_byte
        variable = self._analysis.unit.lookup(name, scope, at) if name else None
        if variable is None or variable.kind != "local":
            return
        setting = []
        for file, use, _ in uses_of(self._analysis, variable):
            if self._gone.covers(file, use.start_byte):
                continue
            statement = statement_of(use)
            if statement is None or not (only_sets(statement, use) or only_calls(statement, use)):
                return
            setting.append(statement)
        for each in (*setting, variable.node):
            self._gone.statement(variable.file, each)
        block = variable.node.parent
        outer = None if block is None else block.parent
        if block is None or outer is None or outer.type != "compound_statement":
            return
        if all(self._gone.covers(variable.file, each.start_byte) for each in block.named_children):
            self._gone.statement(variable.file, block)

    def _take_reading(self, site: Site) -> bool:
        """Take out a function that reads a parameter as Plastron writes it."""
        if site.endpoint.kind is not EndpointKind.PARAMETER:
            return False
        functions = reading_function(self._analysis, site.call.scope, self._change.name)
        for file, statement, _ in mentions(self._analysis, functions, self._gone):
            self.used.append((file, statement.start_point.row + 1))
        for each in functions:
            remove_function(each, self._gone)
        members = (each for one in functions for each in members_of(self._analysis, one))
        for variable in dict.fromkeys(members):
            uses = uses_of(self._analysis, variable)
            if all(self._gone.covers(file, node.start_byte) for file, node, _ in uses):
                self._gone.statement(variable.file, variable.node)
        return bool(functions)

    def _take_goals(self, site: Site) -> None:
        """Take out what works on the goals of an action as Plastron writes it."""
        functions = [
            each
            for listed in goal_functions(self._analysis, site.endpoint.name or "")
            for each in listed
        ]
        for each in functions:
            remove_function(each, self._gone)
        for variable in dict.fromkeys(goal_variables(self._analysis, functions)):
            uses = [
                each
                for each in uses_of(self._analysis, variable)
                if not self._gone.covers(each[0], each[1].start_byte)
            ]
            left = [each for each in uses if not self._take_use(*each)]
            self._take_guards(left)
            self._gone.statement(variable.file, variable.node)

    def _take_message(self, file: CppFile, statement: Node, scope: Scope) -> None:
        """Take out the local variable that was published, where nothing else uses it."""
        message = local_of(self._analysis, statement, scope)
        if message is None:
            return
        setting = []
        for used_file, node, _ in uses_of(self._analysis, message):
            if self._gone.covers(used_file, node.start_byte):
                continue
            inner = statement_of(node)
            if inner is None or not only_sets(inner, node):
                return
            setting.append(inner)
        for each in setting:
            self._gone.statement(file, each)
        self._gone.statement(file, message.node)

    def _take_guards(self, left: Iterable[tuple[CppFile, Node, Scope]]) -> None:
        """Take out what only asked about the endpoint before it was used."""
        for file, node, _ in left:
            block = emptied(node, file, self._gone)
            if block is not None:
                self._gone.statement(file, block)
            else:
                self.used.append((file, node.start_point.row + 1))

    def finish(self) -> Plan:
        """Take out the callbacks and includes that nothing needs any more, and return the plan."""
        self._take_idle()
        for functions in emptied_functions(self._analysis, self._change.name, self._gone):
            for each in functions:
                remove_function(each, self._gone)
            for file, statement, _ in list(mentions(self._analysis, functions, self._gone)):
                self._gone.statement(file, statement)
        while helpers := list(unused_helpers(self._analysis, self._gone)):
            for functions in helpers:
                for each in functions:
                    remove_function(each, self._gone)
        for site in list(self._plan.lost):
            for functions in functions_of(self._analysis, site):
                if self._is_gone(functions) or has_uses(self._analysis, functions, self._gone):
                    continue
                if all(is_stub(each) for each in functions if each.scope is not None):
                    for each in functions:
                        remove_function(each, self._gone)
        self._gone.take_empty()
        take_types(self._analysis, self._plan.lost, self._gone)
        take_placeholders(self._analysis, self._gone)
        for file in self._gone.files:
            if file.is_beside:
                message = "a part of it is in a file of another node"
                raise RefusedError(message, self._change.span, "change that file first")
            self._plan.splices[file.name] += self._gone.splices(file)
        return self._plan

    def _take_idle(self) -> None:
        """Take out the timers whose functions have nothing left to do."""
        for site in self._analysis.sites:
            is_timer = site.endpoint.kind is EndpointKind.TIMER
            if not is_timer or site in self._plan.lost:
                continue
            own = lambda_of(self._analysis, site)
            if own is not None and is_idle(own.scope.file, own.body, self._gone):
                self.take(site)
            for functions in functions_of(self._analysis, site):
                if any(is_idle(each.file, each.body, self._gone) for each in functions):
                    self.take(site)
                    if not has_uses(self._analysis, functions, self._gone):
                        for each in functions:
                            remove_function(each, self._gone)

    def _is_gone(self, functions: list[Function]) -> bool:
        return all(self._gone.covers(each.file, each.node.start_byte) for each in functions)


def _holder(analysis: Analysis, site: Site) -> Variable | None:
    found = creation_of(analysis, site)
    return None if found is None else found.variable
