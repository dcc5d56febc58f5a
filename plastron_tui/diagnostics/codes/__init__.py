"""Every code that a diagnostic can have, declared once; the source of `docs/diagnostics.md`."""

from __future__ import annotations

from plastron_tui.diagnostics.code import Code

from . import (
    builds,
    files,
    launches,
    meaning,
    names,
    packages,
    robots,
    ros,
    sentences,
    types,
    values,
    xml,
)
from .builds import *  # noqa: F403
from .files import *  # noqa: F403
from .launches import *  # noqa: F403
from .meaning import *  # noqa: F403
from .names import *  # noqa: F403
from .packages import *  # noqa: F403
from .robots import *  # noqa: F403
from .ros import *  # noqa: F403
from .sentences import *  # noqa: F403
from .types import *  # noqa: F403
from .values import *  # noqa: F403
from .xml import *  # noqa: F403

GROUPS: dict[str, tuple[Code, ...]] = {
    module.__name__.rpartition(".")[2]: tuple(
        code for code in vars(module).values() if isinstance(code, Code)
    )
    for module in (
        sentences,
        names,
        meaning,
        values,
        types,
        packages,
        launches,
        robots,
        files,
        xml,
        builds,
        ros,
    )
}
"""The codes, by the module that declares them; each has the docstring that says what they share."""

CODES: dict[str, Code] = {code: code for group in GROUPS.values() for code in group}
"""The codes by their names."""
