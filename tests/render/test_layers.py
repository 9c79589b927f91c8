"""What a layer shows is a function of its parts and of what lies below; prints stay as they are while they are held."""

from __future__ import annotations

from typing import List, Tuple

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from rqt_mrta_py.render.canvas import Box, Canvas
from rqt_mrta_py.render.layers import Layer, Printer
from rqt_mrta_py.render.page import Part

HEIGHT, WIDTH = 4, 24

Picture = NDArray[np.uint8]
Strip = Tuple[int, int, int]
"""From a column to another, in a shade."""


def ground() -> Layer:
    return Layer(np.zeros((HEIGHT, WIDTH, 3), np.uint8))


def brighten(canvas: Canvas, content: Tuple[int, int, int]) -> None:
    left, right, shade = content
    canvas.image[:, left:right] += shade


def part(strip: Strip) -> Part:
    left, right, _ = strip
    return Part(Box(left, 0, right, HEIGHT), strip, brighten)


def plain(*layers: List[Strip]) -> Picture:
    """Add up shades column by column."""
    picture = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
    for strips in layers:
        for left, right, shade in strips:
            picture[:, left:right] += shade
    return picture


def strips_of(cuts: List[int], shades: List[int]) -> List[Strip]:
    edges = sorted(set(cuts))
    return [(left, right, shade) for left, right, shade in zip(edges, edges[1:], shades) if shade]


strips = st.builds(
    strips_of,
    st.lists(st.integers(0, WIDTH), max_size=6),
    st.lists(st.integers(0, 3), min_size=6, max_size=6),
)


@given(st.lists(st.tuples(strips, strips, st.booleans()), max_size=8))
def test_layers_and_prints_show_their_parts_whatever_they_showed_before(
    moments: List[Tuple[List[Strip], List[Strip], bool]],
) -> None:
    lower = ground().on_top()
    upper = lower.on_top()
    printer = Printer(upper)
    held: List[Tuple[Picture, Picture]] = []
    for below, above, keep in moments:
        lower.show([part(strip) for strip in below])
        upper.show([part(strip) for strip in above])
        picture, expected = printer.print(), plain(below, above)
        assert np.array_equal(upper.image, expected)
        assert np.array_equal(picture, expected)
        if keep:
            held.append((picture, expected))
        del picture
    assert all(np.array_equal(picture, expected) for picture, expected in held)


def test_layer_draws_a_part_again_only_if_its_content_or_what_lies_below_has_changed() -> None:
    drawn: List[Tuple[int, int, int]] = []

    def draw(canvas: Canvas, content: Tuple[int, int, int]) -> None:
        drawn.append(content)

    def wanted(left: int, shade: int) -> Part:
        return Part(Box(left, 0, left + 4, HEIGHT), (left, left + 4, shade), draw)

    lower = ground().on_top()
    upper = lower.on_top()
    upper.show([wanted(0, 1), wanted(8, 1)])
    upper.show([wanted(0, 1), wanted(8, 2)])
    assert drawn == [(0, 4, 1), (8, 12, 1), (8, 12, 2)]
    lower.show([part((3, 6, 5))])
    upper.show([wanted(0, 1), wanted(8, 2)])
    assert drawn[3:] == [(0, 4, 1)]


def test_layer_clears_what_a_part_left_that_could_not_be_drawn() -> None:
    def fail(canvas: Canvas, content: str) -> None:
        canvas.image[:, 4:] = 9
        raise ValueError(content)

    layer = ground().on_top()
    with pytest.raises(ValueError, match="no ink"):
        layer.show([part((0, 4, 1)), Part(Box(4, 0, WIDTH, HEIGHT), "no ink", fail)])
    layer.show([part((0, 4, 1))])
    assert np.array_equal(layer.image, plain([(0, 4, 1)]))


def test_printer_copies_nothing_that_was_not_changed() -> None:
    layer = ground().on_top()
    printer = Printer(layer)
    printer.print()
    layer.image[0, 20] = 7
    layer.show([part((0, 4, 1))])
    assert np.array_equal(printer.print(), plain([(0, 4, 1)]))


def test_prints_that_are_held_have_memory_of_their_own() -> None:
    layer = ground().on_top()
    printer = Printer(layer)
    places = []
    held = []
    for shade in range(1, 8):
        layer.show([part((0, 4, shade))])
        held.append(printer.print())
        places.append(held[-1].__array_interface__["data"][0])
    assert len(set(places)) == 7
    assert [int(picture[0, 0, 0]) for picture in held] == list(range(1, 8))
