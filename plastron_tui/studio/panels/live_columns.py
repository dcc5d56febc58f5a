"""How the rows of the live panel are laid out: columns that make the best of its width."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from rich.cells import cell_len

from plastron_tui.diagnostics.terminal import visible

from ..cells import cut, end_of, fitted
from .live_row import Kind, LiveRow
from .sparkline import sparkline
from .styles import Line, Piece

_RATE, _CURVE, _TYPE = 9, 16, 20
_WIDE_CURVE, _WIDE_TYPE = 32, 32
_LEAST_NAME, _LEAST_VALUE = 8, 12
_WITH_CURVE, _WITH_TYPE, _WIDE = 56, 100, 150
"""The widths of a panel from which on it has these columns, and has them wide."""
_BEFORE = 5
"""The cells before a name: one that is empty, the sign to unfold it, what kind of thing it is."""
_SIGNS = {
    Kind.TOPIC: ("≈", "success"),
    Kind.SERVICE: ("◆", "warning"),
    Kind.ACTION: ("★", "warning"),
    Kind.NODE: ("●", "primary"),
}


class Columns(NamedTuple):
    """The cells of each column; 0 for one that is left out."""

    name: int
    rate: int
    type: int
    value: int
    curve: int


def columns_of(rows: Iterable[LiveRow], width: int) -> Columns:
    """Return the columns for rows in a panel of a width."""
    names = [
        cell_len(row.name) + 2 * row.depth
        for row in rows
        if row.kind in _SIGNS or row.kind in (Kind.FIELD, Kind.PARAMETER)
    ]
    curve = 0 if width < _WITH_CURVE else _CURVE if width < _WIDE else _WIDE_CURVE
    type_ = 0 if width < _WITH_TYPE else _TYPE if width < _WIDE else _WIDE_TYPE
    # Each column has an empty cell behind it.
    left = width - _BEFORE - (_RATE + 1) - (curve + bool(curve)) - (type_ + bool(type_)) - 1
    most = max(_LEAST_NAME, left - max(_LEAST_VALUE, left // 2))
    name = max(_LEAST_NAME, min(max(names, default=0), most))
    return Columns(name, _RATE, type_, max(0, left - name), curve)


def line_of(row: LiveRow, columns: Columns, width: int) -> Line:
    """Return a row as it is drawn."""
    if row.kind is Kind.HEADING:
        return (Piece(f" {row.name}", "dim"),)
    if row.kind is Kind.NOTE:
        return (Piece(cut(" " * (_BEFORE + 2 * row.depth) + row.name, width), row.tone),)
    if row.kind in (Kind.ANSWER, Kind.SENDING, Kind.GOAL):
        shown = cut(f"{' ' * (_BEFORE + 2)}{row.name} {row.value}", width)
        return (Piece(shown, row.tone),)
    fold = " " if not row.is_branch else "▾" if row.is_open else "▸"
    sign, tone = _SIGNS.get(row.kind, ("", ""))
    before = f" {fold} " if sign else " " * _BEFORE
    indent = "" if sign else " " * (2 * row.depth)
    # The last part of a name is the one that tells.
    name = fitted(indent + end_of(row.name, columns.name - len(indent)), columns.name)
    is_dim = row.is_old or row.is_foreign
    pieces = [Piece(before, "dim"), Piece(f"{sign} " if sign else "", "dim" if is_dim else tone)]
    strength = "strong" if row.depth == 0 else ""
    pieces += [Piece(name + " ", "quiet" if row.is_foreign else strength)]
    # Values stand below each other, where those without a rate before them have room for that.
    is_quiet = is_dim or row.rate in ("silent", "")
    is_topic = row.kind is Kind.TOPIC
    has_room = row.samples or cell_len(row.value) <= columns.value
    if is_topic or has_room:
        pieces.append(Piece(row.rate.rjust(columns.rate) + " ", "quiet" if is_quiet else "primary"))
    if columns.type and (is_topic or has_room):
        type_ = visible(row.type.rpartition("/")[2]) if is_topic else ""
        pieces.append(Piece(fitted(type_, columns.type) + " ", "quiet"))
    if not row.samples or not columns.curve:
        used = sum(cell_len(piece.text) for piece in pieces)
        return (*pieces, Piece(cut(row.value, width - used), row.tone))
    used = sum(cell_len(piece.text) for piece in pieces) + columns.curve + 1
    pieces.append(Piece(fitted(row.value, max(0, width - used)) + " ", row.tone))
    # The last cell is the frame's distance.
    curve = sparkline(row.samples, columns.curve - 1).rjust(columns.curve - 1)
    return (*pieces, Piece(f"{curve} ", "accent"))
