"""Computed values of C++: what the compiler makes of them is what the language means."""

from __future__ import annotations

import itertools
import math
import operator
import random
import struct
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from calculations import HEARD as HEARD_LISTS
from calculations import calculations

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Condition
from plastron_tui.model.kinds.ranges import Interval, field_range
from plastron_tui.model.values import Computed, OfParameter, OfReceived, calculated
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import Field, FieldType
from plastron_tui.sources.cpp import literals
from plastron_tui.sources.cpp.computed import Computing, Functions
from plastron_tui.sources.cpp.interface_types import scalar_class
from plastron_tui.targets.templates import render_template

INTEGERS = [f"{sign}int{bits}" for bits in (8, 16, 32, 64) for sign in ("", "u")]
FLOATS = ["float32", "float64"]
NUMBERS = [*INTEGERS, *FLOATS]
STEPS: list[tuple[tuple[str, int | float], ...]] = [
    (),
    (("*", 2),),
    (("+", 1), ("*", 3)),
    (("-", 5),),
    (("*", -1),),
    (("*", 1_000_000_007),),
    (("/", 4),),
    (("*", 0.5), ("+", 0.25)),
]
HEARD = tuple(Field(name, FieldType(name)) for name in NUMBERS)
LISTS = tuple(Field(f"{name}s", FieldType(name, is_array=True)) for name in NUMBERS)

PROGRAM = """
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>
FUNCTIONS

struct Received
{
  MEMBERS
};

template<typename Number>
void show(Number number)
{
  std::cout << +number << '\\n';
}

template<typename Number>
void show(const std::vector<Number> & numbers)
{
  for (const auto number : numbers) {
    std::cout << +number << ' ';
  }
  std::cout << '\\n';
}

BLOCKS

int main()
{
  std::cout.precision(17);
  CALLS
  return 0;
}
"""


class _Plan:
    def __init__(self, functions: Functions) -> None:
        self.functions = functions


def computing(version: int, functions: Functions) -> Computing:
    def parameter(name: str) -> tuple[str, Interval | None]:
        return name, field_range(FieldType("float64" if name == "real" else "int64"), version)

    return Computing(Catalog("jazzy"), version, Span(0, 0), parameter, functions)


def results(tmp_path: Path, blocks: list[str], functions: Functions) -> list[str]:
    """Compile blocks, and return the line that each prints; `!` where it throws."""
    members = [f"{scalar_class(name, 2)} {name};" for name in NUMBERS]
    members += [f"std::vector<{scalar_class(name, 2)}> {name}s;" for name in NUMBERS]
    made = [
        f"void block{index}()\n{{\n  Received received{{}};\n{block}\n}}\n"
        for index, block in enumerate(blocks)
    ]
    calls = [
        f'try {{block{index}();}} catch (const std::out_of_range &) {{std::cout << "!\\n";}}'
        for index in range(len(blocks))
    ]
    text = (
        PROGRAM.replace(
            "FUNCTIONS", render_template(("cpp",), None, "functions.j2", {"node": _Plan(functions)})
        )
        .replace("MEMBERS", "\n  ".join(members))
        .replace("BLOCKS", "\n".join(made))
        .replace("CALLS", "\n  ".join(calls))
    )
    source = tmp_path / "computed.cpp"
    source.write_text(text)
    flags = ["-std=c++14", "-O0", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
    subprocess.run(["g++", *flags, "-o", tmp_path / "computed", source], check=True)
    run = subprocess.run([tmp_path / "computed"], capture_output=True, text=True, check=True)
    return run.stdout.split("\n")[:-1]


def values_of(name: str, chance: random.Random) -> list[int | float]:
    range_ = field_range(FieldType(name), 2)
    assert range_ is not None
    if isinstance(range_.least, int):
        return [range_.least, range_.most, chance.randint(-100, 100) % (range_.most // 2)]
    return [0.0, -2.5, chance.uniform(-1e6, 1e6) // 0.125 * 0.125]


def literal(name: str, value: int | float) -> str:
    return literals.integer(int(value)) if name in INTEGERS else literals.real(float(value))


def stored(name: str, number: int | float) -> str | float:
    """Return what a field of a type holds of a number, `!` where it cannot."""
    range_ = field_range(FieldType(name), 2)
    assert range_ is not None
    if isinstance(range_.least, int):
        return number if range_.least <= number <= range_.most else "!"
    if name == "float32":
        try:
            return float(struct.unpack("f", struct.pack("f", number))[0])
        except OverflowError:
            return math.copysign(math.inf, number)
    return float(number)


def is_same(shown: str, wanted: str | float) -> bool:
    if wanted == "!" or shown == "!":
        return shown == wanted
    return math.isclose(float(shown), float(wanted), rel_tol=1e-6, abs_tol=1e-9)


@pytest.mark.long(0.3)
def test_a_number_is_stored_as_the_language_means_it(tmp_path: Path) -> None:
    chance = random.Random(14)
    functions = Functions()
    writer = computing(2, functions)
    blocks, wanted = [], []
    for given, taken, steps in itertools.product(NUMBERS, NUMBERS, STEPS):
        is_float = given in FLOATS or any(
            sign == "/" or isinstance(number, float) for sign, number in steps
        )
        if is_float and taken in INTEGERS:
            continue
        value = Computed(OfReceived((given,)), steps, FieldType(taken), is_float)
        number = chance.choice(values_of(given, chance))
        target = f"{scalar_class(taken, 2)} target{{}};"
        lines = [f"received.{given} = {literal(given, number)};", target]
        lines += [*writer.set("target", value, "received", HEARD), "show(target);"]
        blocks.append("\n".join(f"  {line}" for line in lines))
        wanted.append(stored(taken, calculated(number, steps)))
    shown = results(tmp_path, blocks, functions)
    wrong = [
        (block, got, want)
        for block, got, want in zip(blocks, shown, wanted, strict=True)
        if not is_same(got, want)
    ]
    assert wrong == []


@pytest.mark.long(0.2)
def test_a_list_is_stored_as_the_language_means_it(tmp_path: Path) -> None:
    functions = Functions()
    writer = computing(2, functions)
    blocks, wanted = [], []
    for given, taken in itertools.product(NUMBERS, NUMBERS):
        if given in FLOATS and taken in INTEGERS:
            continue
        value = Computed(OfReceived((f"{given}s",)), (), FieldType(taken, is_array=True))
        for number in (7, values_of(given, random.Random(1))[1]):
            lines = [
                f"received.{given}s = {{1, {literal(given, number)}}};",
                f"std::vector<{scalar_class(taken, 2)}> target;",
                *writer.set("target", value, "received", LISTS),
                "show(target);",
            ]
            blocks.append("\n".join(f"  {line}" for line in lines))
            wanted.append(stored(taken, number))
    for source, taken in (("real", "float32"), ("whole", "float64")):
        value = Computed(OfParameter(source), (), FieldType(taken, is_array=True))
        class_ = "double" if source == "real" else "int64_t"
        lines = [
            f"const auto {source} = std::vector<{class_}>{{1, 7}};",
            f"std::vector<{scalar_class(taken, 2)}> target;",
            *writer.set("target", value, "received", LISTS),
            "show(target);",
        ]
        blocks.append("\n".join(f"  {line}" for line in lines))
        wanted.append(7)
    shown = results(tmp_path, blocks, functions)
    wrong = [
        (block, got, want)
        for block, got, want in zip(blocks, shown, wanted, strict=True)
        if not is_same(got.split(" ")[1] if " " in got else got, want)
    ]
    assert wrong == []


@pytest.mark.long(0.3)
def test_what_is_calculated_of_several_is_what_the_language_means(tmp_path: Path) -> None:
    functions = Functions()
    writer = computing(2, functions)
    found = list(calculations(500, 5))
    blocks = []
    for each in found:
        lines = [
            f"received.{name} = {{{literal(name.removesuffix('s'), number)}}};"
            for name, number in each.received.items()
        ]
        lines.append(f"{scalar_class(each.value.type.name, 2)} target{{}};")
        lines += [*writer.set("target", each.value, "received", HEARD_LISTS), "show(target);"]
        blocks.append("\n".join(f"  {line}" for line in lines))
    shown = results(tmp_path, blocks, functions)
    wrong = [
        (block, got, each.wanted)
        for block, got, each in zip(blocks, shown, found, strict=True)
        if got != str(each.wanted)
        and (isinstance(each.wanted, int) or not is_same(got, each.wanted))
    ]
    assert wrong == []


CONSTANTS = [
    *(-1, 0, 1, 5, 127, 128, 255, 256, -128, -129, 2**31 - 1, 2**31, 2**32, 2**63 - 1, -(2**63)),
    *(0.5, -0.5, 100.0, 1e300),
]
OPERATORS: dict[str, Callable[[float, float], bool]] = {
    "=": operator.eq,
    "<": operator.lt,
    ">": operator.gt,
}


@pytest.mark.long(0.3)
def test_a_condition_holds_as_the_language_means_it(tmp_path: Path) -> None:
    chance = random.Random(15)
    functions = Functions()
    writer = computing(2, functions)
    blocks, wanted = [], []
    for given, (sign, holds), constant in itertools.product(NUMBERS, OPERATORS.items(), CONSTANTS):
        number = chance.choice([*values_of(given, chance), 5, 100])
        condition = Condition(None, OfReceived((given,)), sign, constant)
        written = literals.scalar(constant)
        text = writer.condition(condition, "received", HEARD, written)
        blocks.append(
            f"  received.{given} = {literal(given, number)};\n"
            f"  if ({text}) {{show(1);}} else {{show(0);}}"
        )
        held = stored(given, number)
        assert not isinstance(held, str)
        wanted.append(int(holds(held, constant)))
    shown = results(tmp_path, blocks, functions)
    wrong = [
        (block, got, want)
        for block, got, want in zip(blocks, shown, wanted, strict=True)
        if int(got) != want
    ]
    assert wrong == []
