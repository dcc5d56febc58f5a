"""Programs made by chance, for properties that hold of every program."""

from __future__ import annotations

from hypothesis import strategies as st

from plastron_tui.language import DECLARATIONS, Document, Program, lower
from plastron_tui.language.inputs import Argument, ListValue, Literal, NamedArgument
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


values = st.recursive(numbers | texts | st.sampled_from(["True", "False"]), _values, max_leaves=6)
inputs = st.just("none") | st.lists(
    values | st.tuples(fields, values).map("=".join), min_size=1, max_size=4
).map(", ".join)


@st.composite
def statements(draw: st.DrawFn) -> str:
    """Draw a statement, words between single spaces."""
    node, other, name = draw(variables), draw(variables), draw(names)
    type_ = draw(types)
    using = draw(st.sampled_from(["", " using rospy", " using rclpy"]))
    calling = draw(st.sampled_from(["", f" calling {other}", " calling _handle"]))
    rate = draw(st.just("") | numbers.map(" at {} hz".format))
    return draw(
        st.sampled_from(
            [
                f"create_node {name} as {node}{using}",
                f"load {other} as {node}",
                f"load 'nodes/{other}.py' as {node}",
                f"create_message {node} of message_type {type_} and input {draw(inputs)}",
                f"subscribe {node} to {name} of message_type {type_}{calling}",
                f"unsubscribe {node} from {name}",
                f"{node} publish {other} to {name} of message_type {type_}{rate}",
                f"{node} stop_publishing to {name}",
                f"{node} client_requests {name} of service_type {type_} with input {draw(inputs)}",
                f"{node} stop_request {name}",
                f"{node} provides_service {name} of service_type {type_}{calling}",
                f"{node} stop_service {name}",
                f"generate_node {node}{using}",
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
    return tuple(map(argument, value)) if isinstance(value, tuple) else value


def argument(value: Argument) -> object:
    """Return what a value says, without where it says it."""
    if isinstance(value, NamedArgument):
        return ".".join(value.path), "=", argument(value.value)
    if isinstance(value, Literal):
        return repr(value.value)
    if isinstance(value, ListValue):
        return ["list", *map(argument, value.items)]
    return ["nested", *map(argument, value.arguments)]
