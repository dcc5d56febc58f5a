"""Functions, event handlers and branches of launch files in Python: what they start for sure."""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest

from plastron_tui.ros.launch import Container, Group, Item, LaunchFile, StartedNode, Unread
from plastron_tui.ros.launch_resolution import resolve
from plastron_tui.ros.launch_text import Scope
from plastron_tui.sources.launch.python_reader import read_launch_python

A, B, X = (f"Node(package='p', executable={each})" for each in ("'a'", "'b'", "x"))
PART = "ComposableNode(package='p', plugin='p::{}')"
LATER = "LaunchDescription([OpaqueFunction(function=f)])"
HELD = "composable_node_descriptions=parts"


def _items(top: str, body: str) -> tuple[Item, ...]:
    lines = "".join(f"    {line}\n" for line in body.splitlines())
    source = f"import os\n{top}\ndef generate_launch_description():\n{lines}"
    ast.parse(source)
    launch = read_launch_python(source.encode()).launch
    assert launch is not None
    return launch.items


def _shown(items: tuple[Item, ...], *, is_sure: bool = True) -> Iterator[str]:
    """Yield executables, those behind `?` that are started where something unknown holds."""
    for item in items:
        holds = is_sure and item.condition is None
        if isinstance(item, Group):
            yield from _shown(item.items, is_sure=holds)
        elif isinstance(item, Container):
            yield from _shown(tuple(filter(None, (item.node,))), is_sure=holds)
            yield from _shown(item.components, is_sure=holds)
        elif isinstance(item, StartedNode):
            yield f"{'' if holds else '?'}{item.executable}"
        else:
            assert isinstance(item, Unread)
            yield f"-- {item.what}"


@pytest.mark.parametrize(
    ("top", "body", "expected"),
    [
        ("", f"def f(context):\n    return [{A}]\nNODES(OpaqueFunction(function=f))", "a"),
        (f"def f(context):\n    return [{A}]", "NODES(OpaqueFunction(function=f))", "a"),
        (f"def f(context):\n    a = {A}\n    return (a, {B})", "NODES(OpaqueFunction(function=f))",
         "a b"),
        (f"def f(context, x):\n    return [{X}]", "NODES(OpaqueFunction(function=f, args=['c']))",
         "c"),
        (f"def f(context, x):\n    return [{X}]",
         "NODES(OpaqueFunction(function=f, kwargs={'x': 'c'}))", "c"),
        (f"def f(context, x='d', *args, **kwargs):\n    return [{X}]",
         "NODES(OpaqueFunction(function=f, args=word()))", "-- `OpaqueFunction`"),
        (f"def f(context, x):\n    return [{X}]", "NODES(OpaqueFunction(function=f))", "-- `f`"),
        (f"def f(context):\n    return {A}", "NODES(OpaqueFunction(function=f))", "a"),
        ("def f(context):\n    print(context)", "NODES(OpaqueFunction(function=f))", ""),
        ("def f(context):\n    return more()", "NODES(OpaqueFunction(function=f))", "-- `more`"),
        (f"def f(context):\n    yield {A}", "NODES(OpaqueFunction(function=f))", "-- `f`"),
        (f"async def f(context):\n    return [{A}]", "NODES(OpaqueFunction(function=f))",
         "-- `f`"),
        ("", "NODES(OpaqueFunction(function=elsewhere))", "-- `OpaqueFunction`"),
        ("def f(context):\n    return [OpaqueFunction(function=f)]",
         "NODES(OpaqueFunction(function=f))", "-- `f`"),
        (f"def f(context):\n    return [{A}]",
         "NODES(OpaqueFunction(function=f, condition=IfCondition(word())))", "?a"),
        (f"def f(x):\n    return [{X}]",
         "NODES(OpaqueFunction(function=lambda context: f('c')))", "c"),
        # What the function around it names later counts.
        ("", f"x = 'c'\ndef f(context):\n    return [{X}]\nx = 'd'\n"
         "NODES(OpaqueFunction(function=f))", "d"),
        # They are not forgotten where every branch returns.
        ("", f"x = 'c'\ndef f(context):\n    return [{X}]\nif os:\n    return {LATER}\n"
         f"else:\n    return {LATER}", "?c -- what an `if` returns ?c -- what an `if` returns"),
        # What another function names does not.
        (f"def f(context):\n    return [{X}]", "x = 'c'\nNODES(OpaqueFunction(function=f))",
         "$(x)"),
        (f"def f(context):\n    if os:\n        return [{A}]\n    return [{B}]",
         "NODES(OpaqueFunction(function=f))", "?a ?b"),
        (f"def f(context):\n    if os:\n        raise OSError\n    return [{B}]",
         "NODES(OpaqueFunction(function=f))", "b"),
        (f"def f(context):\n    try:\n        return [{A}]\n    except OSError:\n        return []",
         "NODES(OpaqueFunction(function=f))", "-- what an `except` returns a"),
        # Helpers.
        (f"def f(x):\n    return {X}", "NODES(f('c'), f(x='d'))", "c d"),
        (f"def f(x):\n    return [{X}]", "NODES(*f('c'), *f('d'))", "c d"),
        (f"def f():\n    return [{A}]", f"return LaunchDescription(f() + [{B}])", "a b"),
        (f"def f():\n    return LaunchDescription([{A}])", "NODES(f())", "a"),
        (f"def f():\n    ld = LaunchDescription()\n    ld.add_action({A})\n    return ld",
         "NODES(f())", "a"),
        (f"def f():\n    return [{A}]", "return LaunchDescription(f() + more())", "a -- `more()`"),
        (f"def f(x, more=None):\n    found = [{X}]\n    if more is not None:\n"
         "        found += more\n    return found",
         f"NODES(*f('c'), *f('d', [{A}]))", "c d a"),
        (f"def f(x):\n    if x == 'c':\n        return {A}\n    return {X}",
         "NODES(f('c'), f('d'))", "a d"),
        (f"def f(x):\n    return [{X}]",
         "NODES(*f('c'), *(f('d') if os else []))", "c ?d"),
        ("", f"nodes = []\ndef add(x):\n    nodes.append({X})\nadd('c')\nadd('d')\nNODES(*nodes)",
         "c d"),
        ("", f"ld = LaunchDescription()\ndef add():\n    ld.add_action({A})\nadd()\nreturn ld",
         "-- what `add` adds"),
        (f"class Node:\n    pass\ndef f(x):\n    return {A}", "NODES(f(word()))", "a"),
        # What a branch did before it returned is not known behind it.
        ("", f"nodes = []\ndef add():\n    if os:\n        nodes.append({A})\n        return\n"
         f"    nodes.append({B})\nadd()\nNODES(*nodes)", "-- what `add` adds"),
        ("", f"nodes = []\ndef add():\n    nodes.append({A})\n    if os:\n        return True\n"
         "    else:\n        return False\nadd()\nNODES(*nodes)", "-- what `add` adds"),
        ("x = 'c'\ndef setup():\n    global x\n    x = 'd'", f"setup()\nNODES({X})", "$(x)"),
        # Branches.
        ("", f"nodes = [{A}]\nif os:\n    nodes.append({B})\nNODES(*nodes)", "a ?b"),
        ("", f"if os:\n    nodes = [{A}]\nelse:\n    nodes = [{B}]\nNODES(*nodes)", "?a ?b"),
        ("", f"if os:\n    node = {A}\nelif dir:\n    node = {B}\nelse:\n    node = None\n"
         "NODES(node)", "?a ?b"),
        ("", f"node = None\nif os:\n    node = {A}\nif node is None:\n    nodes = [{B}]\n"
         "else:\n    nodes = [node]\nNODES(*nodes)", "?b ?a"),
        ("", f"if os:\n    x = 'c'\nelse:\n    x = 'd'\nNODES({X})", "$(x)"),
        ("", f"if os:\n    x = 'c'\nelse:\n    x = 'c'\nNODES({X})", "c"),
        ("", f"x = 'c'\nif os:\n    x = 'd'\nNODES({X})", "$(x)"),
        ("", f"x = True\nif not x:\n    node = {A}\nelse:\n    node = {B}\nNODES(node)", "b"),
        ("", f"nodes = []\nsame = nodes\nif os:\n    nodes.append({A})\nsame.append({B})\n"
         "NODES(*nodes)", "?a b"),
        ("", f"ld = LaunchDescription()\nif os:\n    ld.add_action({A})\nreturn ld", "?a"),
        ("", f"if os:\n    return LaunchDescription([{A}])\nreturn LaunchDescription([{B}])",
         "?a -- what an `if` returns b"),
        # What is done later.
        ("", f"NODES(TimerAction(period=1.0, actions=[{A}]))",
         "-- the period of a `TimerAction` a"),
        ("", f"NODES(RegisterEventHandler(OnProcessExit(target_action={A}, on_exit=[{B}])))",
         "?b"),
        ("", f"NODES(RegisterEventHandler(event_handler=OnProcessStart(on_start={B})))", "?b"),
        ("", "NODES(RegisterEventHandler(OnStateTransition(goal_state='active', "
         f"entities=[LogInfo(msg='x'), {B}])))", "?b"),
        ("", f"NODES(RegisterEventHandler(OnProcessExit(on_exit=lambda e, c: [{B}])))", "?b"),
        ("", f"def f(event, context):\n    return {B}\n"
         "NODES(RegisterEventHandler(OnProcessExit(on_exit=f)))", "?b"),
        ("", "NODES(RegisterEventHandler(OnProcessExit(on_exit=[EmitEvent(event=word())])))",
         "-- `RegisterEventHandler`"),
        ("", f"NODES(GroupAction([TimerAction(period=1.0, actions=[{A}])]))",
         "-- the period of a `TimerAction` a"),
        # Components.
        ("", f"parts = [{PART.format('A')}]\nif os:\n    parts.append({PART.format('B')})\n"
         f"NODES(LoadComposableNodes(target_container='c', {HELD}))", "p::A ?p::B"),
        ("", f"parts = [{PART.format('A')}] + more()\n"
         f"NODES(ComposableNodeContainer(package='p', executable='c', name='c', {HELD}))",
         "c p::A "),
    ],
)  # fmt: skip
def test_what_functions_return_is_started(top: str, body: str, expected: str) -> None:
    body = "\n".join(
        f"return LaunchDescription([{line[6:-1]}])" if line.startswith("NODES(") else line
        for line in body.splitlines()
    )
    assert " ".join(_shown(_items(top, body))) == expected


USE = "ns = {}\n    return [Node(package='p', executable='a', namespace=ns)]"
GIVEN = "DeclareLaunchArgument('ns', default_value='front')"


@pytest.mark.parametrize(
    ("top", "before", "expected"),
    [
        (USE.format("LaunchConfiguration('ns').perform(context)"), GIVEN, "/front"),
        (USE.format("context.perform_substitution(LaunchConfiguration('ns'))"), GIVEN, "/front"),
        (USE.format("context.launch_configurations['ns']"), GIVEN, "/front"),
        (USE.format("f\"{LaunchConfiguration('ns').perform(context)}_2\""), GIVEN, "/front_2"),
        (USE.format("f\"{LaunchConfiguration('ns')}_2\""), GIVEN, ""),
        (USE.format("LaunchConfiguration('ns').perform(context)"), "", ""),
        (USE.format("LaunchConfiguration('ns').perform(context)"),
         "DeclareLaunchArgument('ns', default_value=word())", ""),
        (USE.format("LaunchConfiguration('ns').perform(context).lower()"), GIVEN, ""),
        ("context.launch_configurations['ns'] = 'rear'\n    "
         + USE.format("LaunchConfiguration('ns')"), GIVEN, "/rear"),
        ("if os:\n        context.launch_configurations['ns'] = 'rear'\n    "
         + USE.format("LaunchConfiguration('ns')"), GIVEN, ""),
        (USE.format("LaunchConfiguration('ns', default='side')"), "", "/side"),
        (USE.format("LaunchConfiguration('ns', default='side')"), GIVEN, "/front"),
        (USE.format("LaunchConfiguration('ns', default='side')"), "DeclareLaunchArgument('ns')",
         ""),
        (USE.format("LaunchConfiguration('ns', default='side')"),
         "DeclareLaunchArgument('ns', default_value=word())", ""),
        (USE.format("LaunchConfiguration('ns', default=word())"), "", ""),
    ],
)  # fmt: skip
def test_arguments_have_their_defaults_in_functions(top: str, before: str, expected: str) -> None:
    actions = ", ".join(filter(None, (before, "OpaqueFunction(function=f)")))
    items = _items(f"def f(context):\n    {top}", f"return LaunchDescription([{actions}])")
    resolved = resolve(LaunchFile(items), 2, Scope())
    assert [each.namespace for each in resolved.started] == [expected] * bool(expected)
    assert bool(resolved.started) or resolved.unresolved
