"""The page of a comparison in a headless Chromium."""

from __future__ import annotations

from pathlib import Path
from typing import Iterator

import pytest

from tests.app.compare.test_page import HOSTILE, written
from tests.render.report.browser import Browser, require_browser


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Browser]:
    require_browser()
    with Browser(tmp_path_factory.mktemp("browser")) as started:
        yield started


def test_the_page_needs_nothing_has_both_themes_and_fits_small_windows(browser: Browser, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text(written(tmp_path, "r1"), encoding="utf-8")
    tab = browser.open(page, width=1100)
    grounds = []
    for scheme in ("light", "dark"):
        tab.media(scheme)
        grounds.append(tab.run("getComputedStyle(document.body).backgroundColor"))
    assert grounds == ["rgb(255, 255, 255)", "rgb(21, 24, 29)"]
    for width in (1100, 390):
        tab.size(width, 800)
        assert tab.run("document.documentElement.scrollWidth") == width
    assert tab.complaints() == []


def test_the_lists_open_by_keyboard(browser: Browser, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text(written(tmp_path, "r1"), encoding="utf-8")
    tab = browser.open(page)
    tab.run("document.querySelector('summary').focus()")
    assert tab.run("document.querySelector('details').open") is False
    tab.press(" ")
    assert tab.run("document.querySelector('details').open") is True


def test_texts_from_outside_do_nothing(browser: Browser, tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text(written(tmp_path, HOSTILE), encoding="utf-8")
    tab = browser.open(page)
    assert tab.run("[document.scripts.length, document.images.length]") == [0, 0]
    assert HOSTILE in tab.run("[...document.querySelectorAll('h3')].map((each) => each.textContent)")
    assert tab.complaints() == []
