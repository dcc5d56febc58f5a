"""Names at run time: the namespace and the remaps that a run gives its nodes.

Sources: the ROS wiki pages "Names" and "Remapping Arguments"; for ROS 2 the design article
"Remapping Names", and `rcl_remap_name`: a rule applies once, to names as they are resolved.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from .names import check_topic_name, resolved_name, spelled

REMAP_FORM = "FROM:=TO"

_ACTION_PARTS = {
    1: ("goal", "cancel", "status", "feedback", "result"),
    2: tuple(
        f"_action/{part}"
        for part in ("send_goal", "cancel_goal", "get_result", "feedback", "status")
    ),
}
"""What an action is made of, below its name (ROS wiki, "actionlib"; ROS 2 design, "Actions")."""


class Remap(NamedTuple):
    """A rule that gives a topic or service another name.

    Attributes:
        old: the name that nodes ask for, as programs spell it.
        new: the name that they get.
        node: the node that the rule is for, None where it is for all.
    """

    old: str
    new: str
    node: str | None = None

    @property
    def words(self) -> str:
        """The rule as a command line has it."""
        return f"{'' if self.node is None else f'{self.node}:'}{self.old}:={self.new}"

    def of_action(self, ros_version: int) -> Iterator[Remap]:
        """Yield the rules that give an action of the name the other one."""
        for part in _ACTION_PARTS[ros_version]:
            yield self._replace(old=f"{self.old}/{part}", new=f"{self.new}/{part}")


class RunNames(NamedTuple):
    """What a run says about names.

    Attributes:
        namespace: the namespace of all nodes, such as `/robot1`; "" for the root, None where
            nothing is said.
        remaps: the rules; the first that fits a name applies.
    """

    namespace: str | None = None
    remaps: tuple[Remap, ...] = ()

    def of(self, *node: str) -> RunNames:
        """Return what holds for a node that goes by these names."""
        return self._replace(remaps=tuple(one for one in self.remaps if one.node in (None, *node)))

    def full_node(self, node: str) -> str:
        """Return the full name of a node, such as `/robot1/talker`."""
        return f"{self.namespace or ''}/{node}"

    def with_actions(self, node: str, actions: Iterable[str], ros_version: int) -> RunNames:
        """Return the same with rules for the topics and services that a node's actions are."""
        full = {self.joined(node, name) for name in actions}
        meant = (one for one in self.remaps if self.joined(node, one.old) in full)
        more = tuple(rule for one in meant for rule in one.of_action(ros_version))
        return self._replace(remaps=(*self.remaps, *more))

    def joined(self, node: str, name: str) -> str:
        """Return the full name of a node's topic or service before it is remapped."""
        return resolved_name(node, name, self.namespace or "")

    def resolved(self, node: str, name: str) -> str:
        """Return the full name that a node's topic or service gets."""
        full = self.joined(node, name)
        found = (one.new for one in self.remaps if self.joined(node, one.old) == full)
        new = next(found, None)
        return full if new is None else self.joined(node, new)

    def problem(self, ros_version: int, node: str) -> str | None:
        """Return what is wrong with the names for a node, None when nothing is."""
        seen: dict[str, Remap] = {}
        for remap in self.remaps:
            wrong = _name_problem(remap.old, ros_version) or _name_problem(remap.new, ros_version)
            if wrong is not None:
                return f"`{remap.words}`: {wrong}"
            first = seen.setdefault(self.joined(node, remap.old), remap)
            if first is not remap:
                return f"`{first.words}` and `{remap.words}` are for the same name"
        if self.namespace:
            wrong = _name_problem(self.namespace, ros_version)
            return None if wrong is None else f"`{self.namespace}`: {wrong}"
        return None


AS_WRITTEN = RunNames()
"""The names of a run that says nothing about them."""


def parse_remap(text: str) -> Remap | str:
    """Return the rule that a text says, or what is wrong with its form.

    The form is that of ROS 2, `FROM:=TO` or `NODE:FROM:=TO`; what names are right is another
    question, which depends on the generation of ROS (`RunNames.problem`).
    """
    left, sign, new = text.partition(":=")
    node, colon, old = left.rpartition(":")
    if not sign or not old or not new or (colon and not node):
        return f"a remap is `{REMAP_FORM}`, or `NODE:{REMAP_FORM}` for one node"
    if old.startswith("__"):
        remedy = "`--namespace` sets it" if old == "__ns" else "it is no topic or service"
        return f"`{old}` cannot be remapped; {remedy}"
    return Remap(spelled(old), spelled(new), node or None)


def parse_namespace(text: str) -> str | None:
    """Return a namespace with a slash before each part, "" for the root; None for no namespace."""
    name = f"/{text.removeprefix('/')}".removesuffix("/")
    if not text or (name and all(check_topic_name(name, version) for version in (1, 2))):
        return None
    return name


def _name_problem(name: str, ros_version: int) -> str | None:
    if "{" in name:
        return "a name at run time has no substitutions"
    found = check_topic_name(name, ros_version)
    return None if found is None else found.message
