"""Files in an encoding of their own: the coding line is what counts."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.diagnostics import Span
from plastron_tui.model.kinds import Message, Publication, Publisher
from plastron_tui.model.source import Add
from plastron_tui.model.values import MessageValue
from plastron_tui.ros.catalog import Catalog
from plastron_tui.ros.interfaces import InterfaceName
from plastron_tui.sources.python import edit_python, read_python
from plastron_tui.sources.python.syntax import parse
from plastron_tui.targets.base import Rendered
from plastron_tui.targets.python.porting.port import port_python
from plastron_tui.targets.python.rospy import DIALECT

NODE = b"import rospy\nfrom std_msgs.msg import String\nrospy.init_node('n')\n"


@pytest.mark.parametrize(
    ("text", "encoding"),
    [
        (b"x = 1\n", "utf-8"),
        (b"# -*- coding: latin-1 -*-\n", "latin-1"),
        (b"#!/usr/bin/env python\n# coding: cp1252\n", "cp1252"),
        (b"x = 1\n# coding: cp1252\n", "utf-8"),
        (b"# coding: utf8\nx = '\xc3\xa9'\n", "utf-8"),
        (b"# coding: utf8\nx = '\xe9'\n", "latin-1"),
        (b"# coding: ascii\nx = '\xc3\xa9'\n", "utf-8"),
        (b"# coding: utf-16\n", "utf-8"),
        (b"# coding: rot13\n", "utf-8"),
        (b"\xef\xbb\xbf# coding: latin-1\n", "utf-8"),
    ],
)
def test_the_encoding_of_a_file(text: bytes, encoding: str) -> None:
    assert parse(text).encoding == encoding


def edited(text: bytes, data: str) -> Rendered:
    source = read_python(Path("node.py"), one(text)).source
    assert source is not None
    type_, at = InterfaceName("std_msgs", "String"), Span(0, 1)
    sent = Publication(Message("m", MessageValue(type_, {"data": data}), at), 10.0, at, True)
    change = Add(Publisher("t", type_, [sent], at))
    return edit_python(source, [change], Catalog("noetic"), DIALECT)


def test_an_edit_is_in_the_encoding_that_the_file_names() -> None:
    text = edited(b"# coding: latin-1\n" + NODE + b"rospy.spin()\n", "caf\xe9").files
    assert text is not None
    assert b"caf\xe9" in text.main
    ast.parse(text.main)


def test_a_character_that_the_encoding_lacks_is_refused() -> None:
    refused = edited(b"# coding: latin-1\n" + NODE, "\u4f60")
    assert refused.files is None
    assert [found.code for found in refused.diagnostics] == ["edit-refused"]


def test_a_port_that_the_encoding_lacks_a_character_for_is_refused() -> None:
    text = b"# coding: ascii\n" + NODE.replace(b"'n'", b"'\\u4f60'")
    source = read_python(Path("node.py"), one(text)).source
    assert source is not None
    refused = port_python(source, Catalog("kilted"), "rclpy")
    assert refused.files is None
    assert [found.code for found in refused.diagnostics] == ["edit-refused"]
