"""Programs made by chance, for properties that hold of every program."""

from __future__ import annotations

import re

from hypothesis import strategies as st
from robot_programs import robot_statements

from plastron_tui.language import DECLARATIONS, Document, Program, lower
from plastron_tui.language.definitions import FieldText, RemapText, SettingText
from plastron_tui.language.inputs import (
    Argument,
    Calculation,
    Condition,
    ListValue,
    Literal,
    NamedArgument,
    NestedValue,
    ParameterValue,
    QosWord,
    Received,
)
from plastron_tui.language.keywords import KEYWORDS

variables = st.from_regex(r"[A-Za-z][A-Za-z0-9_]{0,8}", fullmatch=True).filter(
    lambda word: word not in KEYWORDS
)
names = st.from_regex(r"[~/]?[A-Za-z][A-Za-z0-9_/]{0,8}", fullmatch=True).map("'{}'".format)
types = st.sampled_from(["String", "geometry_msgs/Twist", "std_msgs/msg/String", "A"])
numbers = st.from_regex(r"[+-]?([0-9]{1,3}(\.[0-9]{0,2})?|\.[0-9])(e[+-]?[0-9])?", fullmatch=True)
texts = st.text(alphabet=st.sampled_from("ab é🐢/*'(,\"\\\n\t"), max_size=8).map(
    lambda text: '"' + text.translate({34: '\\"', 92: "\\\\", 10: "\\n", 9: "\\t"}) + '"'
)
fields = st.lists(variables, min_size=1, max_size=3).map(".".join)


def _values(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    lists = st.lists(inner, max_size=3).map(lambda items: f"[{', '.join(items)}]")
    arguments = inner | st.tuples(fields, inner).map("=".join)
    nested = st.lists(arguments, max_size=3).map(lambda items: f"({', '.join(items)})")
    return lists | nested


received = st.tuples(fields, st.sampled_from(["", "[0]", "[12]"])).map(
    lambda parts: f"received.{parts[0]}{parts[1]}"
)
parameters = names.map("parameter {}".format)
steps = st.lists(
    st.tuples(st.sampled_from("+-*/"), numbers).map(" {0[0]} {0[1]}".format), max_size=2
)
computed = st.tuples(received | parameters, steps.map("".join)).map("".join)
rates = (numbers | parameters).map(" at {} hz".format)
literals = numbers | texts | st.sampled_from(["True", "False"])
conditions = st.builds(
    "{}{} {} {}".format,
    st.sampled_from(["", "any ", "all "]),
    received,
    st.sampled_from("<>="),
    literals,
)
qos = st.lists(
    st.tuples(
        st.sampled_from(["reliable", "depth", "managed", "qos"]),
        st.just("") | numbers.map(" {}".format),
    ).map("".join),
    min_size=1,
    max_size=3,
).map(lambda words: f" with qos {', '.join(words)}")

values = st.recursive(literals | computed, _values, max_leaves=6)
field_types = st.builds(
    "{}{}{}".format,
    types,
    st.sampled_from(["", "<= 10"]),
    st.sampled_from(["", "[]", "[3]", "[<= 3]"]),
)
definitions = st.just("none") | st.lists(
    st.builds(
        "{} {}{}".format,
        field_types,
        variables,
        st.just("") | st.builds(" {} {}".format, st.sampled_from(["=", "default"]), values),
    ),
    min_size=1,
    max_size=3,
).map(", ".join)
remaps = st.lists(st.builds("{} to {}".format, names, names), min_size=1, max_size=3).map(
    lambda parts: f" remapping {', '.join(parts)}"
)
parameter_settings = st.lists(
    st.builds("{} = {}".format, names, values), min_size=1, max_size=3
).map(lambda parts: f" setting {', '.join(parts)}")
given_values = st.lists(
    values | st.tuples(fields, values).map("=".join), min_size=1, max_size=4
).map(", ".join)
inputs = st.just("none") | given_values
about_robots = robot_statements(variables, names, numbers, given_values)


def _maybe(clause: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.just("") | clause


def _any_order(*clauses: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.permutations(clauses).flatmap(lambda order: st.tuples(*order)).map("".join)


_using = st.sampled_from(["", " using rospy", " using rclpy"])
_calling = st.sampled_from(["", " calling _handle"]) | variables.map(" calling {}".format)
_rate = _maybe(rates)
_quality = _maybe(qos)
_when = _maybe(conditions.map(" when {}".format))
_described = _maybe(texts.map(" described_as {}".format))
_executable = _maybe(names.map(" as {}".format))
_place = st.lists(
    st.sampled_from([" in {}", " inside {}", " with parameters {}"]), unique=True
).flatmap(lambda forms: st.tuples(*(names.map(form.format) for form in forms)).map("".join))

_WORDS: dict[str, st.SearchStrategy[str]] = {
    "node": variables,
    "other": variables,
    "name": names,
    "other_or_name": variables | names,
    "type": types,
    "using": _using,
    "calling": _calling,
    "rate": _rate,
    "rates": rates,
    "inputs": inputs,
    "values": values,
    "texts": texts,
    "definitions": definitions,
    "section": _maybe(variables.map(" in {}".format)),
    "executable": _executable,
    "of_a_node": _any_order(_using, st.sampled_from(["", " managed"])),
    "of_a_subscription": _any_order(_quality, _calling),
    "of_a_publication": _any_order(
        _rate | st.just(" once") | st.builds(" for_each {}{}".format, names, _when), _quality
    ),
    "of_a_service": _any_order(_maybe(inputs.map(" answering {}".format)), _calling),
    "of_a_parameter": _any_order(
        _maybe(st.builds(" between {} and {}".format, numbers, numbers)), _described
    ),
    "of_a_package": _any_order(
        _described,
        _maybe(texts.map(" maintained_by {}".format)),
        _maybe(texts.map(" licensed_under {}".format)),
    ),
    "of_a_start": _any_order(_executable, _place, _maybe(remaps), _maybe(parameter_settings)),
}
"""What stands at each place of a form; clauses begin with a space."""

_FORMS = (
    "create_node {name} as {node}{of_a_node}",
    "load {other} as {node}",
    "load {other} node {name} as {node}",
    "load 'nodes/{other}.py' as {node}",
    "create_message {node} of message_type {type} and input {inputs}",
    "subscribe {node} to {name} of message_type {type}{of_a_subscription}",
    "unsubscribe {node} from {name}",
    "{node} publish {other} to {name} of message_type {type}{of_a_publication}",
    "{node} stop_publishing to {name}",
    "{node} client_requests {name} of service_type {type} with input {inputs}{rate}",
    "{node} stop_request {name}",
    "{node} provides_service {name} of service_type {type}{of_a_service}",
    "{node} stop_service {name}",
    "{node} provides_action {name} of action_type {type}{calling}",
    "{node} stop_action {name}",
    "{node} sends_goal to {name} of action_type {type} with input {inputs}",
    "{node} stop_goal to {name}",
    "{node} has_parameter {name} of parameter_type {other} with default {values}{of_a_parameter}",
    "{node} no_longer_has_parameter {name}",
    "{node} repeats {other}{rates}",
    "{node} stop_repeating {other}",
    "{node} renames {other} {name} to {name}",
    "generate_node {node}{using}",
    "create_message_type {type} with {definitions}",
    "create_service_type {type} with {definitions} returning {definitions}",
    "create_action_type {type} with {definitions} returning {definitions} reporting {definitions}",
    "load_type {name} as {node}",
    "{node} has_field {texts}{section}",
    "{node} no_longer_has_field {name}{section}",
    "drop_type {node}",
    "generate_type {node}",
    "create_package {name} as {node}{of_a_package}",
    "load_package {name} as {node}",
    "{node} contains {other}{executable}",
    "{node} no_longer_contains {other_or_name}",
    "generate_package {node}",
    "create_launch {name} as {node}",
    "load_launch {name} as {node}",
    "{node} has_argument {name} with default {values}",
    "{node} no_longer_has_argument {name}",
    "{node} starts {other_or_name}{of_a_start}",
    "{node} no_longer_starts {name}",
    "{node} includes {name}",
    "{node} no_longer_includes {name}",
    "generate_launch {node}",
)


def _formed(form: str) -> st.SearchStrategy[str]:
    """Return how the places of a form are filled: only its own words are drawn."""
    words = [_WORDS[word] for word in re.findall(r"\{(\w+)\}", form)]
    return st.tuples(*words).map(lambda drawn: re.sub(r"\{\w+\}", "{}", form).format(*drawn))


_formed_statements = st.one_of(list(map(_formed, _FORMS)))


@st.composite
def statements(draw: st.DrawFn) -> str:
    """Draw a statement, words between single spaces."""
    return draw(about_robots if draw(st.integers(0, 5)) == 0 else _formed_statements)


EXAMPLES = tuple(declaration.example for declaration in DECLARATIONS.values())
STRAYS = ("'a'", '"abc"', "1", "$", "of", "x", "(")

broken_lines = st.builds(
    str.format,
    st.sampled_from(["{0}{2}{3}", "{1}{2}{3}", "{1}{2}{0} {3}", "{0} {1} {1}", "{1}"]),
    st.sampled_from(EXAMPLES),
    st.sampled_from(STRAYS),
    st.sampled_from(["", " "]),
    st.sampled_from(EXAMPLES),
)
"""Lines in which statements, or a statement and other words, stand side by side."""


def boundary(text: bytes, share: float) -> int:
    """Return an offset between two characters."""
    at = round(share * len(text))
    while 0 < at < len(text) and text[at] & 0xC0 == 0x80:
        at -= 1
    return at


def read(text: str | bytes) -> Program:
    """Lower a text."""
    return lower(Document(text.encode() if isinstance(text, str) else text))


def shape(program: Program) -> list[object]:
    """Return what the statements of a program say, without where they say it."""
    return [
        (
            type(statement).__name__,
            *(
                _shape_of(getattr(statement, slot))
                for slot in type(statement).__slots__
                if slot not in ("span", "syntax")
            ),
        )
        for statement in program.statements
    ]


def _shape_of(value: object) -> object:
    match value:
        case Condition(quantifier, received, operator, compared):
            return quantifier, argument(received), operator, argument(compared)
        case (QosWord(), *_):
            return " ".join(f"{each.word} {each.number}" for each in value)
        case int() | float(), int() | float(), int() | float():
            return value  # a vector
        case tuple() if not hasattr(value, "syntax"):
            return tuple(map(argument, value))
        case tuple():
            return argument(value)  # type: ignore[arg-type]
        case _:
            return value


def operand(value: object) -> object:
    """Return what is calculated with, a number as it is."""
    return value if isinstance(value, int | float) else argument(value)  # type: ignore[arg-type]


def argument(value: Argument | FieldText | RemapText | SettingText) -> object:
    """Return what a value says, without where it says it."""
    match value:
        case FieldText(type_, name, operator, inner):
            return type_, name, operator, None if inner is None else argument(inner)
        case RemapText(old, new):
            return old, new
        case SettingText(name, inner):
            return name, argument(inner)
        case NamedArgument(path, inner):
            return ".".join(path), "=", argument(inner)
        case Literal(known):
            return repr(known)
        case ListValue(items):
            return ["list", *map(argument, items)]
        case NestedValue(arguments):
            return ["nested", *map(argument, arguments)]
        case ParameterValue(name):
            return f"parameter {name}"
        case Received(path, position):
            return f"received {'.'.join(path)}{'' if position is None else f'[{position}]'}"
        case Calculation(first, steps):
            return " ".join(
                [
                    str(argument(first)),
                    *(f"{step.operator} {operand(step.operand)}" for step in steps),
                ]
            )
