"""What is drawn again when a part of the screen has changed: that part, and nothing behind it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, cast

from textual.geometry import Region
from textual.screen import Screen
from textual.strip import Strip

from .textual_private import compositor_class

if TYPE_CHECKING:
    from textual._compositor import ChopsUpdate, Compositor


def draw_sparingly(screen: Screen[Any]) -> None:
    """Let a screen ask only those widgets to draw that something that has changed is seen of.

    Textual asks all within the least rectangle that holds all changes, those that are behind others
    too: where a key changes a line at the top and a number at the bottom changes, that is nearly
    all there are.
    """
    base = compositor_class(screen)
    if base is not None:
        screen._compositor = _sparing(base)()


def _sparing(base: type[Compositor]) -> type[Compositor]:
    class SparingCompositor(base):  # type: ignore[valid-type, misc]
        """Draws what has changed."""

        _changed: Sequence[Region] = ()
        """What is drawn now; empty for all."""

        def render_partial_update(self) -> ChopsUpdate | None:
            """Draw what has changed since this was called last."""
            self._changed = tuple(self._dirty_regions)
            try:
                return cast("ChopsUpdate | None", super().render_partial_update())
            finally:
                self._changed = ()

        def _get_renders(
            self, crop: Region | None = None
        ) -> Iterable[tuple[Region, Region, list[Strip]]]:
            """Return where widgets are, what of them is drawn, and its lines; the front first."""
            if not self._changed:
                yield from super()._get_renders(crop)
                return
            left = self._changed
            for widget, (region, clip) in self.visible_widgets.items():
                shown = region.intersection(clip)
                parts = [part for each in left if (part := each.intersection(shown))]
                if not parts:
                    continue
                rows = Region.from_union(parts)
                # Strips are cut where widgets end.
                drawn = Region(shown.x, rows.y, shown.width, rows.height)
                yield region, drawn, widget.render_lines(drawn.translate(-region.offset))
                left = tuple(each for each in left if not shown.contains_region(each))
                if not left:
                    return

    return SparingCompositor
