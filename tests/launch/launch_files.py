"""Launch files as `hypothesis` makes them."""

from __future__ import annotations

from hypothesis import strategies as some

from plastron_tui.ros.launch import (
    Argument,
    Condition,
    Container,
    Group,
    Include,
    Item,
    LaunchFile,
    Namespace,
    ParameterFile,
    ParameterValue,
    Remapping,
    StartedNode,
    Variable,
)
from plastron_tui.ros.launch_text import Kind, Substitution, Text, argument, package_file, text

WORDS = some.from_regex(r"[a-z][a-z0-9_]{0,8}", fullmatch=True)
LITERALS = some.text(
    some.sampled_from("ab01.-+_ \\\"'<>&$()[]{}:#,éyn~\t\n"), min_size=1, max_size=12
)
NUMBERS = some.integers(-(2**31), 2**31 - 1) | some.floats(allow_nan=False)
SCALARS = some.booleans() | NUMBERS | LITERALS | some.sampled_from(["true", "1", "", "1e3", "~"])
LISTS = some.one_of(
    *(some.lists(each, max_size=3).map(tuple)
      for each in (some.booleans(), some.integers(-9, 9), some.floats(-9, 9), LITERALS))
)  # fmt: skip


def texts(ros_version: int) -> some.SearchStrategy[Text]:
    """Texts with substitutions."""
    literal = LITERALS if ros_version == 2 else LITERALS.filter(lambda x: "$(" not in x)
    part = some.one_of(
        literal,
        WORDS.map(lambda name: Substitution(Kind.ARGUMENT, text(name))),
        WORDS.map(lambda name: Substitution(Kind.PACKAGE, text(name))),
        some.builds(
            lambda name, default: Substitution(
                Kind.ENVIRONMENT, text(name), text(default) if default else None
            ),
            WORDS,
            some.none() | WORDS,
        ),
    )
    whole = some.lists(part, min_size=1, max_size=3).map(lambda parts: text(*parts))
    return whole.filter(lambda each: ros_version == 2 or "$(" not in _literals(each))


def _literals(of: Text) -> str:
    return "".join(part if isinstance(part, str) else " " for part in of.parts)


def _parameters(ros_version: int) -> some.SearchStrategy[object]:
    name = WORDS.map(text)
    literal = (SCALARS | LISTS).filter(lambda x: ros_version == 2 or "$(" not in repr(x))
    computed = WORDS.map(argument)
    return some.one_of(
        some.builds(ParameterValue, name, literal, some.just(False), some.just(False)),
        some.builds(ParameterValue, name, computed, some.booleans(), some.just(False)),
        some.builds(ParameterValue, name, computed, some.just(False), some.just(True)),
        some.builds(ParameterFile, some.builds(package_file, WORDS, WORDS)),
    )


def launch_files(ros_version: int) -> some.SearchStrategy[LaunchFile]:
    """Launch files that either XML can say."""
    word = WORDS.map(text)
    any_text = texts(ros_version)
    condition = some.none() | some.builds(Condition, WORDS.map(argument), some.booleans())

    def node(with_name: bool, when: some.SearchStrategy[Condition | None]) -> object:
        return some.builds(
            StartedNode,
            word,
            word,
            word if with_name else some.none() | word,
            some.none() | any_text,
            some.lists(some.builds(Remapping, word, any_text), max_size=2).map(tuple),
            some.lists(_parameters(ros_version), max_size=3).map(tuple),
            some.just(()) | some.just((("output", text("screen")),)),
            condition=when,
        )

    nodes = node(ros_version == 1, condition)
    simple: list[some.SearchStrategy[Item]] = [
        some.builds(Argument, WORDS, some.none() | any_text, WORDS | some.just("")),
        some.builds(Variable, WORDS, any_text),
        nodes,
        some.builds(
            Include,
            some.builds(package_file, WORDS, WORDS),
            some.lists(some.tuples(WORDS, any_text), max_size=2).map(tuple),
            some.none() if ros_version == 2 else some.none() | word,
            condition=condition,
        ),
    ]
    if ros_version == 2:
        parts = some.lists(node(True, condition), max_size=2).map(tuple)
        simple.append(
            some.builds(Container, node(True, some.none()), some.none(), parts, condition=condition)
        )
        simple.append(some.builds(Container, some.none(), word, parts, condition=condition))
    groups = some.builds(
        lambda namespace, items, when: Group((Namespace(namespace), *items), condition=when),
        any_text,
        some.lists(some.one_of(simple), max_size=3),
        condition,
    )
    return some.lists(some.one_of(*simple, groups), max_size=5).map(
        lambda items: LaunchFile(tuple(items))
    )
