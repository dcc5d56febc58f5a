"""Publishers and subscriptions."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from typing import NamedTuple

from plastron_tui.model.kinds import Condition, Publication, Publisher, Rate, Subscription
from plastron_tui.model.values import OfReceived, computed_in
from plastron_tui.ros.interfaces import Field, InterfaceKind
from plastron_tui.sources import naming

from .periods import planned_timer
from .plan import (
    MethodPlan,
    NodePlan,
    OncePlan,
    PublisherPlan,
    ReactionPlan,
    SendPlan,
    SubscriptionPlan,
)
from .writing import Writing


class _Reactions(NamedTuple):
    """What is sent through a publisher for the messages of a topic, under one condition."""

    topic: str
    condition: Condition | None


def add_publishers(writing: Writing, plan: NodePlan) -> None:
    """Plan the publishers of a node, and what sends its messages."""
    for publisher in writing.node.of(Publisher).values():
        name = naming.words(publisher.name)
        attribute = writing.attributes.new(f"{name}_publisher")
        type_ = writing.message_class(publisher.type, publisher.name, publisher.span)
        qos = writing.quality(publisher.qos, is_publisher=True)
        plan.publishers.append(PublisherPlan(attribute, writing.name(publisher), type_, qos))
        label = naming.label(publisher.name, "its topic")
        by_rate: dict[Rate, list[Publication]] = defaultdict(list)
        by_reaction: dict[_Reactions, list[Publication]] = defaultdict(list)
        once: list[Publication] = []
        for each in publisher.publications:
            if each.is_once:
                once.append(each)
            elif each.reaction is not None:
                by_reaction[_Reactions(*each.reaction)].append(each)
            else:
                by_rate[Rate(each.rate, each.parameter)].append(each)
        for rate, found in by_rate.items():
            method = writing.attributes.new(f"publish_{name}")
            sends = _sends(writing, publisher, found)
            timer = planned_timer(writing, rate, method, f"{name}_timer")
            plan.timers.append(timer._replace(publisher=attribute, label=label, sends=sends))
        for reaction, found in by_reaction.items():
            heard = _heard(writing, reaction.topic)
            condition, compared = _condition(writing, reaction.condition, heard)
            plan.reactions.append(
                ReactionPlan(
                    publisher=attribute,
                    method=writing.attributes.new(f"publish_{name}"),
                    topic=reaction.topic,
                    type=_heard_class(writing, reaction.topic),
                    heard=naming.label(reaction.topic, "its topic"),
                    label=label,
                    sends=_sends(writing, publisher, found, heard),
                    condition=condition,
                    compared=compared,
                    is_heard=_is_heard(reaction, found),
                )
            )
        if once:
            new = writing.attributes.new
            method, waiting = new(f"publish_{name}"), new(f"{name}_timer")
            sends = _sends(writing, publisher, once)
            rest = (new(f"{name}_is_heard"), "") if writing.is_ros2 else ("", new(f"await_{name}"))
            plan.once.append(OncePlan(attribute, method, waiting, label, sends, *rest))


def _sends(
    writing: Writing,
    publisher: Publisher,
    found: list[Publication],
    heard: Sequence[Field] = (),
) -> tuple[SendPlan, ...]:
    return tuple(writing.send(each.message.value, publisher.span, heard) for each in found)


def _is_heard(reaction: _Reactions, found: list[Publication]) -> bool:
    """Tell whether what is sent, or whether it is, depends on the message that is received."""
    return reaction.condition is not None or any(
        isinstance(origin, OfReceived)
        for each in found
        for value in computed_in(each.message.value)
        for origin in value.origins
    )


def _heard_class(writing: Writing, topic: str) -> str:
    """Write the class of the messages of a topic that the node subscribes to."""
    subscription = writing.node.of(Subscription)[topic]
    return writing.message_class(subscription.type, topic, subscription.span)


def _heard(writing: Writing, topic: str) -> Sequence[Field]:
    """Return the fields of the messages of a topic that the node subscribes to."""
    subscription = writing.node.of(Subscription)[topic]
    assert subscription.type is not None  # a statement reacts to a type that is known
    return writing.find(subscription.type, InterfaceKind.MESSAGE, subscription.span).fields


def _condition(
    writing: Writing, condition: Condition | None, heard: Sequence[Field]
) -> tuple[str, tuple[str, ...]]:
    """Write what must hold of a message that is called `received`; name what it may lack."""
    if condition is None:
        return "", ()
    value = writing.setting(condition.value)
    text = writing.computing.condition(condition, "received", heard, value)
    is_unsure = writing.computing.lacks(condition.source, heard)
    return text, (str(condition.source),) if is_unsure else ()


def add_subscriptions(writing: Writing, plan: NodePlan) -> None:
    """Plan the subscriptions of a node, after its publishers."""
    for subscription in writing.node.of(Subscription).values():
        type_ = writing.message_class(subscription.type, subscription.name, subscription.span)
        callback = subscription.callback
        if callback is None:
            callback = writing.attributes.new(f"on_{naming.words(subscription.name)}")
        plan.subscriptions.append(
            SubscriptionPlan(
                writing.name(subscription),
                type_,
                callback,
                writing.quality(subscription.qos, is_publisher=False),
                writing.held(f"{naming.words(subscription.name)}_subscription"),
            )
        )
        reactions = tuple(each.method for each in plan.reactions if each.topic == subscription.name)
        key = writing.method_key(callback, type_)
        known = writing.methods.get(key)
        if known is None:
            known = MethodPlan(callback, naming.label(subscription.name, callback), type_)
            writing.methods[key] = known
            plan.callbacks.append(known)
        known.reactions += reactions
