"""Programs of roscpp whose `main` is in one source, and the classes of whose node in others."""

from __future__ import annotations

import os
from collections.abc import Sequence

from .tree import UnitFacts


def joined(units: Sequence[UnitFacts]) -> UnitFacts | None:
    """Return the sources of one program as the one node that its `main` names.

    None where that is not sure: one source alone may start ROS, and those of the others that
    create anything for it lie beside it, so that each was read with a look at the others.
    """
    mains = [each for each in units if _starts(each)]
    if len(mains) != 1 or len(units) < 2:
        return None
    main = mains[0]
    folder = main.path.parent
    node = main.nodes[0]
    endpoints = list(node.endpoints)
    for unit in units:
        if unit is main:
            continue
        if unit.library != "roscpp" or unit.path.parent != folder or unit.is_test:
            return None
        for each in unit.nodes:
            if each.name is not None or each.class_name is None:
                return None
            endpoints += (
                endpoint._replace(file=os.path.relpath(unit.path_of(endpoint), folder))
                for endpoint in each.endpoints
            )
    is_closed = all(each.code.is_closed for each in units)
    return main._replace(
        nodes=(node._replace(endpoints=tuple(endpoints)),),
        code=main.code._replace(is_closed=is_closed),
    )


def _starts(unit: UnitFacts) -> bool:
    """Tell whether a source names the node of a program, and has no other node."""
    nodes = unit.nodes
    is_one = unit.library == "roscpp" and not unit.is_test and len(nodes) == 1
    return is_one and nodes[0].class_name is None and nodes[0].name is not None
