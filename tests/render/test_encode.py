from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from rqt_mrta_py.errors import MissingDependencyError, RenderError
from rqt_mrta_py.render import jpeg, libraries, png, write_picture

PICTURE = np.zeros((20, 30, 3), dtype=np.uint8)
PICTURE[5:15, 10:20] = (200, 100, 50)


def test_png_keeps_every_pixel() -> None:
    data = png(PICTURE)
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    assert np.array_equal(cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR), PICTURE)


def test_jpeg_keeps_about_every_pixel() -> None:
    data = jpeg(PICTURE, 95)
    assert data.startswith(b"\xff\xd8\xff")
    decoded = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)
    assert np.abs(decoded.astype(int) - PICTURE)[8:12, 13:17].max() < 12


def test_encoders_give_equal_bytes_for_equal_pictures() -> None:
    assert png(PICTURE) == png(PICTURE.copy())
    assert jpeg(PICTURE) == jpeg(PICTURE.copy())


@pytest.mark.parametrize("quality", [0, 101])
def test_jpeg_refuses_a_quality_out_of_range(quality: int) -> None:
    with pytest.raises(ValueError, match=f"between 1 and 100 \\(got {quality}\\)"):
        jpeg(PICTURE, quality)


@pytest.mark.parametrize("name", ["a.png", "a.jpg", "a.JPEG"])
def test_write_picture_writes_by_the_ending_and_leaves_nothing_else(tmp_path: Path, name: str) -> None:
    write_picture(tmp_path / name, PICTURE)
    assert [path.name for path in tmp_path.iterdir()] == [name]
    assert cv2.imread(str(tmp_path / name)).shape == (20, 30, 3)


def test_write_picture_replaces_an_older_one(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    path.write_bytes(b"old")
    write_picture(path, PICTURE)
    assert path.read_bytes() == png(PICTURE)


def test_write_picture_names_an_ending_that_it_does_not_know(tmp_path: Path) -> None:
    path = tmp_path / "a.gif"
    with pytest.raises(RenderError) as caught:
        write_picture(path, PICTURE)
    assert str(caught.value) == f"{path}: no picture format ends in '.gif'; use .png, .jpg or .jpeg"


def test_write_picture_names_the_path_that_it_cannot_write(tmp_path: Path) -> None:
    path = tmp_path / "nowhere" / "a.png"
    with pytest.raises(RenderError) as caught:
        write_picture(path, PICTURE)
    assert str(caught.value) == f"{path}: the picture cannot be written: No such file or directory"


def test_write_picture_keeps_the_old_file_and_leaves_no_other_when_renaming_fails(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    path.mkdir()
    with pytest.raises(RenderError, match="cannot be written"):
        write_picture(path, PICTURE)
    assert [each.name for each in tmp_path.iterdir()] == ["a.png"]


@pytest.mark.parametrize(
    "image",
    [np.zeros((4, 4), np.uint8), np.zeros((4, 4, 3), np.float64), np.zeros((0, 4, 3), np.uint8)],
    ids=["grey", "floats", "empty"],
)
def test_png_says_what_is_wrong_with_a_picture(image: np.ndarray) -> None:
    with pytest.raises(RenderError, match=r"must be \(height, width, 3\) of uint8, not empty"):
        png(image)


def test_require_says_what_to_install() -> None:
    with pytest.raises(MissingDependencyError) as caught:
        libraries.require("no_such_library", "no-such-library>=1", "drawing")
    assert "install 'no-such-library>=1', or rqt_mrta_py with its extra [plot]" in str(caught.value)
