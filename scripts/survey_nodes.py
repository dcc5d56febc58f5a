#!/usr/bin/env python3
"""Edit every Python node that this machine holds, and check that nothing else changes.

    scripts/survey_nodes.py [FOLDER...]

Each node is read, and every statement's edit is made on it, in memory only: a publisher, a
subscription, a service and a client are added, with new functions and with functions that are
there; every named endpoint is removed; what was added is removed, what was removed is added.
Prints a table, and exits 1 where an invariant does not hold.
"""

from __future__ import annotations

import argparse
import sys
import sysconfig
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from survey_checks import Text, check, names_at_fault

from plastron_tui.diagnostics import Diagnostic, Span
from plastron_tui.model.kinds import (
    EDITABLE,
    Client,
    Message,
    Publication,
    Publisher,
    Request,
    Service,
    Subscription,
)
from plastron_tui.model.source import Add, Change, EndpointKind, FileSet, Remove, Rename, SourceUnit
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.targets import find_target, read_source

MOST_BYTES = 400_000
"""A larger file is no node that a person wrote."""

_AT = Span(0, 0)
_STRING = InterfaceName("std_msgs", "String")
_TWIST = InterfaceName("geometry_msgs", "Twist")
_SET_BOOL = InterfaceName("std_srvs", "SetBool")
_TRIGGER = InterfaceName("std_srvs", "Trigger")
_DISTRIBUTIONS = {"rospy": "noetic", "rclpy": "jazzy"}


@dataclass
class Tally:
    """What the survey has seen so far."""

    files: int = 0
    nodes: int = 0
    endpoints: Counter[str] = field(default_factory=Counter)
    edits: Counter[str] = field(default_factory=Counter)
    refusals: Counter[str] = field(default_factory=Counter)
    refused: list[str] = field(default_factory=list)
    violations: list[str] = field(default_factory=list)
    results: list[tuple[str, bytes, bytes]] = field(default_factory=list)


def default_folders() -> list[Path]:
    """Return where Debian and this interpreter keep Python code."""
    found = [Path("/usr/lib/python3/dist-packages"), Path(sysconfig.get_paths()["purelib"])]
    # Debian keeps the executables of a ROS package in a folder of the package's name.
    libraries = Path("/usr/lib")
    if libraries.is_dir():
        found += [f for f in sorted(libraries.iterdir()) if (Path("/usr/share") / f.name).is_dir()]
    found += [Path("/usr/share/rostest")]
    return [folder for folder in found if folder.is_dir()]


def node_files(folders: Sequence[Path]) -> Iterator[Path]:
    """Yield the Python files that mention a client library, each text once."""
    seen: set[bytes] = set()
    for folder in folders:
        for path in sorted(folder.rglob("*")):
            if path.suffix not in (".py", "") or not path.is_file() or path.is_symlink():
                continue
            if path.stat().st_size > MOST_BYTES:
                continue
            text = path.read_bytes()
            if b"rospy" not in text and b"rclpy" not in text:
                continue
            if path.suffix == "" and not text.startswith(b"#!"):
                continue
            if text not in seen:
                seen.add(text)
                yield path


def additions(existing: str | None) -> dict[str, Change]:
    """Return an addition for each kind of statement; one calls a function that exists."""
    sent = Publication(Message("m", MessageValue(_STRING, {"data": "hello"}), _AT), 10.0)
    changes: dict[str, Change] = {
        "add publisher": Add(Publisher("plastron_out", _STRING, (sent,), _AT)),
        "add subscription": Add(Subscription("plastron_in", _TWIST, None, _AT)),
        "add service": Add(Service("plastron_set", _SET_BOOL, None, _AT)),
        "add client": Add(
            Client("plastron_call", _TRIGGER, (Request(MessageValue(_TRIGGER, {})),), _AT)
        ),
    }
    if existing is not None:
        changes["add calling"] = Add(Subscription("plastron_in", _STRING, existing, _AT))
    return changes


class Survey:
    """Reads and edits one file after the other."""

    def __init__(self) -> None:
        self.tally = Tally()
        self._catalogs = {name: Catalog(each) for name, each in _DISTRIBUTIONS.items()}

    def visit(self, path: Path) -> None:
        """Read a file, and make every edit on it."""
        source = read_source(path, FileSet.single(".py", path.read_bytes())).source
        if source is None or not source.nodes:
            return
        tally = self.tally
        tally.files += 1
        tally.nodes += len(source.nodes)
        tally.endpoints.update(e.kind.value for e in source.endpoints)
        original = Text(source)
        if self._edit(source, []) != source.files.main:
            tally.violations.append(f"{path}: no change changes the file")
        for what, change in additions(_callback(source)).items():
            text = self._change(original, what, change)
            if text is not None and isinstance(change, Add):
                removal = _removal(change)
                restored = self._change(text, f"{what}, then remove", removal)
                # A function of a name that the file has elsewhere is kept: it may be meant there.
                is_kept = what == "add calling" and _functions(text) != _functions(original)
                if restored and not is_kept and _lines(restored.source) != _lines(source):
                    tally.violations.append(f"{path}: {what}, then remove: not what it was")
                self._compare_at_once(original, (change, removal), restored)
        for kind, name in sorted(_named(source), key=lambda key: (key[0].value, key[1])):
            if kind in EDITABLE:
                self._remove(original, kind, name)
            self._rename(original, kind, name)

    def _rename(self, original: Text, kind: EndpointKind, name: str) -> None:
        what = f"rename {kind.value.removesuffix('s')}"
        renamed = self._change(original, what, Rename(kind, name, "plastron_name", _AT))
        if renamed is not None:
            back = Rename(kind, "plastron_name", name, _AT)
            self._change(renamed, f"{what} and back", back)

    def _remove(self, original: Text, kind: EndpointKind, name: str) -> None:
        what = f"remove {kind.value.removesuffix('s')}"
        removal = Remove(kind, name, _AT)
        removed = self._change(original, what, removal)
        if removed is None:
            return
        again = _addition(kind, name, original.source)
        if again is not None and removed.source.nodes:
            added = self._change(removed, f"{what}, then add", again)
            self._compare_at_once(original, (removal, again), added)

    def _compare_at_once(
        self, original: Text, changes: tuple[Change, ...], in_steps: Text | None
    ) -> None:
        """Two changes of one edit must give what they give one after the other."""
        if in_steps is None or (at_once := self._edit(original.source, changes)) is None:
            return
        if _unbroken(at_once) != _unbroken(in_steps.source.files.main):
            path = original.source.path
            self.tally.violations.append(f"{path}: two changes at once differ from two steps")

    def _edit(self, source: SourceUnit, changes: Sequence[Change]) -> bytes | None:
        return self._render(source, changes)[0]

    def _render(
        self, source: SourceUnit, changes: Sequence[Change]
    ) -> tuple[bytes | None, tuple[Diagnostic, ...]]:
        target = find_target(source.library)
        assert target is not None
        rendered = target.edit(source, changes, self._catalogs[source.library])
        files = rendered.files
        return None if files is None else files.main, rendered.diagnostics

    def _change(self, before: Text, what: str, change: Change) -> Text | None:
        tally, path = self.tally, before.source.path
        tally.edits[what] += 1
        try:
            text, diagnostics = self._render(before.source, [change])
        except Exception as error:  # any exception is a violation, and the survey goes on
            tally.violations.append(f"{path}: {what}: {error!r}")
            return None
        if text is None:
            if not diagnostics:
                tally.violations.append(f"{path}: {what}: refused without a reason")
                return None
            tally.refusals[f"{what}: {diagnostics[0].code}"] += 1
            tally.refused.append(f"{path}: {what}: {diagnostics[0].message}")
            return None
        source = read_source(path, FileSet.single(".py", text)).source
        after = Text(source) if source is not None else None
        if after is None:
            if any(True for _ in before.source.endpoints):
                return None  # the last endpoint is gone, and with it the only import
            tally.violations.append(f"{path}: {what}: cannot be read again")
            return None
        for problem in check(before, after, change):
            tally.violations.append(f"{path}: {what}: {problem}")
        tally.results.append((f"{path}: {what} {_name_of(change)}", before.source.files.main, text))
        return after


def _named(source: SourceUnit) -> set[tuple[EndpointKind, str]]:
    return {
        (endpoint.kind, endpoint.name)
        for node in source.nodes
        for endpoint in node.endpoints
        if endpoint.name is not None
    }


def _lines(source: SourceUnit) -> list[bytes]:
    """Return the lines that tell: not blank ones, nor imports of the library, which may stay."""
    libraries = (b"import rospy", b"import rclpy", b"from rospy import", b"from rclpy import")
    lines = map(bytes.strip, source.files.main.splitlines())
    return [line for line in lines if line and not line.startswith(libraries)]


def _unbroken(text: bytes) -> bytes:
    """Return a text without what breaks lines: how long they may be, a removal may change."""
    return b"".join(text.split()).replace(b",)", b")")


def _functions(text: Text) -> int:
    return text.source.files.main.count(b"def ")


def _callback(source: SourceUnit) -> str | None:
    """Return a function of the file that one of its subscriptions calls."""
    for node in source.nodes:
        for endpoint in node.of_kind(EndpointKind.SUBSCRIPTION):
            if endpoint.callback and f"def {endpoint.callback}(".encode() in source.files.main:
                return endpoint.callback
    return None


def _name_of(change: Change) -> str:
    return change.name if isinstance(change, Remove | Rename) else change.endpoint.name


def _removal(change: Add) -> Remove:
    kinds = {
        Publisher: EndpointKind.PUBLISHER,
        Subscription: EndpointKind.SUBSCRIPTION,
        Service: EndpointKind.SERVICE,
        Client: EndpointKind.CLIENT,
    }
    return Remove(kinds[type(change.endpoint)], _name_of(change), _AT)


def _addition(kind: EndpointKind, name: str, source: SourceUnit) -> Add | None:
    """Return the addition of an endpoint that the file had; None where its type is not known."""
    found = next(e for node in source.nodes for e in node.of_kind(kind) if e.name == name)
    if found.type is None:
        return None
    if kind is EndpointKind.PUBLISHER:
        return Add(Publisher(name, found.type, (), _AT))
    if kind is EndpointKind.SUBSCRIPTION:
        return Add(Subscription(name, found.type, None, _AT))
    if kind is EndpointKind.SERVICE:
        return Add(Service(name, found.type, None, _AT))
    return Add(Client(name, found.type, (), _AT))


def table(tally: Tally, seconds: float) -> str:
    """Return the summary."""
    rows = [("files", tally.files), ("nodes", tally.nodes)]
    rows += [(f"  {kind}", count) for kind, count in sorted(tally.endpoints.items())]
    rows.append(("edits", sum(tally.edits.values())))
    rows += [(f"  {what}", count) for what, count in sorted(tally.edits.items())]
    rows.append(("refused", sum(tally.refusals.values())))
    rows += [(f"  {why}", count) for why, count in sorted(tally.refusals.items())]
    rows += [("violations", len(tally.violations)), ("seconds", round(seconds))]
    width = max(len(name) for name, _ in rows)
    return "\n".join(f"{name:<{width}}  {count:>6}" for name, count in rows)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the survey; return 1 where an invariant does not hold."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0] if __doc__ else None)
    parser.add_argument("folders", nargs="*", type=Path, metavar="FOLDER")
    parser.add_argument("--refusals", action="store_true", help="list each refusal")
    given = parser.parse_args(arguments)
    start = time.monotonic()
    survey = Survey()
    for path in node_files(given.folders or default_folders()):
        survey.visit(path)
    tally = survey.tally
    with tempfile.TemporaryDirectory() as folder:
        tally.violations += names_at_fault(tally.results, Path(folder))
    print(table(tally, time.monotonic() - start))
    for line in tally.refused if given.refusals else ():
        print("refused:", line)
    for line in tally.violations:
        print("violation:", line, file=sys.stderr)
    return 1 if tally.violations else 0


if __name__ == "__main__":
    sys.exit(main())
