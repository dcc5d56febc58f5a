"""What a CMakeLists.txt says: its commands with their values, loops unrolled where that is sure."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.sources.build_files import RefusedError, refusal

from .definitions import definitions_of
from .syntax import Argument, Block, Command, Listing, Statement, parse_cmake
from .variables import Item, Variable, Variables, appended, reference_of, split_list

_MOST_CALLS = 20_000
# Commands that change no variable that is named by one of their arguments.
HARMLESS = (
    "add_",
    "ament_",
    "catkin_",
    "cmake_",
    "enable_",
    "find_",
    "generate_",
    "include",
    "install",
    "link_",
    "message",
    "pluginlib_",
    "rclcpp_",
    "return",
    "rosidl_",
    "target_",
    "unset",
)


class Call(NamedTuple):
    """A command that runs, once for each turn of the loops that it is in.

    Attributes:
        command: where it is written.
        items: its values.
        conditions: what has to be true for it, the outermost first: `if(BUILD_TESTING)`.
        is_whole: whether all variables that it is given are known.
        is_repeated: whether it is in a loop.
        is_followed: whether all that it does is known, of a function, a macro or a file.
        open_lists: the variables that it is given and that may hold more than is known.
    """

    command: Command
    items: tuple[Item, ...]
    conditions: tuple[str, ...] = ()
    is_whole: bool = True
    is_repeated: bool = False
    is_followed: bool = False
    open_lists: tuple[str, ...] = ()

    @property
    def is_plain(self) -> bool:
        """Whether it stands in no branch and no loop."""
        return not self.conditions and not self.is_repeated

    def section(self, keyword: str, keywords: Iterable[str]) -> list[Item]:
        """Return the values between a keyword and the next of others; "" for the first ones."""
        found: list[Item] = []
        is_in = keyword == ""
        others = set(keywords)
        for item in self.items:
            is_keyword = not item.argument.is_quoted and item.value in others
            if is_keyword:
                is_in = item.value == keyword
            elif is_in:
                found.append(item)
        return found


@dataclass(frozen=True, slots=True)
class CMakeLists:
    """What is known of a CMakeLists.txt.

    Attributes:
        listing: its commands as they are written.
        name: what its project is called, None where that is computed.
        calls: what runs.
        variables: the variables as they are at its end.
        opaque: the functions and macros that may do what is not known.
    """

    listing: Listing
    name: str | None
    calls: tuple[Call, ...]
    variables: Variables
    opaque: tuple[Block, ...] = ()

    def named(self, *names: str) -> list[Call]:
        """Return the calls of some commands."""
        return [each for each in self.calls if each.command.name in names]


class ReadCMake(NamedTuple):
    """What was read of a CMakeLists.txt, or why nothing was."""

    lists: CMakeLists | None
    diagnostics: tuple[Diagnostic, ...] = ()


def read_cmake(text: bytes, path: Path) -> ReadCMake:
    """Read a CMakeLists.txt; nothing of it is run."""
    try:
        return ReadCMake(interpret(parse_cmake(text, path)))
    except RefusedError as refused:
        return ReadCMake(None, (refused.diagnostic,))


def interpret(listing: Listing) -> CMakeLists:
    """Follow the commands of a file from its first to its last."""
    run = Run(listing)
    run.statements(listing.statements, Variables.copy(run.variables), (), False, top=True)
    opaque = tuple(each.block for each in definitions_of(listing))
    return CMakeLists(listing, run.name, tuple(run.calls), run.variables, opaque)


@dataclass
class Run:
    """Follows the commands of a file."""

    listing: Listing
    calls: list[Call] = field(default_factory=list)
    variables: Variables = field(default_factory=Variables)
    name: str | None = None

    def statements(
        self,
        statements: Sequence[Statement],
        variables: Variables,
        conditions: tuple[str, ...],
        is_repeated: bool,
        top: bool = False,
    ) -> None:
        """Follow statements; what they set is in the variables afterwards."""
        for each in statements:
            if len(self.calls) >= _MOST_CALLS:
                span = each.span if isinstance(each, Command) else (each.start, each.end)
                why = f"is reached after {_MOST_CALLS} commands"
                raise refusal(self.listing.text, self.listing.path, span, why)
            if isinstance(each, Command):
                self._command(each, variables, conditions, is_repeated)
            elif each.kind == "if":
                self._branches(each, variables, conditions, is_repeated)
            elif each.kind in ("foreach", "while"):
                self._loop(each, variables, conditions)
            elif each.kind == "block":
                inner = variables.copy()
                self.statements(each.branches[0].statements, inner, conditions, is_repeated)
                variables.after_branch(inner)
        if top:
            self.variables = variables

    def _command(
        self, command: Command, variables: Variables, conditions: tuple[str, ...], loop: bool
    ) -> None:
        items = [item for each in command.arguments for item in variables.expand(each, command)]
        is_whole = variables.is_whole(command.arguments)
        call = Call(command, tuple(items), conditions, is_whole, loop,
                    open_lists=tuple(_open_lists(command, variables)))  # fmt: skip
        if self.follows(call, variables):
            return
        self.calls.append(call)
        self.before(call, variables)
        if command.name == "project" and items:
            self.name = items[0].value
            for name in ("PROJECT_NAME", "CMAKE_PROJECT_NAME"):
                variables.put(name, Variable([items[0]]))
        elif command.name == "set":
            _set(command, variables, is_whole)
        elif command.name == "list":
            _change_list(command, variables, is_whole)
        elif command.name == "file":
            _glob(command, items, variables)
        elif not command.name.startswith(HARMLESS):
            for each in command.arguments:
                variables.put(each.value, None)
        elif command.name == "unset" and command.arguments:
            variables.put(command.arguments[0].value, None)

    def follows(self, call: Call, variables: Variables) -> bool:
        """Follow what a call does that is written elsewhere; tell whether all of it is known."""
        del call, variables
        return False

    def before(self, call: Call, variables: Variables) -> None:
        """Do what a call does besides what it does in a file."""

    def _branches(
        self, block: Block, variables: Variables, conditions: tuple[str, ...], loop: bool
    ) -> None:
        for branch in block.branches:
            inner = variables.copy()
            opening = branch.opening
            said = self.listing.text[opening.start : opening.end].decode()
            self.statements(branch.statements, inner, (*conditions, said), loop)
            variables.after_branch(inner)

    def _loop(self, block: Block, variables: Variables, conditions: tuple[str, ...]) -> None:
        branch = block.branches[0]
        values = _loop_values(branch.opening, variables) if block.kind == "foreach" else None
        inner = variables.copy()
        if values is None:
            if branch.opening.arguments:
                inner.put(branch.opening.arguments[0].value, None)
            said = self.listing.text[branch.opening.start : branch.opening.end].decode()
            self.statements(branch.statements, inner, (*conditions, said), True)
        else:
            for item in values:
                inner.put(branch.opening.arguments[0].value, Variable([item]))
                self.statements(branch.statements, inner, conditions, True)
        variables.after_branch(inner)


def _set(command: Command, variables: Variables, is_whole: bool) -> None:
    if not command.arguments:
        return
    name, *given = command.arguments
    words = {each.value for each in given if not each.is_quoted}
    if "$" in name.value or words & {"CACHE", "PARENT_SCOPE"}:
        variables.put(name.value, None)
        return
    items = [item for each in given for item in variables.expand(each, command)]
    has_unknown = any(_has_unknown(each, variables) for each in given)
    variables.put(name.value, Variable(items, is_whole and not has_unknown, command))


def _open_lists(command: Command, variables: Variables) -> Iterator[str]:
    """Yield the variables that a command is given and that may hold more than is known."""
    for argument in command.arguments:
        name = reference_of(argument)
        known = None if name is None else variables.get(name)
        if name is None or (known is not None and known.is_whole):
            continue
        # All that patterns find is known.
        if known is None or not (known.items and all(each.is_pattern for each in known.items)):
            yield name


def _has_unknown(argument: Argument, variables: Variables) -> bool:
    name = reference_of(argument)
    return name is not None and variables.get(name) is None


def _change_list(command: Command, variables: Variables, is_whole: bool) -> None:
    if len(command.arguments) < 2:
        return
    kind, name, *given = command.arguments
    if kind.value.upper() == "APPEND":
        items = [item for each in given for item in variables.expand(each, command)]
        known = appended(variables.get(name.value), items, command)
        if known is not None and not is_whole:
            known.is_whole = False
        variables.put(name.value, known)
    elif kind.value.upper() not in ("LENGTH", "GET", "FIND", "JOIN", "SUBLIST"):
        variables.put(name.value, None)
    else:
        variables.put(command.arguments[-1].value, None)


def _glob(command: Command, items: Sequence[Item], variables: Variables) -> None:
    """Note the patterns of `file(GLOB NAME …)`, by paths from the package's folder."""
    values = [each.value for each in items]
    if len(values) < 2 or not values[0].startswith("GLOB"):
        for each in command.arguments[1:]:
            variables.put(each.value, None)
        return
    rest = list(items[2:])
    patterns: list[Item] = []
    base = ""
    while rest:
        item = rest.pop(0)
        if item.value in ("LIST_DIRECTORIES", "RELATIVE") and rest:
            base = rest.pop(0).value if item.value == "RELATIVE" else base
        elif item.value not in ("CONFIGURE_DEPENDS", "FOLLOW_SYMLINKS"):
            patterns.append(Item(item.value, item.argument, command, True))
    is_known = values[0] == "GLOB" and in_package(base + "/") in ("", "/")
    variables.put(values[1], Variable(patterns, False) if is_known else None)


def _loop_values(opening: Command, variables: Variables) -> list[Item] | None:
    """Return the values of a loop over what is written; None for other loops."""
    words = [each.value for each in opening.arguments]
    given = opening.arguments[1:]
    if len(words) < 2 or words[1] in ("RANGE",) or "ZIP_LISTS" in words:
        return None
    if words[1] == "IN":
        if len(words) > 2 and words[2] == "LISTS":
            items: list[Item] = []
            for each in given[2:]:
                variable = variables.get(each.value)
                if variable is None or not variable.is_whole or each.value == "ITEMS":
                    return None
                items += [part for one in variable.items for part in split_list(one)]
            return items
        given = given[2:]
    if not variables.is_whole(given):
        return None
    return [item for each in given for item in variables.expand(each, opening)]


_FOLDERS = ("CMAKE_CURRENT_SOURCE_DIR", "CMAKE_CURRENT_LIST_DIR", "PROJECT_SOURCE_DIR")


def in_package(path: str) -> str:
    """Return a path from the package's folder, where it begins with a name of that folder."""
    for name in (*_FOLDERS, "CMAKE_SOURCE_DIR"):
        path = path.removeprefix("${" + name + "}/")
    return path.removeprefix("./")
