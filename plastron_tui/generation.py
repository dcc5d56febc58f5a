"""From what a program asked to generate to the texts of files."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from plastron_tui.diagnostics import Diagnostic, Severity
from plastron_tui.model.source import Add, Change, EndpointKind, Remove, SourceFile
from plastron_tui.model.workspace import Client, Generation, Node, Publisher
from plastron_tui.output.manifest import Manifest
from plastron_tui.output.plan import OutputFile
from plastron_tui.ros.catalog import Catalog

if TYPE_CHECKING:
    from plastron_tui.targets.base import Rendered, Target


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


def changes_between(source: SourceFile, node: Node) -> tuple[Change, ...]:
    """Return what would make the endpoints of a file those of a node."""
    return tuple(_changes(node, _names_in(source), is_program_whole=True))


def _changes(
    node: Node, present: Mapping[EndpointKind, set[str]], *, is_program_whole: bool = False
) -> Iterator[Change]:
    for kind, endpoints in _by_kind(node).items():
        for name in sorted(present[kind] - endpoints.keys()):
            yield Remove(kind, name, node.removed.get(name))
        for name, endpoint in endpoints.items():
            is_present = name in present[kind]
            if is_program_whole:
                if not is_present:
                    yield Add(endpoint)
            elif endpoint.span is not None:
                # Removed and asked for again, with another type perhaps.
                if is_present:
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
) -> Generated:
    """Make the text of one `generate_node`.

    A created node is written anew; where its file was changed by hand, the endpoints are merged
    into what is there, unless `force` asks for the new text. A loaded node is its file, changed
    by splices; `in_place` writes it over the file that it came from. Where it is for another
    client library, the changes are made in the file's own (`origin`), and the result is ported.
    """
    node = generation.node
    if node.source is None:
        return _created(generation, target, catalog, output, manifest, force=force)
    if node.source.library != target.name:
        return _ported(generation, node.source, target, catalog, origin)
    rendered = target.edit(node.source, changes_of(node), catalog)
    if rendered.text is None:
        return _refused(generation, rendered)
    path, text = node.source.path, node.source.text
    # What lies in the output folder may be what this program generates, and on no disk yet.
    is_elsewhere = in_place and path.parent != output
    is_kept = is_elsewhere or _on_disk(output / path.name) == text
    file = OutputFile(
        path.name,
        rendered.text,
        target.is_executable,
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
) -> Generated:
    node = generation.node
    rendered = target.render(node, catalog)
    if rendered.text is None:
        return _refused(generation, rendered)
    name = target.file_name(node)
    path = output / name
    present = _on_disk(path)
    if present is None or present == rendered.text or manifest.has(name, present):
        file = OutputFile(name, rendered.text, target.is_executable)
        return Generated(generation, file, rendered.diagnostics)
    can_merge = name in manifest.digests and not force
    merged = _merged(node, path, present, target, catalog) if can_merge else None
    if merged is None:
        file = OutputFile(name, rendered.text, target.is_executable)
        return Generated(generation, file, rendered.diagnostics)
    file = OutputFile(name, merged, target.is_executable, merged_from=present)
    return Generated(generation, file, (*rendered.diagnostics, _kept_handwork(name, path)))


def _merged(
    node: Node, path: Path, present: bytes, target: Target, catalog: Catalog
) -> bytes | None:
    """Add to a file that was changed by hand what it lacks of a node; None where refused.

    What the file has and the node has not may be the user's own, and a type that differs may be
    too: neither is undone without being asked.
    """
    read = target.read(path, present)
    if read.source is None or read.source.library != target.name:
        return None
    changes = changes_between(read.source, node)
    if any(isinstance(change, Remove) for change in changes) or not _agrees(read.source, node):
        return None
    return target.edit(read.source, changes, catalog).text


def _agrees(source: SourceFile, node: Node) -> bool:
    """Tell whether a file has the type of the node wherever both have an endpoint."""
    wanted = _by_kind(node)
    return all(
        endpoint.type == wanted[endpoint.kind][endpoint.name].type
        for source_node in source.nodes
        for endpoint in source_node.endpoints
        if endpoint.kind in wanted
        and endpoint.name is not None
        and endpoint.name in wanted[endpoint.kind]
        and endpoint.type is not None
    )


def _kept_handwork(name: str, path: Path) -> Diagnostic:
    return Diagnostic(
        "merged-by-hand",
        f"`{name}` was changed by hand and is kept; only what it lacks is added",
        file=path,
        help="messages, rates and callbacks stay as the file has them; `--force` writes it anew "
        "and keeps a backup",
        severity=Severity.WARNING,
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
    try:
        return path.read_bytes()
    except OSError:
        return None
