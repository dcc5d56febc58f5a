"""What a target is: a client library that Plastron can write, read and edit.

A target is found by the name of its client library, loaded when first used, and may come from
another distribution (the entry point group `plastron.targets`). What a target cannot do is a
diagnostic, never an exception.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

from plastron_tui.diagnostics import Diagnostic
from plastron_tui.model.source import Change, SourceFile
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog


@dataclass(frozen=True, slots=True)
class Rendered:
    """The source of a node, or why there is none (`text` is then None)."""

    text: bytes | None
    diagnostics: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True, slots=True)
class ReadResult:
    """What a file holds; `source` is None when the target cannot read the file at all."""

    source: SourceFile | None
    diagnostics: tuple[Diagnostic, ...] = ()


class Target:
    """The base of a target. What is not overridden is reported as not supported."""

    name: ClassVar[str]
    ros_version: ClassVar[int]
    suffix: ClassVar[str] = ".py"
    is_executable: ClassVar[bool] = True

    def file_name(self, node: Node) -> str:
        """Return the name of the file that a created node becomes (docs/language.md, "Files").

        The suffix tells the next reader what the node does: `_pub`, `_sub1`, `_sub2`,
        `_client`, `_server`, or `_node` for a mixture.
        """
        kinds = {
            "_pub": bool(node.publishers),
            "_sub1" if len(node.subscriptions) == 1 else "_sub2": bool(node.subscriptions),
            "_client": bool(node.clients),
            "_server": bool(node.services),
        }
        used = [suffix for suffix, is_used in kinds.items() if is_used]
        return f"{node.name}{used[0] if len(used) == 1 else '_node'}{self.suffix}"

    def render(self, node: Node, catalog: Catalog) -> Rendered:
        """Write a created node as a new source file."""
        return Rendered(None, (self._cannot("generate nodes for"),))

    def read(self, path: Path, text: bytes) -> ReadResult:
        """Read the nodes and endpoints of a source file."""
        return ReadResult(None, (self._cannot("read files of"),))

    def edit(self, source: SourceFile, changes: Sequence[Change], catalog: Catalog) -> Rendered:
        """Change a source file by splices; every byte that no splice covers stays.

        The result was read again: it parses no worse than before and shows exactly the
        endpoints that were asked for. Otherwise `text` is None and the diagnostics say why.
        """
        return Rendered(None, (self._cannot("change files of"),))

    def port(self, node: Node, source: SourceFile, catalog: Catalog) -> Rendered:
        """Write a node that was loaded from a file of another client library."""
        return Rendered(None, (self._cannot(f"bring a node of `{source.library}` to"),))

    def is_worse(self, text: bytes, *others: bytes) -> bool:
        """Tell whether a text breaks the rules of its language, which none of the others does.

        A target that cannot tell leaves it to whether the text can be read.
        """
        del text, others
        return False

    def definitions(self, text: bytes, name: str) -> int:
        """Count the functions of a name that a text defines; 0 as well where that is not known."""
        del text, name
        return 0

    def mentions(self, text: bytes, name: str) -> bool:
        """Tell whether the code of a text has a name; by default any mention counts."""
        return name.encode() in text

    def lines_of_code(self, text: bytes) -> Counter[bytes]:
        """Return the lines of a text, without their indent, that tell what it does."""
        return Counter(line.strip() for line in text.splitlines() if line.strip())

    def _cannot(self, what: str) -> Diagnostic:
        return Diagnostic("unsupported-target", f"plastron cannot {what} `{self.name}` yet")
