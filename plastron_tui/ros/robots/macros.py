"""What a robot's file leaves to macros: what they are, and where they are called.

Source: the wiki page "xacro", and xacro itself.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

from plastron_tui.diagnostics.wording import counted

_DEEPEST = 50

Arguments: TypeAlias = tuple[tuple[str, str], ...]
"""What a file's arguments (`$(arg NAME)`) are given: their names, and the values as texts."""


class Parameter(NamedTuple):
    """A parameter of a macro.

    Attributes:
        name: what it is called, without the stars of a block.
        default: what it is where a call does not say it, None where a call has to.
        is_block: whether it is an element that a call has in it.
    """

    name: str
    default: str | None = None
    is_block: bool = False


class MacroCall(NamedTuple):
    """A call of a macro; the arguments are as they are written."""

    macro: str
    arguments: tuple[tuple[str, str], ...] = ()
    line: int = 0


class Macro(NamedTuple):
    """A macro.

    Attributes:
        name: what it is called.
        parameters: what it is called with.
        links: how many links are written in it.
        joints: how many joints likewise.
        calls: the calls of macros that are written in it.
        line: where it stands.
        is_conditional: whether some of this depends on a condition.
    """

    name: str
    parameters: tuple[Parameter, ...] = ()
    links: int = 0
    joints: int = 0
    calls: tuple[MacroCall, ...] = ()
    line: int = 0
    is_conditional: bool = False


class Definition(NamedTuple):
    """A property, or an argument of the file; the value is as it is written, None for elements."""

    name: str
    value: str | None = None
    line: int = 0


class Include(NamedTuple):
    """A file that another one includes.

    Attributes:
        file: its path as it is written.
        line: where that stands.
        is_optional: whether it need not be there.
        namespace: what its names are called by, "" for nothing.
        is_certain: whether it is included whatever is computed; otherwise a macro or a condition
            has it in it.
    """

    file: str
    line: int = 0
    is_optional: bool = False
    namespace: str = ""
    is_certain: bool = True


class Macros(NamedTuple):
    """What a file with macros says, unexpanded.

    Attributes:
        includes: the files that it includes.
        macros: its macros, by name; the last of a name counts.
        calls: the calls beside its links.
        properties: its properties.
        arguments: what it can be given from outside.
        conditions: how many parts of it are there on a condition.
    """

    includes: tuple[Include, ...] = ()
    macros: tuple[Macro, ...] = ()
    calls: tuple[MacroCall, ...] = ()
    properties: tuple[Definition, ...] = ()
    arguments: tuple[Definition, ...] = ()
    conditions: int = 0

    def made_by(self, macro: str) -> tuple[int, int] | None:
        """Return how many links and joints a call of a macro makes.

        None where that cannot be told: the macro, or one that it calls, is in another file, calls
        itself, or has conditions.
        """
        by_name = {each.name: each for each in self.macros}
        known: dict[str, tuple[int, int] | None] = {}

        def count(name: str, depth: int) -> tuple[int, int] | None:
            if name in known:
                return known[name]
            found = by_name.get(name)
            known[name] = None
            if found is None or found.is_conditional or depth > _DEEPEST:
                return None
            links, joints = found.links, found.joints
            for call in found.calls:
                made = count(call.macro, depth + 1)
                if made is None:
                    return None
                links, joints = links + made[0], joints + made[1]
            known[name] = links, joints
            return known[name]

        return count(macro, 0)

    @property
    def words(self) -> str:
        """What there is of all this, for a person: `2 includes, 3 macros, 5 calls`."""
        counts = (
            (len(self.includes), "include"),
            (len(self.macros), "macro"),
            (len(self.calls), "call"),
            (self.conditions, "condition"),
        )
        return ", ".join(counted(count, word) for count, word in counts if count)
