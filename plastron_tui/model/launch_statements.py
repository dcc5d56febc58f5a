"""The statements about launch files."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from plastron_tui.diagnostics import Code, Diagnostic, Label, Span, codes, guess
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.language.inputs import InputValue, ListValue, Literal
from plastron_tui.ros.launch import Argument, Include, Item, StartedNode, items_of
from plastron_tui.ros.launch_values import as_value
from plastron_tui.ros.names import check_node_name, check_parameter_name, check_topic_name, spelled
from plastron_tui.ros.packages import LONGEST_FILE_NAME
from plastron_tui.ros.parameters import Setting

from .launches import Included, Launch, LaunchArgument, LaunchGeneration, Start
from .mistake import Mistake
from .run import Run

_LONGEST_NAME = LONGEST_FILE_NAME - len(".launch.xml")


def create_launch(run: Run, statement: st.CreateLaunch) -> None:
    """Make a launch file."""
    run.checks.new_variable(statement, statement.variable)
    check_launch_named(run, statement)
    name = statement.name
    run.workspace.launches[statement.variable] = Launch(name, statement.variable, statement.span)


def check_launch_named(run: Run, statement: st.CreateLaunch) -> None:
    """Check that a launch file may have its name, and that no other has it."""
    name = statement.name
    if not name.isascii() or not name.replace("-", "_").replace(".", "_").isidentifier():
        message = f"`{name}` cannot be the name of a launch file"
        help_text = "its name has letters, digits, `_`, `-` and dots, without its ending"
        raise _bad_name(message, statement.span_of("name"), help_text)
    if len(name) > _LONGEST_NAME:
        message = (
            f"the name of a launch file has at most {_LONGEST_NAME} characters, and this one "
            f"{len(name)}"
        )
        raise _bad_name(message, statement.span_of("name"), "choose a shorter one")
    for other in run.workspace.launches.values():
        if other.name == name:
            raise _twice(
                codes.LAUNCH_EXISTS,
                f"a launch file `{name}` exists already",
                statement.span_of("name"),
                other.span,
            )


def load_launch(run: Run, statement: st.LoadLaunch) -> None:
    """Read a launch file, to change it."""
    run.checks.new_variable(statement, statement.variable)
    where = statement.span_of("source")
    loaded = run.setting.read_launch(statement.source)
    found = [each if each.file else each._replace(span=where) for each in loaded.diagnostics]
    source = loaded.source
    if source is None:
        raise Mistake(*found)
    for other in run.workspace.launches.values():
        if other.source is not None and other.source.path == source.path:
            message = f"`{statement.source}` is loaded already"
            raise _twice(codes.LAUNCH_EXISTS, message, where, other.span)
    for each in found:
        run.report(statement, each)
    name, variable = source.path.name, statement.variable
    for ending in (".xml", ".launch"):
        name = name.removesuffix(ending)
    run.workspace.launches[variable] = Launch(name, variable, statement.span, source)


def has_argument(run: Run, statement: st.HasArgument) -> None:
    """Give a launch file an argument."""
    launch = _launch(run, statement)
    name, where = statement.argument, statement.span_of("argument")
    if not name.isascii() or not name.isidentifier():
        message = f"`{name}` cannot be the name of an argument"
        raise _bad_name(message, where, "it has letters, digits and `_`")
    if name in launch.arguments or _is_there(launch, name, Argument, launch.removed_arguments):
        message = f"`{launch.variable}` has an argument `{name}` already"
        earlier = launch.arguments.get(name)
        raise _twice(codes.ALREADY_STARTED, message, where, earlier and earlier.span)
    default = None
    if statement.default is not None:
        default = _setting(statement, "default", statement.default)
    launch.arguments[name] = LaunchArgument(name, default, statement.span)


def no_longer_has_argument(run: Run, statement: st.NoLongerHasArgument) -> None:
    """Take an argument away from a launch file."""
    launch = _launch(run, statement)
    _take(run, statement, "argument", launch, launch.arguments, launch.removed_arguments, Argument)


def starts(run: Run, statement: st.Starts) -> None:
    """Let a launch file start a node."""
    launch = _launch(run, statement)
    start = _start(run, statement)
    name = start.run_name
    earlier = launch.starts.get(name)
    if earlier is not None or _is_there(launch, name, StartedNode, launch.removed_starts):
        is_apart = earlier is not None and (earlier.namespace or "") != (start.namespace or "")
        if not is_apart:
            raise _twice(
                codes.ALREADY_STARTED,
                f"`{launch.variable}` starts a node `{name}` already",
                statement.span_of("started" if statement.name is None else "name"),
                earlier and earlier.span,
                f"name it otherwise: `starts … as 'other_{name}'`",
            )
        name = f"{(start.namespace or '').strip('/')}/{name}".lstrip("/")
    launch.starts[name] = start


def no_longer_starts(run: Run, statement: st.NoLongerStarts) -> None:
    """Let a launch file no longer start a node."""
    launch = _launch(run, statement)
    _take(run, statement, "name", launch, launch.starts, launch.removed_starts, StartedNode)


def includes(run: Run, statement: st.Includes) -> None:
    """Let a launch file start another one."""
    launch = _launch(run, statement)
    where = statement.span_of("file")
    package, slash, file = statement.file.partition("/")
    if not slash or not file or not package.isidentifier() or ".." in file.split("/"):
        help_text = "write the package and the file in it: `includes 'rover/sensors.launch.xml'`"
        raise _bad_name(f"`{statement.file}` names no launch file of a package", where, help_text)
    if statement.file in launch.includes or _is_there(
        launch, statement.file, Include, launch.removed_includes
    ):
        earlier = launch.includes.get(statement.file)
        message = f"`{launch.variable}` includes `{statement.file}` already"
        raise _twice(codes.ALREADY_STARTED, message, where, earlier and earlier.span)
    launch.includes[statement.file] = Included(package, file, statement.span)


def no_longer_includes(run: Run, statement: st.NoLongerIncludes) -> None:
    """Let a launch file no longer start another one."""
    launch = _launch(run, statement)
    _take(run, statement, "file", launch, launch.includes, launch.removed_includes, Include)


def generate_launch(run: Run, statement: st.GenerateLaunch) -> None:
    """Note that a launch file is to be written as it is now."""
    launch = _launch(run, statement)
    run.workspace.written_launches.append(LaunchGeneration(launch.snapshot(), statement.span))


def _start(run: Run, statement: st.Starts) -> Start:
    started, where = statement.started, statement.span_of("started")
    node, package, executable, version = None, "", "", run.setting.ros_version(None)
    if started.startswith("'"):
        package, slash, executable = started[1:-1].partition("/")
        is_name = package.isascii() and package.isidentifier()
        if not slash or not executable or "/" in executable or not is_name:
            help_text = "write the package and the executable: `starts 'demo/talker'`"
            raise _bad_name(f"`{started[1:-1]}` names no executable of a package", where, help_text)
    else:
        node = run.workspace.nodes.get(started)
        if node is None:
            raise _unknown_node(run, started, where)
        version = run.checks.version_of(node)
    if statement.name is not None:
        run.checks.name(statement, "name", statement.name, version, check_node_name)
    for slot in ("namespace", "container"):
        written = getattr(statement, slot)
        if written is not None:
            run.checks.name(statement, slot, written, version, check_topic_name)
    return Start(
        node,
        package,
        executable,
        statement.name,
        statement.namespace,
        statement.container,
        tuple(_remaps(statement, version)),
        tuple(_settings(statement, version)),
        statement.parameters,
        statement.span,
        where,
    )


def _remaps(statement: st.Starts, version: int) -> Iterable[tuple[str, str]]:
    for each in statement.remaps or ():
        for name, field in ((each.old, "old"), (each.new, "new")):
            problem = check_topic_name(spelled(name), version)
            if problem is not None:
                where = _child_span(each.syntax, field)
                raise Mistake(Diagnostic(codes.INVALID_NAME, problem.message, where))
        yield spelled(each.old), spelled(each.new)


def _settings(statement: st.Starts, version: int) -> Iterable[tuple[str, Setting]]:
    for each in statement.settings or ():
        problem = check_parameter_name(each.parameter, version)
        if problem is not None:
            where = _child_span(each.syntax, "parameter")
            raise Mistake(Diagnostic(codes.INVALID_NAME, problem.message, where))
        value = _plain(each.value)
        if value is None:
            where = _child_span(each.syntax, "value")
            raise _bad_name("this is no value of a parameter", where, _VALUE_HELP)
        yield each.parameter, value


_VALUE_HELP = "a parameter is a number, a text, a boolean, or a list of one of them"


def _child_span(syntax: Any, field: str) -> Span:
    child = syntax.child_by_field_name(field) or syntax
    return Span(child.start_byte, child.end_byte)


def _setting(statement: Any, slot: str, value: InputValue) -> Setting:
    found = _plain(value)
    if found is None:
        raise _bad_name("this is no value of an argument", statement.span_of(slot), _VALUE_HELP)
    return found


def _plain(value: InputValue) -> Setting | None:
    if isinstance(value, Literal):
        return value.value
    if isinstance(value, ListValue):
        return as_value([each.value for each in value.items if isinstance(each, Literal)])
    return None


def _names(launch: Launch, kind: type[Item]) -> list[str]:
    """Return what a loaded launch file has of a kind, by the names that programs have for it."""
    if launch.source is None:
        return []
    return [name for item in items_of(launch.source.launch.items, kind) if (name := item.called)]


def _is_there(launch: Launch, name: str, kind: type[Item], removed: Mapping[str, Span]) -> bool:
    return name not in removed and name in _names(launch, kind)


def _take(
    run: Run,
    statement: Any,
    slot: str,
    launch: Launch,
    own: dict[str, Any],
    removed: dict[str, Span],
    kind: type[Item],
) -> None:
    name: str = getattr(statement, slot)
    if own.pop(name, None) is not None:
        return
    there = [each for each in _names(launch, kind) if each not in removed]
    if name in there:
        removed[name] = statement.span
        return
    if run.consequences.mentions(name):
        raise Mistake
    where = statement.span_of(slot)
    remedy, fix = guess(name, [*own, *there], where, is_quoted=True)
    message = f"`{launch.variable}` has no `{name}` to take away"
    raise Mistake(Diagnostic(codes.NOT_STARTED, message, where, help=remedy, fix=fix))


def _launch(run: Run, statement: Any) -> Launch:
    """Return the launch file that a statement is about."""
    variable: str = statement.launch
    launch = run.workspace.launches.get(variable)
    if launch is not None:
        return launch
    if run.consequences.declares(variable):
        raise Mistake
    where = statement.span_of("launch")
    other = run.workspace.what(variable)
    remedy, fix = guess(variable, run.workspace.launches, where)
    if other is not None:
        remedy, fix = f"`{variable}` is a {other[0]}", None
    remedy = remedy or f"make it first: `create_launch '{variable}' as {variable}`"
    message = f"no launch file `{variable}`"
    raise Mistake(Diagnostic(codes.UNKNOWN_LAUNCH, message, where, help=remedy, fix=fix))


def _unknown_node(run: Run, variable: str, where: Span) -> Mistake:
    if run.consequences.declares(variable):
        return Mistake()
    other = run.workspace.what(variable)
    remedy, fix = guess(variable, run.workspace.nodes, where)
    if other is not None:
        remedy, fix = f"`{variable}` is a {other[0]}", None
    remedy = remedy or f"make it first: `create_node '{variable}' as {variable}`"
    message = f"no node `{variable}`"
    return Mistake(Diagnostic(codes.UNKNOWN_NODE, message, where, help=remedy, fix=fix))


def _bad_name(message: str, where: Span, help_text: str) -> Mistake:
    return Mistake(Diagnostic(codes.BAD_LAUNCH_NAME, message, where, help=help_text))


def _twice(
    code: Code, message: str, where: Span, first: Span | None, help_text: str | None = None
) -> Mistake:
    labels = () if first is None else (Label(first, "first here"),)
    return Mistake(Diagnostic(code, message, where, help=help_text, labels=labels))


HANDLERS: dict[type[Statement], Callable[[Run, Any], None]] = {
    st.CreateLaunch: create_launch,
    st.LoadLaunch: load_launch,
    st.HasArgument: has_argument,
    st.NoLongerHasArgument: no_longer_has_argument,
    st.Starts: starts,
    st.NoLongerStarts: no_longer_starts,
    st.Includes: includes,
    st.NoLongerIncludes: no_longer_includes,
    st.GenerateLaunch: generate_launch,
}
"""What each statement about launch files does."""
