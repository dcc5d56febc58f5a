"""Values that only what is removed read go with it, though their variable is read elsewhere."""

from __future__ import annotations

import pytest
from edits import AT, PUB, edited

from plastron_tui.model.source import Remove

HEAD = "import rospy\nfrom std_msgs.msg import Int32, String\n"
PUBS = "keep = rospy.Publisher('keep', Int32)\nrospy.Subscriber('b', Int32, f)\n"
# The body of a function, in which the lines with a `-` go.
CASES = {
    "a last value": "x = g()\nprint(x)\n-x = 2 * x\n-p.publish(x)\n",
    "a chain of values": (
        "x = g()\nprint(x)\n-if x > 3:\n-    x = 3\n-x = 2 * x\n-y = x\n"
        "-p.publish(y)\nx = 4\nprint(x)\n"
    ),
    "a value that one way reads": (
        "x = g()\nprint(x)\nx = 2\n-p.publish(x)\nif g():\n    print(x)\n"
    ),
    "a value of one of two ways": (
        "if g():\n    print()\n-    n = Int32()\n-    n.data = 2\n-    p.publish(n)\n"
        "else:\n    n = Int32()\n    n.data = 3\n    keep.publish(n)\n"
    ),
    "a value that the next turn reads": (
        "x = 0\nwhile g():\n    print(x)\n    x += 1\n-    p.publish(x)\n"
    ),
    "a value that the next turn gives anew": (
        "while g():\n    x = g()\n    print(x)\n-    x += 1\n-    p.publish(x)\n"
    ),
    "a value of a turn that ends": (
        "x = 0\nfor y in g():\n    x = 2\n-    p.publish(x)\n    if y:\n        break\n"
        "    x = 3\nprint(x)\n"
    ),
    "a value that a handler reads": (
        "x = 0\ntry:\n    x = 1\n-    p.publish(x)\n    g()\n    x = 2\nexcept E:\n    print(x)\n"
    ),
    "a value that is read in the end": (
        "x = 0\ntry:\n    x = 1\n-    p.publish(x)\n    return\nfinally:\n    print(x)\n"
    ),
    "a value in front of the end": (
        "x = g()\ntry:\n    print(x)\n-    x = 1\n-    p.publish(x)\nfinally:\n    print()\n"
    ),
    "a value that a function inside reads": ("x = 0\ng(lambda: x)\nx = 1\n-p.publish(x)\ng(x)\n"),
    "a value that nothing read before": "x = g()\nprint(x)\nx = 1\n-p.publish(2)\n",
    "a value that such a one reads": "x = g()\nprint(x)\nx = 1\ny = x\n-p.publish(x)\n",
    "a value that does something": "x = g()\nprint(x)\nx = g()\n-p.publish(x)\n",
    "a part of what another has": (
        "m = Int32()\ng(m)\nm.data = 2\n-p.publish(m)\nm = Int32()\nkeep.publish(m)\n"
    ),
    "a part of what is given": "m.data = 2\n-p.publish(m)\nm = Int32()\nkeep.publish(m)\n",
    "a list that others have": "x = m\nx += [1]\n-p.publish(x)\nx = 2\nprint(x)\n",
    "an array that others have": "x = m\nx += 1\n-p.publish(x)\nx = 2\nprint(x)\n",
    "a parameter": "if g():\n    print()\n-    m = 2\n-p.publish(m)\n",
    "the only line of a way": (
        "if g():\n    x = 2\nelse:\n    print()\n-p.publish(x)\nx = 3\ng(x)\n"
    ),
    "a value that a call reads which is left bare": "x = 1\ng(x)  # y = g(x)\n-p.publish(y)\n",
    "what reads all": "x = g()\nprint(x)\nx = 2\n-p.publish(x)\nprint(locals())\n",
}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("x = y = n = 0", "y = 0"),
        ("y = x = n = 0", "y = 0"),
        ("n = x = y = 0", "y = 0"),
        ("y = 0; x = n = 0", "y = 0; x = n = 0"),
        ("y = 0; x = m.data = n = 0", "y = 0; m.data = 0"),
    ],
)
def test_names_that_get_a_value_with_others(before: str, after: str) -> None:
    head = f"{HEAD}p = rospy.Publisher('a', Int32)\n{PUBS}"
    rest = "    x += 2\n    p.publish(x + n)\n"
    text = edited(f"{head}def f(m):\n    {before}\n{rest}    print(y)\n", Remove(PUB, "a", AT))
    assert text.endswith(f"def f(m):\n    {after}\n    print(y)\n")


@pytest.mark.parametrize("parts", ["m.x = m.y = 0", "m.x = m.z.y = m.y = 0.5"])
def test_parts_that_get_a_value_together(parts: str) -> None:
    head = f"{HEAD}p = rospy.Publisher('a', Int32)\n{PUBS}"
    body = f"    print(x)\n    m = String()\n    {parts}\n    p.publish(m)\n"
    text = edited(f"{head}def f(x):\n{body}", Remove(PUB, "a", AT))
    assert text.endswith("def f(x):\n    print(x)\n")


@pytest.mark.parametrize("case", CASES)
def test_values_that_nothing_reads_any_more(case: str) -> None:
    lines = [f"    {each}\n" for each in CASES[case].splitlines()]
    lines = [
        each.replace("    -", "    ") if each[4] == "-" else f"{each[:-1]}  #\n" for each in lines
    ]
    kept = [each for each in lines if each.endswith("#\n")]
    # What is written behind a line stood there before.
    lines = [each.replace("g(x)  # y =", "y =") for each in lines]
    before = f"{HEAD}p = rospy.Publisher('a', Int32)\n{PUBS}def f(m):\n{''.join(lines)}"
    after = edited(before, Remove(PUB, "a", AT))
    assert after.partition("def f(m):\n")[2] == "".join(kept).replace("# y = g(x)  #", "#")
