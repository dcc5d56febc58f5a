"""How the tables of seeds are written."""

from __future__ import annotations

from collections.abc import Callable

from seeded_workspaces import HERE, Edit, Seed

_OPTIONS = {
    "RG107": ("--select", "RG107"),
    "RG108": ("--select", "RG108"),
    "RG109": ("--select", "RG109"),
    "RG110": ("--select", "RG110"),
    "RK508": ("--against", "HEAD"),
}
"""How the rules are asked for that are not followed without."""


def seeds_of(workspace: str) -> Callable[..., Seed]:
    """Return what makes a seed of a workspace.

    It takes a code and the edits, each a file, what it has and what it gets. Where no edit marks
    a line with `HERE`, and no other place is given, it is the first line that the first edit makes.
    """

    def seed(
        code: str,
        *edits: tuple[str, str | None, str | None],
        at: tuple[tuple[str, str], ...] = (),
        also: str = "",
        mode: str = "",
        missed: str = "",
    ) -> Seed:
        if not at and not any(HERE in (new or "") for _, _, new in edits):
            file, old, new = edits[0]
            text = new or ""
            blank = len(text) - len(text.lstrip("\n"))
            edits = ((file, old, text[:blank] + HERE + text[blank:]), *edits[1:])
        return Seed(
            code,
            workspace,
            tuple(Edit(*edit) for edit in edits),
            at,
            tuple(also.split()),
            _OPTIONS.get(code, ()),
            mode,
            missed,
        )

    return seed
