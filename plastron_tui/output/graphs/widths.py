"""How wide a text is in a picture, and how a long one is broken.

Who looks at the picture may have another sans-serif font, so a character counts as wide as it
is in the widest of the usual ones: the advance widths are the larger of DejaVu Sans (about as
wide as Verdana) and Liberation Sans (as wide as Arial and Helvetica), in thousandths of an em.
"""

from __future__ import annotations

import re

FONT = "Inter,'Segoe UI',Roboto,'Helvetica Neue',Arial,'Liberation Sans','DejaVu Sans',sans-serif"

# fmt: off
_REGULAR = (
    318, 401, 460, 838, 637, 951, 780, 275, 391, 391, 500, 838, 318, 361, 318, 337, 637, 637, 637,
    637, 637, 637, 637, 637, 637, 637, 337, 337, 838, 838, 838, 557, 1016, 685, 687, 723, 771,
    667, 611, 778, 752, 295, 500, 667, 558, 863, 749, 788, 667, 788, 723, 667, 611, 732, 685, 989,
    686, 667, 686, 391, 337, 391, 838, 557, 500, 613, 635, 550, 635, 616, 353, 635, 634, 278, 278,
    580, 278, 975, 634, 612, 635, 635, 412, 521, 393, 634, 592, 818, 592, 592, 525, 637, 337, 637,
    838,
)
_BOLD = (
    349, 457, 521, 838, 696, 1002, 873, 307, 458, 458, 523, 838, 380, 416, 380, 366, 696, 696,
    696, 696, 696, 696, 696, 696, 696, 696, 400, 400, 838, 838, 838, 611, 1000, 774, 763, 734,
    831, 684, 684, 821, 837, 373, 557, 775, 638, 996, 837, 851, 733, 851, 771, 721, 683, 813, 774,
    1104, 771, 725, 726, 458, 366, 458, 838, 557, 500, 675, 716, 593, 716, 679, 436, 716, 712,
    343, 343, 666, 343, 1042, 712, 688, 716, 716, 494, 596, 479, 712, 652, 924, 646, 652, 583,
    712, 366, 712, 838,
)
# fmt: on
_OTHER = {"°": 500, "·": 380, "×": 838, "…": 1000}
_WIDEST = 1600
# Latin, Greek, Cyrillic, kana, ideographs, Hangul: whatever font has them, none is wider.
_KNOWN = re.compile("[ -~°·…\u00c0-\u024f\u0370-\u04ff\u3041-\u30ff\u4e00-\u9fff\uac00-\ud7a3]")


def text_width(text: str, size: float, *, bold: bool = False) -> float:
    """Return an upper bound of the width of a text whose characters are all drawable."""
    table = _BOLD if bold else _REGULAR
    total = 0
    for char in text:
        at = ord(char) - 32
        total += table[at] if 0 <= at < len(table) else _OTHER.get(char, _WIDEST)
    return total * size / 1000


def drawable(text: str) -> str:
    r"""Return a text with each character whose width nobody knows as `\x..` or `\u....`."""
    return "".join(char if _KNOWN.match(char) else _escape(char) for char in text)


def _escape(char: str) -> str:
    return char.encode("unicode_escape").decode("ascii")


def broken(text: str, size: float, room: float, most: int, *, bold: bool = False) -> list[str]:
    """Break a text into at most `most` lines that fit, the middle left out when it must be.

    Lines end after `/`, `_` or a space where that leaves them more than half full.
    """
    lines = _lines(text, size, room, bold)
    if len(lines) <= most:
        return lines
    half = most // 2
    tail = _lines(text[::-1], size, room, bold)[: most - half]
    last = [line[::-1] for line in reversed(tail)]
    return [*lines[:half], *_with_dots(last, size, room, bold)]


def _with_dots(lines: list[str], size: float, room: float, bold: bool) -> list[str]:
    first = lines[0]
    while first and text_width("…" + first, size, bold=bold) > room:
        first = first[1:]
    return ["…" + first, *lines[1:]]


def _lines(text: str, size: float, room: float, bold: bool) -> list[str]:
    lines = []
    rest = text
    while rest:
        end = _fitting(rest, size, room, bold)
        if end < len(rest):
            at = max(rest.rfind(mark, 0, end) for mark in "/_ ·")
            end = at + 1 if at + 1 > end // 2 else end
        lines.append(rest[:end].strip())
        rest = rest[end:].strip()
    return lines or [""]


def _fitting(text: str, size: float, room: float, bold: bool) -> int:
    """Return how many characters fit, at least one."""
    width = 0.0
    for number, char in enumerate(text):
        width += text_width(char, size, bold=bold)
        if width > room:
            return max(number, 1)
    return len(text)
