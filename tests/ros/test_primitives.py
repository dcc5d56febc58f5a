from __future__ import annotations

import math

import pytest

from plastron_tui.ros.primitives import PRIMITIVES, check_scalar, primitive

FITS = [
    ("int8", -128, 1),
    ("int8", 127, 1),
    ("uint64", 2**64 - 1, 2),
    ("int64", -(2**63), 2),
    ("byte", -128, 1),
    ("byte", 255, 2),
    ("char", 255, 1),
    ("char", 255, 2),
    ("bool", True, 1),
    ("float32", 3, 1),
    ("float32", 3.4e38, 1),
    ("float32", math.inf, 1),
    ("float64", math.nan, 2),
    ("float64", 1e308, 1),
    ("string", "grün \n 日本", 2),
    ("string", "a\0b", 1),
    ("wstring", "x", 2),
    ("time", 1.5, 1),
    ("duration", -1, 1),
]

DOES_NOT_FIT = [
    ("uint8", 300, 1, "300 does not fit `uint8` (0 to 255)"),
    ("uint8", -1, 1, "-1 does not fit `uint8` (0 to 255)"),
    ("byte", 200, 1, "200 does not fit `byte` (-128 to 127)"),
    ("byte", -1, 2, "-1 does not fit `byte` (0 to 255)"),
    ("char", 256, 2, "256 does not fit `char` (0 to 255)"),
    ("int32", 1.0, 1, "1.0 is not a whole number, which `int32` takes"),
    ("int32", True, 1, "True is not a number, which `int32` takes"),
    ("int32", "5", 1, '"5" is not a number, which `int32` takes'),
    ("int64", 10**3000, 1, "a number of more than 40 digits does not fit `int64` "),
    ("float64", 10**400, 1, "a number of more than 40 digits does not fit `float64`"),
    ("float64", False, 2, "False is not a number, which `float64` takes"),
    ("float32", 3.5e38, 1, "3.5e+38 does not fit `float32` (up to 3.4e38)"),
    ("float32", -1e39, 2, "-1e+39 does not fit `float32` (up to 3.4e38)"),
    ("bool", 1, 1, "1 is not a `bool`"),
    ("bool", "True", 2, '"True" is not a `bool`'),
    ("string", 5, 1, "5 is not a string, which `string` takes"),
    ("string", "\ud800", 1, "half of a surrogate pair is no text"),
    ("string", "a\0b", 2, "a ROS 2 string ends at its first NUL character"),
    ("time", -1, 1, "-1 does not fit `time` (0 to 4294967295 seconds)"),
    ("time", math.nan, 1, "nan does not fit `time`"),
    ("string", [1], 1, "a list is not a string"),
]


@pytest.mark.parametrize(("name", "value", "version"), FITS)
def test_what_fits(name: str, value: object, version: int) -> None:
    assert check_scalar(name, value, version) is None


@pytest.mark.parametrize(("name", "value", "version", "message"), DOES_NOT_FIT)
def test_what_does_not_fit(name: str, value: object, version: int, message: str) -> None:
    assert (check_scalar(name, value, version) or "").startswith(message)


def test_a_string_has_at_most_its_bound_of_characters() -> None:
    assert check_scalar("string", "12345", 2, string_bound=5) is None
    problem = check_scalar("string", "123456", 2, string_bound=5)
    assert problem == "6 characters do not fit `string<=5`"


@pytest.mark.parametrize("version", [1, 2])
def test_every_default_fits(version: int) -> None:
    for name, known in PRIMITIVES[version].items():
        assert type(known.default) is known.kind
        assert check_scalar(name, known.default, version) is None


def test_the_generations_differ() -> None:
    assert primitive("time", 1) is not None
    assert primitive("time", 2) is None
    assert primitive("wstring", 1) is None
