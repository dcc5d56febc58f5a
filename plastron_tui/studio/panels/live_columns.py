"""How the rows of the live panel are laid out: columns that make the best of its width."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from rich.cells import cell_len

from plastron_tui.diagnostics.terminal import visible

from ..cells import cut, fitted
from .live_rows import Kind, LiveRow
from .sparkline import sparkline
from .styles import Line, Piece

_RATE, _CURVE, _TYPE = 9, 16, 20
_LEAST_NAME, _LEAST_VALUE = 8, 12
_WITH_CURVE, _WITH_TYPE = 56, 100
_SIGNS = {
    Kind.TOPIC: ("≈", "success"),
    Kind.SERVICE: ("◆", "warning"),
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
        if row.kind in (Kind.TOPIC, Kind.FIELD, Kind.SERVICE, Kind.NODE, Kind.PARAMETER)
    ]
    curve = _CURVE if width >= _WITH_CURVE else 0
    type_ = _TYPE if width >= _WITH_TYPE else 0
    # What is before the name takes four cells, and each column has one behind it.
    left = width - 4 - (_RATE + 1) - (curve + bool(curve)) - (type_ + bool(type_)) - 1
    most = max(_LEAST_NAME, left - max(_LEAST_VALUE, left // 2))
    name = max(_LEAST_NAME, min(max(names, default=0), most))
    return Columns(name, _RATE, type_, max(0, left - name), curve)


def line_of(row: LiveRow, columns: Columns, width: int) -> Line:
    """Return a row as it is drawn."""
    if row.kind is Kind.HEADING:
        return (Piece(f" {row.name}", "dim"),)
    if row.kind is Kind.NOTE:
        return (Piece(cut(" " * (4 + 2 * row.depth) + row.name, width), row.tone),)
    if row.kind is Kind.ANSWER:
        shown = cut(f"      {row.name} {row.value}", width)
        return (Piece(shown, row.tone),)
    fold = " " if not row.is_branch else "▾" if row.is_open else "▸"
    sign, tone = _SIGNS.get(row.kind, ("", ""))
    before = f"{fold} " if sign else "    "
    indent = "" if sign else " " * (2 * row.depth)
    name = fitted(indent + row.name, columns.name)
    pieces = [
        Piece(before, "dim"),
        Piece(f"{sign} " if sign else "", "dim" if row.is_old else tone),
    ]
    pieces += [Piece(name + " ", "strong" if row.depth == 0 else "")]
    has_rate = row.kind is Kind.TOPIC
    if has_rate:
        rate = row.rate.rjust(columns.rate)
        is_quiet = row.is_old or row.rate == "silent"
        pieces.append(Piece(rate + " ", "quiet" if is_quiet else "primary"))
    if columns.type and has_rate:
        pieces.append(
            Piece(fitted(visible(row.type.rpartition("/")[2]), columns.type) + " ", "quiet")
        )
    if not row.samples or not columns.curve:
        used = sum(cell_len(piece.text) for piece in pieces)
        return (*pieces, Piece(cut(row.value, width - used), row.tone))
    used = sum(cell_len(piece.text) for piece in pieces) + columns.curve + 1
    pieces.append(Piece(fitted(row.value, max(0, width - used)) + " ", row.tone))
    return (*pieces, Piece(sparkline(row.samples, columns.curve).rjust(columns.curve), "accent"))
