"""Programs made by chance, for properties that hold of every program."""

from __future__ import annotations

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


@st.composite
def statements(draw: st.DrawFn) -> str:
    """Draw a statement, words between single spaces."""
    if draw(st.integers(0, 5)) == 0:
        return draw(about_robots)
    node, other, name = draw(variables), draw(variables), draw(names)
    type_ = draw(types)
    using = draw(st.sampled_from(["", " using rospy", " using rclpy"]))
    calling = draw(st.sampled_from(["", f" calling {other}", " calling _handle"]))
    managed = draw(st.sampled_from(["", " managed"]))
    rate = draw(st.just("") | rates)
    quality = draw(st.just("") | qos)
    when = draw(st.just("") | conditions.map(" when {}".format))
    sent = draw(st.sampled_from([rate, " once", f" for_each {name}{when}"]))
    limits = draw(st.sampled_from(["", f" between {draw(numbers)} and {draw(numbers)}"]))
    described = draw(st.just("") | texts.map(" described_as {}".format))
    answering = draw(st.just("") | inputs.map(" answering {}".format))
    mail = draw(st.just("") | texts.map(" maintained_by {}".format))
    license_ = draw(st.just("") | texts.map(" licensed_under {}".format))
    section = draw(st.sampled_from(["", f" in {other}"]))
    executable = draw(st.sampled_from(["", f" as {name}"]))
    places = [f" in {name}", f" inside {name}", f" with parameters {name}"]
    place = draw(st.lists(st.sampled_from(places), unique=True).map("".join))
    given = draw(st.just("") | remaps), draw(st.just("") | parameter_settings)

    def any_order(*clauses: str) -> str:
        return "".join(draw(st.permutations(clauses)))

    return draw(
        st.sampled_from(
            [
                f"create_node {name} as {node}{any_order(using, managed)}",
                f"load {other} as {node}",
                f"load {other} node {name} as {node}",
                f"load 'nodes/{other}.py' as {node}",
                f"create_message {node} of message_type {type_} and input {draw(inputs)}",
                f"subscribe {node} to {name} of message_type {type_}{any_order(quality, calling)}",
                f"unsubscribe {node} from {name}",
                f"{node} publish {other} to {name} of message_type {type_}"
                f"{any_order(sent, quality)}",
                f"{node} stop_publishing to {name}",
                f"{node} client_requests {name} of service_type {type_} with input {draw(inputs)}"
                f"{rate}",
                f"{node} stop_request {name}",
                f"{node} provides_service {name} of service_type {type_}"
                f"{any_order(answering, calling)}",
                f"{node} stop_service {name}",
                f"{node} provides_action {name} of action_type {type_}{calling}",
                f"{node} stop_action {name}",
                f"{node} sends_goal to {name} of action_type {type_} with input {draw(inputs)}",
                f"{node} stop_goal to {name}",
                f"{node} has_parameter {name} of parameter_type {other} with default"
                f" {draw(values)}{any_order(limits, described)}",
                f"{node} no_longer_has_parameter {name}",
                f"{node} repeats {other}{draw(rates)}",
                f"{node} stop_repeating {other}",
                f"{node} renames {other} {name} to {name}",
                f"generate_node {node}{using}",
                f"create_message_type {type_} with {draw(definitions)}",
                f"create_service_type {type_} with {draw(definitions)}"
                f" returning {draw(definitions)}",
                f"create_action_type {type_} with {draw(definitions)}"
                f" returning {draw(definitions)} reporting {draw(definitions)}",
                f"load_type {name} as {node}",
                f"{node} has_field {draw(texts)}{section}",
                f"{node} no_longer_has_field {name}{section}",
                f"drop_type {node}",
                f"generate_type {node}",
                f"create_package {name} as {node}{any_order(described, mail, license_)}",
                f"load_package {name} as {node}",
                f"{node} contains {other}{executable}",
                f"{node} no_longer_contains {draw(st.sampled_from([other, name]))}",
                f"generate_package {node}",
                f"create_launch {name} as {node}",
                f"load_launch {name} as {node}",
                f"{node} has_argument {name}{draw(values.map(' with default {}'.format))}",
                f"{node} no_longer_has_argument {name}",
                f"{node} starts {draw(st.sampled_from([other, name]))}"
                f"{any_order(executable, place, *given)}",
                f"{node} no_longer_starts {name}",
                f"{node} includes {name}",
                f"{node} no_longer_includes {name}",
                f"generate_launch {node}",
            ]
        )
    )


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
