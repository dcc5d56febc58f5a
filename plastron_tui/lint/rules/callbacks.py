"""What is wrong with the functions of a node that ROS calls."""

from __future__ import annotations

from collections.abc import Iterator

from plastron_tui.diagnostics import Code, Diagnostic, Label, Severity, counted
from plastron_tui.lint.message_fields import PYTHON
from plastron_tui.lint.rule import rule
from plastron_tui.lint.tree import SourceTree, UnitFacts
from plastron_tui.model.code_facts import Arity, Blocking, Repeated, Wait
from plastron_tui.model.kinds import EndpointKind

from .code_examples import AGAIN, ARITY, BLOCKING, SLEEPING

_SHORTEST = 0.05
"""How many seconds a callback sleeps that holds up others."""

_SHORTEST_OF_ROSPY = 0.5
"""How many seconds a callback sleeps that holds up the messages of its own topic."""

_AWAITED = {
    Wait.SERVICE: "waits for the answer of a service",
    Wait.ACTION: "waits for the result of an action",
    Wait.SPIN: "spins until something is done",
}

_CALLED = (
    EndpointKind.SUBSCRIPTION,
    EndpointKind.SERVICE,
    EndpointKind.TIMER,
    EndpointKind.CLIENT,
    EndpointKind.ACTION_CLIENT,
    # It is asked for goals, for their results and to give up.
    EndpointKind.ACTION_SERVER,
    EndpointKind.ACTION_SERVER,
)
"""For what the executor has to call something, as often as it may be called for an endpoint."""

_ASKING = (EndpointKind.CLIENT, EndpointKind.ACTION_CLIENT)


def _running(tree: SourceTree) -> Iterator[UnitFacts]:
    """Yield the files of a workspace that a robot runs."""
    return (unit for unit in tree.built if not unit.is_test)


@rule(
    "RC401",
    "blocking-call-in-callback",
    "A callback waits for what can only come once it has returned.",
    why="The thread of the executor that calls the callback is the one that would take the answer, "
    "or the two are in one group of callbacks, of which one is called at a time: the node hangs. "
    "The default group of a node is such a group, whatever the executor. Not told where the client "
    "is in another group and the file makes an executor of several threads, or where it is not "
    "sure that the answer is brought by the same node. What spins its own node in a callback of "
    "rclcpp gets an exception: an executor has the node already.",
    bad=BLOCKING["bad"],
    good=BLOCKING["good"],
)
def blocking_call_in_callback(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find calls in callbacks that never return."""
    for unit in _running(tree):
        for each in unit.code.blocking:
            if each.wait is not Wait.SLEEP and each.is_endless:
                is_python = unit.library in PYTHON
                yield Diagnostic(
                    code,
                    _blocked(each, is_python),
                    each.span,
                    unit.file(each.file),
                    help=_instead(each, is_python),
                )


def _named(callback: str) -> str:
    return "the lambda" if callback == "lambda" else f"`{callback}`"


def _blocked(fact: Blocking, is_python: bool) -> str:
    name = _named(fact.callback)
    if fact.wait is Wait.SPIN and not is_python:
        return f"{name} spins its own node, which another executor spins: rclcpp throws"
    return f"{name} {_AWAITED[fact.wait]}, which only comes once {name} has returned"


def _instead(fact: Blocking, is_python: bool) -> str:
    if not is_python:
        return "hand a callback over with the request, and go on there"
    calls = "`call_async`"
    if fact.wait is Wait.ACTION:
        calls = "`send_goal_async` and `get_result_async`"
    return f"use {calls} with `add_done_callback`, and go on in the function that you give it"


@rule(
    "RC402",
    "sleep-in-callback",
    "A callback sleeps.",
    severity=Severity.WARNING,
    why="Until it returns, the node calls no other callback: messages, timers and requests wait, "
    "and messages that do not fit in their queue are lost. It is an error where it sleeps with a "
    "rate, in an executor of one thread: a rate of rclpy waits for a timer, which the same thread "
    "would have to call, and so it never returns. Not told of a sleep of under 0.05 s, or before "
    "the program ends, of a node that has this one callback alone, nor where the file makes an "
    "executor of several threads. rospy has a thread for each connection: there it is told of "
    "half a second and more in the callback of a topic, at each message, for the next ones wait. "
    "With a queue of one message a sleep at the end, or on a condition, is meant there, and so is "
    "one at a signal (`Empty`), or where the callback unregisters its subscriber.",
    bad=SLEEPING["bad"],
    good=SLEEPING["good"],
)
def sleep_in_callback(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find callbacks that sleep."""
    for unit in _running(tree):
        is_rospy = unit.library == "rospy"
        is_alone = not is_rospy and _is_alone(unit)
        told: set[tuple[str, str, int]] = set()
        for each in unit.code.blocking:
            if not _sleeps(each, is_rospy) or (is_alone and not each.is_endless):
                continue
            # However often it sleeps, the same others wait.
            key = each.file, each.callback, each.created
            if key in told:
                continue
            told.add(key)
            yield Diagnostic(
                code,
                _held_up(each, is_rospy),
                each.span,
                unit.file(each.file),
                help=_apart(each, unit),
                severity=Severity.ERROR if each.is_endless else None,
            )


def _apart(fact: Blocking, unit: UnitFacts) -> str:
    """Return how others do not wait: a goal's result is due when its callback returns."""
    if fact.kind is EndpointKind.ACTION_SERVER and unit.ros_version == 2:
        executor = "MultiThreadedExecutor"
        where = executor if unit.library in PYTHON else f"rclcpp::executors::{executor}"
        return f"spin the node in a `{where}`, with a reentrant callback group for the action"
    return "let a timer do what comes later"


def _is_alone(unit: UnitFacts) -> bool:
    """Tell whether the executor has one function alone to call, and so nothing else waits."""
    kinds = [each.kind for node in unit.nodes for each in node.endpoints]
    if unit.ros_version == 1:
        # There no answer is brought by who calls the callbacks.
        kinds = [each for each in kinds if each not in _ASKING]
    return sum(map(_CALLED.count, kinds)) == 1


def _held_up(fact: Blocking, is_rospy: bool) -> str:
    name = _named(fact.callback)
    if fact.is_endless:
        return f"{name} waits for a rate, whose timer is only called once {name} has returned"
    sleeps = f"`{fact.inside}` sleeps, which {name} calls" if fact.inside else f"{name} sleeps"
    if is_rospy:
        return f"{sleeps}: the next messages of the topic wait meanwhile"
    return f"{sleeps}: the node calls no other callback meanwhile"


def _sleeps(fact: Blocking, is_rospy: bool) -> bool:
    return fact.wait is Wait.SLEEP and not _is_short(fact, is_rospy)


def _is_short(fact: Blocking, is_rospy: bool) -> bool:
    if is_rospy:
        return fact.seconds is None or fact.seconds < _SHORTEST_OF_ROSPY
    return fact.seconds is not None and fact.seconds < _SHORTEST


@rule(
    "RC403",
    "callback-arity",
    "A callback does not take what it is called with.",
    why="rclpy calls that of a subscription with the message, that of a service with the request "
    "and the response, that of a timer with nothing; rospy calls each with one thing, and with "
    "`callback_args` besides where the subscriber has them. A callback that takes more or less "
    "raises a TypeError when it is called first. Not told of functions that have a decorator.",
    bad=ARITY["bad"],
    good=ARITY["good"],
)
def callback_arity(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find callbacks that cannot be called."""
    for unit in _running(tree):
        for each in unit.code.arities:
            file = unit.file(each.file)
            what = "it gives nothing back" if each.is_result else "what it takes"
            yield Diagnostic(
                code,
                _misfit(each),
                each.span,
                file,
                help=_to_take(each),
                labels=(Label(each.definition, what, file),),
            )


def _misfit(fact: Arity) -> str:
    if fact.is_result:
        return f"{_named(fact.callback)} is called here, and what it returns cannot be called later"
    given = counted(fact.given, "argument") if fact.given else "none"
    if fact.with_self:
        given = f"its object and {given}" if fact.given else "its object"
        return f"{_named(fact.callback)} is a method without `self`, and is called with {given}"
    if fact.besides:
        given += f": the message, and `{fact.besides}` as `callback_args`"
    return f"{_named(fact.callback)} {_taken(fact)}, and is called with {given}"


def _taken(fact: Arity) -> str:
    least, most = fact.least, fact.most
    if most is None:
        return f"takes at least {counted(least, 'argument')}"
    if least == most == fact.given:
        return "cannot be called by position"
    if least == most:
        return f"takes {counted(most, 'argument')}" if most else "takes no argument"
    return f"takes {least} to {counted(most, 'argument')}"


def _to_take(fact: Arity) -> str | None:
    if fact.is_result:
        return "hand the function over, without brackets behind it"
    if fact.with_self:
        return f"add `self`: `{fact.with_self}`"
    if fact.besides.isdecimal():
        return f"write `queue_size={fact.besides}`"
    if fact.besides:
        return "let it take the message and the other, or leave `callback_args` out"
    wanted = {
        EndpointKind.SUBSCRIPTION: "the message",
        EndpointKind.SERVICE: "the request" if fact.given == 1 else "the request and the response",
        EndpointKind.ACTION_SERVER: "the goal",
        EndpointKind.TIMER: "the event" if fact.given == 1 else "nothing",
    }.get(fact.kind)
    return None if wanted is None else f"let it take {wanted}"


@rule(
    "RC404",
    "endpoint-made-again",
    "A callback, or a loop without end, creates an endpoint each time.",
    severity=Severity.WARNING,
    why="The node keeps the one of each time before: there are more of them with every call, each "
    "subscription calls its callback once more, and what a new publisher sends first is lost, for "
    "nobody has found it yet. Not told where the file ends endpoints of the kind before the node "
    "itself ends (`destroy_node`, `on_cleanup`), where a condition asks for more than the message, "
    "or where the name is another one each time.",
    bad=AGAIN["bad"],
    good=AGAIN["good"],
)
def endpoint_made_again(tree: SourceTree, code: Code) -> Iterator[Diagnostic]:
    """Find endpoints that are created again and again."""
    for unit in _running(tree):
        for each in unit.code.repeated:
            yield Diagnostic(
                code,
                f"{_again(each)}",
                each.span,
                unit.file(each.file),
                help="create it once, where the node starts",
            )


def _again(fact: Repeated) -> str:
    role = fact.kind.facts.role or fact.kind.value.rstrip("s").replace("_", " ")
    article = "an" if role[0] in "aeiou" else "a"
    if fact.callback:
        return f"{_named(fact.callback)} creates {article} {role} each time it is called"
    return f"the loop creates {article} {role} in each turn"
