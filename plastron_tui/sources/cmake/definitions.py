"""Functions and macros that a file defines and calls, and files of the package that it includes.

Source: "function", "macro", "include" and "cmake_parse_arguments" of CMake's manual.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple

from .syntax import Argument, Block, Command, Listing, Statement
from .variables import Item, Variable, Variables, reference_of, split_list

ReadFile = Callable[[str], bytes | None]
"""Returns what a file of the package holds, None for what is none."""

DEEPEST_CALL = 8
MODULES = ("CheckC", "CheckI", "CheckS", "CTest", "CMake", "GNUInstallDirs", "GenerateExport",
           "ExternalProject", "FetchContent", "FeatureSummary", "Find")  # fmt: skip
"""How the names of files begin that CMake brings along and that make no program."""
_TESTS = re.compile(r"BUILD_TESTING|CATKIN_ENABLE_TESTING")
_NOT = re.compile(r"\bNOT\b")
_MAKING = frozenset({
    "add_executable", "add_subdirectory", "ament_auto_add_executable", "catkin_install_python",
    "include", "install", "rclcpp_components_register_node", "rclcpp_components_register_nodes",
})  # fmt: skip
_NOT_FOLLOWED = frozenset({"break", "cmake_language", "continue", "include", "return"})
_CONFIGURING = frozenset({
    "add_compile_definitions", "add_compile_options", "add_definitions", "add_link_options",
    "cmake_minimum_required", "cmake_parse_arguments", "cmake_policy", "else", "elseif",
    "execute_process", "file", "find_file", "find_library", "find_package", "find_path",
    "find_program", "foreach", "get_cmake_property", "get_directory_property",
    "get_filename_component", "get_property", "get_target_property", "if", "include",
    "include_directories", "link_directories", "list", "mark_as_advanced", "math",
    "message", "option", "pkg_check_modules", "pkg_search_module", "return", "separate_arguments",
    "set", "string", "target_compile_definitions", "target_compile_features",
    "target_compile_options", "target_include_directories", "target_link_directories",
    "target_link_libraries", "target_link_options", "unset", "while",
})  # fmt: skip
"""Commands that make nothing, and bring no commands that do."""
_BUILDING = ("actionlib", "ament", "catkin", "genmsg", "message_generation", "rosidl")
"""How packages begin whose commands make something."""


class NotFollowedError(Exception):
    """What a call does is not known for sure."""


class Definition(NamedTuple):
    """A function or a macro, and whether it is defined in any case, once, or for tests alone."""

    block: Block
    is_plain: bool
    is_for_tests: bool

    @property
    def name(self) -> str:
        """Its name in small letters, "" where it has none."""
        return _arguments(self.block)[0].value.lower() if _arguments(self.block) else ""

    @property
    def parameters(self) -> tuple[str, ...]:
        """The names of its arguments."""
        return tuple(each.value for each in _arguments(self.block)[1:])

    @property
    def is_macro(self) -> bool:
        """Whether it runs where it is called."""
        return self.block.kind == "macro"

    @property
    def statements(self) -> tuple[Statement, ...]:
        """What it does."""
        return self.block.branches[0].statements

    @property
    def makes_nothing(self) -> bool:
        """Whether nothing in it makes programs, or says where they go."""
        return not any(each.name in _MAKING for each in _commands(self.statements))


def _arguments(block: Block) -> tuple[Argument, ...]:
    return block.branches[0].opening.arguments if block.branches else ()


def is_for_tests(conditions: Iterable[str]) -> bool:
    """Tell whether something runs only where tests are built."""
    return any(_TESTS.search(each) and not _NOT.search(each) for each in conditions)


def definitions_of(listing: Listing) -> tuple[Definition, ...]:
    """Return the functions and macros that a file defines."""
    found = list(_definitions(listing, listing.statements, ()))
    names = [each.name for each in found]
    return tuple(each._replace(is_plain=each.is_plain and names.count(each.name) == 1)
                 for each in found)  # fmt: skip


def _definitions(
    listing: Listing, statements: Sequence[Statement], conditions: tuple[str, ...]
) -> Iterator[Definition]:
    for each in statements:
        if not isinstance(each, Block):
            continue
        if each.kind in ("function", "macro") and each.branches:
            yield Definition(each, not conditions, is_for_tests(conditions))
        for branch in each.branches:
            said = listing.text[branch.opening.start : branch.opening.end].decode()
            yield from _definitions(listing, branch.statements, (*conditions, said))


def _commands(statements: Iterable[Statement]) -> Iterator[Command]:
    for each in statements:
        if isinstance(each, Command):
            yield each
            continue
        for branch in each.branches:
            yield branch.opening
            yield from _commands(branch.statements)


def check_followed(definition: Definition) -> None:
    """Look whether what a function or a macro does is what its commands say, one by one.

    Raises:
        NotFollowedError: it is not.
    """
    own = {*definition.parameters, "ARGC", "ARGN", "ARGV"}
    for each in _commands(definition.statements):
        if each.name in ("function", "macro") or (
            each.name in _NOT_FOLLOWED and not _is_module(each)
        ):
            raise NotFollowedError
        # The arguments of a macro are no variables: only `${NAME}` is replaced.
        words = () if each.name in ("if", "elseif", "else") else each.arguments
        if definition.is_macro and any(word.value in own for word in words):
            raise NotFollowedError


def _is_module(command: Command) -> bool:
    file = command.arguments[0].value if command.arguments else ""
    return command.name == "include" and file.startswith(MODULES) and not file.endswith(".cmake")


def only_configures(listing: Listing) -> bool:
    """Tell whether a file that is included makes nothing, and defines nothing that may."""
    for each in _commands(listing.statements):
        words = [one.value for one in each.arguments]
        if each.name == "add_library":
            if not {"ALIAS", "IMPORTED", "INTERFACE"} & {*words}:
                return False
        elif each.name not in _CONFIGURING or (
            (each.name == "include" and not _is_module(each))
            or (each.name == "find_package" and "".join(words[:1]).startswith((*_BUILDING, "$")))
        ):
            return False
    return True


def bound(definition: Definition, command: Command, variables: Variables) -> dict[str, Variable]:
    """Return the variables that a call gives a function or a macro; what is not known is left out.

    Raises:
        NotFollowedError: the call has too few arguments.
    """
    items: list[Item] = []
    known = None
    for each in command.arguments:
        items += variables.expand(each, command)
        name = reference_of(each)
        if name is not None and not variables.is_whole([each]):
            known = len(items) if known is None else known
            if variables.get(name) is not None:
                # There may be more than is known.
                items.append(Item(each.value, each, command))
            else:
                known = min(known, len(items) - 1)
    is_whole = known is None
    known = len(items) if known is None else known
    names = definition.parameters
    if is_whole and len(items) < len(names):
        raise NotFollowedError
    found = {name: Variable([each]) for name, each in zip(names, items[:known], strict=False)}
    found |= {f"ARGV{at}": Variable([each]) for at, each in enumerate(items[:known])}
    found["ARGV"] = Variable(items, is_whole)
    if known >= len(names):
        found["ARGN"] = Variable(items[len(names) :], is_whole)
    return found


def parse_arguments(command: Command, variables: Variables) -> None:
    """Set the variables that `cmake_parse_arguments` sets.

    Raises:
        NotFollowedError: it is not known which ones, or what is in them.
    """
    arguments = list(command.arguments)
    given: list[Item] | None = None
    is_whole = True
    if arguments and arguments[0].value == "PARSE_ARGV":
        everything = variables.get("ARGV")
        if len(arguments) != 6 or everything is None or not arguments[1].value.isdigit():
            raise NotFollowedError
        given, is_whole = everything.items[int(arguments[1].value) :], everything.is_whole
        arguments = arguments[2:]
    if len(arguments) < 4:
        raise NotFollowedError
    prefix, *kinds = (
        ";".join(item.value for item in variables.expand(each, command)) for each in arguments[:4]
    )
    if given is None:
        given = [item for each in arguments[4:] for item in variables.expand(each, command)]
        is_whole = variables.is_whole(arguments[4:])
    options, singles, lists = ([x for x in each.split(";") if x] for each in kinds)
    if "$" in "".join((prefix, *kinds)):
        raise NotFollowedError
    sections: dict[str, list[Item]] = {name: [] for name in (*singles, *lists, "")}
    chosen = set()
    last = ""
    for item in (one for each in given for one in split_list(each)):
        if item.value in options:
            chosen.add(item.value)
            last = ""
        elif item.value in sections and item.value:
            last = item.value
        else:
            sections[last].append(item)
            last = "" if last in singles else last
    for name, items in sections.items():
        is_known = not any(_is_open(each) for each in items) and (is_whole or name != last)
        variables.put(f"{prefix}_{name or 'UNPARSED_ARGUMENTS'}", Variable(items, is_known))
    for name in options:
        word = Item("TRUE" if name in chosen else "FALSE", arguments[1], command)
        variables.put(f"{prefix}_{name}", Variable([word]))


def _is_open(item: Item) -> bool:
    return item.is_pattern or (item.value.startswith("${") and item.value.endswith("}"))
