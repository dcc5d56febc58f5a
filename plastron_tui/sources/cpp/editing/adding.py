"""One endpoint on its way into the files of a unit."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from tree_sitter import Node

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Endpoint
from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources import naming
from plastron_tui.sources.splices import indent_of, line_end, line_start

from ..analysis import Analysis, Site
from ..scopes import CppFile, Scope, Variable
from .clang_format import ClangFormat
from .include_place import add_include, is_included
from .interfaces import Interfaces
from .manner import free_name, held_by
from .place import Place, is_model
from .plans import Plan
from .style import Style, style_of
from .units import Key

_REST = re.compile(rb"[ \t]*(?://[^\n]*|/\*[^\n]*?\*/[ \t]*)?\r?\n?")


@dataclass(slots=True)
class Addition:
    """One endpoint on its way into the files of a unit.

    Attributes:
        analysis: what is known of the files.
        kind: the endpoint's kind.
        endpoint: the endpoint.
        place: where it is created.
        interfaces: what knows types.
        sites: the call sites of the node.
        taken: the names that the files have.
        label: the label of the node.
        settings: what the settings around the files say of their layout.
        plan: what is to be done.
        lines: the statements that go to the place, in order.
        hidden_functions: the methods of a private part that the class has not yet.
        hidden_members: the members of it.
    """

    analysis: Analysis
    kind: EndpointKind
    endpoint: Endpoint
    place: Place
    interfaces: Interfaces
    sites: list[Site]
    taken: set[str]
    label: str
    settings: ClangFormat = field(default_factory=ClangFormat)
    plan: Plan = field(default_factory=Plan)
    lines: list[str] = field(default_factory=list)
    hidden_functions: list[list[str]] = field(default_factory=list)
    hidden_members: list[str] = field(default_factory=list)
    _styles: dict[str, Style] = field(default_factory=dict)
    _included: set[tuple[str, str]] = field(default_factory=set)

    @property
    def is_ros2(self) -> bool:
        """Whether the files are of ROS 2."""
        return self.analysis.ros_version == 2

    @property
    def span(self) -> Span | None:
        """The statement that asks for the endpoint."""
        return self.endpoint.span

    @property
    def owner(self) -> Scope | None:
        """The class that creates the endpoint, None for a function of a namespace."""
        return self.place.owner

    @property
    def topic(self) -> str:
        """The endpoint's name as a part of identifiers."""
        return naming.words(self.endpoint.name)

    @property
    def prose(self) -> str:
        """The endpoint's name as a log may say it."""
        return naming.label(self.endpoint.name, "its topic")

    def style(self, file: CppFile) -> Style:
        """Return the layout of a file."""
        if file.name not in self._styles:
            files = self.analysis.unit.files
            self._styles[file.name] = style_of(
                file, self.analysis.ros_version, self.settings, files
            )
        return self._styles[file.name]

    def free(self, wanted: str, end: str = "") -> str:
        """Take a name that the files do not have yet."""
        return free_name(self.taken, wanted, end)

    def like(self, kind: EndpointKind | None = None) -> list[Site]:
        """Return the call sites of the node that are of a kind, as the client library has it."""
        wanted = self.kind if kind is None else kind
        return [site for site in self.sites if site.endpoint.kind is wanted and is_model(site)]

    def model(self, kind: EndpointKind | None = None) -> Site | None:
        """Return the call site that a new one of a kind is modelled on."""
        found = self.like(kind)
        beside = self.place.beside
        if beside is not None and any(each is beside for each in found):
            return beside
        here = [each for each in found if each.file is self.place.file]
        return here[-1] if here else found[-1] if found else None

    def expect(
        self, kind: EndpointKind, name: str, type_: InterfaceName | None, called: str
    ) -> None:
        """Note that a reader must find an endpoint."""
        key: Key = (kind, name, str(type_), called)
        if kind is EndpointKind.TIMER:
            key = (kind, None, "", called)
        self.plan.added.append((self.label, key))

    def include(self, file: CppFile, header: str) -> None:
        """Let a file include a header that it does not yet."""
        key = file.name, header
        if key in self._included or is_included(self.analysis.unit, file, header):
            return
        if not file.name and any(name and each == header for name, each in self._included):
            # A header of the unit, which the source includes, gets it.
            return
        self._included.add(key)
        add_include(self.plan, self.analysis.unit, file, header, self.analysis.ros_version)

    def include_types(self, file: CppFile) -> None:
        """Include the headers of the types that were written since, where they are needed."""
        for header in self.interfaces.headers:
            self.include(file, header)
        self.interfaces.headers.clear()

    def put_behind(self, file: CppFile, node: Node, lines: list[str], *, gap: bool = False) -> None:
        """Write lines behind a statement or a declaration, with an empty line before for a gap."""
        style, text = self.style(file), file.syntax.text
        end = node.end_byte
        if text[end : end + 1] == b";":
            end += 1
        indent = indent_of(text, node.start_byte).decode()
        rest = _REST.match(text, end)
        assert rest is not None, "the pattern fits everything"
        if rest.end() != line_end(text, max(end - 1, 0)):
            # What follows stands in the same line.
            written = style.newline + style.laid_out(lines, indent)
            blanks = len(text[end:]) - len(text[end:].lstrip(b" \t"))
            self.plan.replace(file, end, end + blanks, written + indent)
            return
        offset = rest.end()
        written = style.laid_out(lines, indent)
        if not text[:offset].endswith(b"\n"):
            written = style.newline + written
        if gap and style.is_spaced:
            below = text[offset : line_end(text, offset)].strip()
            is_last = not below or below.startswith((b"}", b"#"))
            written = style.newline + written + ("" if is_last else style.newline)
        self.plan.replace(file, offset, offset, written)

    def put_above(self, file: CppFile, node: Node, lines: list[str], *, gap: bool = False) -> None:
        """Write lines above a definition and the comment that speaks of it.

        Before a statement that is not the first of its line they are in that line too.
        """
        style, text = self.style(file), file.syntax.text
        offset = line_start(text, node.start_byte)
        if text[offset : node.start_byte].strip() and not gap:
            written = "".join(f"{each.strip()} " for each in lines)
            self.plan.replace(file, node.start_byte, node.start_byte, written)
            return
        while offset > 0:
            above = line_start(text, offset - 1)
            line = text[above:offset].strip()
            if not line.startswith((b"//", b"/*", b"*")) and not line.endswith(b"*/"):
                break
            offset = above
        written = style.laid_out(lines, indent_of(text, node.start_byte).decode())
        before = text[line_start(text, offset - 1) : offset].strip() if offset else b""
        if gap and before and not before.endswith(b"{"):
            written = style.newline + written
        self.plan.replace(file, offset, offset, written + (style.newline if gap else ""))

    @property
    def columns(self) -> int:
        """The columns that are taken before a statement at the place."""
        place = self.place
        node = place.after if place.after is not None else place.function.node
        blanks = indent_of(place.file.syntax.text, node.start_byte).decode()
        extra = "" if place.after is not None else self.style(place.file).indent
        return len(f"{blanks}{extra}".expandtabs(4))

    def put_at_place(self) -> None:
        """Write the statements that create the endpoint."""
        place = self.place
        if not self.lines:
            return
        if place.after is not None:
            self.put_behind(place.file, place.after, self.lines)
        else:
            put_in_body(self, place.file, place.function.node, place.body, self.lines, place.is_end)


def put_in_body(
    added: Addition, file: CppFile, owner: Node, body: Node, lines: list[str], is_end: bool
) -> None:
    """Write lines at the start or the end of a block."""
    style, text = added.style(file), file.syntax.text
    outer = indent_of(text, owner.start_byte).decode()
    inner = outer + style.indent
    written = style.laid_out(lines, inner)
    start, end = body.start_byte + 1, body.end_byte - 1
    if not text[start:end].strip():
        newline = style.newline
        comment = b"\n" in text[start:end]
        if comment:
            offset = line_end(text, start)
            added.plan.replace(file, offset, offset, written)
        else:
            opens = "{" + newline
            before = body.start_byte
            # `A() {}`: the brace goes where the file has those of its functions.
            if style.is_broken and text[line_start(text, before) : before].strip():
                blanks = len(text[:before]) - len(text[:before].rstrip(b" \t"))
                added.plan.replace(
                    file,
                    before - blanks,
                    body.end_byte,
                    f"{newline}{outer}{opens}{written}{outer}}}",
                )
            else:
                added.plan.replace(file, before, body.end_byte, f"{opens}{written}{outer}}}")
        return
    if is_end:
        offset = line_start(text, end)
        if text[offset:end].strip():
            offset = end
            written = style.newline + written + outer
        added.plan.replace(file, offset, offset, written)
        return
    offset = line_end(text, start)
    if text[start:offset].strip() and not text[start:offset].strip().startswith(b"//"):
        statement = body.named_children[0]
        blanks = statement.start_byte - start
        added.plan.replace(file, start, start + blanks, style.newline + written + inner)
        return
    added.plan.replace(file, offset, offset, written)


def variables_like(
    added: Addition, kind: EndpointKind | None = None
) -> list[tuple[Site, Variable]]:
    """Return what holds the endpoints of a kind in this node; of any kind for None."""
    sites = added.sites if kind is None else added.like(kind)
    found = ((site, held_by(added.analysis, site)) for site in sites)
    return [(site, variable) for site, variable in found if variable is not None]
