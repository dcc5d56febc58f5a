"""The quality of service that a statement asks for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plastron_tui.diagnostics import Diagnostic, Label, Severity, Span, codes
from plastron_tui.language.statements import Publish, Subscribe
from plastron_tui.ros.qos import Qos
from plastron_tui.ros.qos_words import WORDS, parse_words

from ..mistake import Mistake

if TYPE_CHECKING:
    from ..run import Run

_KEPT, _ = parse_words([("latched", None)])
"""What is sent once is kept for those who listen later."""


def qos_of(run: Run, statement: Publish | Subscribe, version: int) -> Qos | None:
    """Return the quality of service of a statement, None where it says none.

    What is sent once is kept for those who listen later. What ROS 1 has no word for is a warning
    there.
    """
    is_once = isinstance(statement, Publish) and statement.once
    if not statement.qos:
        return _KEPT if is_once else None
    spans = [
        Span(word.syntax.start_byte, word.syntax.end_byte).moved(statement.shift)
        for word in statement.qos
    ]
    found, problems = parse_words([(each.word, each.number) for each in statement.qos])
    if problems:
        raise Mistake(
            *(
                Diagnostic(
                    codes.INVALID_QOS,
                    each.message,
                    spans[each.at],
                    help=each.help,
                    labels=() if each.other is None else (Label(spans[each.other], "said here"),),
                )
                for each in problems
            )
        )
    if version == 1:
        # A profile has a depth, which is left out with the rest of it.
        known = [each for each in statement.qos if WORDS[each.word].is_ros1]
        found, _ = parse_words([(each.word, each.number) for each in known])
    if is_once:
        if found.durability not in (None, _KEPT.durability):
            raise Mistake(
                Diagnostic(
                    codes.INVALID_QOS,
                    "what is sent once is kept for those who listen later: `transient_local`",
                    statement.span_of("qos"),
                    help="write `latched`, or leave `with qos` out",
                )
            )
        found = found.over(_KEPT)
    for word, where in zip(statement.qos, spans, strict=True):
        if version == 1 and not WORDS[word.word].is_ros1:
            run.report(
                statement,
                Diagnostic(
                    codes.NOT_IN_ROS_1,
                    f"ROS 1 has nothing like `{word.word}`, which is left out",
                    where,
                    severity=Severity.WARNING,
                ),
            )
    return found if found.known else None


def agreed(
    statement: Publish, given: Qos | None, earlier: Qos | None, where: Span | None
) -> Qos | None:
    """Return what a publisher has that sends one more message: it has one quality of service.

    `where` is None for one that was read from a file: whether its calls say the same is seen when
    they are edited.
    """
    if given is None or earlier is None or given == earlier:
        return earlier if given is None else given
    if not statement.qos and given.durability == earlier.durability:
        return earlier
    if where is None:
        return given.over(earlier) if statement.qos else earlier
    message = "this node publishes to the topic with another quality of service already"
    remedy = "give it once, with the first message"
    if not statement.qos:
        message = "what is sent once is kept for those who listen later, and this topic's is not"
        remedy = "write `latched` with the quality of service of the first message"
    raise Mistake(
        Diagnostic(
            codes.INVALID_QOS,
            message,
            statement.span_of("qos" if statement.qos else "once"),
            help=remedy,
            labels=(Label(where, "given here"),),
        )
    )
