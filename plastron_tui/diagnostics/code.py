"""What is said about a code."""

from __future__ import annotations

from .severity import Severity


class Code(str):
    """A kind of mistake: its stable name, what it means, and how it is made and mended.

    `bad` and `good` are programs, so that a test can run them: `bad` gives exactly this code,
    `good` gives nothing. A mistake that no program shows (a file that cannot be read, say) has
    neither, and says in `summary` what to do.

    Attributes:
        summary: what the mistake is.
        severity: how bad it is, unless a diagnostic says otherwise.
        is_io: whether it is of a file that cannot be read or written: a command then ends with
            status 2, not 1.
        bad: a program that makes it, "" where none can.
        good: the program without it.
    """

    summary: str
    severity: Severity
    is_io: bool
    bad: str
    good: str

    def __new__(
        cls,
        name: str,
        summary: str,
        *,
        severity: Severity = Severity.ERROR,
        is_io: bool = False,
        bad: str = "",
        good: str = "",
    ) -> Code:
        """Declare a code."""
        code = super().__new__(cls, name)
        code.summary, code.severity, code.is_io = summary, severity, is_io
        code.bad, code.good = bad, good
        return code
