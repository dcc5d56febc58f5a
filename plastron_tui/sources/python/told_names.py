"""Logs, errors, comments and docstrings that spell out a name which is to be another one."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.ros.names import name_as_written

from .analysis import Analysis, Site
from .name_texts import NameText, docs_naming, is_other_name, texts_saying
from .name_uses import NameUses
from .splices import Splice


def retell(
    analysis: Analysis, wanted: Mapping[Site, str], said: Collection[int]
) -> Iterator[Splice]:
    """Yield what lets the texts that are only told say the new names of call sites.

    A name that is one plain word may mean something else there, and is left; not so a parameter's
    that something's `name` is compared with, as those do that hear of changes.

    Args:
        analysis: the file.
        wanted: the call sites, each with its new name.
        said: the ids of the strings that change as they decide a name.
    """
    kept = {site.endpoint.name for site in analysis.sites if site not in wanted}
    news: dict[str, set[str]] = {}
    parameters = set()
    for site, new in wanted.items():
        if site.endpoint.kind is EndpointKind.PARAMETER:
            parameters.add(site.endpoint.name)
        if site.endpoint.name is not None:
            news.setdefault(site.endpoint.name, set()).add(new)
    uses = NameUses(analysis, said)
    for old, found in news.items():
        if old in kept or len(found) > 1:
            continue
        for text in texts_saying(analysis, old):
            splice = _respelled(analysis, text, old, next(iter(found)))
            if splice is None or text.node.id in said:
                continue
            if text.is_whole and old in parameters and _is_compared(analysis, text.node):
                yield splice
                continue
            if not text.is_sure or is_other_name(analysis, text):
                continue
            if uses.is_harmless(text.node):
                yield splice
        yield from _redocumented(analysis, old, next(iter(found)))


def _is_compared(analysis: Analysis, text: Node) -> bool:
    """Whether the `name` of something is compared with a text."""
    parent = text.parent
    if parent is None or parent.type != "comparison_operator":
        return False
    members = [each.child_by_field_name("attribute") for each in parent.named_children]
    return any(each is not None and analysis.syntax.slice(each) == "name" for each in members)


def _redocumented(analysis: Analysis, old: str, new: str) -> Iterator[Splice]:
    """Yield what lets comments and docstrings say a new name, which say the old one for sure."""
    for said in docs_naming(analysis, old):
        prefix = _prefix(said.written)
        written = new if prefix == _prefix(old) else prefix + new.lstrip("~/")
        yield Splice(said.start, said.end, analysis.syntax.encode(written))


def _respelled(analysis: Analysis, text: NameText, old: str, new: str) -> Splice | None:
    """Return the splice of a name, which may leave out the `/` or the `~` that both begin with."""
    version, syntax = analysis.library.ros_version, analysis.syntax
    old, new = name_as_written(old, version), name_as_written(new, version)
    written = text.written
    if written == old:
        return Splice(text.start, text.end, syntax.encode(new))
    is_alike = _prefix(old) == _prefix(new) != "" and written == old[len(_prefix(old)) :]
    if not is_alike:
        return None
    return Splice(text.start, text.end, syntax.encode(new[len(_prefix(new)) :]))


def _prefix(name: str) -> str:
    return name[: len(name) - len(name.lstrip("~/"))]
