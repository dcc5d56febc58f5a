"""The messages of a program, and what each is to the nodes of ROS 1 and of ROS 2."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes, guess
from plastron_tui.language import statements as st
from plastron_tui.language.lowering import Program
from plastron_tui.ros.interfaces import InterfaceKind

from .checks import Checks
from .consequences import Consequences
from .context import Setting
from .kinds import Message
from .mistake import Mistake
from .named_types import NamedTypes
from .values import MessageValue
from .workspace import Workspace


class MessageHistory(NamedTuple):
    """How the messages of a program were made, all for its own ROS.

    Attributes:
        statements: what made each, by its variable.
        variants: what each is in another generation of ROS; None where it is nothing there.
    """

    statements: Mapping[str, st.CreateMessage]
    variants: Mapping[tuple[str, int], Message | None]


class Messages:
    """Makes messages, and looks them up for the nodes that send them."""

    def __init__(
        self,
        setting: Setting,
        workspace: Workspace,
        checks: Checks,
        types: NamedTypes,
        consequences: Consequences,
    ) -> None:
        """Start with none; the arguments are what a `Run` has."""
        self._setting = setting
        self._workspace = workspace
        self._checks = checks
        self._types = types
        self._consequences = consequences
        self._version = setting.ros_version(None)
        self._program = Program(())
        self._made: dict[str, st.CreateMessage] = {}
        # Those of this program, and not of one before it.
        self._here: set[str] = set()
        # Those that only the other ROS has, with its generation.
        self._foreign: dict[str, int] = {}
        self._variants: dict[tuple[str, int], Message | None] = {}

    def begin(self, program: Program) -> None:
        """Go on with another program."""
        self._program = program
        self._here = set()

    @property
    def are_sure(self) -> bool:
        """Whether the rest of the program had no part in how they were made so far."""
        return not self._foreign

    @property
    def history(self) -> MessageHistory:
        """How they were made so far."""
        return MessageHistory(dict(self._made), dict(self._variants))

    def resume(self, made: MessageHistory) -> None:
        """Start with those that the first statements of the program have made."""
        self._made.update(made.statements)
        self._here.update(made.statements)
        self._variants.update(made.variants)

    def create(self, statement: st.CreateMessage) -> None:
        """Make the message that a statement asks for."""
        variable = statement.variable
        self._checks.new_variable(statement, variable)
        version, self._workspace.messages[variable] = self.made(statement)
        if version != self._version:
            self._foreign[variable] = version
        self._made[variable] = statement
        self._here.add(variable)

    def made(self, statement: st.CreateMessage) -> tuple[int, Message]:
        """Return the message that a statement asks for, and the generation of ROS it is of."""
        try:
            return self._version, self._message_in(statement, self._version)
        except Mistake:
            # The message may be meant for nodes of the other ROS.
            for version in self.other_versions():
                with suppress(Mistake):
                    return version, self._message_in(statement, version)
            raise

    def _message_in(self, statement: st.CreateMessage, version: int) -> Message:
        """Make a message of the type that its name means in a generation of ROS."""
        type_ = self._types.named(statement, statement.type, InterfaceKind.MESSAGE, version)
        value = self._types.fit(statement, type_, version)
        return Message(statement.variable, value, statement.span)

    def other_versions(self) -> set[int]:
        """Return the other generations of ROS that nodes of the program are for."""
        used = {
            self._setting.ros_version(statement.library)
            for statement in self._program.statements
            if isinstance(statement, st.CreateNode) and statement.library is not None
        }
        return used - {self._version}

    def values(self) -> Iterator[MessageValue]:
        """Yield the values of the messages, for each generation of ROS that one is made for."""
        yield from (each.value for each in self._workspace.messages.values())
        yield from (each.value for each in self._variants.values() if each is not None)

    def change(self, change: Callable[[MessageValue], MessageValue]) -> None:
        """Give each message another value."""
        messages = self._workspace.messages
        for variable, each in messages.items():
            messages[variable] = each._replace(value=change(each.value))
        for key, variant in self._variants.items():
            if variant is not None:
                self._variants[key] = variant._replace(value=change(variant.value))

    def made_by(self, message: Message) -> st.CreateMessage | None:
        """Return the statement that made a message, None where another program did."""
        return self._made.get(message.variable) if message.variable in self._here else None

    def for_version(self, message: Message, version: int) -> Message:
        """Return a message as nodes of a generation of ROS send it."""
        variable = message.variable
        if version == self._foreign.get(variable, self._version):
            return message
        key = variable, version
        if key not in self._variants:
            self._variants[key] = None
            self._variants[key] = self._message_in(self._made[variable], version)
        found = self._variants[key]
        if found is None:
            raise Mistake
        return found

    def find(self, statement: st.Publish) -> Message:
        """Return the message that a statement sends."""
        message = self._workspace.messages.get(statement.message)
        if message is not None:
            return message
        variable = statement.message
        if self._consequences.declares(variable):
            raise Mistake
        where = statement.span_of("message")
        remedy, fix = guess(variable, self._workspace.messages, where)
        if variable in self._workspace.nodes:
            remedy, fix = f"`{variable}` is a node", None
        if remedy is None:
            made = f"create_message {variable} of message_type {statement.type} and input"
            remedy = f"make it first: `{made} ...`, with its values"
        raise Mistake(
            Diagnostic(
                codes.UNKNOWN_MESSAGE, f"no message `{variable}`", where, help=remedy, fix=fix
            )
        )
