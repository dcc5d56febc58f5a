"""The parameters of running nodes, and what their values are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from plastron_tui.model.endpoint_details import ParameterDetails
from plastron_tui.ros.parameters import ParameterType, Setting, as_setting


def setting(value: object) -> Setting | None:
    """Return a value of JSON, YAML or XML-RPC as a parameter holds it, None for what is none."""
    type_ = _type_of(value)
    return None if type_ is None else as_setting(type_, value)


def type_of_setting(value: object) -> str | None:
    """Return the type of parameters that hold a value, None for what is none."""
    type_ = _type_of(value)
    return None if type_ is None else type_.value


def _type_of(value: object) -> ParameterType | None:
    is_list = isinstance(value, (list, tuple))
    if is_list and not value:
        return None  # it may be of any type
    types = (each for each in ParameterType if each.is_list == is_list)
    return next((each for each in types if as_setting(each, value) is not None), None)


def private_parameters(
    tree: object, nodes: Iterable[str]
) -> dict[str, dict[str, ParameterDetails]]:
    """Return the private parameters of nodes of ROS 1, by the full names of the nodes.

    Args:
        tree: all parameters of a master, by name.
        nodes: the full names of the nodes; what is below another node's name is that one's.
    """
    names = set(nodes)
    found: dict[str, dict[str, ParameterDetails]] = {}
    for name in names:
        at = tree
        for part in name.strip("/").split("/"):
            at = at.get(part) if isinstance(at, Mapping) else None
        if isinstance(at, Mapping):
            leaves = _leaves(at, name, names)
            found[name] = {
                f"~{full[len(name) :]}": ParameterDetails(type_of_setting(value), setting(value))
                for full, value in leaves
            }
    return found


def _leaves(
    tree: Mapping[str, object], name: str, others: set[str]
) -> Iterator[tuple[str, object]]:
    for part, value in tree.items():
        full = f"{name}/{part}"
        if isinstance(value, Mapping):
            if full not in others:
                yield from _leaves(value, full, others)
        else:
            yield full, value
