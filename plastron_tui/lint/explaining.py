"""What is said about a rule: on the command line, and in the documentation."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from plastron_tui.diagnostics import Severity

from .rule import Files, Group, Rule

_GROUPS = {
    Group.GRAPH: ("The graph", "What is wrong between nodes that run together."),
    Group.MESSAGES: ("Messages", "What code does with messages, requests and answers."),
    Group.PARAMETERS: ("Parameters", "Parameters, and the files that set them."),
    Group.CODE: ("Code", "What is wrong in the code of one node."),
    Group.PACKAGES: ("Packages", "Packages, what they install, what they need."),
}
_SEVERITIES = {
    Severity.ERROR: "An error: it does not work.",
    Severity.WARNING: "A warning: it works badly, or by luck.",
    Severity.NOTE: "A note.",
}


_OPT_IN = "It is followed only where it is selected."


def explained(rule: Rule) -> str:
    """Return what a rule is about, as Markdown; of what is no rule what its code says."""
    if not rule.bad:
        return f"# {rule.code}\n\n{rule.why}\n"
    parts = [
        f"# {rule.code}: {rule.name}",
        rule.code.summary,
        _SEVERITIES[rule.code.severity] + (f" {_OPT_IN}" if rule.is_opt_in else ""),
        rule.why,
        *_earlier(rule),
        "## Wrong",
        _shown(rule.bad),
        "## Right",
        _shown(rule.good),
    ]
    return "\n\n".join(parts) + "\n"


def table(rules: Iterable[Rule]) -> str:
    """Return the rules in a table a group, as Markdown; each leads to a page of its own."""
    listed = tuple(rules)
    parts = []
    for group, (title, about) in _GROUPS.items():
        rows = [
            f"| [{rule.code}]({rule.code}.md) | `{rule.name}` | {rule.code.severity.value}"
            f"{', only if selected' if rule.is_opt_in else ''} | {rule.code.summary} |"
            for rule in sorted(listed, key=lambda rule: rule.code)
            if rule.group is group
        ]
        if rows:
            head = "| code | name | | what it finds |\n|---|---|---|---|"
            parts.append("\n".join((f"## {title}\n\n{about}\n\n{head}", *rows)))
    return "\n\n".join(parts) + "\n"


def _earlier(rule: Rule) -> Iterator[str]:
    """Yield what of the wrong example was otherwise at the earlier revision."""
    changed = {name: text for name, text in rule.before.items() if text != rule.bad.get(name)}
    if changed:
        yield "## At the earlier revision"
        yield _shown(changed)


def _shown(files: Files) -> str:
    return "\n\n".join(
        f"`{name}`:\n\n```{_language(name)}\n{text.rstrip()}\n```" for name, text in files.items()
    )


def _language(name: str) -> str:
    endings = {".py": "python", ".cpp": "cpp", ".hpp": "cpp", ".xml": "xml", ".launch": "xml"}
    endings |= {".yaml": "yaml", ".txt": "cmake", ".msg": "", ".srv": "", ".action": ""}
    return next((word for ending, word in endings.items() if name.endswith(ending)), "")
