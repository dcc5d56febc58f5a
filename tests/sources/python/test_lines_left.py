"""What is left around the lines that a removal takes: comments, blank lines, other values."""

from __future__ import annotations

import pytest
from edits import AT, PUB, edited

from plastron_tui.model.source import Remove

HEAD = "import rospy\nfrom std_msgs.msg import Int32, String\n"
TAIL = "rospy.init_node('n')\n"
MORE = "keep = rospy.Publisher('keep', Int32)\n"

# What goes with `{}`, and what is left of the lines.
LINES = {
    "the larger gap stays": ("a = 1\n\n{}\n\nb = 2\n", "a = 1\n\n\nb = 2\n"),
    "one gap of two": ("a = 1\n\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
    "no gap": ("a = 1\n{}b = 2\n", "a = 1\nb = 2\n"),
    "no gap at the start of a block": ("if f():\n    {}\n    b = 2\n", "if f():\n    b = 2\n"),
    "no gap at the end": ("a = 1\n\n{}", "a = 1\n"),
    "its comment": ("a = 1\n\n# Publish greetings\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
    "a comment above another one": ("# Publish\n{}# Add\nb = 2\n", "# Add\nb = 2\n"),
    "its comment at the end of a block": (
        "def f():\n    a = 1\n    # Publish\n    {}\n\nb = 2\n",
        "def f():\n    a = 1\n\n\nb = 2\n",
    ),
    "its comment, which no line below is about": (
        "a = 1\n# the publishers\n{}b = 2\n", "a = 1\nb = 2\n"
    ),
    "a comment on another one too": (
        "# the publishers\n{}b = publisher()\n", "# the publishers\nb = publisher()\n"
    ),
    "its comment, with an aside": ("a = 1\n# Publish (to all)\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
    "a comment of more lines": ("# Greet, add\n{}b = 2\n", "# Greet, add\nb = 2\n"),
    "its comment, with a value": ("# Publish (to = all)\n{}b = 2\n", "b = 2\n"),
    "code in a comment": ("# p = None\n{}\nb = 2\n", "# p = None\n\nb = 2\n"),
    "a heading": (
        "a = 1\n\n####\n# Publishers\n####\n{}\n# ---- More ----\nb = 2\n",
        "a = 1\n\n# ---- More ----\nb = 2\n",
    ),
    "a heading on one line, at the end of a block": (
        "def f():\n    a = 1\n    # === Publish ===\n\n    {}\nb = 2\n",
        "def f():\n    a = 1\n\nb = 2\n",
    ),
    "a heading of something else": (
        "a = 1\n\n####\n# Greet\n####\n{}\n# ---- More ----\nb = 2\n",
        "a = 1\n\n####\n# Greet\n####\n\n# ---- More ----\nb = 2\n",
    ),
    "a heading of something more": (
        "# ---- Publish ----\n{}\nb = publish(2)\n", "# ---- Publish ----\n\nb = publish(2)\n"
    ),
    "a comment with a blank line below": ("a = 1\n\n# Publish\n\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
    "a comment on a paragraph": (
        "a = 1\n\n# Publish\n\n{}b = 2\n", "a = 1\n\n# Publish\n\nb = 2\n"
    ),
    "a ruler": ("# ---- Greet ----\n{}\nb = 2\n", "# ---- Greet ----\n\nb = 2\n"),
    "what tools read": ("# fmt: off\n{}\nb = 2\n", "# fmt: off\n\nb = 2\n"),
    "a comment further left": (
        "if f():\n# Greet\n    {}    b = 2\n", "if f():\n# Greet\n    b = 2\n"
    ),
    "a condition": ("if x and not y:\n    {}b = 2\n", "b = 2\n"),
    "conditions within others": (
        "if x:\n  if y:\n    if x and y:\n      with x.lock:\n        {}b = 2\n", "b = 2\n"
    ),
    "a condition with an else": (
        "if x:\n    {}else:\n    b = 2\n", "if x:\n    pass\nelse:\n    b = 2\n"
    ),
    "an else": ("if x:\n    b = 2\nelse:\n    {}", "if x:\n    b = 2\n"),
    "the end of the first way": (
        "if x:\n    b = 2\n\n    {}else:\n    b = 3\n", "if x:\n    b = 2\nelse:\n    b = 3\n"
    ),
    "both ways of a condition": ("if x:\n    {}elif y:\n    {}else:\n    {}b = 2\n", "b = 2\n"),
    "the last two of three ways": (
        "if x:\n    a = 1\nelif y:\n    {}else:\n    {}b = 2\n", "if x:\n    a = 1\nb = 2\n"
    ),
    "the last of three ways": (
        "if x:\n    a = 1\nelif f():\n    {}elif y:\n    {}b = 2\n",
        "if x:\n    a = 1\nelif f():\n    pass\nb = 2\n",
    ),
    "a condition that does something": ("if x == f():\n    {}b = 2\n", "f()\nb = 2\n"),
    "a condition that may do something": (
        "if x and f():\n    {}b = 2\n", "if x and f():\n    pass\nb = 2\n"
    ),
    "what is done in the end for nothing": ("try:\n    {}finally:\n    pass\nb = 2\n", "b = 2\n"),
    "what a lock guards": ("with x.lock:\n    {}b = 2\n", "b = 2\n"),
    "what a lock guards, and more": (
        "with x.lock:\n    {}    b = 2\n", "with x.lock:\n    b = 2\n"
    ),
    "what opens something": (
        "with x.lock, f() as z:\n    {}b = 2\n", "with x.lock, f() as z:\n    pass\nb = 2\n"
    ),
    "what may not fail any more": ("try:\n    {}except E:\n    c = 1\nb = 2\n", "b = 2\n"),
    "what is done then all the same": (
        "try:\n    {}finally:\n    c = 1\nb = 2\n",
        "try:\n    pass\nfinally:\n    c = 1\nb = 2\n",
    ),
    "what is done after a failure": (
        "try:\n    a = 1\nexcept E:\n    {}b = 2\n",
        "try:\n    a = 1\nexcept E:\n    pass\nb = 2\n",
    ),
    "what is done but after a failure": (
        "try:\n    a = 1\nexcept E:\n    c = 1\nelse:\n    {}b = 2\n",
        "try:\n    a = 1\nexcept E:\n    c = 1\nb = 2\n",
    ),
    "what alone is done in the end": (
        "try:\n    a = 1\nfinally:\n    {}b = 2\n",
        "try:\n    a = 1\nfinally:\n    pass\nb = 2\n",
    ),
    "what is done in the end": (
        "try:\n    a = 1\nexcept E:\n    c = 1\nfinally:\n    {}b = 2\n",
        "try:\n    a = 1\nexcept E:\n    c = 1\nb = 2\n",
    ),
    "a loop over what is there": ("for z in x:\n    {}b = 2\n", "b = 2\n"),
    "a loop over what is made": (
        "for z in f():\n    {}b = 2\n", "for z in f():\n    pass\nb = 2\n"
    ),
    "a loop whose turns may end": (
        "for z in x:\n    if z > 1:\n        break\n    elif z:\n        continue\n    {}b = 2\n",
        "b = 2\n",
    ),
    "a loop whose turns may end otherwise": (
        "for z in x:\n    if z > 1:\n        {}    else:\n        continue\nb = 2\n", "b = 2\n",
    ),
    "a loop that something ends": (
        "for z in x:\n    if f(z):\n        break\n    {}b = 2\n",
        "for z in x:\n    if f(z):\n        break\nb = 2\n",
    ),
    "a loop that looks for something": (
        "for z in x:\n    if z > 1:\n        break\n    {}b = z\n",
        "for z in x:\n    if z > 1:\n        break\nb = z\n",
    ),
    "a loop before another one": ("for z in x:\n    {}for z in y:\n    b = z\n",
                                  "for z in y:\n    b = z\n"),
    "a loop that something is left of": (
        "for z in x:\n    {}b = z\n", "for z in x:\n    pass\nb = z\n"
    ),
    "a loop with an else": (
        "for z in x:\n    {}else:\n    b = 2\n", "for z in x:\n    pass\nelse:\n    b = 2\n"
    ),
    "a value that a block needs": (
        "p = {}if f():\n    z = 1\n    p.publish(z)\n", "if f():\n    z = 1\n"
    ),
    "a value in a block of a script": (
        "p = {}if f():\n    z = 1\n    p.publish(z)\n    b = 2\n", "if f():\n    b = 2\n"
    ),
    "a message of a script": (
        "z = Int32()\nz.data = 1\np = {}p.publish(z)\nb = 2\n", "b = 2\n"
    ),
    "a message of a script that is read": (
        "z = Int32()\np = {}p.publish(z)\nb = z\n", "z = Int32()\nb = z\n"
    ),
    "a value of a class": (
        "p = {}class A:\n    z = 1\n    p.publish(z)\n", "class A:\n    z = 1\n"
    ),
    "a comment that is not about it": (
        "a = 1\n\n# Greet\n{}\nb = 2\n", "a = 1\n\n# Greet\n\nb = 2\n"
    ),
    "a comment about it in another language": (
        "a = 1\n\n# El publicador\n{}\nb = 2\n", "a = 1\n\nb = 2\n"
    ),
    "a comment on what is left too": (
        "a = 1\n\n# Publishers, services\n{}\nb = 2\n",
        "a = 1\n\n# Publishers, services\n\nb = 2\n",
    ),
    "a comment between lines that go": (
        "a = 1\n\n{}# Publish\n{}\nb = 2\n", "a = 1\n\nb = 2\n"
    ),
    "code for two that is none": (
        "a = 1\n# b, c.d = c.d, b\n{}\nb = 2\n", "a = 1\n# b, c.d = c.d, b\n\nb = 2\n"
    ),
    "a comment below code that is none": (
        "a = 1\n# print(x)\n# publish x\n{}\nb = 2\n", "a = 1\n# print(x)\n\nb = 2\n"
    ),
    "code that is none below a comment": (
        "a = 1\n# publish x\n# print(x)\n{}\nb = 2\n",
        "a = 1\n# publish x\n# print(x)\n\nb = 2\n",
    ),
    "a comment in Chinese": ("# 创建发布者\n{}b = 2\n", "b = 2\n"),
    "a comment in Chinese on something else": ("# 创建订阅者\n{}b = 2\n", "# 创建订阅者\nb = 2\n"),
    "a comment in another script": ("a = 1\n\n# 发布\n{}\nb = 2\n", "a = 1\n\nb = 2\n"),
}  # fmt: skip


@pytest.mark.parametrize("case", LINES)
def test_lines_around_what_is_removed(case):
    before, after = (f"{HEAD}x = y = String, Int32\n{each}" for each in LINES[case])
    if not case.endswith("end"):
        before, after = before + TAIL, after + TAIL
    before = before.replace("{}", "rospy.Publisher('t', String)\n")
    assert edited(f"{MORE}{before}", Remove(PUB, "t", AT)) == f"{MORE}{after}"
