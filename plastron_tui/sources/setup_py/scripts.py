"""Adding and removing a console script of a setup.py."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.sources.build_files import Edited, RefusedError, edited, refusal, take_back
from plastron_tui.sources.splices import Splice, apply, indent_of, line_start, newline_of

from .items import insert, removals, sorted_index
from .reader import (
    CONSOLE_SCRIPTS,
    ConsoleScript,
    SetupFile,
    changed_scripts,
    changed_summand,
    computed_arguments,
    describe,
    dictionary,
    entry_points,
    keyword,
    placed,
)
from .syntax import Setup, parse_setup
from .values import comprehension_parts, evaluate, items_of, summands

_UNIT = "    "


def add_console_script(text: bytes, path: Path, name: str, target: str) -> Edited:
    """Make a function an executable of the package, `NAME = MODULE:FUNCTION`.

    Nothing changes where it is one already. Otherwise the result was read again: it has that
    script more, and nothing else is different.
    """
    return edited(_add, text, path, name, target)


def remove_console_script(text: bytes, path: Path, name: str) -> Edited:
    """Take an executable out; one that was added before leaves the bytes that were there."""
    return edited(_remove, text, path, name)


def has_script(
    scripts: Iterable[ConsoleScript], name: str, target: str, text: bytes, path: Path
) -> bool:
    """Tell whether an executable is there already; one of its name that starts another is refused.

    Raises:
        RefusedError: at the line of the other.
    """
    for each in scripts:
        if each.name == name:
            if each.target == target:
                return True
            why = f"makes `{name}` start `{each.target}` already"
            raise refusal(text, path, each.span, why, codes.EDIT_REFUSED)
    return False


def _add(text: bytes, path: Path, name: str, target: str) -> bytes:
    setup = parse_setup(text, path)
    before = describe(setup)
    _refuse_catkin(setup)
    written = f"{name} = {target}"
    if not written.isprintable() or any(each in written for each in "'\"\\"):
        message = f"`{written}` cannot be written as an entry point"
        raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, file=path))
    if has_script(before.console_scripts, name, target, text, path):
        return text
    after = apply(text, _addition(setup, name, written))
    expected = _scripts(before) + Counter({(name, target): 1})
    if not _is_right(after, path, before, expected):
        message = f"adding `{name}` would change more of `{path.name}` than that"
        raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, file=path))
    return after


def _refuse_catkin(setup: Setup) -> None:
    if setup.is_catkin:
        span = (setup.call.start_byte, setup.call.end_byte)
        why = "is catkin's, which takes no console scripts"
        remedy = "install the script by `catkin_install_python` in CMakeLists.txt"
        raise refusal(setup.text, setup.path, span, why, codes.EDIT_REFUSED, remedy)


def _computed(setup: Setup, node: Node, what: str) -> RefusedError:
    span = (node.start_byte, node.end_byte)
    return refusal(setup.text, setup.path, span, f"computes {what}")


def _addition(setup: Setup, name: str, written: str) -> list[Splice]:
    given = keyword(setup, "entry_points")
    arguments = setup.call.child_by_field_name("arguments")
    assert arguments is not None
    if (computed := computed_arguments(setup, is_given=given is not None)) is not None:
        raise _computed(setup, computed, "what `setup` is called with")
    if given is None:
        return _new_argument(setup, arguments, written)
    found = dictionary(setup, given)
    changed = setup.changed(given)
    if found is None or changed is not None:
        raise _computed(setup, changed or given, "`entry_points`, or writes it as one text")
    node = entry_points(setup)
    if node is None:
        quote = setup.quote(found, setup.call)
        key = f"{quote}{CONSOLE_SCRIPTS}{quote}: "
        key = key if found.type == "dictionary" else f"{CONSOLE_SCRIPTS}="
        item = f"{key}[{quote}{written}{quote}]".encode()
        return insert(setup.text, found, lambda _: item, len(items_of(found)))
    if (changed := changed_summand(setup, node)) is not None:
        raise _computed(setup, changed, "the console scripts")
    return _into_list(setup, node, name, written)


def _new_argument(setup: Setup, arguments: Node, written: str) -> list[Splice]:
    """Write `entry_points` as the last argument of `setup`."""
    quote = setup.quote(arguments, setup.call)
    end = newline_of(setup.text).decode()
    is_long = b"\n" in setup.text[arguments.start_byte : arguments.end_byte]

    def item(indent: bytes) -> bytes:
        script = f"{quote}{written}{quote}"
        if is_long:
            script = f"{end}{indent.decode()}{_UNIT}{script},{end}{indent.decode()}"
        return f"entry_points={{{quote}{CONSOLE_SCRIPTS}{quote}: [{script}]}}".encode()

    return insert(setup.text, arguments, item, len(items_of(arguments)))


def _into_list(setup: Setup, node: Node, name: str, written: str) -> list[Splice]:
    resolved = setup.resolve(node)
    if resolved.type == "list":
        quote = setup.quote(resolved, setup.call)
        values = [value for _, value in placed(setup, resolved)]
        index = sorted_index(values, written)
        item = f"{quote}{written}{quote}".encode()
        if not values and _is_line(setup, resolved):
            return _unfolded(setup, resolved, item)
        return insert(setup.text, resolved, lambda _: item, index)
    if resolved.type == "binary_operator":
        parts = [resolved.child_by_field_name(each) for each in ("right", "left")]
        known = [each for each in parts if each is not None]
        for part in known:
            if setup.resolve(part).type in ("list", "binary_operator"):
                return _into_list(setup, part, name, written)
        for part in known:
            if setup.resolve(part).type == "list_comprehension":
                return _into_list(setup, part, name, written)
    if resolved.type == "list_comprehension":
        return _into_comprehension(setup, resolved, name, written)
    raise _computed(setup, resolved, "the console scripts")


def _is_line(setup: Setup, node: Node) -> bool:
    """Whether an empty list stands in one line, which its key begins."""
    key = node.parent
    if key is None or key.type != "pair" or node.named_child_count:
        return False
    start = line_start(setup.text, key.start_byte)
    is_first = not setup.text[start : key.start_byte].strip()
    return is_first and node.start_point.row == node.end_point.row


def _unfolded(setup: Setup, node: Node, item: bytes) -> list[Splice]:
    """Write the first item of a list on a line of its own, without a comma.

    So it differs from what is written where there was no list, or one over two lines.
    """
    end, indent = newline_of(setup.text), indent_of(setup.text, node.start_byte)
    inner = end + indent + _UNIT.encode() + item + end + indent
    return [Splice(node.start_byte + 1, node.end_byte - 1, inner)]


def _source_list(setup: Setup, node: Node) -> tuple[Node, Node, str] | None:
    """Return the literal list that a comprehension goes over, what it makes, of which variable.

    None where it is not that plain, or the list is used for something else too.
    """
    found = comprehension_parts(setup, node)
    if found is None:
        return None
    body, variable, iterable = found
    source = setup.resolve(iterable)
    is_named = iterable.type == "identifier"
    if source.type != "list" or setup.changed(iterable) is not None:
        return None
    # Once where it is made, and once here.
    if is_named and setup.names.uses[setup.source(iterable)] > 2:
        return None
    return source, body, variable


def _into_comprehension(setup: Setup, node: Node, name: str, written: str) -> list[Splice]:
    found = _source_list(setup, node)
    if found is not None:
        source, body, variable = found
        script = evaluate(setup, body, {variable: name})
        if isinstance(script, str) and _normal(script) == _normal(written):
            quote = setup.quote(source, setup.call)
            index = sorted_index([evaluate(setup, each) for each in items_of(source)], name)
            item = f"{quote}{name}{quote}".encode()
            return insert(setup.text, source, lambda _: item, index)
    raise _computed(setup, node, "the console scripts")


def _normal(script: str) -> str:
    return "=".join(part.strip() for part in script.split("="))


def _scripts(described: SetupFile) -> Counter[tuple[str, str]]:
    return Counter((each.name, each.target) for each in described.console_scripts)


def _rest(described: SetupFile) -> object:
    """Return what a setup.py says besides its console scripts, wherever it says it."""
    data = [each._replace(span=Span(0, 0)) for each in described.data_files]
    kinds = [kind for kind, _ in described.computed]
    return described._replace(console_scripts=(), data_files=tuple(data), computed=()), kinds


def _is_right(
    after: bytes, path: Path, before: SetupFile, expected: Counter[tuple[str, str]]
) -> bool:
    try:
        described = describe(parse_setup(after, path))
    except RefusedError:
        return False
    return _scripts(described) == expected and _rest(described) == _rest(before)


def _remove(text: bytes, path: Path, name: str) -> bytes:
    setup = parse_setup(text, path)
    before = describe(setup)
    found = [each for each in before.console_scripts if each.name == name]
    if not found:
        if before.computed and any(kind == "entry_points" for kind, _ in before.computed):
            span = next(span for kind, span in before.computed if kind == "entry_points")
            raise refusal(text, path, span, f"computes the console scripts, `{name}` perhaps")
        return text
    if (changed := changed_scripts(setup)) is not None:
        raise _computed(setup, changed, f"the console scripts, `{name}` perhaps")
    script = found[0]
    expected = _scripts(before) - Counter({(name, script.target): 1})

    def add(each: bytes) -> bytes | None:
        return add_console_script(each, path, name, script.target).text

    found_at = _place(setup, script)
    if found_at is None:
        raise refusal(text, path, script.span, f"computes the console script `{name}`")
    source, item = found_at
    after = take_back(
        text,
        (apply(text, each) for each in removals(text, source, item)),
        add,
        lambda each: _is_right(each, path, before, expected),
        exact=(apply(text, each) for each in _whole_removals(setup, source)),
    )
    if after is None:
        raise refusal(text, path, script.span, f"computes the console script `{name}`")
    return after


def _place(setup: Setup, script: ConsoleScript) -> tuple[Node, Node] | None:
    """Return the list that a script comes from, and what says it there."""
    node = entry_points(setup)
    for source in _lists(setup, node) if node is not None else ():
        item = _item_at(setup, source, script)
        if item is not None:
            return source, item
    return None


def _whole_removals(setup: Setup, source: Node) -> Iterator[list[Splice]]:
    """Return the ways to take a script out with the key, or the argument, that it is alone in."""
    node, given = entry_points(setup), keyword(setup, "entry_points")
    if node is None or given is None or len(items_of(source)) > 1 or source.id != node.id:
        return
    argument, pair = given.parent, node.parent
    found = dictionary(setup, given)
    is_alone = found is not None and len(items_of(found)) == 1
    if is_alone and argument is not None and argument.parent is not None:
        yield from removals(setup.text, argument.parent, argument)
    if pair is not None and pair.parent is not None:
        yield from removals(setup.text, pair.parent, pair)
    yield [Splice(source.start_byte + 1, source.end_byte - 1)]


def _lists(setup: Setup, node: Node) -> Iterator[Node]:
    """Return the literal lists that the console scripts come from."""
    for each in summands(setup, node):
        if each.type == "list":
            yield each
        elif each.type == "list_comprehension":
            found = _source_list(setup, each)
            if found is not None:
                yield found[0]


def _item_at(setup: Setup, source: Node, script: ConsoleScript) -> Node | None:
    """Return the item of a list that says a script, or that a comprehension makes it of."""
    for each in items_of(source):
        if (each.start_byte, each.end_byte) == script.span:
            return each
    start, end = script.span
    is_apart = not (source.start_byte <= start and end <= source.end_byte)
    made = is_apart or setup.text[start : start + 1] == b"["
    for each in items_of(source):
        if made and evaluate(setup, each) == script.name:
            return each
    return None
