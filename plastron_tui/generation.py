"""From what a program asked to generate to the texts of files."""

from __future__ import annotations

import stat
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.model.source import Add, Change, EndpointKind, Remove, SourceFile
from plastron_tui.model.workspace import Client, Generation, Node, Publisher
from plastron_tui.output.manifest import Base, Manifest
from plastron_tui.output.plan import OutputFile
from plastron_tui.output.remembered import recall, remember
from plastron_tui.ros.catalog import Catalog

if TYPE_CHECKING:
    from plastron_tui.merging import Merged
    from plastron_tui.targets.base import Rendered, Target

# What a target puts behind a node's name tells what the node does, and changes with it.
_PARTS = ("_pub", "_sub1", "_sub2", "_client", "_server", "_node")


@dataclass(frozen=True, slots=True)
class Generated:
    """The file of one `generate_node`, or why there is none."""

    generation: Generation
    file: OutputFile | None
    diagnostics: tuple[Diagnostic, ...] = ()


def changes_of(node: Node) -> tuple[Change, ...]:
    """Return what a program changed in a node that it loaded."""
    if node.source is None:
        return ()
    return tuple(_changes(node, _names_in(node.source)))


def _changes(node: Node, present: Mapping[EndpointKind, set[str]]) -> Iterator[Change]:
    for kind, endpoints in _by_kind(node).items():
        for name in sorted(present[kind] - endpoints.keys()):
            yield Remove(kind, name, node.removed.get(name))
        for name, endpoint in endpoints.items():
            if endpoint.span is not None:
                # Removed and asked for again, with another type perhaps.
                if name in present[kind]:
                    yield Remove(kind, name, node.removed.get(name))
                yield Add(endpoint)
            elif _is_extended(endpoint):
                yield Add(endpoint)


def _is_extended(endpoint: Any) -> bool:
    """Tell whether the program sends more through an endpoint that it found in the file."""
    match endpoint:
        case Publisher(publications=more) | Client(requests=more):
            return bool(more)
        case _:
            return False


def _by_kind(node: Node) -> dict[EndpointKind, Mapping[str, Any]]:
    return {
        EndpointKind.PUBLISHER: node.publishers,
        EndpointKind.SUBSCRIPTION: node.subscriptions,
        EndpointKind.SERVICE: node.services,
        EndpointKind.CLIENT: node.clients,
    }


def _names_in(source: SourceFile) -> dict[EndpointKind, set[str]]:
    names: dict[EndpointKind, set[str]] = {kind: set() for kind in EndpointKind}
    for node in source.nodes:
        for endpoint in node.endpoints:
            if endpoint.name is not None:
                names[endpoint.kind].add(endpoint.name)
    return names


def generate(
    generation: Generation,
    target: Target,
    catalog: Catalog,
    output: Path,
    manifest: Manifest,
    *,
    in_place: bool = False,
    force: bool = False,
    origin: tuple[Target, Catalog] | None = None,
    program: str = "",
) -> Generated:
    """Make the text of one `generate_node`.

    A created node is written anew; where its file was changed by hand, what the program changed
    since is merged into it, unless `force` asks for the new text. A loaded node is its file,
    changed by splices; `in_place` writes it over the file that it came from. Where it is for
    another client library, the changes are made in the file's own (`origin`), and the result is
    ported. `program` is the name of the program's file: nodes of one name in two programs are two.
    """
    node = generation.node
    if node.source is None:
        return _created(generation, target, catalog, output, manifest, force=force, program=program)
    if node.source.library != target.name:
        return _ported(generation, node.source, target, catalog, origin)
    rendered = target.edit(node.source, changes_of(node), catalog)
    if rendered.text is None:
        return _refused(generation, rendered)
    path, text = node.source.path, node.source.text
    # What lies in the output folder may be what this program generates, and on no disk yet.
    is_elsewhere = in_place and path.parent != output
    present = _on_disk(output / path.name)
    is_kept = is_elsewhere or present == text
    # A file that is written over where it came from keeps its mode: it is the user's.
    is_over = is_elsewhere or (path.parent == output and present is not None)
    file = OutputFile(
        path.name,
        rendered.text,
        target.is_executable and not is_over,
        merged_from=text if is_kept else None,
        path=path if is_elsewhere else None,
    )
    return Generated(generation, file, rendered.diagnostics)


def _created(
    generation: Generation,
    target: Target,
    catalog: Catalog,
    output: Path,
    manifest: Manifest,
    *,
    force: bool,
    program: str,
) -> Generated:
    node = generation.node
    rendered = target.render(node, catalog)
    if rendered.text is None:
        return _refused(generation, rendered)
    name = target.file_name(node)
    base = remember(node, target.name, program)
    file = OutputFile(name, rendered.text, target.is_executable, base=base)
    owner = _other_program(name, program, manifest)
    there = _on_disk(output / name) if owner is not None else None
    if owner is not None and there not in (None, rendered.text):
        # Forced too it is a conflict, so that a backup is kept.
        file = replace(file, problem=_of_other_program(output / name, owner))
        return Generated(generation, file, rendered.diagnostics)
    others = _other_files(name, base, target, output, manifest)
    notes = (*rendered.diagnostics, *(_left_behind(output / other, name) for other in others))
    earlier = _earlier(name, others, output, manifest)
    if earlier is not None:
        file = replace(file, supersedes=earlier)
    origin = output / (earlier or name)
    present = _on_disk(origin)
    is_own = present is None or present == rendered.text or manifest.has(origin.name, present)
    if earlier is not None and not force and not _may_replace(output / name, manifest):
        return Generated(generation, replace(file, problem=_stale(output / name, earlier)), notes)
    if force or is_own or present is None or origin.name not in manifest:
        return Generated(generation, file, notes)
    merged = _merged(node, origin, present, target, catalog, manifest)
    if merged.text is None:
        problem = _unmergeable(origin, merged.reason)
        return Generated(generation, replace(file, problem=problem), notes)
    file = replace(
        file,
        text=merged.text,
        merged_from=present if earlier is None else None,
        has_handwork=True,
    )
    return Generated(generation, file, (*notes, _kept_handwork(origin, name), *merged.notes))


def _merged(
    node: Node,
    path: Path,
    present: bytes,
    target: Target,
    catalog: Catalog,
    manifest: Manifest,
) -> Merged:
    """Merge what the program changed in a node into a file that was changed by hand."""
    from plastron_tui.merging import Merged, merge
    from plastron_tui.targets import read_source

    seen = read_source(path, present).source
    if seen is not None and seen.library != target.name:
        return Merged(None, f"it is a node of `{seen.library}`")
    read = target.read(path, present)
    if read.source is None or not read.source.nodes:
        return Merged(None, "it holds no node that can be read")
    known = manifest.bases.get(path.name)
    base = None if known is None else recall(known)
    return merge(read.source, base, node, target, catalog)


def _other_program(name: str, program: str, manifest: Manifest) -> str | None:
    """Return the other program that a file was made by, None where nothing tells of one."""
    known = manifest.bases.get(name, {}).get("program")
    is_other = isinstance(known, str) and known and program and known != program
    return known if is_other else None


def _other_files(
    name: str, base: Base, target: Target, output: Path, manifest: Manifest
) -> list[str]:
    """Return the files of other names that a program made of the same node before."""
    names = (f"{base['node']}{part}{target.suffix}" for part in _PARTS)
    same = ("node", "library", "program")
    return [
        other
        for other in names
        if other != name
        and (known := manifest.bases.get(other)) is not None
        and all(known.get(key) == base[key] for key in same)
        and (output / other).is_file()
    ]


def _earlier(name: str, others: list[str], output: Path, manifest: Manifest) -> str | None:
    """Return the file that held a node until its file's name became another."""
    is_current = name in manifest and manifest.successor(name) is None
    if not others or (is_current and (output / name).is_file()):
        return None
    return next((other for other in others if manifest.successor(other) is None), None)


def _may_replace(path: Path, manifest: Manifest) -> bool:
    """Tell whether a file of an earlier generate holds nothing but what Plastron wrote."""
    present = _on_disk(path)
    return present is None or path.name not in manifest or manifest.has(path.name, present)


def _kept_handwork(path: Path, name: str) -> Diagnostic:
    where = "" if path.name == name else f" in `{name}`"
    return Diagnostic(
        "merged-by-hand",
        f"`{path.name}` was changed by hand and is kept{where}, with the program's changes",
        file=path,
        help="`--force` writes it anew and keeps a backup" if not where else
        "`--force` writes it anew",
        severity=Severity.WARNING,
    )  # fmt: skip


def _left_behind(path: Path, name: str) -> Diagnostic:
    return Diagnostic(
        "left-behind",
        f"the node of `{path.name}` is in `{name}` now, but can still be started from the old file",
        file=path,
        help=f"compare it with `{name}`, and remove it",
        severity=Severity.WARNING,
    )


def _stale(path: Path, current: str) -> Diagnostic:
    return Diagnostic(
        "file-conflict",
        f"`{path.name}` was changed by hand, and later the node went on in `{current}`",
        file=path,
        help=f"remove `{path.name}`, and what `{current}` holds goes there; or use `--force` to "
        "overwrite it and keep a backup",
    )


def _of_other_program(path: Path, program: str) -> Diagnostic:
    return Diagnostic(
        "file-conflict",
        f"`{path.name}` was generated by another program, `{program}`",
        file=path,
        help="give one of the nodes another name, choose another folder with `-o`, or use "
        "`--force` to overwrite it and keep a backup",
    )


def _unmergeable(path: Path, reason: str) -> Diagnostic:
    return Diagnostic(
        "file-conflict",
        f"`{path.name}` was changed by hand, and {reason}",
        file=path,
        help="change the file or the program so that they agree, or use `--force` to write it "
        "anew and keep a backup",
    )


def _ported(
    generation: Generation,
    source: SourceFile,
    target: Target,
    catalog: Catalog,
    origin: tuple[Target, Catalog] | None,
) -> Generated:
    """Write a loaded node for another client library, with the changes of the program.

    It goes under the file's own name, into the output folder: never over the file itself.
    """
    changes = changes_of(generation.node)
    is_changed = bool(changes) and origin is not None
    if changes and origin is not None:
        own, own_catalog = origin
        edited = own.edit(source, changes, own_catalog)
        read = own.read(source.path, edited.text) if edited.text is not None else None
        if read is None or read.source is None:
            return _refused(generation, edited)
        source = read.source
    rendered = target.port(generation.node, source, catalog)
    if rendered.text is None:
        return _refused(generation, rendered)
    name = f"{source.path.stem}{target.suffix}"
    file = OutputFile(name, rendered.text, target.is_executable)
    # What was found after a change has no place in the file as it is on the disk.
    found = rendered.diagnostics
    if is_changed:
        found = tuple(each._replace(span=None) for each in found)
    return Generated(generation, file, found)


def _refused(generation: Generation, rendered: Rendered) -> Generated:
    """Give every diagnostic a place: where none says better, the statement that generates."""
    return Generated(
        generation,
        None,
        tuple(
            found
            if found.span is not None or found.file is not None
            else found._replace(span=generation.span)
            for found in rendered.diagnostics
        ),
    )


def _on_disk(path: Path) -> bytes | None:
    """Return what a file holds, None for what is no file: reading a pipe would wait for ever."""
    try:
        return path.read_bytes() if stat.S_ISREG(path.stat().st_mode) else None
    except (OSError, ValueError):
        return None
