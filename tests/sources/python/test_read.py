"""What the reader says of small texts; whole files are compared in `tests/nodes`."""

from __future__ import annotations

from pathlib import Path

import pytest
from file_sets import one

from plastron_tui.model.source import EndpointKind
from plastron_tui.sources.python import read_python


def read(text: str | bytes):
    data = text.encode() if isinstance(text, str) else text
    return read_python(Path("x.py"), one(data)).source


TOPICS = [
    ("'a'", "a", None),
    ("u'a'", "a", None),
    ("r'a'", "a", None),
    ("'a' 'b'", "ab", None),
    ("('a' + \"b\")", "ab", None),
    ("f'a{N}'", "ax", None),
    ("f'a{{}}{N!r}'", None, None),
    ("f'\\x61{N}'", None, None),
    ("fr'a{N}'", "ax", None),
    ("str(N)", "x", None),
    ("str(N, N)", None, None),
    ("'%s/%d' % (N, 3)", "x/3", None),
    ("'{}/{k}'.format(N, k='b')", "x/b", None),
    ("'%99999999d' % 1", None, None),
    ("N", "x", None),
    ("TWICE", "b", None),
    ("unknown", None, None),
    ("'a' if N else 'b'", None, None),
    ("rospy.get_param('~t', 'd')", None, "d"),
    ("N + rospy.get_param('~t', default='d')", None, "xd"),
    ("rospy.get_param('~t')", None, None),
    ("rospy.resolve_name('a')", None, None),
    ("b'a'", None, None),
    ("3", None, None),
]


@pytest.mark.parametrize(("expression", "name", "default"), TOPICS)
def test_a_topic_is_what_the_file_says_or_nothing(expression, name, default):
    source = read(
        "import rospy\nfrom std_msgs.msg import String\nN = 'x'\nTWICE = 'a'\nTWICE = 'b'\n"
        f"p = rospy.Publisher({expression}, String)\n"
    )
    (publisher,) = source.nodes[0].of_kind(EndpointKind.PUBLISHER)
    assert (publisher.name, publisher.default) == (name, default)
    assert publisher.expression == expression


@pytest.mark.parametrize(
    ("imports", "package"),
    [
        ("from a_msgs.msg import Scan\n", "a_msgs"),
        ("from a_msgs.msg import Scan\n" * 2, "a_msgs"),
        ("from a_msgs.msg import Scan\nfrom b_msgs.msg import Scan\n", None),
        ("from b_msgs.msg import Scan\n" + "from a_msgs.msg import Scan\n" * 2, None),
    ],
)
def test_a_type_is_certain_where_all_imports_of_its_name_agree(imports, package):
    source = read(f"import rospy\n{imports}rospy.init_node('n')\nrospy.Publisher('t', Scan)\n")
    (publisher,) = source.endpoints
    assert (publisher.type.package if publisher.type else None) == package


def test_a_block_without_its_colon_keeps_what_is_in_it():
    text = "import rospy\nfrom std_msgs.msg import String\nN = 'a'\n\n\ndef talk(x)\n    N = 'b'\n"
    source = read(f"{text}    rospy.Publisher(N, String)\n")
    (publisher,) = source.nodes[0].of_kind(EndpointKind.PUBLISHER)
    assert publisher.name == "b"


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (b"", "no-node"),
        (b"print('hello')\n", "no-node"),
        (b"# import rospy\n", "no-node"),
        (b"\xf0\x00\x01import rospy", "no-node"),
        (b"import rospy\n\x00", "unreadable-file"),
        ("\ufeffimport rospy\n".encode("utf-16-le"), "unreadable-file"),
    ],
)
def test_a_file_that_is_no_node_is_a_diagnostic(text, code):
    result = read_python(Path("x"), one(text))
    assert result.source is None
    assert [d.code for d in result.diagnostics] == [code]


def test_a_huge_file_is_a_diagnostic():
    result = read_python(Path("x"), one(b"import rospy\n" + b"x = 1\n" * 2_000_000))
    assert [d.code for d in result.diagnostics] == ["file-too-large"]


@pytest.mark.parametrize("deep", ["(" * 5000 + ")" * 5000, "a" + "+ 'a'" * 5000, "f(" * 3000])
def test_deep_nesting_does_not_overflow(deep):
    source = read(f"import rospy\nrospy.Publisher({deep}, String)\nrospy.init_node('n')\n")
    assert source.library == "rospy"
