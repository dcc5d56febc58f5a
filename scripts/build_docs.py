"""Write the parts of the documentation that follow from the source.

python scripts/build_docs.py            writes docs/language.md, docs/diagnostics.md, docs/rules/
python scripts/build_docs.py --check    exits with 1 when they are not what they should be
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from language_prose import LANGUAGE_HEAD, LANGUAGE_TAIL, STATEMENTS_HEAD
from robot_prose import ROBOTS

from plastron_tui.diagnostics import Code
from plastron_tui.diagnostics.codes import GROUPS
from plastron_tui.language import DECLARATIONS, Declaration, Slot
from plastron_tui.language.keywords import KEYWORDS
from plastron_tui.lint.explaining import explained, table
from plastron_tui.lint.rules import RULES
from plastron_tui.ros.qos_words import WORDS
from plastron_tui.ros.robots.colors import NAMES

DOCS = Path(__file__).resolve().parent.parent / "docs"

_DIAGNOSTICS_HEAD = """\
# Diagnostics

What Plastron reports, by the code in brackets: `error[unknown-node]`. An error keeps a program from
generating anything; a warning does not. A command ends with status 1 when there are errors, and
with status 2 when a file cannot be read or written.

"""

_SECTIONS = {
    "sentences": ("Sentences", "Lines that are no statement."),
    "names": ("Names and types", "What a statement names."),
    "meaning": ("Meaning", "What a statement does."),
    "values": ("Values", "What messages and requests hold."),
    "types": ("Types of one's own", "Messages, services and actions that the program makes."),
    "packages": ("Packages", "What a robot's workspace takes."),
    "launches": ("Launch files", "What starts nodes together."),
    "robots": ("Robots", "Links, joints, and what they are made of."),
    "files": ("Files", "What is read and written."),
    "xml": ("XML files", "Packages, launch files and plugin descriptions that exist."),
    "builds": ("Build files", "What packages that exist are built with."),
    "ros": ("ROS", "What is installed, and what runs."),
}


def language_page() -> str:
    """Return the language on one page, from the declarations of its statements."""
    statements = "\n".join(map(_statement, DECLARATIONS.values()))
    words = ", ".join(f"`{word}`" for word in sorted(KEYWORDS, key=str.lower))
    keywords = f"The keywords, which are no variables: {words}.\n\n"
    tail = LANGUAGE_TAIL.replace("@QOS@\n", "\n".join(_qos_rows()))
    colors = ", ".join(f"`{name}`" for name in NAMES)
    tail = tail.replace("@ROBOTS@\n", ROBOTS.replace("@COLORS@", colors))
    return LANGUAGE_HEAD + keywords + STATEMENTS_HEAD + statements + "\n" + tail


def _qos_rows() -> Iterator[str]:
    yield "| word | what it means | ROS 1 |"
    yield "|---|---|---|"
    for word in WORDS.values():
        number = {"": "", "depth": " NUMBER"}.get(word.number, " SECONDS")
        yield f"| `{word.word}{number}` | {word.summary} | {'too' if word.is_ros1 else ''} |"
    yield "\n"


def _statement(declaration: Declaration) -> str:
    lines = [
        f"### `{declaration.keyword}`",
        "",
        declaration.summary,
        "",
        "```text",
        declaration.usage,
        "```",
        "",
    ]
    lines += [f"- {_placeholder(slot)}: {slot.help}" for slot in declaration.slots]
    lines += ["", "```plastron", declaration.example, "```", ""]
    return "\n".join(lines)


def _placeholder(slot: Slot) -> str:
    return " or ".join(f"`{part}`" for part in slot.placeholder.split(" | "))


def diagnostics_page() -> str:
    """Return the list of all codes, by theme."""
    return _DIAGNOSTICS_HEAD + "\n".join(_diagnostics()).rstrip() + "\n"


def _diagnostics() -> Iterator[str]:
    for group, declared in GROUPS.items():
        title, about = _SECTIONS[group]
        yield f"## {title}\n\n{about}\n"
        yield from map(_code, declared)


def _code(code: Code) -> str:
    status = " A command then ends with status 2." if code.is_io else ""
    text = f"### `{code}`\n\n{code.summary}{status}\n"
    for label, program in (("Wrong", code.bad), ("Right", code.good)):
        if program:
            text += f"\n{label}:\n\n```plastron\n{program}```\n"
    return text


_RULES_HEAD = """\
# Rules

What [`plastron lint`](../commands.md#plastron-lint) finds in a workspace that exists, without building
or running it. A rule is named by its code, by what codes begin with (`RG`), or by its name; `plastron
lint --explain CODE` shows its page. What is not sure is not told.

"""


def rules_page() -> str:
    """Return the table of all rules."""
    return _RULES_HEAD + table(RULES.values())


PAGES: dict[str, Callable[[], str]] = {
    "language.md": language_page,
    "diagnostics.md": diagnostics_page,
    "rules/README.md": rules_page,
    **{f"rules/{rule.code}.md": partial(explained, rule) for rule in RULES.values()},
}
"""The files in `docs` that this script writes."""


def main(arguments: list[str]) -> int:
    """Write the pages, or with `--check` compare them; return the exit status."""
    if arguments not in ([], ["--check"]):
        print(__doc__, file=sys.stderr)
        return 2
    stale = []
    for name, page in PAGES.items():
        path = DOCS / name
        text = page()
        if path.is_file() and path.read_text(encoding="utf-8") == text:
            continue
        stale.append(name)
        if not arguments:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="\n")
    for path in sorted(DOCS.glob("rules/*.md")):
        name = path.relative_to(DOCS).as_posix()
        if name not in PAGES:
            stale.append(name)
            if not arguments:
                path.unlink()
    if arguments and stale:
        print(f"out of date: {', '.join(stale)}; run scripts/build_docs.py", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
