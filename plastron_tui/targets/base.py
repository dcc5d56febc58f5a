"""What a target is: a client library that Plastron can write, and bring nodes to.

A target is found by the name of its client library, loaded when first used, and may come from
another distribution (the entry point group `plastron.targets`). What a target cannot do is a
diagnostic, never an exception.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import ClassVar

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import Client, EndpointKind, Publisher, Service, Subscription
from plastron_tui.model.source import Change, FileSet, SourceUnit
from plastron_tui.model.workspace import Home, Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.sources.base import Language, ReadResult, Rendered

_UNTOLD = (EndpointKind.ACTION_SERVER, EndpointKind.ACTION_CLIENT, EndpointKind.TIMER)
"""What a node does, and no ending of its file tells."""

API_VERSION = 4
"""The version of this interface; a target says for which one it was written."""


class Target:
    """The base of a target. What is not overridden is reported as not supported.

    Attributes:
        api_version: the `API_VERSION` that the target was written for.
        name: the client library.
        ros_version: the generation of ROS that it is for, 1 or 2.
        language: the language that its nodes are written in.
        writes: the kinds of endpoints that its nodes can have.
        writes_managed: whether its nodes can be lifecycle nodes.
        package_folder: the folder of a package that its nodes are in; `{}` is the package's name.
    """

    api_version: ClassVar[int] = 1
    name: ClassVar[str]
    ros_version: ClassVar[int]
    language: ClassVar[Language]
    writes: ClassVar[frozenset[EndpointKind]] = frozenset(
        {
            EndpointKind.PUBLISHER,
            EndpointKind.SUBSCRIPTION,
            EndpointKind.SERVICE,
            EndpointKind.CLIENT,
        }
    )
    writes_managed: ClassVar[bool] = False
    package_folder: ClassVar[str] = "src"

    def plugin_class(self, node: Node) -> str | None:
        """Return the class that another process loads a node as; None for one with its own."""
        del node
        return None

    def set_layouts(self, layouts: Mapping[str, str]) -> None:
        """Let a project say how many files a new node has.

        Args:
            layouts: `single` or `split`, by the name of a language that leaves it open.
        """
        del layouts

    def packaged(self, home: Home, name: str) -> str:
        """Return where a node's file is in a folder of packages, by the file's name."""
        usual = self.package_folder.format(home.package)
        folder = usual if home.folder is None else home.folder
        package = "" if home.is_output else home.package
        return "/".join(part for part in (package, folder, name) if part)

    def unwritable(self, node: Node) -> Diagnostic | None:
        """Return what of a node the client library has no means for, None where it has all."""
        for kind, found in node.by_kind.items():
            if found and kind not in self.writes:
                first = next(iter(found.values()))
                return self._cannot(f"write {kind.word}s for")._replace(span=first.span)
        if node.is_managed and not self.writes_managed:
            return self._cannot("write managed nodes for")._replace(span=node.span)
        return None

    def file_name(self, node: Node) -> str:
        """Return the name of a created node's main file (docs/language.md, "Files").

        A node keeps the file that it has. Of a new one the ending tells the next reader what it
        does: `_pub`, `_sub1`, `_sub2`, `_client`, `_server`, or `_node` for a mixture, and for
        what has no ending of its own.
        """
        if node.file:
            return node.file
        kinds = {
            "_pub": bool(node.of(Publisher)),
            "_sub1" if len(node.of(Subscription)) == 1 else "_sub2": bool(node.of(Subscription)),
            "_client": bool(node.of(Client)),
            "_server": bool(node.of(Service)),
            "_node": any(node.by_kind[kind] for kind in _UNTOLD),
        }
        used = [ending for ending, is_used in kinds.items() if is_used]
        return f"{node.name}{used[0] if len(used) == 1 else '_node'}{self.language.suffix}"

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        """Write a created node as new source files; `file_name` names the main one."""
        return Rendered(None, (self._cannot("generate nodes for"),))

    def render_program(self, nodes: Sequence[Node], catalog: Catalog) -> Rendered:
        """Write the files that belong to no single node, such as what builds them all.

        Their names are those in the output folder. Without any, `files` is None.

        Args:
            nodes: the nodes that a program generates for this client library.
            catalog: the interface types.
        """
        del nodes, catalog
        return Rendered(None)

    def read(self, path: Path, files: FileSet) -> ReadResult:
        """Read the nodes and endpoints of source files of this client library."""
        return self.language.read(path, files, self.name)

    def edit(self, source: SourceUnit, changes: Sequence[Change], catalog: Catalog) -> Rendered:
        """Change source files by splices; every byte that no splice covers stays.

        The result was read again: it parses no worse than before and shows exactly the
        endpoints that were asked for. Otherwise `files` is None and the diagnostics say why.
        Where an `Update` cannot be made in place, its `apart` is made instead.
        """
        return Rendered(None, (self._cannot("change files of"),))

    def port(self, node: Node, source: SourceUnit, catalog: Catalog) -> Rendered:
        """Write a node that was loaded from files of another client library."""
        message = f"plastron cannot bring a node of `{source.library}` to `{self.name}`"
        help_ = (
            f"`plastron inspect --format plastron {source.path.name}` writes the statements of a "
            f"node like it, to be made `using {self.name}`"
        )
        return Rendered(None, (Diagnostic(codes.UNSUPPORTED_TARGET, message, help=help_),))

    def _cannot(self, what: str) -> Diagnostic:
        return Diagnostic(codes.UNSUPPORTED_TARGET, f"plastron cannot {what} `{self.name}` yet")
