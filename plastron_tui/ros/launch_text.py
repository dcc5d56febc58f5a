"""Texts of launch files: literals, and the substitutions in them.

Sources: the ROS wiki page "roslaunch/XML", section "substitution args"; for ROS 2 the design
article "ROS 2 Launch Static Descriptions", `launch/frontend/grammar.lark`, and of the package
launch what `expose_substitution` names. What a file holds and what a command says are attributes
in ROS 1 (the wiki page "roslaunch/XML/param").
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from typing import NamedTuple

from plastron_tui.diagnostics import Span


class Kind(Enum):
    """What a substitution asks for; its value is what ROS 2 calls it in XML."""

    ARGUMENT = "var"
    PACKAGE = "find-pkg-share"
    ENVIRONMENT = "env"
    FOLDER = "dirname"
    CONTENT = "file-content"
    COMMAND = "command"
    OTHER = ""


class Substitution(NamedTuple):
    """What stands in `$(…)`, or does so in Python.

    Attributes:
        kind: what it asks for.
        argument: of what: the name of an argument or of a package, the path of a file that is
            read, the command of which the output counts; for `OTHER` what it says.
        default: what it is where there is none.
    """

    kind: Kind
    argument: Text
    default: Text | None = None


@dataclass(frozen=True, slots=True)
class Text:
    """A text of a launch file; no two literals stand next to each other in it.

    Attributes:
        parts: its literals and substitutions.
        span: where it stands as it is; None where it is written otherwise, or put together. It
            tells no two apart.
    """

    parts: tuple[str | Substitution, ...] = ()
    span: Span | None = field(default=None, compare=False, repr=False)

    @property
    def literal(self) -> str | None:
        """The text, None where it has substitutions."""
        if not self.parts:
            return ""
        return self.parts[0] if len(self.parts) == 1 and isinstance(self.parts[0], str) else None

    def __str__(self) -> str:
        return "".join(part if isinstance(part, str) else _shown(part) for part in self.parts)


def _shown(part: Substitution) -> str:
    if part.kind is Kind.OTHER:
        return f"$({part.argument})"
    words = [part.kind.value, str(part.argument)]
    if part.default is not None:
        words.append(str(part.default))
    return f"$({' '.join(word for word in words if word)})"


def text(*parts: str | Substitution | Text) -> Text:
    """Return a text of these parts."""
    found: list[str | Substitution] = []
    for outer in parts:
        for part in outer.parts if isinstance(outer, Text) else (outer,):
            last = found[-1] if found else None
            if isinstance(part, str) and isinstance(last, str):
                found[-1] = last + part
            elif part != "":
                found.append(part)
    return Text(tuple(found))


def argument(name: str) -> Text:
    """Return the value of an argument, as a text."""
    return Text((Substitution(Kind.ARGUMENT, text(name)),))


def with_arguments(source: str) -> Text:
    """Read `$(var NAME)`, and `$(arg NAME)` as ROS 1 has it; all else is literal."""
    found: list[str | Substitution] = []
    at = 0
    while (start := source.find("$(", at)) >= 0:
        end = source.find(")", start)
        word, _, name = source[start + 2 : max(end, 0)].partition(" ")
        if end < 0 or word not in ("var", "arg"):
            end = start + 1
            found.append(source[at : end + 1])
        else:
            found += (source[at:start], Substitution(Kind.ARGUMENT, text(name.strip())))
        at = end + 1
    return text(*found, source[at:])


def package_file(package: str, path: str) -> Text:
    """Return the path of a file that a package has."""
    return text(Substitution(Kind.PACKAGE, text(package)), f"/{path}")


def _nowhere(_: str) -> str | None:
    return None


@dataclass(frozen=True, slots=True)
class Scope:
    """What the substitutions of a launch file get their values from.

    Attributes:
        arguments: the arguments and variables that are set.
        environ: the environment variables.
        folder: the folder of the launch file, None where it has none.
        find_package: returns the folder of a package that others find its files in.
        read_file: returns what a file holds.
        run_command: returns what a command says besides `cat`, of which that is known without.
        unknown_arguments: those that are set to what is not known: no default stands for that.
    """

    arguments: Mapping[str, str] = field(default_factory=dict)
    environ: Mapping[str, str] = field(default_factory=dict)
    folder: str | None = None
    find_package: Callable[[str], str | None] = _nowhere
    read_file: Callable[[str], str | None] = _nowhere
    run_command: Callable[[str], str | None] = _nowhere
    unknown_arguments: frozenset[str] = frozenset()

    def has(self, name: str) -> bool:
        """Tell whether an argument is set, to a known value or not."""
        return name in self.arguments or name in self.unknown_arguments

    def with_argument(self, name: str, value: str | None) -> Scope:
        """Return this with an argument that is set, to None where its value is not known."""
        known = {key: each for key, each in self.arguments.items() if key != name}
        unknown = self.unknown_arguments - {name}
        if value is None:
            return replace(self, arguments=known, unknown_arguments=unknown | {name})
        return replace(self, arguments={**known, name: value}, unknown_arguments=unknown)

    def value(self, of: Text) -> str | None:
        """Return what a text comes to, None where that is not known."""
        found = [self._part(part) for part in of.parts]
        known = [part for part in found if part is not None]
        return "".join(known) if len(known) == len(found) else None

    def unknown(self, of: Text) -> Substitution | None:
        """Return the first substitution that has no known value."""
        return next(
            (
                part
                for part in of.parts
                if isinstance(part, Substitution) and self._part(part) is None
            ),
            None,
        )

    def _shown(self, command: str) -> str | None:
        """Return what a command says."""
        word, _, path = command.partition(" ")
        return self.read_file(path.strip()) if word == "cat" else self.run_command(command)

    def _part(self, part: str | Substitution) -> str | None:
        if isinstance(part, str):
            return part
        name = self.value(part.argument)
        if name is None:
            return None
        if part.kind is Kind.ARGUMENT:
            if name in self.unknown_arguments:
                return None
            found = self.arguments.get(name)
        elif part.kind is Kind.PACKAGE:
            found = self.find_package(name)
        elif part.kind is Kind.ENVIRONMENT:
            found = self.environ.get(name)
        elif part.kind is Kind.CONTENT:
            found = self.read_file(name)
        elif part.kind is Kind.COMMAND:
            found = self._shown(name)
        elif part.kind is Kind.FOLDER:
            return self.folder
        else:
            return None
        return self.value(part.default) if found is None and part.default is not None else found
