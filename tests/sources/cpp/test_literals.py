"""Literals of C++: what is written is what the compiler reads."""

from __future__ import annotations

import struct
import subprocess
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from plastron_tui.sources.cpp import literals

HARD_TEXTS = [
    "",
    "plain",
    'quote " and \\ backslash',
    "\n\r\t\v\f\a\b\x1b\x7f",
    "??/ ??= ??' ?????/ ?",
    "100 % %s %d %%",
    "a\0b",
    "\0",
    "\0" + "0123",
    "\x011 \x07f",
    "grüße 你好 🤖",
    "\u202eright to left\u2066",
    "\u2028\u0085\ufeff",
    '*/ // R"( )" {{ }} {% %}',
    "line\\\nsplice",
    "x" * 3000,
]
HARD_INTEGERS = [
    *(
        sign * 2**bits + off
        for bits in (7, 8, 15, 16, 31, 32, 63)
        for sign in (1, -1)
        for off in (-1, 0, 1)
    ),
    0,
    2**64 - 1,
]
HARD_FLOATS = [
    0.0,
    -0.0,
    1.0,
    0.1,
    1e300,
    1e-300,
    5e-324,
    -1.7976931348623157e308,
    1e16,
    123456789.123456789,
    float("inf"),
    float("-inf"),
    float("nan"),
]


def fits(value: int) -> bool:
    return -(2**63) <= value < 2**64


TEXTS = st.lists(st.text(max_size=30), min_size=60, max_size=60)
INTEGERS = st.lists(st.integers(-(2**63), 2**64 - 1), min_size=60, max_size=60)
FLOATS = st.lists(st.floats(), min_size=60, max_size=60)


def printed(tmp_path: Path, texts: list[str], integers: list[int], floats: list[float]) -> bytes:
    """Compile a program that has the values as literals, and return what it prints of them."""
    lines = [f"text({literals.string(text)});" for text in texts]
    lines += [f"wide({literals.wide(text)});" for text in texts]
    lines += [
        f"raw<{'uint64_t' if value >= 2**63 else 'int64_t'}>({literals.integer(value)});"
        for value in integers
    ]
    lines += [f"raw<double>({literals.real(value)});" for value in floats]
    source = tmp_path / "values.cpp"
    source.write_text(PROGRAM.replace("VALUES", "\n  ".join(lines)), encoding="utf-8")
    program = tmp_path / "values"
    flags = ["-std=c++14", "-O0", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
    subprocess.run(["g++", *flags, "-o", program, source], check=True)
    return subprocess.run([program], capture_output=True, check=True).stdout


PROGRAM = """
#include <cstdint>
#include <cstring>
#include <iostream>
#include <limits>
#include <string>

void bytes(const char * data, uint64_t size)
{
  std::cout.write(reinterpret_cast<const char *>(&size), 8);
  std::cout.write(data, static_cast<std::streamsize>(size));
}

void text(const std::string & value) {bytes(value.data(), value.size());}

void wide(const std::u16string & value)
{
  bytes(reinterpret_cast<const char *>(value.data()), 2 * value.size());
}

template<typename Number>
void raw(Number number) {bytes(reinterpret_cast<const char *>(&number), sizeof(number));}

int main()
{
  VALUES
  return 0;
}
"""


def expected(texts: list[str], integers: list[int], floats: list[float]) -> bytes:
    held = [text.encode(errors="surrogatepass") for text in texts]
    held += [text.encode("utf-16-le", errors="surrogatepass") for text in texts]
    held += [struct.pack("<Q" if value >= 2**63 else "<q", value) for value in integers]
    held += [struct.pack("<d", value) for value in floats]
    return b"".join(struct.pack("<Q", len(each)) + each for each in held)


@pytest.mark.long(0.2)
def test_the_compiler_reads_what_was_meant(tmp_path: Path) -> None:
    integers = [value for value in HARD_INTEGERS if fits(value)]
    values = HARD_TEXTS, integers, HARD_FLOATS
    assert printed(tmp_path, *values) == expected(*values)


@pytest.mark.long(0.5)
@settings(
    max_examples=5, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
@given(TEXTS, INTEGERS, FLOATS)
def test_the_compiler_reads_any_value(
    tmp_path: Path, texts: list[str], integers: list[int], floats: list[float]
) -> None:
    # Which bits a number that is none has is the compiler's choice.
    values = texts, integers, [value for value in floats if value == value]
    assert printed(tmp_path, *values) == expected(*values)


@pytest.mark.parametrize(
    ("value", "literal"),
    [
        ("hello", '"hello"'),
        ('say "hi"', '"say \\"hi\\""'),
        ("a\0b", 'std::string("a\\000b", 3)'),
        ("??/", '"?\\?/"'),
        ("100 %", '"100 %"'),
        ("grüße", '"grüße"'),
        (True, "true"),
        (-(2**63), "(-9223372036854775807LL - 1)"),
        (2**63, "9223372036854775808ULL"),
        (2**31, "2147483648LL"),
        (1.0, "1.0"),
        (1e30, "1e30"),
        (float("-inf"), "-std::numeric_limits<double>::infinity()"),
    ],
)
def test_a_literal(value: bool | int | float | str, literal: str) -> None:
    assert literals.scalar(value) == literal
