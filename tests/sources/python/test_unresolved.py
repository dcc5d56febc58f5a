"""Names that mean nothing in a file, or nothing any more."""

from __future__ import annotations

import pytest

from plastron_tui.sources.python.calls import ROSPY
from plastron_tui.sources.python.shared_analysis import analyze
from plastron_tui.sources.python.unresolved import lost_names, meanings

CASES = {
    "print(x)": {"x"},
    "x = 1\nprint(x, len(__name__))": set(),
    "import a.b as c, d.e\nc.f(d.g)": set(),
    "from a import b as c\nb(c)": {"b"},
    "def f(a, *b, c=1, d: int = 2, **e):\n    return a, b, c, d, e": set(),
    "def f(a=b, c: d = 1) -> e: pass": {"b", "d", "e"},
    "g = lambda a, b=c: a + b + d": {"c", "d"},
    "print([a for a in b if a], a)": {"b", "a"},
    "class A(B):\n    x = 1\n    def f(self):\n        return x": {"B", "x"},
    "try:\n    pass\nexcept E as e:\n    print(e)": {"E"},
    "with a() as b:\n    b(c=d)": {"a", "d"},
    "def f():\n    global g\n    g = 1\nprint(g)": set(),
    "for i, (j, k) in z:\n    print(i, j, k)": {"z"},
    "if (n := 1):\n    print(n)": set(),
    "match p:\n    case [q, *r]:\n        print(q, r)": {"p"},
    "@d\ndef f(): pass": {"d"},
    "print(f'{a} {b!r:>{c}}')": {"a", "b", "c"},
    "del w": {"w"},
    "print unicode(raw_input())": set(),
}


@pytest.mark.parametrize("text", CASES)
def test_names(text: str) -> None:
    assert meanings(analyze(f"{text}\n".encode(), ROSPY)).unresolved == CASES[text]


CLASS = "class A({0}):\n    def f(self):\n        {1}\n    def g(self):\n        self.x(self.h())\n"
BOUND = CLASS.format("object", "self.x = 1")
LOST = {
    "nothing": (BOUND, BOUND, []),
    "an attribute": (BOUND, CLASS.format("object", "pass"), ["x"]),
    "an attribute that is not read": (BOUND, "class A:\n    def g(self): pass\n", []),
    "what a base class may have": (
        CLASS.format("B", "pass"), CLASS.format("B", "self.k()"), []
    ),
    "a method": (
        "class A:\n    def f(self): pass\nA().f()\na = A()\na.f()\n",
        "class A: pass\na = A()\na.f()\n",
        ["f"],
    ),
    "a name": ("import b\nb.c()\n", "b.c()\n", ["b"]),
    "a name that nothing bound": ("b.c()\n", "b.c()\nb.d()\n", []),
}  # fmt: skip


@pytest.mark.parametrize("name", LOST)
def test_lost_names(name: str) -> None:
    before, after, expected = LOST[name]
    found = [meanings(analyze(each.encode(), ROSPY)) for each in (after, before)]
    assert lost_names(*found) == expected
