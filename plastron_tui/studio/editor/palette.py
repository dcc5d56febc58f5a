"""The editor's colours, made from those of the app's theme."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import NamedTuple

from rich.style import Style
from textual.color import Color
from textual.widget import Widget

from ..legibility import LEAST, contrast, legible

PLAIN = Style.null()

_THEMED: Mapping[str, tuple[str, str]] = {
    "keyword.function": ("primary", "bold"),
    "keyword": ("primary", ""),
    "variable": ("", ""),
    "type": ("success", ""),
    "type.builtin": ("success", "italic"),
    "module": ("success", "dim"),
    "function": ("warning", ""),
    "property": ("warning", ""),
    "string": ("accent", ""),
    "string.escape": ("accent", "bold"),
    "string.special": ("secondary", ""),
    "string.special.path": ("secondary", "underline"),
    "number": ("error", ""),
    "boolean": ("error", ""),
    "constant.builtin": ("error", "italic"),
    "operator": ("", "dim"),
    "punctuation.delimiter": ("", "dim"),
    "punctuation.bracket": ("", "dim"),
    "comment": ("", "dim italic"),
}
"""For each capture of the grammar's query: a colour of the theme, and how it is written."""


def tone_of(capture: str) -> str:
    """Return the tone of a capture, for where a text is only read: a colour of the theme."""
    color, how = _THEMED.get(capture, ("", ""))
    return color or ("quiet" if "dim" in how else "")


_ANSI: Mapping[str, str] = {
    "primary": "blue",
    "secondary": "cyan",
    "accent": "green",
    "success": "yellow",
    "warning": "magenta",
    "error": "red",
}


class Palette(NamedTuple):
    """The styles of everything that the editor draws."""

    text: Style
    captures: Mapping[str, Style]
    gutter: Style
    gutter_here: Style
    line_here: Style
    selection: Style
    match: Style
    bracket: Style
    cursor: Style
    cursor_away: Style
    tab: Style
    popup: Style
    popup_here: Style
    popup_quiet: Style
    error: Style
    warning: Style
    error_line: Style
    warning_line: Style


def palette_of(widget: Widget) -> Palette:
    """Make the palette of a widget: of its theme, of the terminal's colours, or of none."""
    app = widget.app
    if app.native_ansi_color:
        palette = ansi_palette()
    else:
        _, _, background, foreground = widget.colors
        text = background.blend(foreground, 1, 1)
        palette = themed_palette(app.theme_variables, text, background)
    return without_colors(palette) if app.no_color else palette


def themed_palette(variables: Mapping[str, str], foreground: Color, background: Color) -> Palette:
    """Make a palette from a theme's CSS variables and a widget's own colours."""

    def color(name: str) -> Color:
        try:
            return Color.parse(variables[name])
        except (KeyError, ValueError):
            return foreground

    foreground = legible(foreground, background)
    text = Style(color=foreground.rich_color, bgcolor=background.rich_color)
    quiet = legible(background.blend(foreground, 0.45), background)
    here = background.blend(foreground, 0.06)
    panel = background.blend(foreground, 0.12)
    selected = _behind(foreground, background, color("primary"))
    on_selected = legible(foreground, selected)

    def written(name: str, how: str) -> Style:
        tint = color(name) if name else foreground
        if "dim" in how:
            tint = background.blend(tint, 0.6)
        tint = legible(tint, background)
        return Style(color=tint.rich_color) + Style.parse(how.replace("dim", "").strip() or "none")

    error = legible(color("error"), background)
    warning = legible(color("warning"), background)
    return Palette(
        text=text,
        captures={capture: written(*look) for capture, look in _THEMED.items()},
        gutter=Style(color=quiet.rich_color),
        gutter_here=Style(color=foreground.rich_color, bold=True),
        line_here=Style(bgcolor=here.rich_color),
        selection=Style(color=on_selected.rich_color, bgcolor=selected.rich_color),
        match=Style(bgcolor=background.blend(warning, 0.3).rich_color),
        bracket=Style(bgcolor=background.blend(foreground, 0.25).rich_color, bold=True),
        cursor=Style(color=background.rich_color, bgcolor=foreground.rich_color),
        cursor_away=Style(bgcolor=background.blend(foreground, 0.3).rich_color),
        tab=Style(color=background.blend(foreground, 0.3).rich_color),
        popup=Style(color=legible(foreground, panel).rich_color, bgcolor=panel.rich_color),
        popup_here=Style(color=on_selected.rich_color, bgcolor=selected.rich_color, bold=True),
        popup_quiet=Style(
            color=legible(panel.blend(foreground, 0.6), panel).rich_color, bgcolor=panel.rich_color
        ),
        error=Style(color=error.rich_color),
        warning=Style(color=warning.rich_color),
        error_line=Style(underline=True, color=error.rich_color),
        warning_line=Style(underline=True, color=warning.rich_color),
    )


def _behind(text: Color, background: Color, tint: Color) -> Color:
    """Mix as much of a colour into the background as leaves the text on it legible."""
    for tenths in (4, 3, 2, 1):
        mixed = background.blend(tint, tenths / 10, 1)
        if contrast(text, mixed) >= LEAST:
            return mixed
    return background.blend(text, 0.15, 1)


def ansi_palette() -> Palette:
    """Make a palette of the terminal's own sixteen colours."""

    def written(name: str, how: str) -> Style:
        return Style(color=_ANSI[name] if name else None) + Style.parse(how or "none")

    return Palette(
        text=PLAIN,
        captures={capture: written(*look) for capture, look in _THEMED.items()},
        gutter=Style(dim=True),
        gutter_here=Style(bold=True),
        line_here=PLAIN,
        selection=Style(reverse=True),
        match=Style(underline=True, bold=True),
        bracket=Style(bold=True, underline=True),
        cursor=Style(reverse=True, underline=True),
        cursor_away=Style(underline=True),
        tab=Style(dim=True),
        popup=Style(reverse=True),
        popup_here=Style(bold=True, underline=True),
        popup_quiet=Style(reverse=True, dim=True),
        error=Style(color="red"),
        warning=Style(color="yellow"),
        error_line=Style(color="red", underline=True),
        warning_line=Style(color="yellow", underline=True),
    )


def without_colors(palette: Palette) -> Palette:
    """Tell everything apart by how it is written, on the palette's own background."""
    plain = ansi_palette()
    strong = Style(bold=True)
    return plain._replace(
        text=palette.text,
        captures={name: style.without_color for name, style in plain.captures.items()},
        error=strong,
        warning=strong,
        error_line=Style(underline=True, bold=True),
        warning_line=Style(underline=True),
    )


@lru_cache(4096)
def combined(base: Style, *more: Style) -> Style:
    """Return styles laid over each other; the same ones are combined once."""
    for style in more:
        base = base + style
    return base
