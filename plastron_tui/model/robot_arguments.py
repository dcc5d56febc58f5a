"""The arguments of robots' files: what a `load_robot` gives them, and what is wrong with that."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from plastron_tui.diagnostics import Diagnostic, Severity, Span, codes, guess
from plastron_tui.language import statements as st
from plastron_tui.ros.robots.macros import Arguments
from plastron_tui.ros.robots.names import NAME_RULE, is_name

from .launch_lookups import plain_value
from .mistake import Mistake
from .robots import LoadedRobot

_VALUE_HELP = "an argument is a number, a boolean, or a text on one line"


def arguments_of(statement: st.LoadRobot) -> Arguments:
    """Return what a statement gives the macros of a robot's file.

    Raises:
        Mistake: a name or a value is none, or a name is there twice.
    """
    found: dict[str, str] = {}
    for each in statement.settings or ():
        name, where = each.parameter, _span(statement, each.syntax, "parameter")
        if not is_name(name):
            raise _mistake(f"`{name}` is no name of an argument", where, NAME_RULE)
        if name in found:
            raise _mistake(f"the argument `{name}` has a value already", where, "say it once")
        value = argument_text(plain_value(each.value))
        if value is None:
            where = _span(statement, each.syntax, "value")
            raise _mistake("this is no value of an argument", where, _VALUE_HELP)
        found[name] = value
    return tuple(found.items())


def argument_text(value: object) -> str | None:
    """Return a value as macros get it, None for what they cannot get."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return str(value)
    # What has a line feed in it is no word of a command line.
    return value if isinstance(value, str) and (not value or value.isprintable()) else None


def unused_arguments(
    source: str, given: Arguments, loaded: LoadedRobot, statement: st.LoadRobot | None = None
) -> Iterator[Diagnostic]:
    """Yield a warning for each argument that a robot's file does not ask for.

    Args:
        source: the file, as it is named.
        given: what it was given.
        loaded: what became of it.
        statement: the statement that gives it, None for none.
    """
    if loaded.source is None:
        return
    places = {} if statement is None else dict(_places(statement))
    has_macros = loaded.source.macros is not None
    for name, _ in given:
        if has_macros and name not in loaded.unused:
            continue
        message = f"`{source}` asks for no argument `{name}`"
        help_, fix = "only the macros of a xacro file have arguments", None
        if has_macros:
            span = places.get(name, Span(0, 0))
            near, fix = guess(name, loaded.asked, span, is_quoted=True)
            if near is None and loaded.source.expanded is None:
                # What is not expanded to its end may ask for it further down.
                continue
            known = ", ".join(f"`{each}`" for each in loaded.asked)
            help_ = near or (f"it asks for {known}" if known else "it asks for none")
        yield Diagnostic(
            codes.BAD_ROBOT_ARGUMENT,
            message,
            places.get(name),
            help=help_,
            fix=fix if name in places else None,
            severity=Severity.WARNING,
        )


def _places(statement: st.LoadRobot) -> Iterator[tuple[str, Span]]:
    for each in statement.settings or ():
        yield each.parameter, _span(statement, each.syntax, "parameter")


def _span(statement: st.LoadRobot, syntax: Any, field: str) -> Span:
    child = syntax.child_by_field_name(field) or syntax
    return Span(child.start_byte, child.end_byte).moved(statement.shift)


def _mistake(message: str, where: Span, help_text: str) -> Mistake:
    return Mistake(Diagnostic(codes.BAD_ROBOT_ARGUMENT, message, where, help=help_text))
