"""What a robot's file leaves to macros, for people and as JSON."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from plastron_tui.diagnostics.wording import counted, shortened
from plastron_tui.ros.robots.macros import (
    Include,
    Macro,
    MacroCall,
    Macros,
    Parameter,
)

_LONGEST = 200


def macro_rows(macros: Macros) -> Iterator[tuple[str, str, str]]:
    """Yield what there is in the words of xacro: a kind, a name, and what is said of it."""
    for kind, name, said in _rows(macros):
        yield kind, _on_a_line(name), _on_a_line(said)


def _on_a_line(text: str) -> str:
    return shortened(" ".join(text.split()), _LONGEST)


def _rows(macros: Macros) -> Iterator[tuple[str, str, str]]:
    for include in macros.includes:
        yield "include", include.file, _told(include)
    for argument in macros.arguments:
        yield "argument", argument.name, "" if argument.value is None else argument.value
    for each in macros.properties:
        yield "property", each.name, "elements" if each.value is None else each.value
    for macro in macros.macros:
        parameters = " ".join(map(_parameter, macro.parameters))
        yield "macro", f"{macro.name} {parameters}".rstrip(), made_words(macros, macro)
    for call in macros.calls:
        yield "call", call.macro, call_words(call)


def made_words(macros: Macros, macro: Macro) -> str:
    """Say how much a macro makes: `1 link, 2 joints`; as far as that can be told."""
    made = macros.made_by(macro.name)
    links, joints = (macro.links, macro.joints) if made is None else made
    words = f"{counted(links, 'link')}, {counted(joints, 'joint')}"
    return words if made is not None else f"{words} and more"


def call_words(call: MacroCall) -> str:
    """Say what a macro is called with: `side="left" radius="0.1"`."""
    return " ".join(f'{name}="{value}"' for name, value in call.arguments)


def macros_json(macros: Macros) -> dict[str, Any]:
    """Describe macros as JSON; what is computed is as it is written."""
    return {
        "includes": [
            {"file": each.file, "line": each.line, "optional": each.is_optional}
            for each in macros.includes
        ],
        "arguments": [each._asdict() for each in macros.arguments],
        "properties": [each._asdict() for each in macros.properties],
        "macros": [
            {
                "name": each.name,
                "parameters": [
                    {"name": x.name, "default": x.default, "block": x.is_block}
                    for x in each.parameters
                ],
                "links": each.links,
                "joints": each.joints,
                "calls": list(map(_call_json, each.calls)),
                "line": each.line,
            }
            for each in macros.macros
        ],
        "calls": list(map(_call_json, macros.calls)),
        "conditions": macros.conditions,
    }


def _call_json(call: MacroCall) -> dict[str, Any]:
    return {"macro": call.macro, "arguments": dict(call.arguments), "line": call.line}


def _told(include: Include) -> str:
    told = []
    if include.is_optional:
        told.append("if it is there")
    if not include.is_certain:
        told.append("on a condition, or in a macro")
    if include.namespace:
        told.append(f"as {include.namespace}")
    return ", ".join(told)


def _parameter(parameter: Parameter) -> str:
    name = f"*{parameter.name}" if parameter.is_block else parameter.name
    return name if parameter.default is None else f"{name}:={parameter.default}"
