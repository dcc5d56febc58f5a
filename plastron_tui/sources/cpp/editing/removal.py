"""Taking an endpoint out of a unit: what creates it, holds it, publishes on it, and hears it."""

from __future__ import annotations

from collections.abc import Iterable

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind, Remove
from plastron_tui.sources.splices import line_number

from ..analysis import Analysis, Site
from ..scopes import CppFile, Scope, Variable
from .containers import in_container
from .creation import Creation, creation_of, holder_of, variable_of
from .deletions import Deletions
from .dependent_code import DependentCode
from .descriptors import take_descriptor
from .kept_values import KeptValues
from .leftovers import (
    functions_of,
    has_uses,
    is_idle,
    remove_function,
    take_callbacks,
    take_headers,
    take_held_lambdas,
    take_literals,
    take_placeholders,
    take_types,
)
from .listening import block_for_listeners
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
from .parameter_names import unname_unused
from .plans import Plan
from .refusals import RefusedError, in_use, not_there
from .shared_statements import SharedStatements
from .statements import calls_method, emptied, local_of, only_sets, sets_what_stays, statement_of
from .units import sites_of
from .uses import hidden_uses, uses_of

_SENDING = frozenset({"publish", "sendTransform"})
_ENDING = frozenset(
    {"shutdown", "reset", "cancel", "stop", "on_activate", "on_deactivate", "start", "spin"}
    | {"join", "setAborted"}
)


def plan_removal(analysis: Analysis, change: Remove, others: Iterable[Remove] = ()) -> Plan:
    """Plan the removal of an endpoint.

    Args:
        analysis: the files.
        change: what is asked for.
        others: what else goes; what one statement makes of it goes with the endpoint.

    Raises:
        RefusedError: the files have none such, or use it in another way.
    """
    sites = sites_of(analysis, change)
    if not sites:
        raise not_there(analysis, change)
    going = [site for other in others for site in sites_of(analysis, other)]
    removal = _Removal(analysis, change, sites, going)
    for site in sites:
        removal.take(site)
    return removal.plan()


def plan_silence(analysis: Analysis, change: Remove) -> Plan:
    """Plan to take out what publishes through a publisher, which itself stays.

    Raises:
        RefusedError: nothing of the files holds it.
    """
    removal = _Removal(analysis, change, [], [])
    for site in sites_of(analysis, change):
        removal.silence(site)
    return removal.plan()


class _Removal:
    """A removal on its way.

    Attributes:
        used: where the endpoint is used in another way, as file and line.
    """

    def __init__(
        self, analysis: Analysis, change: Remove, sites: list[Site], going: list[Site]
    ) -> None:
        self._analysis = analysis
        self._sites = sites
        self._change = change
        self._gone = Deletions()
        self._shared = SharedStatements(analysis, change, [*sites, *going], self._gone)
        self._kept = KeptValues(analysis, sites, self._gone)
        self._served = DependentCode(analysis, self._gone)
        self._plan = Plan()
        self.used: list[tuple[CppFile, int]] = []

    def plan(self) -> Plan:
        """Return what the removal does.

        Raises:
            RefusedError: the endpoint is used in another way.
        """
        self._take_idle()
        self._served.finish(self._plan.lost)
        used = [*self.used, *self._served.used]
        if used:
            raise in_use(self._change, used)
        return self._finish()

    def take(self, site: Site) -> None:
        """Take one call site out, with what holds it and what only served it."""
        if site in self._plan.lost:
            return
        self._plan.lost += [site, *self._shared.created_with(site)]
        if self._gone.covers(site.file, site.call.node.start_byte) or self._take_reading(site):
            return
        if site.endpoint.kind is EndpointKind.PARAMETER and self._kept.keep(site):
            take_descriptor(self._analysis, site, self._gone)
            return
        is_call = site.call.receiver is None and site.call.name == "call"
        if is_call and self._served.take_call(site):
            return
        creation = creation_of(self._analysis, site)
        if creation is None or is_call:
            raise self._does_more(site)
        creation.delete(self._gone)
        self._served.note(creation.file, creation.node)
        self._plan.lost += self._shared.gone_with(site, self._plan.lost)
        if site.endpoint.kind is EndpointKind.PARAMETER:
            take_descriptor(self._analysis, site, self._gone)
        if site.endpoint.kind is EndpointKind.ACTION_SERVER:
            self._take_goals(site)
            if creation.variable is not None:
                self._served.begin(creation.variable)
            self._served.take_named()
        if creation.variable is not None:
            self._take_variable(creation, site)
        if creation.container is not None:
            self.used += in_container(self._analysis, creation.container, self._gone)

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
            if each not in self._plan.lost and holder_of(self._analysis, each) is variable
        ]
        if others:
            return
        self._served.begin(variable)
        left: list[tuple[CppFile, Node, Scope]] = []
        for file, node, scope in uses_of(self._analysis, variable):
            if file.is_beside:
                self.used.append((file, node.start_point.row + 1))
                continue
            if self._gone.covers(file, node.start_byte) or self._take_use(file, node, scope):
                continue
            if not self._take_asking(scope) and not self._served.take(file, node):
                left.append((file, node, scope))
        self._take_guards(left)
        self._note_hidden(variable)
        creation.delete_declaration(self._gone)

    def silence(self, site: Site) -> None:
        """Take out the statements that publish through a publisher, with what only served them."""
        creation = creation_of(self._analysis, site)
        if creation is None or creation.variable is None:
            raise self._does_more(site)
        for file, node, scope in uses_of(self._analysis, creation.variable):
            if not self._gone.covers(file, node.start_byte):
                self._take_sending(file, node, scope)

    def _does_more(self, site: Site) -> RefusedError:
        message = f"line {site.endpoint.line} does more than to create it"
        return RefusedError(message, self._change.span, "change the line by hand")

    def _pending(self, variable: Variable) -> list[Site]:
        """Return the call sites that are yet to go and give a variable its value."""
        return [
            each
            for each in self._sites
            if each not in self._plan.lost and holder_of(self._analysis, each) is variable
        ]

    def _note_hidden(self, variable: Variable) -> None:
        for file, start in hidden_uses(self._analysis, variable.name, self._gone):
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
        self._note_hidden(variable)
        if not used and variable.kind in ("local", "member") and not variable.file.is_beside:
            creation.delete_declaration(self._gone)

    def _take_use(self, file: CppFile, node: Node, scope: Scope) -> bool:
        """Take out a statement that does nothing but use the endpoint."""
        if self._take_sending(file, node, scope):
            return True
        statement, syntax = statement_of(node), file.syntax
        if statement is None or statement.type != "expression_statement":
            return False
        if calls_method(statement, node, syntax, _ENDING) or only_sets(statement, node):
            self._gone.statement(file, statement)
            return True
        return False

    def _take_sending(self, file: CppFile, node: Node, scope: Scope) -> bool:
        statement = statement_of(node)
        if statement is None or statement.type != "expression_statement":
            return False
        if not calls_method(statement, node, file.syntax, _SENDING):
            return False
        if sets_what_stays(self._analysis, statement, scope):
            return False
        self._gone.statement(file, statement)
        self._take_message(file, statement, scope)
        return True

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
            unheard = block_for_listeners(self._analysis, file, node)
            if unheard is not None:
                self._gone.statement(file, unheard)
                continue
            block = emptied(node, file, self._gone)
            condition = None if block is None else block.child_by_field_name("condition")
            is_asking = condition is not None and self._served.is_asking(file, node, condition)
            if block is not None and is_asking:
                self._gone.statement(file, block)
            else:
                self.used.append((file, node.start_point.row + 1))

    def _finish(self) -> Plan:
        """Take out the callbacks and includes that nothing needs any more, and return the plan."""
        for functions in emptied_functions(self._analysis, self._change.name, self._gone):
            for each in functions:
                remove_function(each, self._gone)
            for file, statement, _ in list(mentions(self._analysis, functions, self._gone)):
                self._gone.statement(file, statement)
        while helpers := list(unused_helpers(self._analysis, self._gone)):
            for functions in helpers:
                for each in functions:
                    remove_function(each, self._gone)
        take_callbacks(self._analysis, self._plan.lost, self._gone)
        take_held_lambdas(self._analysis, self._plan.lost, self._gone)
        self._gone.take_empty()
        self._gone.take_sections()
        self._note_parameters()
        take_types(self._analysis, self._plan.lost, self._gone)
        take_placeholders(self._analysis, self._gone)
        take_literals(self._analysis, self._gone)
        take_headers(self._analysis, self._gone)
        torn = [each for file in self._gone.files for each in self._gone.torn(file)]
        if torn:
            raise in_use(self._change, torn)
        unname_unused(self._analysis, self._gone, self._plan)
        for file in self._gone.files:
            if file.is_beside:
                message = "a part of it is in a file of another node"
                raise RefusedError(message, self._change.span, "change that file first")
            self._plan.splices[file.name] += self._gone.splices(file)
        return self._plan

    def _note_parameters(self) -> None:
        """Count the parameters as gone that only what goes has read."""
        self._plan.lost += [
            site
            for site in self._analysis.sites
            if site.endpoint.kind is EndpointKind.PARAMETER
            and site not in self._plan.lost
            and self._gone.covers(site.file, site.call.node.start_byte)
        ]

    def _take_idle(self) -> None:
        """Take out the timers whose functions have nothing left to do."""
        for site in self._analysis.sites:
            is_timer = site.endpoint.kind is EndpointKind.TIMER
            if not is_timer or site in self._plan.lost:
                continue
            functions = list(functions_of(self._analysis, site))
            is_done = any(is_idle(each, self._gone) for listed in functions for each in listed)
            if not is_done and not self._served.is_idle(site):
                continue
            self.take(site)
            self._served.take_handle(site)
            for listed in functions:
                if not has_uses(self._analysis, listed, self._gone):
                    for each in listed:
                        remove_function(each, self._gone)
