"""Random XML files, laid out as people lay them out, and as they do not."""

from __future__ import annotations

from dataclasses import dataclass

from hypothesis import strategies as st

NAMES = ("node", "param", "group", "arg", "xacro:if", "rosparam")
VALUES = ("", "1", "a b", "$(find demo)/x", "a > b", "&lt;&amp;", "é")
COMMENTS = ("<!-- note -->", "<!---->", "<!-- <node/> -->")


@dataclass(frozen=True)
class Layout:
    newline: str
    unit: str
    quote: str
    close: str


layouts = st.builds(
    Layout,
    st.sampled_from(["\n", "\r\n"]),
    st.sampled_from(["\t", "  ", "    ", ""]),
    st.sampled_from(["'", '"']),
    st.sampled_from(["/>", " />"]),
)


@st.composite
def files(draw: st.DrawFn) -> bytes:
    layout = draw(layouts)
    head = draw(st.sampled_from(["", '<?xml version="1.0"?>', "\ufeff", "<!-- head -->"]))
    head += layout.newline if head.strip("\ufeff") else ""
    return (head + _element(draw, layout, 0) + draw(st.sampled_from(["", layout.newline]))).encode()


def _element(draw: st.DrawFn, layout: Layout, depth: int) -> str:
    name = draw(st.sampled_from(NAMES))
    tag = f"<{name}"
    for number in range(draw(st.integers(0, 2))):
        gap = draw(st.sampled_from([" ", " ", "  ", layout.newline + "\t"]))
        tag += f"{gap}a{number}={layout.quote}{draw(st.sampled_from(VALUES))}{layout.quote}"
    kinds = ["empty", "closed", "text", "lines", "inline"]
    kind = "lines" if depth == 0 else draw(st.sampled_from(kinds if depth < 3 else kinds[:3]))
    if kind == "empty":
        return tag + layout.close
    indent = layout.unit * depth
    content = {"closed": "", "text": draw(st.sampled_from(["text", " a b ", " "]))}.get(kind)
    if content is None:
        inner = layout.newline + indent + layout.unit if kind == "lines" else ""
        pieces = [_piece(draw, layout, depth + 1, inner) for _ in range(draw(st.integers(1, 3)))]
        content = "".join(pieces)
        if inner:
            content += draw(st.sampled_from([layout.newline + indent] * 3 + ["", " "]))
    return f"{tag}>{content}</{name}>"


def _piece(draw: st.DrawFn, layout: Layout, depth: int, inner: str) -> str:
    gap = draw(st.sampled_from([inner] * 5 + ["", " ", "  ", layout.newline + inner]))
    kind = draw(st.sampled_from(["element"] * 4 + ["comment", "text", "remark", "instruction"]))
    if kind == "comment":
        return gap + draw(st.sampled_from(COMMENTS))
    if kind == "text":
        return gap + "words"
    if kind == "instruction":
        return gap + "<?go on?>"
    remark = draw(st.sampled_from(COMMENTS)) if kind == "remark" else ""
    return gap + _element(draw, layout, depth) + (f" {remark}" if remark else "")
