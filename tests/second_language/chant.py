"""A client library in a language of its own, as another distribution would bring it.

A node is two files: `NAME.chanth` says what it speaks to, `NAME.chant` what it does. They may hold
several nodes. The program as a whole has a file `chorus.txt`.

    ; what talker speaks to              ; what talker does
    node talker                          node talker
      sends chatter std_msgs/String      end
      hears hymn std_msgs/String by sing
    end                                  verse sing of talker
                                           speak
                                         end
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from plastron_tui.diagnostics import Diagnostic, Span, codes
from plastron_tui.model.kinds import Client, Publisher, Service, Subscription, callback_of
from plastron_tui.model.source import (
    Add,
    EndpointKind,
    FileSet,
    Rename,
    SourceEndpoint,
    SourceNode,
    SourceUnit,
    Update,
)
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.base import Language, ReadResult, Rendered
from plastron_tui.targets.base import Target

HEADER = "{}.chanth"
_WORDS = {
    "sends": EndpointKind.PUBLISHER,
    "hears": EndpointKind.SUBSCRIPTION,
    "serves": EndpointKind.SERVICE,
    "asks": EndpointKind.CLIENT,
}
_KINDS = {
    Publisher: "sends",
    Subscription: "hears",
    Service: "serves",
    Client: "asks",
}
_NODE = re.compile(rb"^node (\w+)$", re.MULTILINE)
_END = re.compile(rb"^end$", re.MULTILINE)
_LINE = re.compile(
    rb"^  (sends|hears|serves|asks) (\S+) (\w+)/(\w+)(?: by (\w+))?(?: *;.*)?$", re.MULTILINE
)


class Chant(Language):
    name = "chant"
    title = "Chant"
    suffixes = (".chant", ".chanth")

    def is_keyword(self, word):
        return word in {"node", "verse", "end", "by", "of", "speak", *_WORDS}

    def mentioned_library(self, text):
        return "roschant" if b"node " in text else None

    def others(self, path, text):
        return (HEADER,)

    def read(self, path, files, library=None):
        header = files.get(HEADER)
        if header is None or not _NODE.search(header):
            found = Diagnostic(codes.NO_NODE, "no node in the header", file=path)
            return ReadResult(None, (found,))
        nodes = tuple(
            SourceNode(
                block.name,
                block.name,
                tuple(_endpoint(header, match) for match in block.lines),
                Span(block.start, block.end),
            )
            for block in _blocks(header)
        )
        return ReadResult(SourceUnit(path, files, "roschant", nodes))

    def command(self, file, interpreter):
        return str(interpreter), str(Path(__file__).with_name("chant_player.py")), str(file)

    def definitions(self, text, name):
        return len(re.findall(rb"^verse %b of " % name.encode(), text, re.MULTILINE))


@dataclass(frozen=True)
class _Block:
    name: str
    start: int
    end: int
    lines: tuple[re.Match[bytes], ...]


def _blocks(header):
    for match in _NODE.finditer(header):
        closing = _END.search(header, match.end())
        end = closing.start() if closing else len(header)
        yield _Block(
            match[1].decode(), match.start(), end, tuple(_LINE.finditer(header, match.end(), end))
        )


def _endpoint(header, match):
    word, name, package, type_, callback = (each and each.decode() for each in match.groups())
    return SourceEndpoint(
        _WORDS[word],
        name,
        name,
        Span(match.start(), match.end()),
        header.count(b"\n", 0, match.start()) + 1,
        InterfaceName(package, type_),
        f"{package}/{type_}",
        callback,
        file=HEADER,
    )


def _callback(endpoint):
    if not isinstance(endpoint, (Subscription, Service)):
        return None
    return endpoint.callback or "on_" + re.sub(r"\W+", "_", endpoint.name).strip("_")


def _line(endpoint):
    callback = _callback(endpoint)
    by = f" by {callback}" if callback else ""
    return f"  {_KINDS[type(endpoint)]} {endpoint.name} {endpoint.type}{by}\n".encode()


def _verse(callback, node):
    return f"\nverse {callback} of {node}\n  speak\nend\n".encode()


class ChantTarget(Target):
    api_version = 4
    name = "roschant"
    ros_version = 2
    language = Chant()

    def __init__(self, template_folder=None):
        pass

    def render(self, node, catalog):
        header = f"; what {node.name} speaks to\nnode {node.name}\n".encode()
        main = f"; what {node.name} does\nnode {node.name}\nend\n".encode()
        for endpoint in node.endpoints.values():
            header += _line(endpoint)
            if callback := _callback(endpoint):
                main += _verse(callback, node.name)
        return Rendered(FileSet((("{}.chant", main), (HEADER, header + b"end\n"))))

    def render_program(self, nodes, catalog):
        listed = "".join(sorted(f"{self.file_name(node)}\n" for node in nodes))
        return Rendered(FileSet((("chorus.txt", listed.encode()),)))

    def edit(self, source, changes, catalog):
        files = self._renamed(source.files, [each for each in changes if isinstance(each, Rename)])
        for change in (each for each in changes if not isinstance(each, Rename)):
            edited = self._edited(source._replace(files=files), change)
            if isinstance(edited, Diagnostic):
                return Rendered(None, (edited,))
            files = edited
        return Rendered(files)

    def _renamed(self, files, renames):
        """Give names to what is in the header, all at once."""
        header, found = files.get(HEADER), []
        for change in renames:
            for block in _blocks(header):
                if change.node not in (None, block.name):
                    continue
                for match in block.lines:
                    what = (_WORDS[match[1].decode()], match[2].decode())
                    if what == (change.kind, change.name):
                        found.append((match.start(2), match.end(2), change.to.encode()))
        for start, end, name in sorted(found, reverse=True):
            header = header[:start] + name + header[end:]
        return files.with_text(HEADER, header)

    def _edited(self, source, change):
        files, header = source.files, source.files.get(HEADER)
        blocks = list(_blocks(header))
        block = next((each for each in blocks if change.node in (None, each.name)), None)
        if block is None:
            return Diagnostic(codes.EDIT_REFUSED, f"there is no node `{change.node}`")
        if isinstance(change, Add):
            line = _line(change.endpoint)
            files = files.with_text(HEADER, header[: block.end] + line + header[block.end :])
            callback = _callback(change.endpoint)
            if callback and not self.language.definitions(files.main, callback):
                files = files.with_main(files.main + _verse(callback, block.name))
            return files
        for match in block.lines:
            if (_WORDS[match[1].decode()], match[2].decode()) != (change.kind, change.name):
                continue
            if isinstance(change, Update):
                return self._updated(files, match, change.endpoint, block.name)
            end = match.end() + 1
            files = files.with_text(HEADER, header[: match.start()] + header[end:])
            if match[5]:
                stub = _verse(match[5].decode(), block.name)
                files = files.with_main(files.main.replace(stub, b""))
            return files
        return Diagnostic(codes.EDIT_REFUSED, f"there is no `{change.name}`", change.span)

    def _updated(self, files, match, endpoint, node):
        """Change the words of a line that differ; the comment behind them stays."""
        header = files.get(HEADER)
        callback = callback_of(endpoint) or (match[5] and match[5].decode())
        if callback and not self.language.definitions(files.main, callback):
            files = files.with_main(files.main + _verse(callback, node))
        by = f" by {callback}" if callback else ""
        words = f"{endpoint.name} {endpoint.type}{by}".encode()
        end = match.end(5) if match[5] else match.end(4)
        return files.with_text(HEADER, header[: match.start(2)] + words + header[end:])
