"""Adding and removing what a setup.py installs beside the code: launch files, configuration."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tree_sitter import Node

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.sources.build_files import Edited, RefusedError, edited, refusal, take_back
from plastron_tui.sources.splices import Splice, apply, newline_of

from .items import insert, removals
from .reader import DataFiles, SetupFile, changed_data_files, computed_arguments, describe, keyword
from .syntax import Setup, parse_setup
from .values import evaluate, items_of, summands


def add_data_file(text: bytes, path: Path, folder: str, file: str) -> Edited:
    """Install a file in `share/PACKAGE/FOLDER`; nothing changes where it is installed already.

    Args:
        text: what is in the setup.py.
        path: the setup.py.
        folder: the folder below `share/PACKAGE`, such as `launch`; "" for that one itself.
        file: the file, by its path from the package's folder.
    """
    return edited(_add, text, path, folder, file)


def remove_data_file(text: bytes, path: Path, folder: str, file: str) -> Edited:
    """Install a file no more; one that a pattern covers stays covered."""
    return edited(_remove, text, path, folder, file)


def _destination(setup: Setup, described: SetupFile, folder: str) -> str:
    if described.name is None:
        span = (setup.call.start_byte, setup.call.end_byte)
        raise refusal(setup.text, setup.path, span, "computes the name of the package")
    return f"share/{described.name}/{folder}".rstrip("/")


def _add(text: bytes, path: Path, folder: str, file: str) -> bytes:
    setup = parse_setup(text, path)
    before = describe(setup)
    if setup.is_catkin:
        span = (setup.call.start_byte, setup.call.end_byte)
        remedy = "install the file by CMakeLists.txt"
        why = "is catkin's, which installs no data files"
        raise refusal(text, path, span, why, codes.EDIT_REFUSED, remedy)
    if not file.isprintable() or any(each in file + folder for each in "'\"\\{}"):
        message = f"`{file}` cannot be written as a data file"
        raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, file=path))
    destination = _destination(setup, before, folder)
    if any(each.destination == destination and each.covers(file) for each in before.data_files):
        return text
    after = apply(text, _addition(setup, before, destination, file))
    expected = _files(before) + Counter({(destination, file): 1})
    if not _is_right(after, path, before, expected):
        message = f"installing `{file}` would change more of `{path.name}` than that"
        raise RefusedError(Diagnostic(codes.EDIT_REFUSED, message, file=path))
    return after


def _addition(setup: Setup, before: SetupFile, destination: str, file: str) -> list[Splice]:
    computed = [span for kind, span in before.computed if kind == "data_files"]
    computed += [
        each.span
        for each in before.data_files
        if each.destination is None or (each.destination == destination and not each.is_whole)
    ]
    if computed:
        raise refusal(setup.text, setup.path, computed[0], "computes `data_files`")
    quote = setup.quote(setup.call)
    node = keyword(setup, "data_files")
    written = f"{quote}{file}{quote}"
    if node is None:
        return _new_argument(setup, f"({quote}{destination}{quote}, [{written}])")
    for entry, given in _entries(setup, node):
        files = setup.resolve(given)
        if evaluate(setup, entry) == destination and files.type == "list":
            return insert(setup.text, files, lambda _: written.encode(), len(items_of(files)))
    target = _last_list(setup, node)
    if target is None:
        span = (node.start_byte, node.end_byte)
        raise refusal(setup.text, setup.path, span, "computes `data_files`")
    folder = destination.removeprefix(f"share/{before.name}").lstrip("/")
    place = _written_destination(setup, node, before.name or "", folder, quote)
    item = f"({place}, [{written}])".encode()
    return insert(setup.text, target, lambda _: item, len(items_of(target)))


def _new_argument(setup: Setup, entry: str) -> list[Splice]:
    arguments = setup.call.child_by_field_name("arguments")
    assert arguments is not None
    if (each := computed_arguments(setup)) is not None:
        span = (each.start_byte, each.end_byte)
        raise refusal(setup.text, setup.path, span, "computes what `setup` is called with")
    end = newline_of(setup.text).decode()
    is_long = b"\n" in setup.text[arguments.start_byte : arguments.end_byte]

    def item(indent: bytes) -> bytes:
        before = indent.decode()
        inner = f"{end}{before}    {entry},{end}{before}" if is_long else entry
        return f"data_files=[{inner}]".encode()

    return insert(setup.text, arguments, item, len(items_of(arguments)))


def _entries(setup: Setup, node: Node) -> Iterator[tuple[Node, Node]]:
    """Return the destination and the files of each entry that is written as a pair."""
    for target in _literal_lists(setup, node):
        for each in items_of(target):
            pair = items_of(setup.resolve(each))
            if setup.resolve(each).type in ("tuple", "list") and len(pair) == 2:
                yield pair[0], pair[1]


def _literal_lists(setup: Setup, node: Node) -> list[Node]:
    return [each for each in summands(setup, node) if each.type == "list"]


def _last_list(setup: Setup, node: Node) -> Node | None:
    found = _literal_lists(setup, node)
    return found[-1] if found else None


def _written_destination(setup: Setup, node: Node, name: str, folder: str, quote: str) -> str:
    """Write a folder of the package as other entries write theirs."""
    share = f"share/{name}"
    if not folder:
        return f"{quote}{share}{quote}"
    for place, _ in _entries(setup, node):
        value, source = evaluate(setup, place), setup.source(place)
        if not isinstance(value, str) or not (value + "/").startswith(share + "/"):
            continue
        if place.type == "call" and value == share:
            return f"{source[:-1].rstrip().rstrip(',')}, {quote}{folder}{quote})"
        if place.type == "call" and value.count("/") == 2 and "\n" not in source:
            last = items_of(_arguments(place))[-1]
            if evaluate(setup, last) == value.rpartition("/")[2]:
                kept = setup.text[place.start_byte : last.start_byte].decode()
                return f"{kept}{quote}{folder}{quote})"
        if place.type == "binary_operator" and value == share and "\n" not in source:
            return f"{source} + {quote}/{folder}{quote}"
        if place.type == "string" and value == share and source.startswith(("f", "F")):
            return f"{source[:-1]}/{folder}{source[-1]}"
    return f"{quote}{share}/{folder}{quote}"


def _arguments(call: Node) -> Node:
    arguments = call.child_by_field_name("arguments")
    assert arguments is not None
    return arguments


def _files(described: SetupFile) -> Counter[tuple[str | None, str]]:
    return Counter((each.destination, file) for each in described.data_files for file in each.files)


def _rest(described: SetupFile) -> object:
    """Return what a setup.py says besides the files that it names, wherever it says it."""
    patterns = [
        (each.destination, each.patterns, each.is_whole)
        for each in described.data_files
        if each.patterns or not each.is_whole
    ]
    scripts = [each[:2] for each in described.console_scripts]
    kinds = [kind for kind, _ in described.computed]
    plain = described._replace(data_files=(), console_scripts=(), computed=())
    return plain, sorted(patterns, key=str), scripts, kinds


def _is_right(
    after: bytes, path: Path, before: SetupFile, expected: Counter[tuple[str | None, str]]
) -> bool:
    try:
        described = describe(parse_setup(after, path))
    except RefusedError:
        return False
    return _files(described) == expected and _rest(described) == _rest(before)


def _remove(text: bytes, path: Path, folder: str, file: str) -> bytes:
    setup = parse_setup(text, path)
    before = describe(setup)
    destination = _destination(setup, before, folder)
    found = [each for each in before.data_files if each.destination == destination]
    if (changed := changed_data_files(setup)) is not None:
        span = (changed.start_byte, changed.end_byte)
        raise refusal(text, path, span, f"computes `data_files`, `{file}` perhaps")
    if not any(file in each.files for each in found):
        unknown = [each.span for each in found if not each.is_whole]
        if unknown and not any(each.covers(file) for each in found):
            raise refusal(text, path, unknown[0], f"computes what it installs, `{file}` perhaps")
        return text
    expected = _files(before) - Counter({(destination, file): 1})

    def add(each: bytes) -> bytes | None:
        return add_data_file(each, path, folder, file).text

    candidates = (apply(text, each) for each in _removals(setup, destination, file))
    after = take_back(text, candidates, add, lambda each: _is_right(each, path, before, expected))
    if after is None:
        raise refusal(text, path, _place(found, file), f"computes where `{file}` is installed")
    return after


def _place(found: list[DataFiles], file: str) -> Span:
    return next(each.span for each in found if file in each.files)


def _removals(setup: Setup, destination: str, file: str) -> Iterator[list[Splice]]:
    node = keyword(setup, "data_files")
    if node is None:
        return
    for target in _literal_lists(setup, node):
        for each in items_of(target):
            pair = items_of(setup.resolve(each))
            if len(pair) != 2 or evaluate(setup, pair[0]) != destination:
                continue
            files = setup.resolve(pair[1])
            named = items_of(files) if files.type in ("list", "tuple") else []
            item = next((one for one in named if evaluate(setup, one) == file), None)
            if item is None:
                continue
            argument = node.parent
            if len(named) == 1 and len(items_of(target)) == 1 and argument and argument.parent:
                yield from removals(setup.text, argument.parent, argument)
            if len(named) == 1:
                yield from removals(setup.text, target, each)
            yield from removals(setup.text, files, item)
