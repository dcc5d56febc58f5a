"""`starts`: the nodes of a launch file, with their names, topics and parameters."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes, guess, write
from plastron_tui.language import statements as st
from plastron_tui.ros.launch import Argument, StartedNode, Variable, items_of
from plastron_tui.ros.launch_text import Substitution, with_arguments
from plastron_tui.ros.names import (
    check_node_name,
    check_parameter_name,
    check_topic_name,
    spelled,
)
from plastron_tui.ros.parameters import Setting

from .launch_lookups import VALUE_HELP, bad_name, find_launch, find_node, names_there, plain_value
from .launch_lookups import twice as told_twice
from .launches import Launch, ParameterFile, Start
from .mistake import Mistake
from .run import Run
from .workspace import Node

_PYTHON = "Python"


def starts(run: Run, statement: st.Starts) -> None:
    """Let a launch file start a node."""
    launch = find_launch(run, statement)
    start = _start(run, launch, statement)
    name = start.full_name
    there = names_there(launch, StartedNode, launch.removed_starts)
    if name in launch.starts or name in there:
        earlier = launch.starts.get(name)
        raise told_twice(
            codes.ALREADY_STARTED,
            f"`{launch.variable}` starts a node `{name}` already",
            statement.span_of("started" if statement.name is None else "name"),
            earlier and earlier.span,
            f"name it otherwise: `starts … as 'other_{start.run_name}'`",
        )
    launch.starts[name] = start


def argument_use(launch: Launch, name: str) -> Span | None:
    """Return the statement by which a program uses an argument, None where none does."""
    for start in launch.starts.values():
        if name in (each for text in _texts(start) for each in _asked(text)):
            return start.span
    return None


def _texts(start: Start) -> Iterator[str]:
    yield from (each for each in (start.name, start.namespace) if each is not None)
    yield from (new for _, new in start.remaps)
    yield from (value for _, value in start.settings if isinstance(value, str))


def _asked(written: str) -> Iterator[str]:
    """Yield the names of the arguments that a text asks for."""
    for part in with_arguments(written).parts:
        if isinstance(part, Substitution):
            yield str(part.argument)


def _start(run: Run, launch: Launch, statement: st.Starts) -> Start:
    started, where = statement.started, statement.span_of("started")
    node, package, executable, version = None, "", "", run.setting.ros_version(None)
    if started.startswith("'"):
        package, slash, executable = started[1:-1].partition("/")
        is_name = package.isascii() and package.isidentifier()
        if not slash or not executable or "/" in executable or not is_name:
            help_text = "write the package and the executable: `starts 'demo/talker'`"
            raise bad_name(f"`{started[1:-1]}` names no executable of a package", where, help_text)
    else:
        node = find_node(run, statement, started, where)
        version = run.checks.version_of(node)
    _check_names(run, launch, statement, version)
    container = None
    if statement.container is not None:
        run.checks.name(statement, "container", statement.container, version, check_topic_name)
        container = statement.span_of("container")
        _check_component(run, statement, node, executable)
    return Start(
        node,
        package,
        executable,
        statement.name,
        statement.namespace,
        statement.container,
        tuple(_remaps(run, launch, statement, version)),
        tuple(_settings(run, launch, statement, version)),
        _parameters(run, statement, version),
        statement.span,
        where,
        container,
        tuple(_child_span(statement, each.syntax, "old") for each in statement.remaps or ()),
        tuple(
            _child_span(statement, each.syntax, "parameter") for each in statement.settings or ()
        ),
        node is not None and _is_loaded(run, node),
    )


def _is_loaded(run: Run, node: Node) -> bool:
    library = run.setting.libraries.get(node.library or run.setting.library)
    return library is not None and library.is_loaded


def _check_names(run: Run, launch: Launch, statement: st.Starts, version: int) -> None:
    checks = {"name": check_node_name, "namespace": check_topic_name}
    for slot, check in checks.items():
        written = getattr(statement, slot)
        if written is not None:
            where = statement.span_of(slot)
            _check_arguments(run, launch, written, Span(where.start + 1, where.end - 1))
            run.checks.name(statement, slot, _with_values(written), version, check)


def _check_component(run: Run, statement: st.Starts, node: Node | None, executable: str) -> None:
    """Check that what is to run in a container is a component, as far as one can tell."""
    where = statement.span_of("container")
    leave_out = f"leave out `inside '{statement.container}'`: it runs in a process of its own"
    if node is not None:
        library = run.setting.libraries.get(node.library or run.setting.library)
        language = _PYTHON if library is None else library.language
        if not _is_loaded(run, node):
            message = f"`{node.variable}` is a node in {language}, and a container has components"
            if library is not None and library.is_built:
                kinds = [each for each in run.setting.libraries.values() if each.is_loaded]
                fit = [each.name for each in kinds if each.ros_version == library.ros_version]
                what = " or ".join(f"`{each}`" for each in fit)
                message = f"`{node.variable}` is a node of `{library.name}`, not of {what}"
            fix = write("", _clause(statement, "container"))
            raise Mistake(
                Diagnostic(codes.NOT_A_COMPONENT, message, where, help=leave_out, fix=fix)
            )
        return
    parts = executable.split("::")
    place = statement.span_of("started")
    name = Span(place.start + 2 + _length_of_package(statement.started), place.end - 1)
    if not all(part.isascii() and part.isidentifier() for part in parts):
        message = f"`{executable}` is no class of C++, and a container loads components by theirs"
        help_text = "write the class: `starts 'demo_nodes_cpp/demo_nodes_cpp::Talker' inside …`"
        raise Mistake(Diagnostic(codes.NOT_A_COMPONENT, message, name, help=help_text))
    if len(parts) == 1 and executable[:1].islower():
        message = f"a container loads the class of a component, and `{executable}` hardly is one"
        help_text = "`ros2 component types` lists those that are installed"
        found = Diagnostic(
            codes.NOT_A_COMPONENT, message, name, help=help_text, severity=Severity.WARNING
        )
        run.report(statement, found)


def _clause(statement: st.Starts, slot: str) -> Span:
    """Return the place of a slot with the word and the blanks before it."""
    child = statement.syntax.child_by_field_name(slot)
    word = None if child is None else child.prev_sibling
    before = None if word is None else word.prev_sibling
    where = statement.span_of(slot)
    if before is None:
        return where
    return Span(before.end_byte, where.end - statement.shift).moved(statement.shift)


def _length_of_package(started: str) -> int:
    """Return how many bytes of `'PACKAGE/EXECUTABLE'` are the package."""
    return len(started[1:-1].partition("/")[0].encode())


def _remaps(
    run: Run, launch: Launch, statement: st.Starts, version: int
) -> Iterable[tuple[str, str]]:
    for each in statement.remaps or ():
        where = _child_span(statement, each.syntax, "new")
        _check_arguments(run, launch, each.new, Span(where.start + 1, where.end - 1))
        for name, field in ((each.old, "old"), (_with_values(each.new), "new")):
            problem = check_topic_name(spelled(name), version)
            if problem is not None:
                where = _child_span(statement, each.syntax, field)
                raise Mistake(Diagnostic(codes.INVALID_NAME, problem.message, where))
        yield spelled(each.old), spelled(each.new)


def _settings(
    run: Run, launch: Launch, statement: st.Starts, version: int
) -> Iterable[tuple[str, Setting]]:
    for each in statement.settings or ():
        problem = check_parameter_name(each.parameter, version)
        if problem is not None:
            where = _child_span(statement, each.syntax, "parameter")
            raise Mistake(Diagnostic(codes.INVALID_NAME, problem.message, where))
        where = _child_span(statement, each.syntax, "value")
        value = plain_value(each.value)
        if value is None:
            raise bad_name("this is no value of a parameter", where, VALUE_HELP)
        if isinstance(value, str):
            _check_arguments(run, launch, value, Span(where.start + 1, where.end - 1))
        yield each.parameter, value


def _parameters(run: Run, statement: st.Starts, version: int) -> ParameterFile | None:
    if statement.parameters is None:
        return None
    where = statement.span_of("parameters")
    loaded = run.setting.read_parameters(statement.parameters, version)
    if loaded.path is None:
        raise Mistake(*(each._replace(span=where) for each in loaded.diagnostics))
    return ParameterFile(loaded.path, loaded.text, where)


def _child_span(statement: st.Starts, syntax: Any, field: str) -> Span:
    child = syntax.child_by_field_name(field) or syntax
    return Span(child.start_byte, child.end_byte).moved(statement.shift)


def _with_values(written: str) -> str:
    """Return a name as it may come out: one letter for what an argument brings."""
    parts = with_arguments(written).parts
    return "".join(part if isinstance(part, str) else "x" for part in parts)


def _check_arguments(run: Run, launch: Launch, written: str, where: Span) -> None:
    """Check that the arguments that a text asks for are there.

    Args:
        run: the program.
        launch: the launch file.
        written: the text.
        where: what is between its quotes.
    """
    found = [*launch.arguments, *names_there(launch, Argument, launch.removed_arguments)]
    if launch.source is not None:
        found += [each.name for each in items_of(launch.source.launch.items, Variable)]
    for name in _asked(written):
        if name in found:
            continue
        if run.consequences.mentions(name):
            raise Mistake
        place = _place_of(name, written, where)
        remedy, fix = guess(name, found, place)
        remedy = remedy or f"make it first: `{launch.variable} has_argument '{name}'`"
        message = f"`{launch.variable}` has no argument `{name}`"
        raise Mistake(Diagnostic(codes.UNKNOWN_ARGUMENT, message, place, help=remedy, fix=fix))


def _place_of(name: str, written: str, where: Span) -> Span:
    """Return where the name of an argument stands; the whole text where escapes are in it."""
    if len(written.encode()) != where.end - where.start:
        return where
    for word in ("$(var ", "$(arg "):
        before, found, _ = written.partition(f"{word}{name})")
        if found:
            start = where.start + len((before + word).encode())
            return Span(start, start + len(name.encode()))
    return where
