"""How the client libraries for C++ differ in the names that their nodes have."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Dialect:
    """A client library for C++.

    Attributes:
        library: its name, which is the folder of its templates too.
        ros_version: 1 or 2.
        like: the client library whose templates serve where it has none of its own, "" for none.
        is_plugin: whether its nodes are loaded into a process of others.
        method_names: names that a method of a node must not have: those of its base class.
        attribute_names: names that the templates give to methods of their own.
    """

    library: str
    ros_version: int
    like: str = ""
    is_plugin: bool = False
    method_names: frozenset[str] = frozenset()
    attribute_names: frozenset[str] = frozenset()

    @property
    def template_folders(self) -> tuple[str, ...]:
        """Where Plastron's own templates are looked for, the first that has one."""
        return tuple(folder for folder in (self.library, self.like, "cpp") if folder)
