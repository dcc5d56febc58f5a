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
    members: tuple[Field | Constant, ...] = (*section.constants, *section.fields)
    return [member_line(member, ros_version) for member in members]


def member_line(member: Field | Constant, ros_version: int) -> str:
    """Return the line of a field or constant, without its end."""
    if isinstance(member, Constant):
        value = member.value
        is_bare = ros_version == 1 and isinstance(value, str)
        text = str(value) if is_bare else _literal(value, ros_version)
        return f"{member.type} {member.name}={text}"
    line = f"{member.type} {member.name}"
    if isinstance(member.default, tuple):
        line += f" [{', '.join(_literal(each, ros_version) for each in member.default)}]"
    elif member.default is not None:
        line += f" {_literal(member.default, ros_version)}"
    return f"{line}  # {member.comment}" if member.comment else line


def _literal(value: Scalar, ros_version: int) -> str:
    if isinstance(value, bool):
        return str(value) if ros_version == 1 else str(value).lower()
    if not isinstance(value, str):
        return repr(value)
    # `rosidl_adapter` does not find the end of a text in a list where it has an escaped quote.
    quote = "'" if '"' in value and "'" not in value else '"'
    escaped = value.replace("\\", "\\\\").replace(quote, f"\\{quote}")
    escaped = escaped.replace("\n", "\\n").replace("\t", "\\t")
    return f"{quote}{escaped}{quote}"
