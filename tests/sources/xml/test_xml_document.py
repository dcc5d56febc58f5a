"""XML files are read with the place of everything, or told what is wrong with them."""

from __future__ import annotations

import subprocess
import sys

import pytest

from plastron_tui.sources.xml.document import read_xml

BROKEN = [
    (b"<a><b></a>", "b", "`<b>` is not closed before `</a>`"),
    (b"<a><b></c></a>", "c", "`</c>` stands where `<b>` is to be closed"),
    (b"<a>\n<b>\n", "b", "`<b>` is not closed"),
    (b"", "", "there is no element in the file"),
    (b"<a b=c/>", "c", "a value has no quotes"),
    (b"<a b/>", "b", "`b` has no value"),
    (b"<a b='1' b='2'/>", "b", "the attribute `b` stands there twice"),
    (b"<a b='<'/>", "<", "`<` cannot stand in a value"),
    (b"<a b='1'\n<c/>", "a", "`<a` has no `>` at its end"),
    (b"<a>\n<b c='1' /\n</a>", "b", "`<b` has no `>` at its end"),
    (b"<a\n<c/>", "a", "`<a` has no `>` at its end"),
    (b"<a b='1/>", "<", "`<a b='1/>` has no end"),
    (b"<a>& </a>", "&", "`&` stands alone"),
    (b"<a>&x;</a>", "&x;", "`&x;` is declared nowhere"),
    (b"<a><!-- x -- y --></a>", "--", "`--` cannot stand in a comment"),
    (b"<a/>\n<b/>", "<", "something stands behind the one element that a file has"),
    (b"\n<?xml version='1.0'?><a/>", "<?xml", "`<?xml` stands at the very start of a file only"),
    (b"hello", "h", "`h` cannot stand here"),
    (b"<a>\x00</a>", "\x00", "what stands here cannot stand here"),
]


@pytest.mark.parametrize(("text", "wrong", "message"), BROKEN)
def test_what_is_not_well_formed_is_told_at_its_place(
    text: bytes, wrong: str, message: str
) -> None:
    document, (diagnostic,) = read_xml(text)
    assert document is None
    assert (diagnostic.code, diagnostic.message) == ("broken-xml", message)
    assert diagnostic.span is not None
    assert text[diagnostic.span.start : diagnostic.span.end].decode() == wrong


UNSUPPORTED = [
    b"<!DOCTYPE a [<!ENTITY x 'y'>]><a>&x;</a>",
    b"<!DOCTYPE a SYSTEM 'file:///etc/passwd'><a>&x;</a>",
    b"<?xml version='1.0' encoding='latin-1'?><a>\xe9</a>",
    b"<?xml version='1.0' encoding='unheard-of'?><a/>",
    b"<?xml version='1.0' encoding='utf-16'?><a/>",
    b"<a>\xe9</a>",
    "<a/>".encode("utf-16"),
    b"<a>" * 201 + b"</a>" * 201,
]


@pytest.mark.parametrize("text", UNSUPPORTED)
def test_what_is_not_read_is_told(text: bytes) -> None:
    document, (diagnostic,) = read_xml(text)
    assert document is None
    assert diagnostic.code == "unsupported-xml"


def test_a_large_file_is_not_read() -> None:
    assert read_xml(b" " * 5_000_000).diagnostics[0].code == "file-too-large"


@pytest.mark.parametrize("head", [b"", b"\xef\xbb\xbf", b"<?xml version='1.0'?>\r\n<?go on?>\r\n"])
def test_places_and_values(head: bytes) -> None:
    text = head + (
        b"<a x:b = '1 &amp;&#65;'\r\n c=\"\xc3\xa9\">\r\n\tone &lt; <!-- no -->"
        b"<b/><?stop?>two<![CDATA[<c/>]]></a >\r\n"
    )
    document, diagnostics = read_xml(text)
    assert diagnostics == () and document is not None
    root = document.root
    (child,) = root.children
    assert (root.get("x:b"), root.get("c"), root.get("d")) == ("1 &A", "é", None)
    assert [document.slice(one.span) for one in root.attributes] == [
        "x:b = '1 &amp;&#65;'",
        'c="é"',
    ]
    assert [document.slice(one.value_span) for one in root.attributes] == ["1 &amp;&#65;", "é"]
    assert root.text == "\n\tone < \ntwo<c/>"
    assert (root.line, child.line) == (1 + head.count(b"\n"), 3 + head.count(b"\n"))
    assert document.slice(root.span) == text[len(head) :].decode().rstrip()
    assert root.end_tag is not None and document.slice(root.end_tag) == "</a >"
    assert (document.slice(child.span), child.end_tag) == ("<b/>", None)
    assert document.parents == {child: root}
    assert [document.slice(one) for one in document.comments] == ["<!-- no -->"]


def test_the_grammar_is_loaded_for_xml_alone() -> None:
    code = (
        "import sys, plastron_tui.cli.check, plastron_tui.session;"
        "print([name for name in sys.modules if 'xml' in name.partition('plastron_tui.')[2]"
        " and 'codes' not in name or name == 'tree_sitter_xml'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
