"""The pictures in the pages: there, small, and of no machine in particular."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
IMAGES = sorted((ROOT / "docs" / "images").iterdir())


def shown(page: Path) -> set[Path]:
    """Return the files of the pictures that a page shows."""
    links = re.findall(r"!\[[^\]]*\]\(([^)]+)\)", page.read_text(encoding="utf-8"))
    return {(page.parent / link).resolve() for link in links}


def test_every_picture_is_shown_and_there() -> None:
    assert set().union(*map(shown, PAGES)) == {image.resolve() for image in IMAGES}


def test_the_readme_opens_with_the_studio() -> None:
    assert re.match(r"!\[The studio[^\]]*\]\(docs/images/studio\.svg\)", PAGES[0].read_text())


@pytest.mark.parametrize("image", IMAGES, ids=lambda image: image.name)
def test_a_picture_is_small_and_of_no_machine(image: Path) -> None:
    text = image.read_text(encoding="utf-8")
    assert len(text.encode()) < 200_000
    assert not re.search(r"/(tmp|home|root|work|Users)/", text)
    assert not re.search(r"https?://(?!www\.w3\.org|(www\.)?textual)", text)
