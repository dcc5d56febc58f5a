"""Write an interface as the text of a `.msg`, `.srv` or `.action` file."""

from __future__ import annotations

from .interfaces import Constant, Field, Interface, Scalar, Section


def format_definition(interface: Interface, ros_version: int) -> str:
    """Return a definition that `parse_definition` reads as this very interface."""
    lines = []
    if interface.comment:
        lines += [f"# {interface.comment}", ""]
    for number, section in enumerate(interface.sections):
        if number:
            lines.append("---")
        lines += _section(section, ros_version)
    # The description ends at the empty line, which is of no use when nothing follows.
    return "\n".join(lines).rstrip("\n") + "\n"


def _section(section: Section, ros_version: int) -> list[str]:
    lines = [_constant(constant, ros_version) for constant in section.constants]
    return lines + [_field(field) for field in section.fields]


def _constant(constant: Constant, ros_version: int) -> str:
    value = constant.value
    text = value if ros_version == 1 and isinstance(value, str) else _literal(value)
    return f"{constant.type} {constant.name}={text}"


def _field(field: Field) -> str:
    line = f"{field.type} {field.name}"
    if isinstance(field.default, tuple):
        line += f" [{', '.join(map(_literal, field.default))}]"
    elif field.default is not None:
        line += f" {_literal(field.default)}"
    return f"{line}  # {field.comment}" if field.comment else line


def _literal(value: Scalar) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if not isinstance(value, str):
        return repr(value)
    escaped = value.replace("\\", "\\\\").replace('"', '\\"')
    escaped = escaped.replace("\n", "\\n").replace("\t", "\\t")
    return f'"{escaped}"'
