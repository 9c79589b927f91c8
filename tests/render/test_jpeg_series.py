"""The bytes of each picture of a series are a function of its pixels, and show what a plain JPEG would."""

from __future__ import annotations

from typing import Any, List, Tuple

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from rqt_mrta_py.errors import RenderError
from rqt_mrta_py.render import JpegSeries, jpeg
from rqt_mrta_py.render.jpeg_series import restart_interval

HEIGHT, WIDTH = 48, 160
Picture = NDArray[np.uint8]
Dab = Tuple[int, int, int]
"""Row, column and shade of a spot."""


def noise(height: int = HEIGHT, width: int = WIDTH) -> Picture:
    return np.random.default_rng(7).integers(0, 256, (height, width, 3), np.uint8)


def encoded(image: Picture, *options: int) -> bytes:
    return bytes(cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, 85, *options])[1])


def decoded(data: bytes) -> Any:
    return cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)


dabs = st.lists(st.tuples(st.integers(0, HEIGHT - 1), st.integers(0, WIDTH - 1), st.integers(0, 255)), max_size=6)


@given(st.lists(dabs, min_size=1, max_size=5))
def test_series_gives_what_encoding_each_picture_as_a_whole_gives(moments: List[List[Dab]]) -> None:
    series, image = JpegSeries(), noise()
    for moment in moments:
        for row, column, shade in moment:
            image[row : row + 5, column : column + 5] = shade
        # 160 pixels are 10 blocks, two tiles of 5.
        assert series(image) == encoded(image, cv2.IMWRITE_JPEG_RST_INTERVAL, 5)


def test_series_shows_what_a_plain_jpeg_shows() -> None:
    series, image = JpegSeries(), noise()
    series(image)
    image[20:30, 100:] = 90
    assert np.array_equal(decoded(series(image)), decoded(encoded(image)))


def test_series_goes_on_with_pictures_of_another_size() -> None:
    series = JpegSeries()
    for height, width, interval in ((48, 160, 5), (32, 160, 5), (32, 64, 4), (48, 160, 5)):
        image = noise(height, width)
        assert series(image) == encoded(image, cv2.IMWRITE_JPEG_RST_INTERVAL, interval)


@pytest.mark.parametrize(("height", "width"), [(40, 160), (48, 150)])
def test_series_encodes_pictures_as_plain_jpeg_that_blocks_do_not_fill(height: int, width: int) -> None:
    series = JpegSeries()
    for image in (noise(height, width), 255 - noise(height, width)):
        assert series(image) == encoded(image)


def test_series_takes_parts_of_larger_pictures() -> None:
    series, whole = JpegSeries(), noise(100, 200)
    for shade in (10, 20):
        whole[10:20, 10:20] = shade
        part = whole[2 : 2 + HEIGHT, 4 : 4 + WIDTH]
        assert series(part) == encoded(part, cv2.IMWRITE_JPEG_RST_INTERVAL, 5)


def test_series_refuses_what_is_no_picture_and_goes_on() -> None:
    series, image = JpegSeries(), noise()
    first = series(image)
    with pytest.raises(RenderError, match=r"must be \(height, width, 3\) of uint8"):
        series(image.astype(np.float64))  # type: ignore[arg-type]
    assert series(image) == first


@pytest.mark.parametrize(
    ("shape", "blocks"), [((720, 1280, 3), 5), ((16, 112, 3), 1), ((16, 48, 3), 3), ((16, 40, 3), 0), ((8, 80, 3), 0)]
)
def test_restart_interval_divides_a_row_of_blocks(shape: Tuple[int, int, int], blocks: int) -> None:
    assert restart_interval(shape) == blocks


def test_jpeg_places_restart_markers() -> None:
    image = noise()
    # 3 rows of 10 blocks: a marker behind each row but the last.
    assert [byte for byte in (0xD0, 0xD1, 0xD2) if bytes((0xFF, byte)) in jpeg(image, restart=10)] == [0xD0, 0xD1]
