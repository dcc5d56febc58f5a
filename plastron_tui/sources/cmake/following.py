"""A CMakeLists.txt with what its functions, its macros and the files that it includes do.

Who changes a file takes it as it is written, without that.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from plastron_tui.sources.build_files import RefusedError

from .definitions import (
    DEEPEST_CALL,
    Definition,
    NotFollowedError,
    ReadFile,
    bound,
    check_followed,
    definitions_of,
    is_for_tests,
    only_configures,
    parse_arguments,
)
from .reader import HARMLESS, Call, CMakeLists, Run, in_package
from .syntax import parse_cmake
from .variables import Variables


def follow(lists: CMakeLists, read: ReadFile) -> CMakeLists:
    """Return what a file says with what is defined or included there.

    Args:
        lists: the file.
        read: returns what a file of the package holds.
    """
    listing = lists.listing
    definitions = definitions_of(listing)
    if not definitions and not any(map(_includes_file, lists.named("include"))):
        return lists
    known = {each.name: each for each in definitions if each.is_plain and each.name}
    run = _FollowingRun(listing, definitions=known, read=read)
    try:
        run.statements(listing.statements, Variables.copy(run.variables), (), False, top=True)
    except RefusedError:
        return lists
    opaque = tuple(each.block for each in definitions if run.is_opaque(each))
    return CMakeLists(listing, run.name, tuple(run.calls), run.variables, opaque)


def _includes_file(call: Call) -> bool:
    return bool(call.items) and call.items[0].value.endswith(".cmake")


def _no_file(name: str) -> bytes | None:
    del name
    return None


@dataclass
class _FollowingRun(Run):
    """Follows functions, macros and files too.

    Attributes:
        definitions: the functions and macros that are defined in any case, by their names.
        read: returns what a file of the package holds.
        refused: the names of those that do what is not known.
        running: the names of those that run, the innermost last.
        outer: the variables that the innermost one sets for its caller.
    """

    definitions: Mapping[str, Definition] = field(default_factory=dict)
    read: ReadFile = _no_file
    refused: set[str] = field(default_factory=set)
    running: list[str] = field(default_factory=list)
    outer: set[str] = field(default_factory=set)

    def is_opaque(self, definition: Definition) -> bool:
        """Tell whether a function or a macro may do what is not known."""
        name = definition.name
        if not name or name in self.refused:
            return True
        calls = [
            each
            for each in self.calls
            if (each.command.name == name and not each.is_followed)
            or any(item.value.lower() == name for item in each.items)
        ]
        if not calls and definition.is_plain:
            return False
        return not (
            (definition.is_plain or definition.is_for_tests)
            and definition.makes_nothing
            and all(is_for_tests(each.conditions) for each in calls)
        )

    def follows(self, call: Call, variables: Variables) -> bool:
        """Follow a call of a function, a macro or a file; tell whether all of it is known."""
        name = call.command.name
        if name == "include" and _includes_file(call):
            is_known = self._includes(in_package(call.items[0].value), variables)
            if is_known:
                self.calls.append(call._replace(is_followed=True))
            return is_known
        definition = self.definitions.get(name)
        if definition is None or name in self.refused:
            return False
        count, inner, outer = len(self.calls), variables.copy(), self.outer
        self.running.append(name)
        self.outer = set()
        self.calls.append(call._replace(is_followed=True))
        try:
            self._run(definition, call, inner)
        except NotFollowedError:
            del self.calls[count:]
            self.refused.add(name)
            return False
        finally:
            changed, self.outer = self.outer, outer
            self.running.pop()
        if definition.is_macro:
            variables.become(inner)
        self.outer |= changed
        for each in changed:
            variables.put(each, None)
        return True

    def _run(self, definition: Definition, call: Call, variables: Variables) -> None:
        """Run what a function or a macro does, with the variables that it has then.

        Raises:
            NotFollowedError: it is not known what it does.
        """
        if definition.name in self.running[:-1] or len(self.running) > DEEPEST_CALL:
            raise NotFollowedError
        check_followed(definition)
        given = bound(definition, call.command, variables)
        hidden = {*given, *definition.parameters, "ARGC", "ARGN", "ARGV"}
        known = {name: variables.get(name) for name in hidden}
        for name in hidden:
            variables.put(name, given.get(name))
        self.statements(definition.statements, variables, call.conditions, call.is_repeated)
        for name, before in known.items():
            variables.put(name, before)

    def before(self, call: Call, variables: Variables) -> None:
        """Forget the variables that a call sets whose names are computed.

        Raises:
            NotFollowedError: it is not known which ones.
        """
        if not self.running:
            return
        command = call.command
        if command.name == "cmake_parse_arguments":
            parse_arguments(command, variables)
        if command.name in ("set", "unset", "list"):
            at = 1 if command.name == "list" else 0
            names = [variables.substituted(x.value) for x in command.arguments[at : at + 1]]
            words = {each.value for each in command.arguments}
            self.outer.update(names if words & {"CACHE", "PARENT_SCOPE"} else ())
        elif command.name.startswith(HARMLESS):
            return
        else:
            names = [each.value for each in call.items]
        is_macro = self.definitions[self.running[-1]].is_macro
        if any("$" in each for each in names) and (is_macro or command.name in ("set", "unset")):
            raise NotFollowedError
        for argument in command.arguments if "$" in str(command.words) else ():
            name = variables.substituted(argument.value)
            if name != argument.value and name in names:
                variables.put(name, None)

    def _includes(self, path: str, variables: Variables) -> bool:
        """Forget what a file sets that only configures; tell whether it is such a file."""
        if set("$:") & set(path) or path.startswith("/") or ".." in path:
            return False
        text = self.read(path)
        try:
            listing = None if text is None else parse_cmake(text, self.listing.path.parent / path)
            if listing is None or not only_configures(listing):
                return False
            after = variables.copy()
            Run(listing).statements(listing.statements, after, (), False)
        except RefusedError:
            return False
        variables.forget_changed(after)
        return True
