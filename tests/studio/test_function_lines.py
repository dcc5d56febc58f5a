"""Where a function is defined or declared."""

from __future__ import annotations

import subprocess
import sys

import pytest

from plastron_tui.studio.function_lines import function_lines

CPP = """\
void heard(int x);
  heard(3);
  const std::map<int, A *> & Node::Inner::heard (
  return heard(1);
else heard(2);
  std::cout << heard(1);
auto x = heard(1);
Message*heard(int a)
unheard(1); void heard2(int);
Node::heard(1);
"""
PYTHON = """\
def heard(message):
    async  def heard[T](self):
    heard(1)
    undef heard(1)
def heard2(): pass
\tdef heard (self): heard()
void heard(int)
"""


@pytest.mark.parametrize(
    ("text", "is_python", "lines"), [(CPP, False, [1, 3, 8]), (PYTHON, True, [1, 2, 6])]
)
@pytest.mark.parametrize("name", ["heard", "self.heard", "Node::heard"])
def test_definitions_are_told_from_calls(
    text: str, is_python: bool, lines: list[int], name: str
) -> None:
    assert list(function_lines(text.encode(), name, is_python=is_python)) == lines


@pytest.mark.parametrize("line", ["*", "& ", "a ", "a::", "heard ", "heard(", " ", "<a,"])
def test_no_line_takes_longer_than_its_length(line: str) -> None:
    """A search that goes back and forth over 1 MB would take hours; the process is ended then."""
    code = (
        "from plastron_tui.studio.function_lines import function_lines\n"
        f"text = {line!r}.encode() * (1_000_000 // {len(line)}) + b'heard(\\nvoid heard(int)'\n"
        "assert list(function_lines(text, 'heard', is_python=False)) == [2]\n"
        "assert list(function_lines(text, 'heard', is_python=True)) == []\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=120)
