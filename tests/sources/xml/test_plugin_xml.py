"""Classes are described in a plugin description, and taken away again."""

from __future__ import annotations

import pytest

from plastron_tui.sources.xml.plugins import (
    PluginClass,
    Plugins,
    add_class,
    read_plugins,
    remove_class,
)

ONE = b"""\
<library path="lib/libfilters">
  <!-- Filters. -->
  <class name="demo/Low" type="demo::Low" base_class_type="demo::Filter">
    <description>
      A low
      pass.
    </description>
  </class>
</library>
"""
SEVERAL = b"""\
<class_libraries>
\t<library path="lib/liba">
\t\t<class type="a::A" base_class_type="nodelet::Nodelet" />
\t</library>
</class_libraries>
"""
NEW = PluginClass("demo/High", "demo::High", "demo::Filter", "A high pass.")
ONE_MORE = b"""\
  <class name="demo/High" type="demo::High" base_class_type="demo::Filter">
    <description>A high pass.</description>
  </class>
</library>
"""


def read(text: bytes) -> Plugins:
    plugins, diagnostics = read_plugins(text)
    assert plugins is not None and diagnostics == ()
    return plugins


def test_classes_are_read() -> None:
    (library,) = read(ONE).libraries
    assert library.path == "lib/libfilters"
    assert [one for one, _ in library.classes] == [
        PluginClass("demo/Low", "demo::Low", "demo::Filter", "A low pass.")
    ]
    assert read(SEVERAL).libraries[0].classes[0][0].name == "a::A"


CASES = [
    (ONE, "lib/libfilters", NEW, ONE.replace(b"</library>\n", ONE_MORE)),
    (
        SEVERAL,
        "lib/liba",
        PluginClass("a::B", "a::B", "nodelet::Nodelet"),
        SEVERAL.replace(
            b" />\n", b' />\n\t\t<class type="a::B" base_class_type="nodelet::Nodelet" />\n'
        ),
    ),
    (
        SEVERAL,
        "lib/libb",
        PluginClass("b::B", "b::B", "nodelet::Nodelet"),
        SEVERAL.replace(
            b"</class_l",
            b'\t<library path="lib/libb">\n\t\t<class type="b::B"'
            b' base_class_type="nodelet::Nodelet" />\n\t</library>\n</class_l',
        ),
    ),
]


@pytest.mark.parametrize(("text", "path", "new", "expected"), CASES)
def test_a_class_is_written_and_goes_without_a_trace(
    text: bytes, path: str, new: PluginClass, expected: bytes
) -> None:
    added = add_class(read(text), path, new).plugins
    assert added is not None
    assert added.document.text.decode() == expected.decode()
    assert add_class(added, path, new).plugins == added
    removed = remove_class(added, new.name, new.base).plugins
    assert removed is not None
    assert removed.document.text == text


def test_what_contradicts_the_file_is_refused() -> None:
    for path, new in [("lib/other", NEW), ("lib/libfilters", NEW._replace(name="demo/Low"))]:
        plugins, (diagnostic,) = add_class(read(ONE), path, new)
        assert (plugins, diagnostic.code) == (None, "edit-refused")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (b"<package/>", "the outermost element is `<package>`, not `<library>`"),
        (b"<library/>", "the library has no path"),
        (b"<library path='a'><class type='A'/></library>", "the class has no `base_class_type`"),
        (ONE.replace(b'type="demo::Low" ', b""), "the class has no `type`"),
        (
            ONE.replace(
                b"</library>",
                b'<class name="demo/Low" type="x" base_class_type="demo::Filter"/></library>',
            ),
            "two classes for `demo::Filter` are called `demo/Low`",
        ),
    ],
)
def test_a_broken_description_is_told(text: bytes, message: str) -> None:
    diagnostics = read_plugins(text).diagnostics
    assert [(one.code, one.message) for one in diagnostics] == [("broken-plugins", message)]
