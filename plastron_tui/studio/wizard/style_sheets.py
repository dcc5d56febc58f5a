"""The style sheets of the wizard's screens, which the app reads when the first one is opened."""

from __future__ import annotations

from pathlib import Path

from textual.types import CSSPathType

from ..screens.dialog import DIALOG_STYLES

STYLES: CSSPathType = [DIALOG_STYLES, Path(__file__).with_name("wizard.tcss")]
