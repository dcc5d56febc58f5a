"""What is taken out of a text before it is parsed, and what parses then."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from reading import ROS2, endpoints, read

from plastron_tui.model.source import LARGEST_FILE, FileSet
from plastron_tui.sources import find_language
from plastron_tui.sources.cpp.headers import others
from plastron_tui.sources.cpp.preprocessing import preprocess
from plastron_tui.sources.cpp.syntax import parse

PIECES = (
    *(
        "//",
        "/*",
        "*/",
        '"',
        "'",
        "\\",
        "\n",
        "\r",
        "#if 0",
        "#if X",
        "#else",
        "#endif",
        "#define A",
    ),
    *('R"(', ')"', "{", "}", "(", ")", ";", "a", "class A_B C {", "PRId64", " ", "é", "1'0"),
)


@pytest.mark.parametrize("splice", ["\\\n", "\\ \n", "\\\t \r\n"])
def test_spliced_line_goes_on_as_it_does_for_gpp(splice: str) -> None:
    text = f"// one {splice} that goes on\n#define MOST 1 {splice} + 2\nint most = {splice} MOST;"
    prepared = preprocess(text.encode())
    assert prepared.code.split() == [b"int", b"most", b"=", b"\\", b"MOST;"]
    start, end = prepared.defines[0][1:]
    assert text[start:end] == f"1 {splice} + 2"
    assert parse(text.encode()).errors == 0


@given(st.lists(st.sampled_from(PIECES)).map("".join))
def test_no_offset_moves(text: str) -> None:
    data = text.encode()
    code = parse(data).code
    assert len(code) == len(data)
    assert code.count(b"\n") >= data.count(b"\n")


WORDS = (
    *("nh.advertise<", "std_msgs::String", ">(", '"a"', ", 1", ")", ";", "{", "}", "class A", ": "),
    *("public rclcpp::Node", "create_publisher<", "std::bind(", "&A::f", "void f(", "T t", "= "),
    *(
        "for (auto t : ",
        "ros::NodeHandle nh",
        "using T = ",
        "template<class T> ",
        "if (x) ",
        "[&](",
    ),
    *(
        "declare_parameter(",
        "nh.param(",
        "return ",
        "A::",
        "#define T ",
        "\n",
        "rclcpp::QoS(",
        "+ ",
    ),
    *(
        "A() : Node(",
        "1s",
        "enum {",
        "nh.subscribe(",
        "new ",
        "std::make_shared<",
        "while (x) ",
        "t",
    ),
)


@given(st.lists(st.sampled_from(WORDS), max_size=60).map(" ".join))
def test_whatever_a_text_is_it_is_read_or_refused(text: str) -> None:
    files = FileSet.single(".cpp", f"#include <ros/ros.h>\n{text}".encode())
    for library in ("roscpp", "rclcpp"):
        result = find_language("cpp").read(Path("x.cpp"), files, library)
        assert result.source is not None or result.diagnostics


PARSED = [
    "class FOO_PUBLIC A : public B {};",
    "class FOO_PUBLIC A final { Q_OBJECT\npublic slots:\n  void f();\nsignals:\n  void g(); };",
    "FOO_PUBLIC void f();",
    'void f() { printf("%" PRId64 "\\n", x); }',
    "struct A {\n  RCLCPP_SMART_PTR_DEFINITIONS(A)\n  void f();\n};",
    "void f([[maybe_unused]] int a) {}",
    "#ifdef A\nvoid f(int a) {\n#else\nvoid f(long a) {\n#endif\n}\n",
    "void f() {\n  g(1,\n#ifdef A\n    2\n#else\n    3\n#endif\n  );\n}\n",
    "void f() { BOOST_FOREACH(const A& a, b) { c(a); } }",
    '#define A "a"\n#define B "b"\nauto c = f("x" A, A B);',
]


@pytest.mark.parametrize("text", PARSED)
def test_what_the_preprocessor_makes_whole_parses(text: str) -> None:
    assert parse(text.encode()).errors == 0


def test_both_branches_are_read_and_what_is_switched_off_is_not() -> None:
    pub = 'create_publisher<std_msgs::msg::String>("{}", 1);\n'
    text = (
        f'{ROS2}class A : public rclcpp::Node {{ A() : Node("a") {{\n'
        f"#ifdef X\n{pub.format('a')}#else\n{pub.format('b')}#endif\n"
        f"#if 0\n{pub.format('c')}#else\n{pub.format('d')}#endif\n}} }};"
    )
    found = [each.split()[1] for each in endpoints(text)]
    assert found == ["a", "b", "d"]


def test_includes_and_macros_are_told() -> None:
    prepared = preprocess(
        b'#include <a/b.h>\n#include "c.h"\n// #include <d.h>\n#if 0\n#include <e.h>\n#endif\n'
        b'#define A "x" // a\n#define F(x) x\n'
    )
    assert [(each.path, each.is_angled) for each in prepared.includes] == [
        ("a/b.h", True),
        ("c.h", False),
    ]
    assert [each.name for each in prepared.defines] == ["A"]


def test_a_source_is_read_with_the_headers_of_its_package(tmp_path: Path) -> None:
    for name in ("package.xml", "include/p/x.hpp", "include/p/base.hpp", "src/own.hpp"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text('#include "p/base.hpp"\n#include <rclcpp/rclcpp.hpp>\n')
    main = tmp_path / "src" / "x.cpp"
    text = b'#include "p/x.hpp"\n#include "own.hpp"\n#include <vector>\n#include "no/such.hpp"\n'
    found = {"../include/p/{}.hpp", "own.hpp", "../include/p/base.hpp"}
    assert set(others(main, text)) == found
    assert set(others(main, b"\xef\xbb\xbf" + text)) == found
    main.write_bytes(text)
    assert others(tmp_path / "include/p/x.hpp", b"")[0] == "../../src/{}.cpp"


@pytest.mark.parametrize(
    ("header", "source", "name"),
    [
        ("include/tf2_x/a/h.hpp", "src/a/h.cc", "../../../src/a/{}.cc"),
        ("include/tf2_x/h.hpp", "src/tf2_x/h.cpp", "../../src/tf2_x/{}.cpp"),
        ("include/tf2_x/h.hpp", "src/nodelets/h.cpp", "../../src/nodelets/{}.cpp"),
        ("src/h.h", "src/h.cpp", "{}.cpp"),
    ],
)
def test_a_header_is_read_with_its_source(
    tmp_path: Path, header: str, source: str, name: str
) -> None:
    for each in ("package.xml", header, source):
        (tmp_path / each).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / each).touch()
    assert others(tmp_path / header, b"") == (name,)
    # What the package is called is no reason to take it for another one.
    if inner := header.partition("include/")[2]:
        assert len(others(tmp_path / source, f"#include <{inner}>".encode())) == 1


@pytest.mark.parametrize(
    ("text", "library"),
    [
        ("#include <ros/ros.h>", "roscpp"),
        ("class A : public nodelet::Nodelet", "nodelet"),
        ("#include <rclcpp/rclcpp.hpp>", "rclcpp"),
        ("#include <rclcpp/rclcpp.hpp>\nRCLCPP_COMPONENTS_REGISTER_NODE(A)", "component"),
        ("#include <vector>", None),
    ],
)
def test_a_text_mentions_its_library(text: str, library: str | None) -> None:
    assert find_language("cpp").mentioned_library(text.encode()) == library


def test_words_of_a_text() -> None:
    language = find_language("cpp")
    text = b'void f() {}\nvoid A::f() { g("h"); }\nvoid g(); // i\n'
    assert [language.definitions(text, name) for name in "fgh"] == [2, 0, 0]
    assert [language.mentions(text, name) for name in "fghi"] == [True, True, False, False]
    assert language.is_worse(b"void f( {}", text)
    assert not language.is_worse(text, b"void f( {}")


@pytest.mark.parametrize("text", [b"int main() {}", b"\0", b" " * (LARGEST_FILE + 1)])
def test_what_is_no_node_is_a_diagnostic(text: bytes) -> None:
    result = find_language("cpp").read(Path("x.cpp"), FileSet.single(".cpp", text))
    assert result.source is None
    assert result.diagnostics


def test_a_call_is_at_its_bytes() -> None:
    made = 'this->create_client<a::srv::B>("é")'
    text = f'{ROS2}// é\nclass A : public rclcpp::Node {{ A() : Node("a") {{\n  x = {made}; }} }};'
    (endpoint,) = read(text).endpoints
    start, end = endpoint.span.start, endpoint.span.end
    assert text.encode()[start:end].decode() == 'this->create_client<a::srv::B>("é")'
    assert endpoint.line == text[: text.index("x = ")].count("\n") + 1
