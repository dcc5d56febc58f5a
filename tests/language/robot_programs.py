"""Statements about robots made by chance."""

from __future__ import annotations

from hypothesis import strategies as st


@st.composite
def robot_statements(
    draw: st.DrawFn,
    variables: st.SearchStrategy[str],
    names: st.SearchStrategy[str],
    numbers: st.SearchStrategy[str],
    inputs: st.SearchStrategy[str],
) -> str:
    """Draw a statement about a robot, words between single spaces.

    Args:
        draw: draws what it consists of.
        variables: words that are no keywords.
        names: names in single quotes.
        numbers: numbers.
        inputs: values, but for `none`.
    """
    robot, word, name, other = draw(variables), draw(variables), draw(names), draw(names)
    vectors = st.lists(numbers, min_size=3, max_size=3).map(", ".join)

    def clauses(*found: st.SearchStrategy[str]) -> str:
        chosen = draw(st.lists(st.sampled_from(found), max_size=len(found), unique=True))
        return "".join(draw(each) for each in chosen)

    place = vectors.map(" at {}".format)
    rotation = st.builds(" turned {} {}".format, vectors, variables)
    code = st.sampled_from(["red", "painted", '"#3060ff"', '""', "none"]).map(" painted {}".format)
    shape = st.builds(" shaped {} {}".format, variables, inputs)
    weight = numbers.map(" weighing {}".format)
    axis = vectors.map(" with axis {}".format)
    followed = st.builds(
        " mimicking {}{}".format, names, st.just("") | numbers.map(" times {}".format)
    ) | st.just(" mimicking none")
    limits = st.builds(" between {} and {} {}".format, numbers, numbers, variables)
    effort = st.builds(" with effort {} and velocity {}".format, numbers, numbers)
    damping = st.builds(" with damping {} and friction {}".format, numbers, numbers)
    match draw(st.integers(0, 4)):
        case 0:
            return f"{robot} has_link {name}{clauses(shape, weight, code, place, rotation)}"
        case 1:
            held = st.just(f" from {name} to {other}")
            said = clauses(st.just(f" of joint_type {word}"), held, place, rotation, axis, followed)
            return f"{robot} has_joint {name}{said}"
        case 2:
            return f"{robot} limits_joint {name}{clauses(limits, effort, damping)}"
        case 3:
            part = draw(st.sampled_from(["link", "joint"]))
            return f"{robot} no_longer_has_{part} {name}"
        case _:
            begun = draw(st.sampled_from([f"create_robot {name} as", f"load_robot {name} as"]))
            given = draw(st.sampled_from(["", " setting 'a' = 1"])) if "load" in begun else ""
            return draw(st.sampled_from([f"{begun} {robot}{given}", f"generate_robot {robot}"]))
