"""Random programs of one node that has something of every kind, or of some."""

from __future__ import annotations

import re

from hypothesis import strategies as st

SENTENCES = (
    "n has_parameter '{parameter}' of parameter_type int with default {int}{range}{described}",
    "n has_parameter '{parameter}' of parameter_type float with default {float}{range}",
    "n has_parameter '{parameter}' of parameter_type string_list with default [{text}, {text}]",
    "n has_parameter '{parameter}' of parameter_type bool with default {bool}",
    "n repeats {function} at {rate} hz",
    "n publish {string} to '{name}' of message_type String{sent}",
    "n publish {point} to '{name}' of message_type Point{sent}",
    "n publish {echo} to '{name}' of message_type Point for_each 'heard'{when}{qos}",
    "n publish {point} to 'both' of message_type Point for_each 'heard'{when}\n"
    "n publish {same} to 'both' of message_type Point at 2 hz",
    "subscribe n to '{name}' of message_type {message_type}{qos}{calling}",
    "n provides_service '{name}' of service_type AddTwoInts{answering}",
    "n client_requests '{name}' of service_type SetBool with input {bool}{asking}",
    "n provides_action '{name}' of action_type Fibonacci",
    "n provides_action '{name}' of action_type Fibonacci calling {function}",
    "n sends_goal to '{name}' of action_type Fibonacci with input {goal}",
)
"""What a program may say of its node; a new kind of endpoint is a line here."""

_ONCE = {
    "'rate'": "n has_parameter 'rate' of parameter_type float with default 5",
    "'heard'": "subscribe n to 'heard' of message_type Point",
}
"""What others refer to, and what makes that."""

_QOS_WORDS = (
    *("sensor_data", "system_default", "latched", "depth 3", "keep_all", "best_effort, depth 1"),
    *("transient_local, reliable", "volatile, deadline 0.5", "lifespan 1.5", "automatic"),
    "manual_by_topic, lease 2",
)
_QOS = st.sampled_from(["", *(f" with qos {words}" for words in _QOS_WORDS)])

_FILLINGS: dict[str, st.SearchStrategy[str]] = {
    "int": st.integers(-100, 100).map(str),
    "float": st.sampled_from(["0", "0.5", "-1.25", "100", "1e-3"]),
    "bool": st.sampled_from(["True", "False"]),
    "text": st.sampled_from(['""', '"left"', '"it\'s \\\\"', '"{x} %s é"']),
    "range": st.sampled_from(["", " between -100 and 100"]),
    "described": st.sampled_from(["", ' described_as "how \\"fast\\""']),
    "rate": st.sampled_from(["1", "0.5", "30", "parameter 'rate'"]),
    "sent": st.tuples(
        st.sampled_from(["", " at 2 hz", " at parameter 'rate' hz", " for_each 'heard'"]), _QOS
    ).map("".join)
    | st.sampled_from([" once", " once with qos transient_local, depth 3"]),
    "qos": _QOS,
    "when": st.sampled_from(["", " when received.x < 0.5", " when received.z = 2"]),
    "calling": st.sampled_from(["", " calling hear"]),
    "answering": st.sampled_from(
        ["", " answering sum=received.a * 2", " answering received.a + received.b"]
    ),
    "asking": st.sampled_from(["", " at 2 hz", " at parameter 'rate' hz"]),
    "goal": st.sampled_from(["order=5", "none"]),
    "message_type": st.sampled_from(["String", "Int32", "geometry_msgs/Twist"]),
}
_MESSAGES: dict[str, st.SearchStrategy[str]] = {
    "string": st.sampled_from(['String and input "hello"', "String and input none"]),
    "point": st.sampled_from(
        ["Point and input x=1", "Point and input x=parameter 'rate' / 2, z=parameter 'rate'"]
    ),
    "echo": st.sampled_from(
        ["Point and input x=received.y / received.x + 1", "Point and input y=2"]
    ),
}


@st.composite
def random_programs(draw: st.DrawFn, library: str) -> str:
    """Return a program whose node is generated last, for a client library; with rclpy some have
    a managed node."""
    is_managed = library == "rclpy" and draw(st.booleans())
    lines: list[str] = []
    for number, sentence in enumerate(
        draw(st.lists(st.sampled_from(SENTENCES), min_size=1, max_size=8))
    ):
        made: list[str] = []

        def fill(found: re.Match[str], number: int = number, made: list[str] = made) -> str:
            slot = found[1]
            if slot == "name":
                return draw(st.sampled_from([f"e{number}", f"/a/b{number}", f"some_{number}_name"]))
            if slot == "parameter":
                return f"p{number}"
            if slot == "function":
                return f"look_{number}"
            if slot == "same":
                return f"m{number}"
            if slot in _MESSAGES:
                value = draw(_MESSAGES[slot])
                made.append(f"create_message m{number} of message_type {value}")
                return f"m{number}"
            return draw(_FILLINGS[slot])

        line = re.sub(r"\{(\w+)\}", fill, sentence)
        lines += [*made, line]
    text = "\n".join(lines)
    needed = [line for name, line in _ONCE.items() if name in text]
    head = f"create_node 'robot' as n{' managed' if is_managed else ''}"
    return "\n".join([head, *needed, *lines, "generate_node n"]) + "\n"
