"""Types that a statement names before the program makes them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from plastron_tui.diagnostics import Label, codes
from plastron_tui.language import statements as st
from plastron_tui.language.declaration import Statement
from plastron_tui.ros.interfaces import InterfaceKind

from .mistake import Mistake
from .types import TypeProblem

_MADE: dict[type[Statement], InterfaceKind] = {
    st.CreateMessageType: InterfaceKind.MESSAGE,
    st.CreateServiceType: InterfaceKind.SERVICE,
    st.CreateActionType: InterfaceKind.ACTION,
}


class LaterTypes:
    """What the statements of a program make, for those that stand before them."""

    def __init__(self, statements: Sequence[Statement] = ()) -> None:
        """Take the statements that make types, in their order."""
        self._made: dict[tuple[str, InterfaceKind], Statement] = {}
        self._told: dict[str, Statement] = {}
        has_any = not _MADE.keys().isdisjoint(map(type, statements))
        for each in statements if has_any else ():
            kind = _MADE.get(type(each))
            if kind is not None:
                self._made.setdefault((_bare(_type_of(each)), kind), each)

    def explain(
        self, statement: Statement, text: str, kind: InterfaceKind, problem: TypeProblem
    ) -> TypeProblem:
        """Return what to say of a type that is not known where a statement names it.

        Args:
            statement: the statement.
            text: the type that it names.
            kind: the kind of type that it needs.
            problem: what is said of a type that nothing makes.

        Raises:
            Mistake: the type is of a circle that was told where another one of it is made.
        """
        name = _bare(text)
        later = self._made.get((name, kind))
        if (
            problem.code != codes.UNKNOWN_TYPE
            or later is None
            or later.span.start <= statement.span.start
            or ("/" in text and _type_of(later) != text)
        ):
            return problem
        own = _bare(_type_of(statement))
        is_message = isinstance(statement, (st.CreateMessageType, st.HasField))
        circle = self._circle(name, own) if is_message else None
        if circle is not None:
            if self._told.setdefault(own, statement) is not statement:
                raise Mistake
            self._told |= dict.fromkeys(circle, statement)
            shown = " in ".join(f"`{each}`" for each in (own, *circle))
            return TypeProblem(codes.CIRCULAR_TYPE, f"`{own}` contains itself: {shown}", None)
        message = f"`{name}` is made further down, and used here already"
        remedy = "a type is made before it is used: move the line that makes it further up"
        label = Label(later.span, "made here")
        return TypeProblem(codes.UNKNOWN_TYPE, message, remedy, labels=(label,))

    def _circle(self, start: str, own: str) -> list[str] | None:
        """Return how a message contains another one, None where it does not."""
        ways: dict[str, str] = {start: ""}
        new = [start]
        while new:
            name = new.pop(0)
            for part in self._parts(name):
                if part == own:
                    circle = []
                    while name:
                        circle.append(name)
                        name = ways[name]
                    return [*circle, own]
                if part not in ways:
                    ways[part] = name
                    new.append(part)
        return None

    def _parts(self, name: str) -> Iterator[str]:
        made = self._made.get((name, InterfaceKind.MESSAGE))
        if isinstance(made, st.CreateMessageType):
            for each in made.fields:
                yield _bare(each.type.partition("[")[0].partition("<=")[0])


def _bare(text: str) -> str:
    return text.rpartition("/")[2]


def _type_of(statement: Statement) -> str:
    return getattr(statement, "type", "")
