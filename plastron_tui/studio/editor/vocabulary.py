"""The names of a program, for completion."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

from plastron_tui.language import Program
from plastron_tui.language import statements as st
from plastron_tui.model.kinds import EDITABLE
from plastron_tui.model.rename import RENAMED
from plastron_tui.ros.interfaces import InterfaceKind

if TYPE_CHECKING:
    from plastron_tui.model.workspace import Workspace


class Vocabulary:
    """The names of a program, as it was when it was last understood."""

    def __init__(self, program: Program, workspace: Workspace) -> None:
        self._program = program
        self._workspace = workspace

    @cached_property
    def _names(self) -> Mapping[str, dict[str, str]]:
        nodes: dict[str, str] = {}
        messages: dict[str, str] = {}
        topics: dict[str, str] = {}
        services: dict[str, str] = {}
        libraries: dict[str, str] = {}
        known_topics, known_services = self._known
        for statement in self._program.statements:
            match statement:
                case st.CreateNode(name=name, variable=variable, library=library):
                    nodes[variable] = f"node '{name}'"
                    if library is not None:
                        libraries[variable] = library
                case st.Load(source=source, variable=variable):
                    nodes[variable] = f"node from {source}"
                case st.CreateMessage(variable=variable, type=type_):
                    messages[variable] = type_
                case st.Subscribe(topic=topic, type=type_) | st.Publish(topic=topic, type=type_):
                    if _agrees(type_, known_topics.get(topic)):
                        topics.setdefault(topic, type_)
                case (
                    st.ProvidesService(service=service, type=type_)
                    | st.ClientRequests(service=service, type=type_)
                ):
                    if _agrees(type_, known_services.get(service)):
                        services.setdefault(service, type_)
        topics = {**known_topics, **topics}
        services = {**known_services, **services}
        return {
            "nodes": nodes,
            "messages": messages,
            "topics": topics,
            "services": services,
            "libraries": libraries,
        }

    @property
    def _known(self) -> tuple[dict[str, str], dict[str, str]]:
        """The topics and the services that have effect, by their full types."""
        topics: dict[str, str] = {}
        services: dict[str, str] = {}
        for node in self._workspace.nodes.values():
            for kind, found in node.by_kind.items():
                known = topics if kind.facts.interface is InterfaceKind.MESSAGE else services
                for name, endpoint in found.items():
                    known.setdefault(name, str(endpoint.type or ""))
        return topics, services

    @property
    def nodes(self) -> dict[str, str]:
        """The variables of nodes, and what each is."""
        return self._names["nodes"]

    @property
    def messages(self) -> dict[str, str]:
        """The variables of messages, and the type of each as it is written."""
        return self._names["messages"]

    @property
    def topics(self) -> dict[str, str]:
        """The topics, and the type of each as it is written, empty where it is unknown."""
        return self._names["topics"]

    @property
    def services(self) -> dict[str, str]:
        """The services, and the type of each as it is written, empty where it is unknown."""
        return self._names["services"]

    def library(self, variable: str) -> str | None:
        """Return the client library that a node names."""
        return self._names["libraries"].get(variable)

    def endpoints(self, variable: str, keyword: str) -> Iterable[str]:
        """Return what a statement that takes something away from a node may name."""
        node = self._workspace.nodes.get(variable)
        if node is None:
            return ()
        ended = (kind for kind in EDITABLE if kind.editing.ending.keyword == keyword)
        return next((node.by_kind[kind] for kind in ended), ())

    def named(self, variable: str, word: str) -> list[str]:
        """Return the names that a node has of what a word of `renames` says."""
        node = self._workspace.nodes.get(variable)
        if node is None:
            return []
        names = (name for kind in RENAMED.get(word, ()) for name in node.names(kind))
        return list(dict.fromkeys(names))

    def renamable(self, variable: str) -> list[str]:
        """Return the words of `renames` for what a node has; of one that is not known, all."""
        return [word for word in RENAMED if self.named(variable, word)] or list(RENAMED)


def _agrees(written: str, known: str | None) -> bool:
    """Tell whether a type as it is written is the one that is known; a half-typed one is not."""
    return not known or written.rpartition("/")[2] == known.rpartition("/")[2]
