from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rqt_mrta_py.render.text import Style, fit, halo_patch, mask, patch, printable, shorten, text_width, wrap

STYLE = Style(13)
NAMES = st.text(st.characters(min_codepoint=33, max_codepoint=126), min_size=1, max_size=60)


@given(NAMES, st.integers(0, 200))
def test_fit_never_exceeds_the_width_and_keeps_the_beginning(name: str, width: int) -> None:
    fitted = fit(name, STYLE, width)
    assert text_width(fitted, STYLE) <= width
    assert fitted == name if text_width(name, STYLE) <= width else name.startswith(fitted[:-1])


@given(NAMES, st.integers(0, 200))
def test_shorten_never_exceeds_the_width_and_keeps_both_ends(name: str, width: int) -> None:
    short = shorten(name, STYLE, width)
    assert text_width(short, STYLE) <= width
    head, _, tail = short.partition("…")
    assert name.startswith(head)
    assert name.endswith(tail)


def test_shorten_keeps_apart_names_that_differ_at_the_end() -> None:
    one, other = (shorten(f"deliver_pallet_to_dock_{i}", STYLE, 90.0) for i in (1, 2))
    assert one != other


def test_text_takes_a_line_break_for_a_space() -> None:
    assert text_width("a\nb", STYLE) == text_width("a b", STYLE)
    assert np.array_equal(mask("a\nb", STYLE)[0], mask("a b", STYLE)[0])


def test_wrap_breaks_between_words_and_loses_none_when_there_is_room() -> None:
    words = "robot3 fell silent while it held border_protection"
    lines = wrap(words, STYLE, 160.0, 5)
    assert " ".join(lines) == words
    assert len(lines) > 1
    assert all(text_width(line, STYLE) <= 160 for line in lines)


def test_wrap_ends_in_an_ellipsis_when_words_are_left_over() -> None:
    lines = wrap("one two three four five six seven eight nine ten", STYLE, 60.0, 2)
    assert len(lines) == 2
    assert lines[-1].endswith("…")


def test_wrap_gives_one_empty_line_for_no_words() -> None:
    assert wrap("", STYLE, 60.0, 2) == ("",)


def test_mask_is_as_wide_as_measured_and_has_ink() -> None:
    coverage, baseline = mask("robot1", STYLE)
    assert coverage.shape[1] == text_width("robot1", STYLE)
    assert coverage.max() > 200
    assert 0 < baseline < coverage.shape[0]


def test_bold_words_have_more_ink() -> None:
    assert mask("robot1", Style(13, bold=True))[0].sum() > mask("robot1", STYLE)[0].sum()


def test_patch_shows_ground_and_colour_only() -> None:
    words, _ = patch("HH", Style(30, bold=True), (200, 10, 20), (255, 255, 255))
    colours = {tuple(pixel) for pixel in words.reshape(-1, 3).tolist()}
    assert (255, 255, 255) in colours
    assert (20, 10, 200) in colours


@pytest.mark.parametrize("ground", [0, 77, 255])
def test_halo_patch_neither_overflows_nor_changes_what_is_far_from_words(ground: int) -> None:
    added, kept, _ = halo_patch("M.", Style(14), (255, 255, 255), (255, 255, 255))
    laid = added.astype(np.int64) + kept.astype(np.int64) * ground
    assert laid.max() < 65536
    corner = int(laid[0, -1, 0]) >> 8
    assert corner == ground


def test_printable_makes_one_short_line_of_anything() -> None:
    assert printable("robot 1 → done ✓") == "robot 1 → done ✓"
    assert printable("a\nb\tc\x00d\ud800e\u202ef") == "a b c\ufffdd\ufffde\ufffdf"
    assert printable("x" * 5000 + "y", 11) == "xxxxx…xxxxy"


@given(st.text(max_size=40), st.integers(0, 200))
def test_words_are_never_wider_than_their_room(text: str, room: int) -> None:
    for words in (fit(text, STYLE, room), shorten(text, STYLE, room)):
        assert not words or text_width(words, STYLE) <= room


def test_names_of_a_million_characters_are_measured_and_drawn() -> None:
    name = "robot\n\x07" * 150_000
    assert 0 < text_width(shorten(name, STYLE, 100.0), STYLE) <= 100
    assert len(wrap(name, STYLE, 200.0, 3)) <= 3
    assert patch(name, STYLE, (0, 0, 0), (255, 255, 255))[0].shape[1] < 8000
