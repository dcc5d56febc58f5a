"""What a setup.py says: names, console scripts, data files."""

from __future__ import annotations

import configparser
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.sources.build_files import RefusedError, matches

from .python_packages import Finder, read_finder, read_root
from .syntax import Setup, parse_setup
from .values import Glob, Unknown, Value, evaluate, items_of

CONSOLE_SCRIPTS = "console_scripts"
_HANGING = ("entry_points", "data_files", "scripts")
"""What is not known of a call that hangs on a condition."""


class ConsoleScript(NamedTuple):
    """An executable that `ros2 run` starts: `talker = demo.talker:main`.

    Attributes:
        name: what it is called.
        target: `MODULE:FUNCTION`.
        span: where the file says so.
    """

    name: str
    target: str
    span: Span


class DataFiles(NamedTuple):
    """Files that are installed beside the code.

    Attributes:
        destination: the folder under the install prefix, None where it is computed.
        files: what goes there, by paths from the package's folder.
        patterns: what goes there as far as it matches.
        is_whole: whether that is all that goes there.
        span: where the file says so.
    """

    destination: str | None
    files: tuple[str, ...]
    patterns: tuple[str, ...]
    is_whole: bool
    span: Span

    def covers(self, file: str) -> bool:
        """Tell whether a file is among them for sure."""
        return file in self.files or any(matches(file, each) for each in self.patterns)


class SetupFile(NamedTuple):
    """What is known of a setup.py.

    Attributes:
        name: what the package is called, None where that is computed.
        is_catkin: whether catkin's `generate_distutils_setup` is called.
        packages: the Python packages, None where they are computed.
        finder: how they are found, None where they are listed, or computed otherwise.
        root: the folder that `package_dir` says they are in, None where it does not.
        console_scripts: the executables that are known.
        data_files: what is installed besides.
        scripts: the files that are installed as they are.
        script_patterns: what is installed as it is as far as it matches.
        computed: what is computed in a way that is not followed, by keyword.
    """

    name: str | None
    is_catkin: bool
    packages: tuple[str, ...] | None
    console_scripts: tuple[ConsoleScript, ...]
    data_files: tuple[DataFiles, ...]
    scripts: tuple[str, ...]
    computed: tuple[tuple[str, Span], ...] = ()
    finder: Finder | None = None
    root: str | None = None
    script_patterns: tuple[str, ...] = ()

    def is_script(self, file: str) -> bool:
        """Tell whether a file is installed as it is for sure."""
        return file in self.scripts or any(matches(file, each) for each in self.script_patterns)


class ReadSetup(NamedTuple):
    """What was read of a setup.py, or why nothing was."""

    setup: SetupFile | None
    diagnostics: tuple[Diagnostic, ...] = ()


def read_setup(text: bytes, path: Path, ros_version: int = 2) -> ReadSetup:
    """Read a setup.py as a generation of ROS would run it; nothing of it is run."""
    try:
        return ReadSetup(describe(parse_setup(text, path, ros_version)))
    except RefusedError as refused:
        return ReadSetup(None, (refused.diagnostic,))


def describe(setup: Setup) -> SetupFile:
    """Return what a parsed setup.py says."""
    name = keyword(setup, "name")
    packages = keyword(setup, "packages")
    scripts, unknown_files = _scripts(setup)
    found_packages = _texts(setup, packages)
    if found_packages is not None:
        # Setuptools takes the path of a folder as well.
        found_packages = tuple(each.replace("/", ".") for each in found_packages)
    console_scripts, unknown_scripts = _console_scripts(setup)
    data_files, unknown_data = _data_files(setup)
    known = evaluate(setup, name) if name is not None else None
    return SetupFile(
        known if isinstance(known, str) else None,
        setup.is_catkin,
        found_packages,
        tuple(console_scripts),
        tuple(data_files),
        tuple(each for each in scripts if isinstance(each, str)),
        (
            *((each, _span(setup.call)) for each in _HANGING if not setup.is_sure),
            *(("entry_points", each) for each in unknown_scripts),
            *(("data_files", each) for each in unknown_data),
            *(("scripts", each) for each in unknown_files),
        ),
        read_finder(setup, packages),
        read_root(setup, keyword(setup, "package_dir")),
        tuple(each.pattern for each in scripts if isinstance(each, Glob)),
    )


def _scripts(setup: Setup) -> tuple[tuple[Value, ...], list[Span]]:
    """Return the files that are installed as they are, and what is computed of them."""
    node = keyword(setup, "scripts")
    if node is None:
        return (), []
    value = evaluate(setup, node)
    # Setuptools takes one text for a list of words, which nobody means.
    values = value if isinstance(value, tuple) else (value,)
    known = tuple(each for each in values if isinstance(each, str | Glob))
    is_whole = len(known) == len(values) and setup.changed(node) is None
    return known, [] if is_whole else [_span(node)]


def keyword(setup: Setup, name: str) -> Node | None:
    """Return the value of a keyword of the call, or of a dictionary given as `**`."""
    arguments = setup.call.child_by_field_name("arguments")
    assert arguments is not None
    return _entry(setup, arguments, name)


def _entry(setup: Setup, node: Node, name: str) -> Node | None:
    """Return what a key of a call or a dictionary has as its value."""
    for each in items_of(node):
        if each.type == "keyword_argument":
            key = each.child_by_field_name("name")
            if key is not None and setup.source(key) == name:
                return each.child_by_field_name("value")
        elif each.type == "pair":
            key = each.child_by_field_name("key")
            if key is not None and evaluate(setup, key) == name:
                return each.child_by_field_name("value")
        elif each.type == "dictionary_splat" and each.named_child_count:
            given = dictionary(setup, each.named_children[0])
            found = _entry(setup, given, name) if given is not None and given != node else None
            if found is not None:
                return found
    return None


def dictionary(setup: Setup, node: Node) -> Node | None:
    """Return the literal dictionary, or the arguments of `dict(…)`, that an expression is."""
    node = setup.resolve(node)
    if node.type == "dictionary":
        return node
    function = node.child_by_field_name("function") if node.type == "call" else None
    if function is not None and setup.source(function) == "dict":
        arguments = node.child_by_field_name("arguments")
        kinds = {each.type for each in items_of(arguments)} if arguments is not None else set()
        # What `dict` is given besides keywords is not followed.
        return arguments if kinds <= {"keyword_argument", "dictionary_splat"} else None
    return None


def computed_arguments(setup: Setup, *, is_given: bool = False) -> Node | None:
    """Return a dictionary given as `**` that is computed or changed, None where there is none.

    Args:
        setup: the file.
        is_given: whether only one that is changed matters, as what is asked for was found.
    """
    arguments = setup.call.child_by_field_name("arguments")
    for each in items_of(arguments) if arguments is not None else ():
        if each.type != "dictionary_splat" or not each.named_child_count:
            continue
        given = each.named_children[0]
        if (changed := setup.changed(given)) is not None:
            return changed
        if dictionary(setup, given) is None and not is_given:
            return each
    return None


def changed_summand(setup: Setup, node: Node) -> Node | None:
    """Return what changes a list that is added up to a value, None where nothing does."""
    for each in (node, *_names_added(setup, node)):
        if (changed := setup.changed(each)) is not None:
            return changed
    return None


def changed_scripts(setup: Setup) -> Node | None:
    """Return what changes the console scripts after they are written, None where nothing does."""
    given, node = keyword(setup, "entry_points"), entry_points(setup)
    changed = computed_arguments(setup, is_given=True)
    if changed is None and given is not None:
        changed = setup.changed(given)
    return changed_summand(setup, node) if changed is None and node is not None else changed


def changed_data_files(setup: Setup) -> Node | None:
    """Return what changes the data files after they are written, None where nothing does."""
    node = keyword(setup, "data_files")
    changed = computed_arguments(setup, is_given=True)
    return changed_summand(setup, node) if changed is None and node is not None else changed


def _names_added(setup: Setup, node: Node) -> Iterator[Node]:
    """Yield the expressions that are added up with `+`, names as they are written."""
    waiting, found = [setup.resolve(node)], set[int]()
    while waiting:
        each = waiting.pop()
        if each.type != "binary_operator" or each.id in found:
            continue
        found.add(each.id)
        for part in (each.child_by_field_name(side) for side in ("left", "right")):
            if part is not None:
                yield part
                waiting.append(setup.resolve(part))


def has_entry_points(text: bytes, path: Path) -> bool:
    """Tell whether `setup` is called with entry points, or with what may have some.

    Raises:
        RefusedError: the file cannot be read.
    """
    setup = parse_setup(text, path)
    unknown = computed_arguments(setup) is not None
    return unknown or keyword(setup, "entry_points") is not None


def entry_points(setup: Setup) -> Node | None:
    """Return what the console scripts are, None where there are none."""
    given = keyword(setup, "entry_points")
    found = dictionary(setup, given) if given is not None else None
    return None if found is None else _entry(setup, found, CONSOLE_SCRIPTS)


def _span(node: Node) -> Span:
    return Span(node.start_byte, node.end_byte)


def _console_scripts(setup: Setup) -> tuple[list[ConsoleScript], list[Span]]:
    given = keyword(setup, "entry_points")
    changed = changed_scripts(setup)
    changes = [] if changed is None else [_span(changed)]
    if given is None:
        return [], changes
    if dictionary(setup, given) is None:
        value = evaluate(setup, given)
        if isinstance(value, str):
            return _from_sections(value, _span(given)), []
        return [], [_span(given)]
    value_node = entry_points(setup)
    if value_node is None:
        return [], changes
    scripts: list[ConsoleScript] = []
    unknown: list[Span] = []
    for place, value in placed(setup, value_node):
        if isinstance(value, str) and "=" in value:
            name, _, target = value.partition("=")
            scripts.append(ConsoleScript(name.strip(), target.strip(), _span(place)))
        else:
            unknown.append(_span(place))
    return scripts, unknown + changes


def placed(setup: Setup, node: Node) -> list[tuple[Node, Value]]:
    """Return the values of a list, each with the expression that says it."""
    resolved = setup.resolve(node)
    if resolved.type in ("list", "tuple"):
        return [(each, evaluate(setup, each)) for each in items_of(resolved)]
    if resolved.type == "binary_operator":
        left, right = (resolved.child_by_field_name(each) for each in ("left", "right"))
        operator = resolved.child_by_field_name("operator")
        if left is not None and right is not None and operator and operator.type == "+":
            return [*placed(setup, left), *placed(setup, right)]
    value = evaluate(setup, resolved)
    if isinstance(value, tuple):
        return [(resolved, each) for each in value]
    return [(resolved, value)]


def _from_sections(text: str, span: Span) -> list[ConsoleScript]:
    """Read entry points that are written as the sections of an ini file."""
    parser = configparser.ConfigParser(delimiters=("=",), interpolation=None, strict=False)
    parser.optionxform = str  # type: ignore[assignment,method-assign]
    try:
        parser.read_string(text)
    except configparser.Error:
        return []
    if not parser.has_section(CONSOLE_SCRIPTS):
        return []
    return [ConsoleScript(name, value, span) for name, value in parser.items(CONSOLE_SCRIPTS)]


def _texts(setup: Setup, node: Node | None) -> tuple[str, ...] | None:
    value = evaluate(setup, node) if node is not None else None
    if not isinstance(value, tuple):
        return None
    texts = [each for each in value if isinstance(each, str)]
    return tuple(texts) if len(texts) == len(value) else None


def _data_files(setup: Setup) -> tuple[list[DataFiles], list[Span]]:
    node = keyword(setup, "data_files")
    changed = changed_data_files(setup)
    unknown = [] if changed is None else [_span(changed)]
    if node is None:
        return [], unknown
    found: list[DataFiles] = []
    for place, value in placed(setup, node):
        if isinstance(value, tuple) and len(value) == 2:
            found.append(_entry_of(value, _span(place)))
        else:
            unknown.append(_span(place))
    return found, unknown


def _entry_of(value: tuple[Value, ...], span: Span) -> DataFiles:
    destination, given = value
    values = given if isinstance(given, tuple) else (given,)
    return DataFiles(
        destination.rstrip("/") if isinstance(destination, str) else None,
        tuple(each for each in values if isinstance(each, str)),
        tuple(each.pattern for each in values if isinstance(each, Glob)),
        not any(isinstance(each, Unknown | tuple) for each in values),
        span,
    )
