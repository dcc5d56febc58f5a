"""What a managed node does to its endpoints in its transitions, done to one more.

Source: `rclcpp_lifecycle/lifecycle_publisher.hpp` of Jazzy.
"""

from __future__ import annotations

import re

from plastron_tui.model.source import EndpointKind

from ..scopes import body_of
from .adding import Addition, variables_like

_DONE = re.compile(r"(?:->on_activate\(\)|->on_deactivate\(\)|\.reset\(\)|\s*=\s*nullptr)\s*;")


def follow_transitions(added: Addition, kind: EndpointKind, name: str) -> None:
    """Activate, deactivate and reset what is new where its like, or else any other, is."""
    like = [variable.name for _, variable in variables_like(added, kind)]
    others = [variable.name for _, variable in variables_like(added)]
    for verbs, names in (("on_", like), ("", like or others)):
        for file in added.analysis.unit.files:
            last = {}
            for scope in file.scopes:
                body = body_of(scope.node) if scope.kind == "function" else None
                for statement in body.named_children if body is not None else ():
                    text = file.syntax.word(statement)
                    own = next((x for x in names if text.startswith((x, f"this->{x}"))), None)
                    rest = text.removeprefix("this->").removeprefix(own) if own else ""
                    if own and _DONE.fullmatch(rest) and ("on_" in rest) == bool(verbs):
                        last[scope.start, rest] = statement, text.replace(own, name, 1)
            for statement, line in last.values():
                added.put_behind(file, statement, [line])
