"""The statements about launch files."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Span, codes, guess
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.launch import Argument, Include, Item, StartedNode
from plastron_tui.ros.packages import LONGEST_FILE_NAME

from .launch_lookups import VALUE_HELP, bad_name, find_launch, names_there, plain_value, twice
from .launch_starts import argument_use, starts
from .launches import Included, Launch, LaunchArgument, LaunchGeneration
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
        raise bad_name(message, statement.span_of("name"), help_text)
    if len(name) > _LONGEST_NAME:
        message = (
            f"the name of a launch file has at most {_LONGEST_NAME} characters, and this one "
            f"{len(name)}"
        )
        raise bad_name(message, statement.span_of("name"), "choose a shorter one")
    for other in run.workspace.launches.values():
        if other.name == name:
            raise twice(
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
            raise twice(codes.LAUNCH_EXISTS, message, where, other.span)
    for each in found:
        run.report(statement, each)
    name, variable = source.path.name, statement.variable
    for ending in (".xml", ".launch"):
        name = name.removesuffix(ending)
    run.workspace.launches[variable] = Launch(name, variable, statement.span, source)


def has_argument(run: Run, statement: st.HasArgument) -> None:
    """Give a launch file an argument."""
    launch = find_launch(run, statement)
    name, where = statement.argument, statement.span_of("argument")
    if not name.isascii() or not name.isidentifier():
        message = f"`{name}` cannot be the name of an argument"
        raise bad_name(message, where, "it has letters, digits and `_`")
    there = names_there(launch, Argument, launch.removed_arguments)
    if name in launch.arguments or name in there:
        message = f"`{launch.variable}` has an argument `{name}` already"
        earlier = launch.arguments.get(name)
        raise twice(codes.ALREADY_STARTED, message, where, earlier and earlier.span)
    default = None
    if statement.default is not None:
        default = plain_value(statement.default)
        if default is None:
            message = "this is no value of an argument"
            raise bad_name(message, statement.span_of("default"), VALUE_HELP)
    launch.arguments[name] = LaunchArgument(name, default, statement.span)


def no_longer_has_argument(run: Run, statement: st.NoLongerHasArgument) -> None:
    """Take an argument away from a launch file."""
    launch = find_launch(run, statement)
    use = argument_use(launch, statement.argument)
    if use is not None:
        message = f"`{statement.argument}` is still used, and cannot be taken away"
        raise twice(codes.UNKNOWN_ARGUMENT, message, statement.span_of("argument"), use)
    _take(run, statement, "argument", launch, launch.arguments, launch.removed_arguments, Argument)


def no_longer_starts(run: Run, statement: st.NoLongerStarts) -> None:
    """Let a launch file no longer start a node."""
    launch = find_launch(run, statement)
    _take(run, statement, "name", launch, launch.starts, launch.removed_starts, StartedNode)


def includes(run: Run, statement: st.Includes) -> None:
    """Let a launch file start another one."""
    launch = find_launch(run, statement)
    where = statement.span_of("file")
    package, slash, file = statement.file.partition("/")
    if not slash or not file or not package.isidentifier() or ".." in file.split("/"):
        help_text = "write the package and the file in it: `includes 'rover/sensors.launch.xml'`"
        raise bad_name(f"`{statement.file}` names no launch file of a package", where, help_text)
    there = names_there(launch, Include, launch.removed_includes)
    if statement.file in launch.includes or statement.file in there:
        earlier = launch.includes.get(statement.file)
        message = f"`{launch.variable}` includes `{statement.file}` already"
        raise twice(codes.ALREADY_STARTED, message, where, earlier and earlier.span)
    launch.includes[statement.file] = Included(package, file, statement.span, where)


def no_longer_includes(run: Run, statement: st.NoLongerIncludes) -> None:
    """Let a launch file no longer start another one."""
    launch = find_launch(run, statement)
    _take(run, statement, "file", launch, launch.includes, launch.removed_includes, Include)


def generate_launch(run: Run, statement: st.GenerateLaunch) -> None:
    """Note that a launch file is to be written as it is now."""
    launch = find_launch(run, statement)
    run.workspace.written_launches.append(LaunchGeneration(launch.snapshot(), statement.span))


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
    there = names_there(launch, kind, removed)
    called = [name] if name in own or name in there else []
    if kind is StartedNode and not called:
        # A node may go by its name alone where no other one has it.
        called = [each for each in (*own, *there) if each.rpartition("/")[2] == name]
    if len(called) == 1:
        if own.pop(called[0], None) is None:
            removed[called[0]] = statement.span
        return
    if run.consequences.mentions(name):
        raise Mistake
    where = statement.span_of(slot)
    if called:
        message = f"`{launch.variable}` starts {len(called)} nodes `{name}`"
        remedy = f"say which: {', '.join(f'`{each}`' for each in called)}"
        raise Mistake(Diagnostic(codes.NOT_STARTED, message, where, help=remedy))
    near, fix = guess(name, [*own, *there], where, is_quoted=True)
    message = f"`{launch.variable}` has no `{name}` to take away"
    raise Mistake(Diagnostic(codes.NOT_STARTED, message, where, help=near, fix=fix))


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
