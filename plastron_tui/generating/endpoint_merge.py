"""Merging what a program has now into a node's file that was changed by hand.

Three sides have a say in each endpoint: the base (what the program had when the file was last
written), the program, and the file. What only the program changed is changed in the file; what
only the user changed stays; what both changed is told, and where the two cannot stand together
the merge is refused.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from plastron_tui.diagnostics import Diagnostic, codes
from plastron_tui.model.kinds import EDITABLE, Endpoint, EndpointKey, callback_of
from plastron_tui.model.source import (
    Add,
    Change,
    FileSet,
    Remove,
    Rename,
    SourceEndpoint,
    SourceUnit,
    Update,
)
from plastron_tui.model.workspace import Node
from plastron_tui.ros.catalog import Catalog
from plastron_tui.targets.base import Target

from .call_sites import (
    asked,
    call_sites,
    changed_in_program,
    count_timers,
    differing,
    has_type,
    is_plain,
    is_shared,
    managed_changed,
    rates,
    sends,
    shown_lines,
    shown_name,
    with_callback,
)
from .language_checks import definitions, mentions
from .merged import Merged


class _RefusedError(Exception):
    """Why a merge is not possible; never leaves this module."""


def merge(
    source: SourceUnit, base: Node | None, node: Node, target: Target, catalog: Catalog
) -> Merged:
    """Bring a program's changes since `base` into a file that was changed by hand.

    Args:
        source: the file as it is now.
        base: the node that the file was last written for; None where nothing tells, and then
            endpoints are only added, and nothing that the file has is taken for Plastron's.
        node: the node as the program has it now.
        target: the client library of all three.
        catalog: the interface types.
    """
    merge = _Merge(source, base, node, target, catalog)
    try:
        return merge.result()
    except _RefusedError as refused:
        return Merged(None, str(refused), tuple(merge.notes))


@dataclass(slots=True)
class _Merge:
    """One merge, and what was decided so far."""

    source: SourceUnit
    base: Node | None
    node: Node
    target: Target
    catalog: Catalog
    renames: list[Change] = field(default_factory=list)
    adds: list[Change] = field(default_factory=list)
    updates: list[Update] = field(default_factory=list)
    removes: list[Change] = field(default_factory=list)
    resends: dict[EndpointKey, SourceEndpoint] = field(default_factory=dict)
    notes: list[Diagnostic] = field(default_factory=list)
    unsent: list[Diagnostic] = field(default_factory=list)
    lost: tuple[Diagnostic, ...] = ()
    cut: list[SourceEndpoint] = field(default_factory=list)

    def result(self) -> Merged:
        """Decide about every endpoint, and edit the file."""
        changed = managed_changed(self.source, self.base, self.node)
        if changed:
            raise _RefusedError(changed)
        file = call_sites(self.source)
        base = {} if self.base is None else self.base.endpoints
        wanted = self.node.endpoints
        renamed = self._renamed(file, base, wanted)
        for old, new in renamed.items():
            self._rename(old, base[old], wanted[new], file[old][0])
        unknown = file if self.base is None else ()
        for key in dict.fromkeys((*base, *wanted, *(x for x in unknown if is_shared(x[0])))):
            if key not in renamed and key not in renamed.values():
                self._decide(key, base.get(key), wanted.get(key), file.get(key, []))
        for change in self.updates:
            before = base[change.kind, change.name]
            if before.type != change.endpoint.type and self._sends_past(change, before):
                name = shown_name((change.kind, change.name))
                raise _RefusedError(f"so were the lines that send through the {name}")
        sending: list[Change] = []
        for key, found in self.resends.items():
            change = self._updated(key, wanted[key])
            if self._is_untouched(key, base[key]) and not self._sends_past(change, base[key]):
                sending.append(change)
            elif not self._is_untouched(key, wanted[key]):
                self._tell_unsent(key, differing(base[key], wanted[key]), found)
        files = self._edited([*self.renames, *self.adds, *self.updates, *sending, *self.removes])
        self._check_callbacks(files)
        notes = (*self.notes, *self._orphans(files))
        return Merged(files, "", notes, tuple(self.unsent), self.lost)

    def _updated(self, key: EndpointKey, wanted: Endpoint) -> Update:
        return Update(*key, wanted, node=self.source.label)

    def _renamed(
        self,
        file: Mapping[EndpointKey, list[SourceEndpoint]],
        base: Mapping[EndpointKey, Endpoint],
        wanted: Mapping[EndpointKey, Endpoint],
    ) -> dict[EndpointKey, EndpointKey]:
        """Return the endpoints that the program gave another name, and that.

        Of one kind, one that is gone and one that came are the same, if they are of one type, and
        the file has it as the program left it.
        """
        renamed = {}
        for kind in EDITABLE:
            gone = [key for key in base if key[0] is kind and key not in wanted]
            new = [key for key in wanted if key[0] is kind and key not in base]
            said = [(old, key) for old, key in self._said(new) if old in gone]
            if not said and len(gone) == len(new) == 1 and is_shared(kind):
                said = [(gone[0], new[0])]
            for old, key in said:
                found = file.get(old, [])
                is_same = len(found) == 1 and base[old].type == wanted[key].type == found[0].type
                if is_same and key not in file and self._may_rename(old, base[old], wanted[key]):
                    renamed[old] = key
        return renamed

    def _may_rename(self, old: EndpointKey, base: Endpoint, wanted: Endpoint) -> bool:
        """Tell whether nothing else is changed of an endpoint, or what is sent alone."""
        if not differing(base, wanted):
            return True
        return not self._is_of_lines(base, wanted) and (
            sends(base) == sends(wanted) or self._is_untouched(old, base)
        )

    def _said(self, new: list[EndpointKey]) -> Iterator[tuple[EndpointKey, EndpointKey]]:
        """Yield what the program says that it renames."""
        for key in new:
            if key in self.node.renamed:
                yield (key[0], self.node.renamed[key].name), key

    def _rename(
        self, old: EndpointKey, base: Endpoint, wanted: Endpoint, found: SourceEndpoint
    ) -> None:
        """Give an endpoint of the file another name; what it calls stays, unless that differs."""
        self.cut.append(found)
        if sends(base) and sends(base) == sends(wanted):
            # What was written around the lines that send stays there.
            self.renames.append(Rename(*old, wanted.name, node=self.source.label))
            return
        callback = found.callback
        if callback_of(wanted) == callback_of(base) and callback and callback.isidentifier():
            wanted = with_callback(wanted, callback)
        self.updates.append(self._updated(old, wanted))

    def _check_callbacks(self, files: FileSet) -> None:
        """Refuse files in which a callback that holds handwork has got a twin."""
        for change in self.updates:
            name = callback_of(change.endpoint)
            if name is None:
                continue
            before = definitions(self.target.language, self.source.files, name)
            if definitions(self.target.language, files, name) > max(1, before):
                raise _RefusedError(f"`{name}` cannot be called from where endpoints are added")

    def _edited(self, changes: list[Change]) -> FileSet:
        edited = self.target.edit(self.source, changes, self.catalog)
        if edited.files is not None:
            self.lost = tuple(
                each for each in edited.diagnostics if each.code == codes.WRITTEN_ANEW
            )
            return edited.files
        # What is refused in the file as it is has the lines that the user sees.
        alone = (
            self.target.edit(self.source, [change], self.catalog)
            for change in changes
            if not isinstance(change, Add)
        )
        refused = next((each for each in alone if each.files is None), edited)
        raise _RefusedError(", and ".join(found.message for found in refused.diagnostics))

    def _decide(
        self,
        key: EndpointKey,
        base: Endpoint | None,
        wanted: Endpoint | None,
        found: list[SourceEndpoint],
    ) -> None:
        if self._is_of_lines(base, wanted):
            self._decide_of_lines(key, base, wanted, found)
        elif wanted is None:
            self._remove(key, base, found)
        elif base is None:
            # An earlier version did not remember what is of no type.
            if key[0].facts.interface is not None or wanted.span is not None:
                self._add(key, wanted, found)
        elif not found:
            self._tell(f"the {shown_name(key)} was taken out by hand, and stays out")
        else:
            self._update(key, base, wanted, found)

    def _is_of_lines(self, *sides: Endpoint | None) -> bool:
        """Tell whether an endpoint of a created node is more than the calls that create it.

        Methods, values and conditions belong to it as they are written new: lines bring them.
        """
        return self.node.source is None and not all(
            each is None or is_plain(each) for each in sides
        )

    def _decide_of_lines(
        self,
        key: EndpointKey,
        base: Endpoint | None,
        wanted: Endpoint | None,
        found: list[SourceEndpoint],
    ) -> None:
        """Leave an endpoint as the file has it; refuse where it cannot do for the program's."""
        if base is not None and wanted is not None:
            if not found:
                self._tell(f"the {shown_name(key)} was taken out by hand, and stays out")
                return
            is_same = base.type == wanted.type and callback_of(base) == callback_of(wanted)
            if is_same:
                if differing(base, wanted):
                    self._tell_unsent(key, differing(base, wanted), found[0])
                return
        elif bool(found) == (wanted is not None) and all(has_type(each, wanted) for each in found):
            return
        raise _RefusedError(f"the program changes the same lines for the {shown_name(key)}")

    def _remove(self, key: EndpointKey, base: Endpoint | None, found: list[SourceEndpoint]) -> None:
        """Take out what the program no longer has, if the file still has it as it was."""
        if not found:
            return
        if base is None:
            raise _RefusedError(f"it has the {shown_name(key)}, which the program does not have")
        if len(found) > 1 and is_shared(key[0]):
            raise _RefusedError(f"the {shown_name(key)} is created in lines {shown_lines(found)}")
        if not has_type(found[0], base):
            raise _RefusedError(
                f"the {shown_name(key)}, which the program no longer has, is of type "
                f"`{found[0].type}` in line {found[0].line}"
            )
        remove = Remove(*key, node=self.source.label)
        self.removes.append(remove)
        self.cut += found
        # Whose timer it is that does other things as well is known of created nodes only.
        timers = len(rates(base)) if self.node.source is None else 0
        files = self.target.edit(self.source, [remove], self.catalog).files if timers else None
        read = None if files is None else self._read(files)
        if read is not None and count_timers(read) > max(0, count_timers(self.source) - timers):
            message = f"a timer that sent through the {shown_name(key)} is kept, and sends no more"
            self._tell(message, found[0])

    def _add(self, key: EndpointKey, wanted: Endpoint, found: list[SourceEndpoint]) -> None:
        if not found:
            self.adds.append(Add(wanted, self.source.label))
        elif not all(has_type(each, wanted) for each in found):
            raise _RefusedError(self._differing(key, wanted, found))

    def _update(
        self, key: EndpointKey, base: Endpoint, wanted: Endpoint, found: list[SourceEndpoint]
    ) -> None:
        """Bring an endpoint that all three have up to date."""
        if base.type != wanted.type:
            self._change_type(key, base, wanted, found)
        elif not all(has_type(each, wanted) for each in found):
            self._tell(
                f"the {shown_name(key)} is of type `{found[0].type}` by hand, not `{wanted.type}`",
                found[0],
            )
        elif callback_of(wanted) not in {None, callback_of(base), found[0].callback}:
            self._change_callback(key, base, wanted, found)
        elif wanted.span is not None and asked(wanted) not in (None, asked(base)):
            self.updates.append(self._updated(key, wanted))
        elif differing(base, wanted):
            self.resends[key] = found[0]

    def _change_type(
        self, key: EndpointKey, base: Endpoint, wanted: Endpoint, found: list[SourceEndpoint]
    ) -> None:
        if all(each.type == wanted.type for each in found):
            return
        if len(found) > 1:
            raise _RefusedError(f"the {shown_name(key)} is created in lines {shown_lines(found)}")
        if not has_type(found[0], base):
            raise _RefusedError(self._differing(key, wanted, found))
        callback = found[0].callback
        if callback is not None and callback.isidentifier() and callback_of(wanted) is None:
            # What was written in the callback goes on being called.
            wanted = with_callback(wanted, callback)
            if self._stays(callback, Remove(*key, node=self.source.label)):
                message = f"`{callback}` was written for `{base.type}`, and gets `{wanted.type}`"
                self._tell(message, found[0])
        self.updates.append(self._updated(key, wanted))
        self.cut += found

    def _sends_past(self, change: Update, base: Endpoint) -> bool:
        """Tell whether an update sends from other lines than those that somebody changed.

        What was written there, a condition for instance, would no longer count.
        """
        edited = self.target.edit(self.source, [change], self.catalog)
        read = None if edited.files is None else self._read(edited.files)
        if not sends(base) or read is None:
            return False
        is_anew = any(each.code == codes.WRITTEN_ANEW for each in edited.diagnostics)
        more = max(0, len(rates(change.endpoint)) - len(rates(base)))
        return is_anew or count_timers(read) > count_timers(self.source) + more

    def _change_callback(
        self, key: EndpointKey, base: Endpoint, wanted: Endpoint, found: list[SourceEndpoint]
    ) -> None:
        is_own = callback_of(base) in {None, found[0].callback}
        if len(found) > 1 or not is_own:
            message = (
                f"the {shown_name(key)} calls another function by hand than `{callback_of(wanted)}`"
            )
            self._tell(message, found[0])
            return
        self.updates.append(self._updated(key, wanted))
        self.cut += found

    def _differing(self, key: EndpointKey, wanted: Endpoint, found: list[SourceEndpoint]) -> str:
        other = next(each for each in found if not has_type(each, wanted))
        return (
            f"the {shown_name(key)} is of type `{other.type}` in line {other.line}, "
            f"but of type `{wanted.type}` in the program"
        )

    def _is_untouched(self, key: EndpointKey, base: Endpoint) -> bool:
        """Tell whether the file still sends what Plastron wrote: to send that changes nothing."""
        edited = self.target.edit(self.source, [self._updated(key, base)], self.catalog)
        return edited.files == self.source.files

    def _read(self, files: FileSet) -> SourceUnit | None:
        read = self.target.read(self.source.path, files).source
        return None if read is None else read.only(self.source.label)

    def _stays(self, callback: str, remove: Remove) -> bool:
        """Tell whether a callback outlives its endpoint: then it is more than a stub."""
        files = self.target.edit(self.source, [remove], self.catalog).files
        return files is not None and mentions(self.target.language, files, callback)

    def _orphans(self, files: FileSet) -> Iterator[Diagnostic]:
        """Tell of callbacks that are kept for what is written in them, and called no more."""
        callbacks = {each.callback for each in self.cut if each.callback is not None}
        if not callbacks:
            return
        read = self._read(files)
        used = {each.callback for each in read.endpoints} if read else set()
        for each in self.cut:
            name = each.callback or ""
            if name in callbacks - used and mentions(self.target.language, files, name):
                message = f"`{each.callback}` is kept, but no longer called"
                yield self._note(message, each, "call it from elsewhere, or remove it by hand")

    def _tell_unsent(self, key: EndpointKey, what: list[str], found: SourceEndpoint) -> None:
        self.unsent.append(self._note(changed_in_program(key, what), found))

    def _tell(self, message: str, found: SourceEndpoint | None = None) -> None:
        self.notes.append(self._note(message, found))

    def _note(
        self, message: str, found: SourceEndpoint | None, remedy: str | None = None
    ) -> Diagnostic:
        return Diagnostic(
            codes.MERGED_BY_HAND,
            message,
            None if found is None else found.span,
            self.source.path if found is None else self.source.path_of(found),
            help=remedy
            or "change the file by hand; `--force --diff` shows what would be written anew",
        )
