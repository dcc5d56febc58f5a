"""The words of the language for quality of service: what they mean, and how they are written.

Sources: the ROS 2 documentation "Quality of Service settings"; the ROS 1 wiki page
"rospy/Overview/Publishers and Subscribers" (`latch`, `queue_size`).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType
from typing import Any, NamedTuple

from plastron_tui.diagnostics.suggest import did_you_mean

from .interfaces import InterfaceName
from .qos import DEFAULT, PROFILES, Qos

MOST_SECONDS = 2.0**31 - 1
"""The longest duration, in seconds: DDS counts them in 31 bits."""

LEAST_SECONDS = 1e-9
"""The shortest duration, in seconds: ROS counts nanoseconds, and none of them mean no limit."""

MOST_MESSAGES = 2**31 - 1
"""The greatest depth, in messages: DDS counts them in 31 bits."""


class QosWord(NamedTuple):
    """A word of the language for quality of service.

    Attributes:
        word: the word.
        summary: what it means, for completion and pages.
        says: the policies that it says, which no other word may say as well.
        base: the policies that it stands for where no other word says them; one word with such
            a base is enough.
        number: the policy that the number behind it is the value of, "" where none follows.
        is_ros1: whether it means something in ROS 1.
    """

    word: str
    summary: str
    says: Qos = Qos()
    base: Qos = Qos()
    number: str = ""
    is_ros1: bool = False

    @property
    def policies(self) -> frozenset[str]:
        """The policies that the word, or its number, says."""
        return frozenset({*self.says.known, self.number} - {""})


_ALL = (
    QosWord(
        "sensor_data",
        "the newest readings, some may be lost",
        base=PROFILES["sensor_data"],
    ),
    QosWord(
        "system_default",
        "as the middleware is configured",
        base=PROFILES["system_default"],
    ),
    QosWord(
        "latched",
        "who subscribes later gets the last message",
        Qos(reliability="reliable", durability="transient_local"),
        Qos(history="keep_last", depth=1),
        is_ros1=True,
    ),
    QosWord("reliable", "what is lost is sent again", Qos(reliability="reliable")),
    QosWord("best_effort", "what is lost stays lost", Qos(reliability="best_effort")),
    QosWord("volatile", "who subscribes later gets what comes then", Qos(durability="volatile")),
    QosWord(
        "transient_local",
        "who subscribes later gets what the publisher has kept",
        Qos(durability="transient_local"),
    ),
    QosWord("keep_all", "every message is kept until it is taken", Qos(history="keep_all")),
    QosWord(
        "depth",
        "how many messages are kept",
        Qos(history="keep_last"),
        number="depth",
        is_ros1=True,
    ),
    QosWord("deadline", "the most seconds between two messages", number="deadline"),
    QosWord("lifespan", "the seconds after which a message is too old", number="lifespan"),
    QosWord("automatic", "a publisher lives while its node does", Qos(liveliness="automatic")),
    QosWord(
        "manual_by_topic",
        "a publisher lives while it says so",
        Qos(liveliness="manual_by_topic"),
    ),
    QosWord("lease", "the seconds within which a publisher shows that it lives", number="lease"),
)

WORDS: Mapping[str, QosWord] = MappingProxyType({each.word: each for each in _ALL})
"""The words of the language, in the order in which they are written."""

_LATCHED = WORDS["latched"].says


def latch_of(qos: Qos) -> bool | None:
    """Return whether a publisher of ROS 1 latches, None where it need not be said."""
    if qos.common(_LATCHED) == _LATCHED:
        return True
    return False if qos.durability == DEFAULT.durability else None


def gives(found: Qos, asked: Qos, version: int) -> bool:
    """Tell whether a topic has all policies that are asked for, those of its ROS at least."""
    if version == 1:
        latch = latch_of(asked)
        is_latched_so = None in (latch, found.durability) or latch is latch_of(found)
        return is_latched_so and asked.depth in (None, found.depth)
    wanted = asked.over(DEFAULT).known if asked.history == "keep_all" else asked.known
    return all(getattr(found, name) == value for name, value in wanted.items())


Said = tuple[str, float | None]
"""A word, and the number behind it."""


class WordProblem(NamedTuple):
    """What is wrong with a word.

    Attributes:
        at: which of the words it is.
        message: lower case, no full stop.
        help: the remedy, None when there is none to offer.
        other: which of the words it does not go with, None when it is wrong alone.
    """

    at: int
    message: str
    help: str | None = None
    other: int | None = None


def parse_words(words: Sequence[Said]) -> tuple[Qos, tuple[WordProblem, ...]]:
    """Return what words mean, and what is wrong with them; a word that is wrong means nothing.

    Args:
        words: the words with their numbers, in any order.
    """
    said = base = Qos()
    taken: list[tuple[int, QosWord]] = []
    problems: list[WordProblem] = []
    for index, (text, number) in enumerate(words):
        problem = _problem(index, text, number, taken)
        if problem is not None:
            problems.append(problem)
            continue
        word = WORDS[text]
        taken.append((index, word))
        base = word.base.over(base)
        said = word.says.over(said)
        if word.number and number is not None:
            is_depth = word.number == "depth"
            said = said.with_policy(word.number, int(number) if is_depth else float(number))
    return said.over(base), tuple(problems)


def _problem(
    index: int, text: str, number: float | None, taken: Sequence[tuple[int, QosWord]]
) -> WordProblem | None:
    word = WORDS.get(text)
    if word is None:
        help_ = did_you_mean(text, WORDS)
        return WordProblem(index, f"there is no quality of service `{text}`", help_)
    wrong = _wrong_number(word, number)
    if wrong is not None:
        return WordProblem(index, *wrong)
    for other, earlier in taken:
        if earlier is word:
            return WordProblem(index, f"`{text}` is there twice", other=other)
        if _contradict(word, earlier):
            message = f"`{text}` does not go with `{earlier.word}`"
            return WordProblem(index, message, "leave one of them out", other)
    return None


def _contradict(one: QosWord, other: QosWord) -> bool:
    """Tell whether two words say the same policy, or both stand for a set of them."""
    return not one.policies.isdisjoint(other.policies) or bool(one.base.known and other.base.known)


def _wrong_number(word: QosWord, number: float | None) -> tuple[str, str] | None:
    """Return the message and the help for a number that is missing, too much or out of range."""
    is_depth = word.number == "depth"
    example = f"write `{word.word} {10 if is_depth else 0.5}`"
    if not word.number:
        problem = (f"`{word.word}` takes no number", f"write `{word.word}`")
        return problem if number is not None else None
    if number is None:
        return f"`{word.word}` lacks its number", example
    if is_depth and (number != number // 1 or not 1 <= number <= MOST_MESSAGES):
        return f"a depth is a whole number from 1 to {MOST_MESSAGES}", example
    if not is_depth and not LEAST_SECONDS <= number <= MOST_SECONDS:
        return f"a {word.word} is from {LEAST_SECONDS:g} to {MOST_SECONDS:.0f} seconds", example
    return None


def possible_words(said: Sequence[str]) -> tuple[QosWord, ...]:
    """Return the words that may follow others: those that do not contradict them."""
    there = [WORDS[word] for word in said if word in WORDS]
    return tuple(
        word
        for word in WORDS.values()
        if word not in there and not any(_contradict(word, each) for each in there)
    )


SENSOR_TYPES = frozenset(
    f"sensor_msgs/{name}"
    for name in (
        "CameraInfo",
        "CompressedImage",
        "FluidPressure",
        "Illuminance",
        "Image",
        "Imu",
        "LaserScan",
        "MagneticField",
        "MultiEchoLaserScan",
        "NavSatFix",
        "PointCloud",
        "PointCloud2",
        "Range",
        "RelativeHumidity",
        "Temperature",
    )
)
"""The types of readings, of which the newest counts."""


def is_sensor_type(type_: InterfaceName | None) -> bool:
    """Tell whether messages of a type are the readings of a sensor."""
    return str(type_) in SENSOR_TYPES


def offered_words(
    said: Sequence[str], ros_version: int, type_: InterfaceName | None
) -> tuple[QosWord, ...]:
    """Return the words that may follow others for a type, the ones that fit it best first.

    Only those are among them that mean something in a generation of ROS.
    """
    found = [each for each in possible_words(said) if each.is_ros1 or ros_version != 1]
    is_sensor = is_sensor_type(type_)
    return tuple(sorted(found, key=lambda each: (each.word == "sensor_data") is not is_sensor))


def words_of(qos: Qos) -> tuple[Said, ...]:
    """Return the fewest words that mean a quality of service, in the order of `WORDS`.

    What no word says is left out; what is not said means what it does in `DEFAULT`.
    """
    candidates = [_words(qos, word) for word in (QosWord("", ""), *WORDS.values()) if _fits(word)]
    found = [(lost, len(words), words) for lost, words in filter(None, candidates)]
    return min(found, key=lambda each: each[:2])[2]


def _fits(word: QosWord) -> bool:
    """Tell whether words may start from one: it stands for a set of policies, or is none."""
    return not word.word or bool(word.base.known)


def _words(qos: Qos, first: QosWord) -> tuple[int, tuple[Said, ...]] | None:
    """Return the words behind a first one, and how many policies they lose.

    None where the first one says what is not meant.
    """
    meant = qos.over(DEFAULT)
    start = first.says.over(first.base)
    if any(getattr(meant, policy) != value for policy, value in first.says.known.items()):
        return None
    # What the first word brings along and is not meant has to be said away.
    wanted = qos if not first.word else Qos._make(map(_unless_same, meant, start.over(DEFAULT)))
    words: list[Said] = [(first.word, None)] if first.word else []
    for word in WORDS.values():
        value = getattr(wanted, word.number) if word.number else None
        if word.base.known or (word.number and value is None):
            continue
        is_said = all(getattr(wanted, policy) == each for policy, each in word.says.known.items())
        is_depth = word.number == "depth"
        if (is_depth or is_said) and value != math.inf and value != 0:
            words.append((word.word, value))
    parsed = parse_words(words)[0].over(DEFAULT)
    lost = sum(a != b for a, b in zip(parsed, meant, strict=True))
    return lost, tuple(words)


def _unless_same(value: Any, other: Any) -> Any:
    return None if value == other else value


@lru_cache(maxsize=256)
def text_of(qos: Qos) -> str:
    """Return a quality of service in words, as in `best_effort, depth 1`; "" for nothing known.

    What is as in `DEFAULT`, but for the depth, is left out where reliability and durability are
    known. A policy that no word says is told by its name.
    """
    shown = qos
    if qos.reliability is not None and qos.durability is not None:
        unusual = Qos._make(map(_unless_same, qos, DEFAULT))
        shown = unusual._replace(history=qos.history, depth=qos.depth)
        if qos.durability != DEFAULT.durability:
            # `latched` is both.
            shown = shown._replace(reliability=qos.reliability)
    words = words_of(shown)
    means = parse_words(words)[0].over(DEFAULT)
    texts = [_text(*each) for each in words]
    texts += [
        f"{policy} {value}"
        for policy, value in shown.known.items()
        if isinstance(value, str) and getattr(means, policy) != value
    ]
    return ", ".join(texts)


def _text(word: str, number: float | None) -> str:
    return word if number is None else f"{word} {number:.15g}"
