"""The words by which a publisher and a subscription of ROS 2 come to match."""

from __future__ import annotations

from collections.abc import Sequence

from .qos import DEFAULT, Qos, mismatches
from .qos_words import parse_words, text_of, words_of


def words_to_hear(offers: Sequence[Qos]) -> str:
    """Return the words of a subscription that hears all publishers of a topic.

    It is "" where no words are needed to hear one of them, and where none do.
    """
    if not offers or not all(mismatches(each, DEFAULT) for each in offers):
        return ""
    texts = (text_of(each) for each in offers if _hears(offers, each))
    return next(texts, "")


def _hears(offers: Sequence[Qos], asked: Qos) -> bool:
    meant = parse_words(words_of(asked))[0].over(DEFAULT)
    return not any(mismatches(each, meant) for each in offers)


def words_to_ask(offered: Qos, requested: Qos) -> str:
    """Return the words of a subscription that asks for no more than is offered, "" for none."""
    found = mismatches(offered, requested.over(DEFAULT))
    less = requested
    for each in found:
        less = less.with_policy(each.policy, each.offered)
    meant = parse_words(words_of(less))[0].over(DEFAULT)
    return "" if mismatches(offered, meant) else text_of(less)


def words_to_offer(offered: Qos, requested: Qos) -> str:
    """Return the words of a publisher that offers as much as is asked for, "" for none."""
    found = mismatches(offered.over(DEFAULT), requested)
    more = offered
    for each in found:
        more = more.with_policy(each.policy, each.requested)
    meant = parse_words(words_of(more))[0].over(DEFAULT)
    return "" if mismatches(meant, requested) else text_of(more)
