"""What every change of a CMakeLists.txt has in common: it is read again before it counts."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.sources.build_files import Edited, RefusedError, edited, refusal, take_back
from plastron_tui.sources.splices import Splice, apply

from .arguments import argument_removals, command_removals, insert_argument
from .facts import Entry, build_type, facts
from .reader import Call, CMakeLists, interpret
from .syntax import Argument, Command, parse_cmake
from .variables import Item, reference_of

Facts = Counter[tuple[object, ...]]


def change(text: bytes, path: Path, edit: Callable[[CMakeLists], bytes]) -> Edited:
    """Change a file, or say why not."""
    return edited(lambda: edit(interpret(parse_cmake(text, path))))


def build_type_of(lists: CMakeLists) -> str:
    """Return whether a package is built by catkin or ament.

    Raises:
        RefusedError: nothing says so.
    """
    found = build_type(lists)
    if found is None:
        listing = lists.listing
        message = f"`{listing.path.name}` finds neither catkin nor ament_cmake"
        raise RefusedError(Diagnostic(codes.BROKEN_BUILD_FILE, message, file=listing.path))
    return found


def applied(lists: CMakeLists, splices: Iterable[Splice], more: Facts, what: str) -> bytes:
    """Return the changed text.

    Args:
        lists: the file before.
        splices: the change.
        more: what the file says besides, after it.
        what: what is done, for the message: "adding `x`".

    Raises:
        RefusedError: it would say more or less than that, or not parse.
    """
    listing = lists.listing
    after = apply(listing.text, splices)
    if not is_right(after, lists, facts(lists) + more):
        message = f"{what} would change more of `{listing.path.name}` than that"
        raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, file=listing.path))
    return after


def is_right(after: bytes, lists: CMakeLists, expected: Facts) -> bool:
    """Whether a changed text says what is expected, and at most one command is another."""
    try:
        read = interpret(parse_cmake(after, lists.listing.path))
    except RefusedError:
        return False
    before = Counter(each.words for each in lists.listing.commands())
    now = Counter(each.words for each in read.listing.commands())
    is_small = (before - now).total() <= 1 and (now - before).total() <= 1
    return is_small and read.name == lists.name and facts(read) == expected


def removed(
    lists: CMakeLists,
    entry: Entry,
    less: Facts,
    add: Callable[[bytes], bytes | None],
    alone: bool,
    is_made: bool = False,
) -> bytes:
    """Return the text without what an entry says, as it was before that was added.

    Args:
        lists: the file.
        entry: what is to go.
        less: what the file says no more then.
        add: what adds it again.
        alone: whether the call goes with it, as it names nothing else.
        is_made: whether the call may go where adding makes one anew.

    Raises:
        RefusedError: it is computed.
    """
    listing = lists.listing
    item = entry.item
    expected = facts(lists) - less

    def texts(ways: Iterable[list[Splice]]) -> Iterator[bytes]:
        return (apply(listing.text, each) for each in ways)

    whole = list(command_removals(listing, entry.call.command)) if alone or is_made else []
    # A reference that nothing follows stands for itself.
    is_plain = reference_of(item.argument) is None or item.value == item.argument.value
    is_written = item.is_own and is_plain
    part = list(argument_removals(listing, item.command, item.argument)) if is_written else []
    after = take_back(
        listing.text,
        texts(whole if alone else part),
        add,
        lambda each: is_right(each, lists, expected),
        exact=texts([*whole, *part]),
    )
    if after is None:
        raise refusal(
            listing.text, listing.path, entry.call.command.span, f"computes `{entry.what}`"
        )
    return after


def into_list(
    lists: CMakeLists, call: Call, items: Sequence[Item], value: str
) -> list[Splice] | None:
    """Insert a value into the list that a section of a call has, or the variable it is.

    None where no such list can be changed alone.
    """
    last = items[-1]
    command = last.command
    is_direct = command.start == call.command.start
    if not is_direct and not _is_alone(lists, call, command):
        return None
    siblings = [
        each.argument
        for each in items
        if each.command.start == command.start
        and each.is_own
        and not each.is_pattern
        and reference_of(each.argument) is None
    ]
    if not siblings:
        return None
    quoted = f'"{value}"' if siblings[-1].is_quoted else value
    return insert_argument(lists.listing, command, siblings, quoted)


def _is_alone(lists: CMakeLists, call: Call, setting: Command) -> bool:
    """Whether a list is set in no branch, and nothing but one call names it."""
    is_top = any(each is setting for each in lists.listing.statements)
    if not is_top or setting.name not in ("set", "list"):
        return False
    name = setting.arguments[1 if setting.name == "list" else 0].value
    users = [each for each in lists.listing.commands() if _uses(each, name)]
    return [each.start for each in users] == [call.command.start]


def _uses(command: Command, name: str) -> bool:
    """Whether a command may read a list: by reference, or by its bare name as `foreach` does."""
    values = [each.value for each in command.arguments]
    is_made = command.name == "set" or [each.upper() for each in values[:1]] == ["APPEND"]
    bare = values[1 if command.name == "set" else 2 :] if is_made else values
    return name in bare or any(f"${{{name}}}" in each for each in values)


def word_of(command: Command, word: str) -> Argument | None:
    """Return the argument that is a keyword."""
    return next((each for each in command.arguments if each.value == word), None)
