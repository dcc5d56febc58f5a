"""Merging the lines of what a program makes and of what was changed by hand.

Both come from one text. Where they touch the same lines, or where what comes of it is not what
program and hands want, there is no merge by lines.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Client
from plastron_tui.model.source import EndpointKind, FileSet, SourceUnit
from plastron_tui.model.workspace import Node
from plastron_tui.output.merge3 import merge_files, split_lines

from .call_sites import call_sites, is_changed, is_plain, is_shared
from .endpoint_merge import merge
from .language_checks import is_worse, mentions
from .lost_lines import lost_lines, tell_lost
from .merged import Merged

if TYPE_CHECKING:
    from plastron_tui.targets.base import Target

    from .apply_changes import Library


_NAMED_OFTEN = (EndpointKind.PARAMETER,)
"""The kinds whose name stands wherever one is used, not only where it is made."""

_NAME = re.compile(rb"[A-Za-z_]\w*", re.ASCII)


class Sides(NamedTuple):
    """What is merged.

    Attributes:
        path: the main file.
        base: what the program made before.
        mine: what it makes now.
        before: what the files hold, with what was changed in them by hand.
    """

    path: Path
    base: FileSet
    mine: FileSet
    before: FileSet


def lines_in_common(some: FileSet, others: FileSet) -> int:
    """Return how many lines two main files share, wherever they stand."""
    return (Counter(some.main.splitlines()) & Counter(others.main.splitlines())).total()


def merge_lines(
    sides: Sides,
    nodes: Sequence[tuple[Node, Node | None]],
    target: Target,
    *,
    side_by_side: bool = False,
    restores: bool = False,
) -> FileSet | None:
    """Merge lines, and return files that hold what they are to hold, None where that fails.

    Args:
        sides: what is merged.
        nodes: the nodes of the files as the program has them, each with what it had before; none
            where nothing is known but that the files can be read.
        target: the client library.
        side_by_side: whether lines that follow each other may be changed by one side each.
        restores: whether the program only puts back what it had taken out.
    """
    path, base, mine, before = sides
    files = merge_files(base, mine, before, side_by_side=side_by_side, restores=restores)
    if files is None or is_worse(target.language, files, before, mine):
        return None
    merged, *others = (target.read(path, each).source for each in (files, before, mine))
    is_sound = merged is not None and all(
        _has_what_it_is_to_have(node, earlier, merged, *others) for node, earlier in nodes
    )
    return files if is_sound else None


def restored_lines(sides: Sides, original: FileSet) -> Counter[bytes] | None:
    """Return the lines that a program puts back, None where it writes others as well.

    Args:
        sides: what is merged.
        original: what the program started from.
    """
    found: Counter[bytes] = Counter()
    for name, text in sides.mine.texts:
        new = Counter(split_lines(text)) - Counter(split_lines(sides.base.get(name) or b""))
        if new - Counter(split_lines(original.get(name) or b"")):
            return None
        found += new
    return found


def tell_rewritten(merged: Merged, restored: Counter[bytes], path: Path) -> Merged:
    """Add a warning where lines that a program puts back are written otherwise than they were."""
    if merged.files is None:
        return merged
    there = Counter(line for _, text in merged.files.texts for line in split_lines(text))
    lost = [line.strip() for line in (restored - there) if len(line.strip()) > 1]
    if not lost:
        return merged
    shown = f"`{lost[0].decode('utf-8', 'replace')}`"
    if len(lost) > 1:
        shown += f" and {len(lost) - 1} other line{'' if len(lost) == 2 else 's'}"
    message = f"what was taken out of `{path.name}` is written anew, not as it was: {shown}"
    help_ = "lines beside it were changed by hand; write again what it did besides"
    told = Diagnostic(codes.MERGED_BY_HAND, message, file=path, help=help_)
    return merged._replace(lost=(*merged.lost, told))


def merge_created(
    source: SourceUnit, sides: Sides, node: tuple[Node, Node], library: Library
) -> Merged:
    """Merge what the program changed in a created node into its file.

    Endpoints are merged, and lines where endpoints refuse or leave something out. Where the
    program changes what is more than calls that create endpoints, lines come first: they are as
    the node is written. What is left out all the same is told.

    Args:
        source: the file as it is.
        sides: what is merged.
        node: the node as the program has it, and what it had before.
        library: what it is written for.
    """
    target, catalog = library
    if _is_more_than_calls(*node):
        files = merge_lines(sides, [node], target, side_by_side=True)
        if files is not None and not _has_stray_name(sides, files, target):
            return Merged(files)
    merged = merge(source, node[1], node[0], target, catalog)
    merged = tell_lost_in(merged, sides, target)
    if merged.files is not None and merged.is_whole:
        return merged
    by_lines = _by_lines(merged, sides, node, library)
    return merged if by_lines is None else Merged(by_lines, notes=merged.notes)


def _is_more_than_calls(node: Node, base: Node) -> bool:
    """Tell whether a program changed what a node does at more places than where it is created."""
    now, before = node.endpoints, base.endpoints
    changed = [
        endpoint
        for key in dict.fromkeys((*before, *now))
        if key not in now or key not in before or is_changed(before[key], now[key])
        for endpoint in (before.get(key), now.get(key))
        if endpoint is not None
    ]
    # A managed node calls others from its activation on.
    calls = [each for each in changed if isinstance(each, Client) and each.requests]
    is_plainly = all(map(is_plain, changed)) and not (node.is_managed and calls)
    return node.is_managed != base.is_managed or not is_plainly


def tell_lost_in(merged: Merged, sides: Sides, target: Target) -> Merged:
    """Add a warning for each line written by hand that a merge does not keep."""
    if merged.files is None:
        return merged
    lost = lost_lines(sides.base, sides.before, merged.files)
    source = target.read(sides.path, sides.before).source if lost else None
    told = () if source is None else tell_lost(sides.path, source, lost)
    return merged._replace(lost=(*merged.lost, *told))


def _by_lines(
    merged: Merged, sides: Sides, node: tuple[Node, Node], library: Library
) -> FileSet | None:
    """Merge lines into what the program asks for, None where that fails."""
    target, catalog = library
    files = merge_lines(sides, [node], target, side_by_side=True)
    if files is None or _has_stray_name(sides, files, target):
        return None
    by_lines = target.read(sides.path, files).source
    if by_lines is None:
        return None
    # Handwork that needs what the program no longer has would have a stray name.
    if merged.files is not None and _sites(by_lines) != _sites(
        target.read(sides.path, merged.files).source
    ):
        return None
    again = merge(by_lines, node[1], node[0], target, catalog)
    return files if again.files == files else None


def _has_stray_name(sides: Sides, files: FileSet, target: Target) -> bool:
    """Tell whether handwork uses a name that the program wrote before, and no longer does."""
    before, now, there = (
        {word.decode() for _, text in each.texts for word in _NAME.findall(text)}
        for each in (sides.base, sides.mine, files)
    )
    language = target.language
    return any(
        # A word of a comment that the program no longer writes is no name.
        mentions(language, files, name) and mentions(language, sides.base, name)
        for name in (before - now) & there
    )


def _sites(source: SourceUnit | None) -> Counter[tuple[object, ...]]:
    """Return what a file creates that others see, with types and callbacks."""
    endpoints = [] if source is None else (x for x in source.endpoints if is_shared(x.kind))
    return Counter((x.kind, x.name, x.expression, x.type, x.callback) for x in endpoints)


def _has_what_it_is_to_have(
    node: Node,
    base: Node | None,
    merged: SourceUnit | None,
    before: SourceUnit | None,
    mine: SourceUnit | None,
) -> bool:
    """Tell whether merged files have the endpoints of a node as the program and hands want them.

    Args:
        node: the node, as the program has it.
        base: what it had when the file was written.
        merged: the merged files.
        before: the files as they are.
        mine: the files as the program makes them.
    """
    label = None if node.source is None else node.source.label
    found, there, made = (
        {} if each is None else call_sites(each.only(label)) for each in (merged, before, mine)
    )
    wanted, known = node.endpoints, {} if base is None else base.endpoints
    has_all = all(key in found or (key in known and key not in there) for key in wanted)
    has_no_more = all(
        (key in wanted or (key in there and key not in known))
        and (
            key[0] in _NAMED_OFTEN
            or len(sites) <= max(len(there.get(key, ())), len(made.get(key, ())))
        )
        for key, sites in found.items()
        if key[0] is not EndpointKind.TIMER or key in wanted or key in known
    )
    return has_all and has_no_more
