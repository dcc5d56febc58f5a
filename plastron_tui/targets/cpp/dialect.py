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
        is_split: whether its nodes have their class in a header, unless a project says otherwise.
        method_names: names that a method of a node must not have: those of its base class.
        attribute_names: names that the templates give to methods and attributes of their own.
        task_names: those of nodes with calls and actions besides.
        managed_names: the methods and attributes that a managed node has besides.
        base: the class that a node is derived from, "" for none.
        managed_base: that of a managed node.
        header: the header of the library.
        managed_header: that of managed nodes.
        action_header: that of servers and clients of actions.
    """

    library: str
    ros_version: int
    like: str = ""
    is_plugin: bool = False
    is_split: bool = False
    method_names: frozenset[str] = frozenset()
    attribute_names: frozenset[str] = frozenset()
    task_names: frozenset[str] = frozenset()
    managed_names: frozenset[str] = frozenset()
    base: str = ""
    managed_base: str = ""
    header: str = ""
    managed_header: str = ""
    action_header: str = ""

    @property
    def template_folders(self) -> tuple[str, ...]:
        """Where Plastron's own templates are looked for, the first that has one."""
        return tuple(folder for folder in (self.library, self.like, "cpp") if folder)

    @property
    def names(self) -> frozenset[str]:
        """All names that a node of the library may have already."""
        methods = self.method_names | self.managed_names
        return methods | self.attribute_names | self.task_names

    def base_of(self, *, is_managed: bool) -> str:
        """Return the class that a node is derived from."""
        return self.managed_base if is_managed else self.base
