"""The policies of quality of service, which of them match, and the words for them."""

from __future__ import annotations

import math
from itertools import combinations

import pytest

from plastron_tui.ros.qos import DEFAULT, PROFILES, Qos, common, mismatches
from plastron_tui.ros.qos_words import (
    WORDS,
    Said,
    WordProblem,
    parse_words,
    possible_words,
    text_of,
    words_of,
)

KEPT = Qos(history="keep_last", depth=5)
LATCHED = Qos("reliable", "transient_local", "keep_last", 1)

MEANINGS = {
    "": Qos(),
    "reliable": Qos(reliability="reliable"),
    "best_effort": Qos(reliability="best_effort"),
    "volatile": Qos(durability="volatile"),
    "transient_local": Qos(durability="transient_local"),
    "keep_all": Qos(history="keep_all"),
    "depth 5": KEPT,
    "deadline 0.5": Qos(deadline=0.5),
    "lifespan 2": Qos(lifespan=2.0),
    "automatic": Qos(liveliness="automatic"),
    "manual_by_topic": Qos(liveliness="manual_by_topic"),
    "lease 1.5": Qos(lease=1.5),
    "sensor_data": PROFILES["sensor_data"],
    "system_default": PROFILES["system_default"],
    "latched": LATCHED,
    "latched, depth 5": LATCHED._replace(depth=5),
    "depth 5, latched": LATCHED._replace(depth=5),
    "latched, keep_all": LATCHED._replace(history="keep_all", depth=None),
    "sensor_data, reliable": PROFILES["sensor_data"]._replace(reliability="reliable"),
    "reliable, sensor_data": PROFILES["sensor_data"]._replace(reliability="reliable"),
    "sensor_data, depth 1": PROFILES["sensor_data"]._replace(depth=1),
    "sensor_data, keep_all": PROFILES["sensor_data"]._replace(history="keep_all", depth=None),
    "best_effort, depth 5, deadline 1": KEPT._replace(reliability="best_effort", deadline=1.0),
}


def said(text: str) -> list[Said]:
    words = (each.split() for each in text.split(", ") if each)
    return [(word, float(number[0]) if number else None) for word, *number in words]


@pytest.mark.parametrize("text", MEANINGS)
def test_words_mean_policies(text: str) -> None:
    assert parse_words(said(text)) == (MEANINGS[text], ())


TWICE = "`reliable` is there twice"
PROBLEMS = {
    "relable": WordProblem(
        0, "there is no quality of service `relable`", "did you mean `reliable`?"
    ),
    "reliable, qqq": WordProblem(1, "there is no quality of service `qqq`"),
    "reliable, reliable": WordProblem(1, TWICE, other=0),
    "reliable, depth 1, best_effort": WordProblem(
        2, "`best_effort` does not go with `reliable`", "leave one of them out", 0
    ),
    "volatile, transient_local": WordProblem(
        1, "`transient_local` does not go with `volatile`", "leave one of them out", 0
    ),
    "depth 3, keep_all": WordProblem(
        1, "`keep_all` does not go with `depth`", "leave one of them out", 0
    ),
    "latched, best_effort": WordProblem(
        1, "`best_effort` does not go with `latched`", "leave one of them out", 0
    ),
    "latched, transient_local": WordProblem(
        1, "`transient_local` does not go with `latched`", "leave one of them out", 0
    ),
    "sensor_data, latched": WordProblem(
        1, "`latched` does not go with `sensor_data`", "leave one of them out", 0
    ),
    "sensor_data, system_default": WordProblem(
        1, "`system_default` does not go with `sensor_data`", "leave one of them out", 0
    ),
    "automatic, manual_by_topic": WordProblem(
        1, "`manual_by_topic` does not go with `automatic`", "leave one of them out", 0
    ),
    "depth": WordProblem(0, "`depth` lacks its number", "write `depth 10`"),
    "lease": WordProblem(0, "`lease` lacks its number", "write `lease 0.5`"),
    "reliable 3": WordProblem(0, "`reliable` takes no number", "write `reliable`"),
    **{
        f"depth {number}": WordProblem(
            0, "a depth is a whole number from 1 to 2147483647", "write `depth 10`"
        )
        for number in ("0", "-1", "1.5", "3e9", "inf", "nan")
    },
    **{
        f"deadline {number}": WordProblem(
            0, "a deadline is from 1e-09 to 2147483647 seconds", "write `deadline 0.5`"
        )
        for number in ("0", "-1", "1e-10", "3e9", "inf", "nan")
    },
}


@pytest.mark.parametrize("text", PROBLEMS)
def test_words_that_are_wrong(text: str) -> None:
    words, wrong = said(text), PROBLEMS[text]
    qos, problems = parse_words(words)
    assert problems == (wrong,)
    # What is wrong means nothing, and the rest what it does alone.
    assert qos == parse_words(words[: wrong.at] + words[wrong.at + 1 :])[0]


NUMBERS = {"depth": 3.0, "deadline": 0.25, "lifespan": 7.0, "lease": 1e-9}
SETS = [
    [(word, NUMBERS.get(word)) for word in words]
    for count in range(5)
    for words in combinations(WORDS, count)
]
RIGHT = [words for words in SETS if not parse_words(words)[1]]


def test_words_are_written_as_they_are_meant() -> None:
    assert len(RIGHT) > 500
    for words in RIGHT:
        meant = parse_words(words)[0]
        written = words_of(meant)
        qos, problems = parse_words(written)
        assert problems == ()
        assert qos.over(DEFAULT) == meant.over(DEFAULT)
        assert words_of(qos) == written
        assert len(written) <= len(words)
        assert parse_words(words[::-1])[0] == meant


def test_every_profile_that_has_words_is_what_they_mean() -> None:
    for name, profile in PROFILES.items():
        if name != "best_available":
            assert parse_words(words_of(profile))[0].over(DEFAULT) == profile


def test_the_words_that_may_follow_are_those_that_are_right_then() -> None:
    for words in RIGHT:
        there = [word for word, _ in words]
        right = [word for word in WORDS if not parse_words([*words, (word, NUMBERS.get(word))])[1]]
        assert [each.word for each in possible_words(there)] == right


TEXTS = {
    DEFAULT: "depth 10",
    Qos(): "",
    Qos("reliable", "volatile"): "",
    Qos(reliability="reliable"): "reliable",
    PROFILES["sensor_data"]: "sensor_data",
    PROFILES["system_default"]: "system_default",
    DEFAULT._replace(reliability="best_effort", depth=1): "best_effort, depth 1",
    LATCHED: "latched",
    LATCHED.over(DEFAULT)._replace(depth=7, deadline=0.5): "latched, depth 7, deadline 0.5",
    DEFAULT._replace(durability=None): "reliable, depth 10",
    DEFAULT._replace(history="keep_all", depth=None): "keep_all",
    DEFAULT._replace(reliability="best_effort", durability="transient_local"): (
        "best_effort, transient_local, depth 10"
    ),
    DEFAULT._replace(reliability="system_default"): "system_default, volatile, depth 10",
    PROFILES["best_available"]: (
        "depth 10, reliability best_available, durability best_available, liveliness best_available"
    ),
}


@pytest.mark.parametrize("qos", TEXTS, ids=TEXTS.get)
def test_what_people_are_shown(qos: Qos) -> None:
    assert text_of(qos) == TEXTS[qos]


def test_what_ros_1_has_words_for() -> None:
    assert [word for word, each in WORDS.items() if each.is_ros1] == ["latched", "depth"]


MATCHES = {
    # policy: what the publisher has, what the subscription has, and whether they may match.
    "reliability": [
        ("best_effort", "best_effort", True),
        ("best_effort", "reliable", False),
        ("reliable", "best_effort", True),
        ("reliable", "reliable", True),
    ],
    "durability": [
        ("volatile", "volatile", True),
        ("volatile", "transient_local", False),
        ("transient_local", "volatile", True),
        ("transient_local", "transient_local", True),
    ],
    "liveliness": [
        ("automatic", "automatic", True),
        ("automatic", "manual_by_topic", False),
        ("manual_by_topic", "automatic", True),
        ("manual_by_topic", "manual_by_topic", True),
    ],
    "deadline": [
        (math.inf, math.inf, True),
        (math.inf, 1.0, False),
        (1.0, math.inf, True),
        (1.0, 1.0, True),
        (2.0, 1.0, False),
        (1.0, 2.0, True),
    ],
    "lifespan": [(math.inf, 1.0, True), (1.0, math.inf, True), (2.0, 1.0, True)],
    "history": [("keep_last", "keep_all", True), ("keep_all", "keep_last", True)],
    "depth": [(1, 10, True), (10, 1, True)],
}
MATCHES["lease"] = MATCHES["deadline"]
PAIRS = [(policy, *pair) for policy, pairs in MATCHES.items() for pair in pairs]


@pytest.mark.parametrize(("policy", "has", "wants", "may_match"), PAIRS)
def test_what_a_publisher_has_to_offer(
    policy: str, has: object, wants: object, may_match: bool
) -> None:
    offered, requested = (DEFAULT.with_policy(policy, each) for each in (has, wants))
    expected = [] if may_match else [(policy, has, wants)]
    assert [*mismatches(offered, requested)] == expected


@pytest.mark.parametrize("policy", Qos._fields)
@pytest.mark.parametrize("open_", [None, "system_default", "best_available"])
def test_what_is_not_known_is_no_mismatch(policy: str, open_: str | None) -> None:
    if open_ is not None and policy not in ("reliability", "durability", "liveliness"):
        open_ = None
    weak = Qos("best_effort", "volatile", "keep_last", 1, 2.0, 2.0, "automatic", 2.0)
    strong = Qos("reliable", "transient_local", "keep_last", 1, 1.0, 1.0, "manual_by_topic", 1.0)
    all_ = {each.policy for each in mismatches(weak, strong)}
    assert all_ == {"reliability", "durability", "liveliness", "deadline", "lease"}
    for pair in (
        (weak.with_policy(policy, open_), strong),
        (weak, strong.with_policy(policy, open_)),
    ):
        assert {each.policy for each in mismatches(*pair)} == all_ - {policy}


def test_the_policies_that_several_have_in_common() -> None:
    assert common([KEPT, KEPT._replace(depth=1)]) == Qos(history="keep_last")
    assert common([KEPT, None]) is None
    assert common([KEPT, Qos(depth=1)]) is None
