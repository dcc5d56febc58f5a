"""Names that lead to each other, within a file and between files: each question about them ends."""

from __future__ import annotations

import re
from pathlib import Path
from random import Random

import pytest
from file_sets import one
from machine import mostly_long

from plastron_tui.sources.python import read_python

MODULES = ("m0", "m1", "m2")
DEEPEST = 4
DEEP_CIRCLES = (1224, 1392, 1435, 3434, 3709, 4489)
"""Modules of random numbers that lead from question to question without an end."""
PARTS = {
    "n": "abcXY",
    "m": MODULES,
    # The first four lead no deeper.
    "e": (
        "$n", "$m.$n", "$n.$n", "'s'", "$e.$n", "$n($e)", "$e + $e", "$m.$n($e)", "self.$n",
        "$e.$n($e)", "$n[$e]", 'f"{$n}/{$n.$n}"',
    ),
    "s": (
        "$n = $e", "rospy.Publisher($e, $e, queue_size=1)", "$e", "from $m import $n as $n",
        "self.$n = $e", "for $n in $e: $n = $e", "return $e", "$n($e, $n=$e)",
    ),
    "d": (
        "$n = $e\n", "from $m import *\n", "from $m import $n as $n\n",
        "def $n($n, z=$e):\n    $s\n    $s\n    $s\n",
        "class $n($m.$n, $n):\n    def __init__(self, $n=$e):\n        $s\n        $s\n"
        "    def $n(self, $n):\n        $s\n        $s\n",
    ),
}  # fmt: skip


def filled(random: Random, form: str, depth: int = 0) -> str:
    """Return a form with names, modules, expressions, statements and definitions in its places."""

    def fill(place: re.Match[str]) -> str:
        parts = PARTS[place[1]]
        is_deep = place[1] == "e" and depth > DEEPEST
        return filled(random, random.choice(parts[:4] if is_deep else parts), depth + 1)

    return re.sub(r"\$([nmesd])", fill, form)


def module(random: Random) -> str:
    return "import rospy, m0, m1, m2\n" + filled(random, "$d" * 8)


@pytest.mark.parametrize("seed", mostly_long((*DEEP_CIRCLES, *range(200)), DEEP_CIRCLES))
def test_names_that_lead_to_each_other_are_read_to_an_end(seed: int, tmp_path: Path) -> None:
    random = Random(seed)
    for name in MODULES:
        (tmp_path / f"{name}.py").write_text(module(random))
    for _ in range(8):
        source = read_python(tmp_path / "node.py", one(module(random).encode())).source
        assert source is not None
