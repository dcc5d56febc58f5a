"""What is wrong between the values that nodes are given and the parameters that they declare."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path

from plastron_tui.diagnostics import Code, Diagnostic, Fix, Label, Severity, Span, write
from plastron_tui.diagnostics.suggest import nearest
from plastron_tui.lint.rule import rule
from plastron_tui.lint.runs import span_of
from plastron_tui.lint.tree import SettingPlace, SourceTree
from plastron_tui.ros.name_slips import is_slip
from plastron_tui.ros.parameter_blocks import KeyPart, ParameterBlock, ParameterKey
from plastron_tui.ros.parameter_values import is_for

from .parameters_examples import GIVEN, given
from .parameters_given import (
    Declared,
    Given,
    Receiver,
    Receivers,
    is_of_every_node,
    receivers_of,
    settings,
)

_FOR_PEOPLE = re.compile(
    r"(?:\A|[_.])(?:do_not|dont|example|unused|deprecated|disabled)(?:[_.]|\Z)"
)
"""What is in the names of keys that are there for people to read: `example_do_not_execute`."""

_UNMEANT = "declare it in the node, or take it out here"


@rule(
    "RP301",
    "undeclared-key",
    "A parameter file or a launch file sets a parameter that no node which gets it declares.",
    severity=Severity.WARNING,
    why="ROS 2 says nothing: the node keeps its default, and whoever wrote the value believes that "
    "it counts. It is told where each node that gets the value is read, declares all of its "
    "parameters by names that are known, and allows no others; of other nodes only a name that is "
    "one slip from a parameter which gets no value. A file that no launch file hands to a node is "
    "taken as meant for the nodes that it names. In ROS 1 any node may read any parameter at any "
    "time, so nothing is told there.",
    bad=given("max_sped: 1.0"),
    good=GIVEN,
)
def undeclared_key(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find values that no node takes."""
    receivers = receivers_of(tree)
    for each in receivers.given:
        if each.nodes and each.is_whole:
            yield from _undeclared_keys(code, each)
    yield from _undeclared_settings(tree, code, receivers)


def _tells_all(node: Declared) -> bool:
    """Tell whether a node has no other parameters than it declares.

    C++ that declares none at all most likely leaves that to a library.
    """
    return node.is_whole and (bool(node.uses) or node.node.unit.is_python)


def _is_undeclared(name: str, nodes: Iterable[Declared]) -> bool:
    """Tell whether a name is meant for nodes, and none of them has such a parameter."""
    return not _FOR_PEOPLE.search(name) and not any(node.has(name) for node in nodes)


def _undeclared_keys(code: Code, given: Given) -> Iterator[Diagnostic]:
    names = [name for node in given.nodes for name in node.uses]
    taken = {key.name for key in given.block.keys}
    is_whole = all(map(_tells_all, given.nodes))
    undeclared = [key for key in given.block.keys if _is_undeclared(key.name, given.nodes)]
    if is_whole and not names and len(undeclared) > 1:
        yield _none_declared(code, given, undeclared)
        return
    told: set[Span] = set()
    for key in undeclared:
        part, name = _wrong_part(key, names)
        if part.span in told:
            continue
        told.add(part.span)
        free = [each for each in names if each not in taken]
        meant = _meant(name, free if name == key.name else names)
        if not is_whole and (meant is None or not is_slip(name, meant)):
            continue
        yield Diagnostic(
            code,
            f"no parameter `{name}` is declared in {_named(given)}",
            part.span,
            given.file,
            help=_UNMEANT if meant is None else f"did you mean `{meant}`?",
            fix=_renamed(name, part, meant),
            labels=_declared(given.nodes, meant),
        )


def _none_declared(code: Code, given: Given, keys: list[ParameterKey]) -> Diagnostic:
    """Tell once of the keys of a block whose nodes declare nothing at all."""
    return Diagnostic(
        code,
        f"none of these {len(keys)} parameters is declared in {_named(given)}, "
        "which declares nothing",
        keys[0].parts[0].span,
        given.file,
        help=_UNMEANT,
    )


def _wrong_part(key: ParameterKey, names: Iterable[str]) -> tuple[KeyPart, str]:
    """Return the first of the keys of a parameter below which nothing is declared, and its name."""
    name = ""
    for part in key.parts:
        name = f"{name}.{part.text}" if name else part.text
        if not any(each.startswith(f"{name}.") for each in names):
            return part, name
    return key.parts[-1], key.name


def _meant(name: str, names: Iterable[str]) -> str | None:
    """Return the name that was meant, or the part of one with as many keys."""
    depth = name.count(".") + 1
    parts = dict.fromkeys(".".join(each.split(".")[:depth]) for each in names)
    return _near(name, parts)


def _near(name: str, names: Iterable[str]) -> str | None:
    """Return the name that is a slip, or another way of writing words, from one; None for none."""
    found = nearest(name, names)
    is_near = found is not None and (is_slip(name, found) or _plain(name) == _plain(found))
    return found if is_near else None


def _plain(name: str) -> str:
    return name.replace("_", "").lower()


def _renamed(name: str, part: KeyPart, meant: str | None) -> Fix | None:
    """Return the fix that writes the name that was meant, None where that is not sure."""
    before = name.removesuffix(part.text)
    is_plain = part.span.end - part.span.start == len(part.text.encode())
    if meant is None or not is_plain or not meant.startswith(before) or not is_slip(name, meant):
        return None
    return write(meant.removeprefix(before), part.span)


def _undeclared_settings(
    tree: SourceTree, code: Code, receivers: Receivers
) -> Iterator[Diagnostic]:
    """Find what a launch file itself sets, and no node declares that is started at the place."""
    of_place: dict[tuple[SettingPlace, Span], list[Receiver]] = defaultdict(list)
    for receiver in receivers.all:
        for _, place, span in settings(tree, receiver):
            of_place[place, span].append(receiver)
    for (place, span), started in of_place.items():
        name = place.name
        nodes = [node for receiver in started for node in receiver.nodes]
        if not all(receiver.nodes for receiver in started) or not _is_undeclared(name, nodes):
            continue
        taken = {each for receiver in started for each in receiver.settings}
        free = [each for node in nodes for each in node.uses if each not in taken]
        meant = _near(name, free)
        if not all(map(_tells_all, nodes)) and (meant is None or not is_slip(name, meant)):
            continue
        yield Diagnostic(
            code,
            f"no parameter `{name}` is declared in {_nodes(nodes)}",
            span,
            Path(place.file),
            help=_UNMEANT if meant is None else f"did you mean `{meant}`?",
            labels=_declared(nodes, meant),
        )


def _declared(nodes: Iterable[Declared], meant: str | None) -> tuple[Label, ...]:
    """Return the first place where the name is declared that was meant, none where it is not."""
    labels = (node.label(meant or "") for node in nodes)
    return next(filter(None, labels), ())


def _named(given: Given) -> str:
    """Return the nodes of a block as people know them: in its namespace, or without one."""
    own = [each for each in given.nodes if is_for(given.block.pattern, each.node.full_name)]
    return _nodes(own) if own else f"`{given.block.last}`"


def _nodes(nodes: Iterable[Declared]) -> str:
    names = dict.fromkeys(f"`{each.node.full_name}`" for each in nodes)
    return ", ".join(names)


@rule(
    "RP302",
    "wrong-node-name",
    "A parameter file that a launch file hands to a node has its values for another name.",
    severity=Severity.WARNING,
    why="ROS 2 takes from the file what stands below the node's full name, its namespace among it, "
    "or below a pattern such as `/**`. All else is left, without a word. It is told where no other "
    "node that gets the file has the name, and it is clear which node is meant: its name is nearly "
    "the same or in another namespace, it declares all that the file sets there, or no other node "
    "gets the file.",
    bad=given("max_speed: 1.0", block="drivr"),
    good=GIVEN,
)
def wrong_node_name(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find names in parameter files that no node has which gets them."""
    receivers = receivers_of(tree)
    names = _all_names(tree, receivers)
    for file, blocks in tree.parameter_files.items():
        given = receivers.of_file.get(file, [])
        known = [receiver for receiver in given if receiver.names is not None]
        lonely = [block for block in blocks if not any(_gets(each, block) for each in known)]
        told: set[Span] = set()
        for receiver in known:
            if receiver.launch is None or any(_gets(receiver, block) for block in blocks):
                continue
            is_alone = len(given) == 1
            block = _block_of(receiver, lonely, is_sure=len(known) == len(given), is_alone=is_alone)
            if block is not None and block.name.span not in told:
                told.add(block.name.span)
                yield _misnamed(code, file, block, receiver)
        for block in lonely:
            if block.name.span not in told:
                yield from _misspelt(code, file, block, blocks, names, receivers)


def _all_names(tree: SourceTree, receivers: Receivers) -> frozenset[str]:
    """Return the names of all nodes that are known, without their namespaces."""
    started = (each.started.name for each in receivers.all if each.started.name)
    in_code = (node.name for unit in tree.units for node in unit.nodes if node.name)
    return frozenset((*receivers.by_name, *started, *in_code))


def _misspelt(
    code: Code,
    file: Path,
    block: ParameterBlock,
    blocks: Iterable[ParameterBlock],
    names: frozenset[str],
    receivers: Receivers,
) -> Iterator[Diagnostic]:
    """Yield that no node has the name of a block, and one that declares its keys nearly has it."""
    last, above = block.last, block.pattern.removesuffix(block.last)
    if block.is_for_any or last in names:
        return
    others = {each.pattern for each in blocks}
    keys = [key.name for key in block.keys if not is_of_every_node(key.name)]
    for name in sorted(names):
        nodes = receivers.named(name, file) if is_slip(last, name) else ()
        if above + name not in others and any(node.has(key) for node in nodes for key in keys):
            is_plain = block.name.text == last
            yield Diagnostic(
                code,
                f"no node is called `{last}`: nobody takes this",
                block.name.span,
                file,
                help=f"did you mean `{name}`?",
                fix=write(name, block.name.span) if is_plain else None,
            )
            return


def _gets(receiver: Receiver, block: ParameterBlock) -> bool:
    return any(is_for(block.pattern, name) for name in receiver.names or ())


def _block_of(
    receiver: Receiver, blocks: list[ParameterBlock], *, is_sure: bool, is_alone: bool
) -> ParameterBlock | None:
    """Return the block that is meant for a process, None where that is not sure."""
    own = {name.rpartition("/")[2] for name in receiver.names or ()}
    elsewhere = [block for block in blocks if block.last in own]
    if elsewhere:
        # Of several, each may be for a run of its own, in the namespace that an argument says.
        return elsewhere[0] if len(elsewhere) == 1 else None
    for block in blocks:
        if any(is_slip(block.last, name) for name in own):
            return block
    if not is_sure:
        return None
    fitting = [block for block in blocks if _fits(receiver, block)]
    if len(fitting) == 1:
        return fitting[0]
    is_only = is_alone and len(blocks) == 1 and receiver.is_one_of_all
    return blocks[0] if is_only and receiver.nodes else None


def _fits(receiver: Receiver, block: ParameterBlock) -> bool:
    """Tell whether all that a block sets is declared by a node of a process."""
    names = [key.name for key in block.keys if not is_of_every_node(key.name)]
    return bool(names) and any(all(map(node.has, names)) for node in receiver.nodes)


def _misnamed(code: Code, file: Path, block: ParameterBlock, receiver: Receiver) -> Diagnostic:
    name = (receiver.names or ("",))[0]
    started = receiver.started
    labels: tuple[Label, ...] = ()
    if started.place is not None and started.file is not None:
        labels = (Label(span_of(started.place), "it gets the file here", Path(started.file)),)
    above, _, last = block.pattern.rpartition("/")
    own = name.rpartition("/")[2]
    is_plain = block.name.text == last
    fix = write(own, block.name.span) if is_plain and f"{above}/{own}" == name else None
    return Diagnostic(
        code,
        f"`{name}` gets the file, and this is for `{block.pattern}`: nobody takes it",
        block.name.span,
        file,
        help=f"write `{name}:`, or `/**:` for every node that gets the file",
        fix=fix if is_slip(last, own) else None,
        labels=labels,
    )
