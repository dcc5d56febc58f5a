"""From rospy to rclpy: what runs the node, what ends it, and what is called then."""

from __future__ import annotations

from dataclasses import dataclass

from tree_sitter import Node

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python.references import identifiers, statement_of
from plastron_tui.sources.python.syntax import is_in_loop, parts_of

from .main_line import asks_user, is_busy_before_spin
from .port_state import Work, walk
from .repetition import is_called_often
from .rewriting import replace_by_opposite, time_module

INTERRUPTS = "KeyboardInterrupt, ExternalShutdownException, ROSInterruptException"
"""What ROS that ends raises in a node of rclpy, where rospy raises a `ROSInterruptException`."""

INTERRUPT_IMPORTS = (
    "from rclpy.executors import ExternalShutdownException",
    "from rclpy.exceptions import ROSInterruptException",
)
_INTERRUPT = ("rospy.ROSInterruptException", "rospy.exceptions.ROSInterruptException")
LISTENS = frozenset({EndpointKind.SUBSCRIPTION, EndpointKind.SERVICE, EndpointKind.TIMER})
"""The endpoints that call a function of the file."""

_ANYWHERE = ("rospy.is_shutdown", "rospy.signal_shutdown", "rospy.on_shutdown")

_SPIN = """\
def {spin}():
    \"\"\"Handle what comes until ROS ends; log what a callback raises.\"\"\"
{executor}    while rclpy.ok():
        try:
            {spins}
        except (KeyboardInterrupt, ExternalShutdownException):
            break
{destroyed}        except Exception:
            if rclpy.ok():
                {node}.get_logger().error(traceback.format_exc())
"""
# One thread for what a callback waits for, one for the callback: those of a node take turns.
_EXECUTOR = """\
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node({node})
"""
# The executor looks at its endpoints while another thread may destroy one.
_DESTROYED = """\
        except InvalidHandle:
            {node}.get_logger().debug(traceback.format_exc())
"""
_SHUTDOWN = """\
def {shutdown}():
    \"\"\"Call the hooks, once, and end ROS.\"\"\"
    if not {ending}.acquire(blocking=False):
        return
    for hook in {hooks}:
        try:
            hook()
        except Exception:
            traceback.print_exc()
    rclpy.try_shutdown()
"""
_THREAD = """\
def {thread}():
    \"\"\"Handle what comes in a thread, until the program ends.\"\"\"
    thread = threading.Thread(target={spin}, daemon=True)
    thread.start()
    atexit.register(thread.join)
    atexit.register({shutdown})
"""
# The handler of rclpy does not wake what sleeps at a rate, and raises a `KeyboardInterrupt` where
# the file asks its user; that of rospy does not.
_SIGNAL = "signal.signal(signal.{signal}, lambda number, frame: {shutdown}())\n"
_WAIT = """\
def {wait}():
    \"\"\"Wait until ROS ends, while a thread handles what comes.\"\"\"
    try:
        while rclpy.ok():
            {time}.sleep(0.1)
    except KeyboardInterrupt:
        pass
"""


@dataclass(frozen=True, slots=True)
class Running:
    """How the new file runs its node.

    Attributes:
        starts: the statements behind the one that makes the node: what starts the thread.
        own_signals: whether the file handles signals itself.
    """

    starts: tuple[str, ...]
    own_signals: bool


def port_running(
    work: Work, node: str, *, waits: bool, in_callbacks: bool, destroys: bool
) -> Running:
    """Rewrite what runs the node, outside of callbacks, and what ends it.

    Args:
        work: the file.
        node: the name of the node.
        waits: whether the file waits for what has to be handled meanwhile.
        in_callbacks: whether callbacks may do so.
        destroys: whether the file destroys endpoints meanwhile.
    """
    calls = _calls(work)
    calls["rospy.Rate"] = _without_idle(work, calls["rospy.Rate"])
    is_made = any(each.call is not None for each in work.analysis.nodes)
    hooks = [each for each in calls["rospy.on_shutdown"] if is_made and _has_one(each)]
    listens = {site.call.id for site in work.analysis.sites if site.endpoint.kind in LISTENS}
    ends = {call.id for call in calls["rospy.spin"]}
    in_thread = (
        bool(calls["rospy.Rate"])
        or bool(hooks)
        or waits
        or (bool(listens) and (not ends or is_busy_before_spin(work, listens, ends)))
    )
    _port_rates(work, node, calls["rospy.Rate"])
    for call in calls["rospy.is_shutdown"]:
        replace_by_opposite(work, call, "rclpy.ok()")
    has_signals = any(
        b"disable_signals" in (each.call.text or b"") for each in work.analysis.nodes if each.call
    )
    own_signals = bool(hooks) or (is_made and not has_signals and asks_user(work))
    shutdown = _port_hooks(work, hooks) if hooks else "rclpy.try_shutdown"
    for call in calls["rospy.signal_shutdown"]:
        work.replace(call, f"{shutdown}()")
    _port_handed_over(work, shutdown)
    spin, wait = work.free_name("spin"), work.free_name("wait")
    for call in calls["rospy.spin"]:
        work.replace(call, f"{wait}()" if in_thread else f"{spin}()")
    if in_thread or calls["rospy.spin"]:
        executor = _EXECUTOR.format(node=node) if in_callbacks else ""
        spins = "executor.spin()" if in_callbacks else f"rclpy.spin({node})"
        destroyed = _DESTROYED.format(node=node) if destroys else ""
        helper = _SPIN.format(
            spin=spin, executor=executor, spins=spins, destroyed=destroyed, node=node
        )
        work.helpers.insert(0, helper)
        if destroys:
            work.imports.add("from rclpy.exceptions import InvalidHandle")
        work.imports.update((INTERRUPT_IMPORTS[0], "import traceback"))
        if in_callbacks:
            work.imports.add("from rclpy.executors import MultiThreadedExecutor")
    signals = [] if has_signals else ["SIGINT", "SIGTERM"] if own_signals else ["SIGTERM"]
    handlers = [_SIGNAL.format(signal=each, shutdown=shutdown) for each in signals]
    starts: tuple[str, ...] = ()
    if in_thread:
        starts = (_run_in_thread(work, spin, shutdown, handlers),)
    elif own_signals:
        starts = tuple(each.rstrip() for each in handlers)
    if handlers and starts:
        work.imports.add("import signal")
    if in_thread and calls["rospy.spin"]:
        work.helpers.append(_WAIT.format(wait=wait, time=time_module(work)))
    _port_interrupts(work)
    return Running(starts, own_signals)


def _calls(work: Work) -> dict[str, list[Node]]:
    """Return the calls of what runs a node, by its name; what may stand in callbacks as well."""
    calls: dict[str, list[Node]] = {name: [] for name in ("rospy.spin", "rospy.Rate", *_ANYWHERE)}
    for call in work.analysis.captures.get("call", []):
        callee = call.child_by_field_name("function")
        if callee is None:
            continue
        is_free = not work.is_in_callback(call)
        for name in work.qualified(callee):
            found = name.replace("rospy.client.", "rospy.").replace("rospy.core.", "rospy.")
            found = found.replace("rospy.timer.", "rospy.")
            if found in calls and (is_free or found in _ANYWHERE):
                calls[found].append(call)
    return calls


def _without_idle(work: Work, rates: list[Node]) -> list[Node]:
    """Take away the rates that nothing sleeps at, and return the others.

    One that a file keeps in an attribute may be of use to another file, unless it is a program.
    """
    targets: dict[str, list[Node]] = {}
    is_program = any(each.call is not None for each in work.analysis.nodes)
    for call in rates:
        left = call.parent.child_by_field_name("left") if call.parent is not None else None
        inside = call.child_by_field_name("arguments")
        is_plain = (
            all(each.type != "call" for each in walk(inside)) if inside is not None else False
        )
        if left is not None and is_plain and statement_of(call).named_children == [call.parent]:
            name = left.child_by_field_name("attribute") if is_program else None
            name = left if left.type == "identifier" else name
            if name is not None:
                targets.setdefault(work.slice(name), []).append(name)
    idle = set()
    for text, names in targets.items():
        if len(list(identifiers(text, work.analysis))) == len(names):
            idle |= {statement_of(each).id for each in names}
    for call in rates:
        if statement_of(call).id in idle:
            work.delete(statement_of(call))
    return [each for each in rates if statement_of(each).id not in idle]


def _has_one(call: Node) -> bool:
    """Tell whether a call is given one thing, by its position."""
    given = parts_of(call.child_by_field_name("arguments"))
    return len(given) == 1 and not given[0].type.endswith(("keyword_argument", "splat"))


def _run_in_thread(work: Work, spin: str, shutdown: str, handlers: list[str]) -> str:
    """Add the function that starts the thread, and handles signals; return its call."""
    thread = work.free_name("spin_in_thread")
    text = _THREAD.format(thread=thread, spin=spin, shutdown=shutdown)
    work.helpers.append(text + "".join(f"    {each}" for each in handlers))
    work.imports.update(("import atexit", "import threading"))
    return f"{thread}()"


def _port_rates(work: Work, node: str, calls: list[Node]) -> None:
    for call in calls:
        callee = call.child_by_field_name("function")
        given = parts_of(call.child_by_field_name("arguments"))
        if callee is not None:
            work.replace(callee, f"{node}.create_rate")
        if is_in_loop(call):
            remedy = "make it once, before the loop: each call makes one more timer of the node"
            work.mark(call, "create_rate in a loop", remedy)
        elif is_called_often(work, call):
            remedy = "make it once, where the function finds it: each makes one more timer"
            work.mark(call, "create_rate on each call", remedy)
        for each in given[1:] + [each for each in given[:1] if each.type == "keyword_argument"]:
            work.mark(call, work.slice(each).partition("=")[0], "`create_rate` takes a frequency")


def _port_hooks(work: Work, calls: list[Node]) -> str:
    """Rewrite `rospy.on_shutdown`, whose hooks run while ROS is there; return what ends it.

    rclpy calls its own hooks when nothing can be published any more, and none after a signal.
    """
    hooks, ending = work.free_name("shutdown_hooks"), work.free_name("ending")
    shutdown = work.free_name("shut_down")
    for call in calls:
        callee = call.child_by_field_name("function")
        assert callee is not None
        work.replace(callee, f"{hooks}.append")
    work.constants += [f"{hooks} = []", f"{ending} = threading.Lock()"]
    work.helpers.append(_SHUTDOWN.format(shutdown=shutdown, ending=ending, hooks=hooks))
    return shutdown


def _port_handed_over(work: Work, shutdown: str) -> None:
    """Rewrite `rospy.signal_shutdown` where it is an argument, of what starts a thread, say."""
    for node in walk(work.analysis.syntax.root):
        is_name = node.type in ("attribute", "identifier")
        is_argument = node.parent is not None and node.parent.type == "argument_list"
        if is_name and is_argument and "rospy.signal_shutdown" in work.qualified(node):
            work.replace(node, f"lambda reason: {shutdown}()")


def _port_interrupts(work: Work) -> None:
    """Rewrite `except rospy.ROSInterruptException`."""
    for node in caught(work, frozenset(_INTERRUPT)):
        port_caught(work, node, INTERRUPTS)


def caught(work: Work, names: frozenset[str]) -> list[Node]:
    """Return where an `except` names one of some exceptions."""
    found = []
    for node in walk(work.analysis.syntax.root):
        if node.type not in ("attribute", "identifier") or node.parent is None:
            continue
        outer: Node | None = node.parent
        while outer is not None and outer.type in ("tuple", "as_pattern"):
            outer = outer.parent
        is_clause = outer is not None and outer.type == "except_clause"
        if is_clause and set(work.qualified(node)) & names:
            found.append(node)
    return found


def port_caught(work: Work, node: Node, exceptions: str) -> None:
    """Catch what rclpy raises instead, by names with commas between."""
    parent = node.parent
    is_item = parent is not None and parent.type == "tuple"
    if is_item and parent is not None and "KeyboardInterrupt" in work.slice(parent):
        exceptions = exceptions.replace("KeyboardInterrupt, ", "")
    is_one = is_item or ", " not in exceptions
    work.replace(node, exceptions if is_one else f"({exceptions})")
    if "ROSInterruptException" in exceptions:
        work.imports.update(INTERRUPT_IMPORTS)
