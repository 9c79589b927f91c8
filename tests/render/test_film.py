from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import List

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from rqt_mrta_py.errors import RenderError
from rqt_mrta_py.render import FilmWriter

COLOURS = [(30, 40, 200), (200, 60, 30), (40, 180, 60), (128, 128, 128)]


def picture(number: int, width: int = 160, height: int = 90) -> NDArray[np.uint8]:
    image = np.full((height, width, 3), 240, dtype=np.uint8)
    image[20:70, 10 * number + 10 : 10 * number + 60] = COLOURS[number % len(COLOURS)]
    return image


def shown(path: Path) -> List[NDArray[np.uint8]]:
    film, pictures = cv2.VideoCapture(str(path)), []
    while True:
        done, image = film.read()
        if not done:
            return pictures
        pictures.append(image)


def test_film_shows_every_picture_at_its_time(tmp_path: Path) -> None:
    path = tmp_path / "monitor.webm"
    with FilmWriter(path, 5.0) as film:
        for number in range(9):
            film.add(picture(number))
        assert not path.exists()
    assert [each.name for each in tmp_path.iterdir()] == ["monitor.webm"]
    assert path.read_bytes()[:4] == b"\x1a\x45\xdf\xa3"  # EBML, of which WebM is made
    assert cv2.VideoCapture(str(path)).get(cv2.CAP_PROP_FPS) == pytest.approx(5.0)
    pictures = shown(path)
    assert len(pictures) == 9
    for number, image in enumerate(pictures):
        assert image.shape == (90, 160, 3)
        assert np.abs(image.astype(int) - picture(number)).mean() < 6.0
        inside = image[35:55, 10 * number + 25 : 10 * number + 45].reshape(-1, 3).mean(axis=0)
        assert np.abs(inside - COLOURS[number % len(COLOURS)]).max() < 25.0


def test_film_of_a_mission_that_stopped_is_there(tmp_path: Path) -> None:
    path = tmp_path / "monitor.webm"

    def mission() -> None:
        with FilmWriter(path, 10.0) as film:
            film.add(picture(0))
            raise KeyError

    with pytest.raises(KeyError):
        mission()
    assert len(shown(path)) == 1


def test_film_without_pictures_leaves_no_file(tmp_path: Path) -> None:
    with FilmWriter(tmp_path / "monitor.webm", 10.0) as film:
        film.close()
    assert list(tmp_path.iterdir()) == []


def test_film_names_the_folder_that_it_cannot_write_to(tmp_path: Path) -> None:
    path = tmp_path / "nowhere" / "monitor.webm"
    with pytest.raises(RenderError) as caught:
        FilmWriter(path, 10.0).add(picture(0))
    assert str(caught.value) == f"{path}: the film cannot be written: No such file or directory"


def test_film_says_what_is_missing_where_opencv_has_no_encoder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Closed:
        def __init__(self, *_: object) -> None:
            pass

        def isOpened(self) -> bool:  # noqa: N802 - OpenCV's name
            return False

    monkeypatch.setattr(cv2, "VideoWriter", Closed)
    with pytest.raises(RenderError, match="without FFmpeg's VP8 encoder; install opencv-python-headless from PyPI"):
        FilmWriter(tmp_path / "monitor.webm", 10.0).add(picture(0))
    assert list(tmp_path.iterdir()) == []


def test_film_says_so_when_the_disk_is_full(tmp_path: Path, root: Path) -> None:
    """OpenCV tells of no failure to write; a limit on the size of files stands for the disk."""
    code = (
        f"import resource, sys; sys.path[:0] = [{str(root)!r}, {str(root / 'src')!r}];"
        "import numpy as np; from pathlib import Path; from rqt_mrta_py.render import FilmWriter;"
        "film = FilmWriter(Path(sys.argv[1]), 10.0); random = np.random.default_rng(0);"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (8_000, 8_000));"
        "[film.add(random.integers(0, 255, (90, 160, 3), np.uint8)) for _ in range(40)]; film.close()"
    )
    path = tmp_path / "monitor.webm"
    done = subprocess.run([sys.executable, "-c", code, str(path)], capture_output=True, text=True, check=False)
    assert f"RenderError: {path}: the film was not written whole; make room on the disk" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_film_refuses_what_makes_no_film(tmp_path: Path) -> None:
    path = tmp_path / "monitor.webm"
    with pytest.raises(ValueError, match=r"must end in \.webm"):
        FilmWriter(tmp_path / "monitor.avi", 10.0)
    with pytest.raises(ValueError, match="above 0 and below 1000"):
        FilmWriter(path, 0.0)
    with pytest.raises(ValueError, match="must be even \\(got 161 x 90 pixels\\)"):
        FilmWriter(path, 10.0).add(picture(0, width=161))
    with pytest.raises(ValueError, match="of uint8"):
        FilmWriter(path, 10.0).add(picture(0).astype(np.float64))  # type: ignore[arg-type]
    with FilmWriter(path, 10.0) as film:
        film.add(picture(0))
        with pytest.raises(ValueError, match="began with 160 x 90 pixels \\(got a picture of 80 x 90\\)"):
            film.add(picture(0, width=80))


def test_film_is_silent(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    with FilmWriter(tmp_path / "monitor.webm", 10.0) as film:
        film.add(picture(0))
    assert capfd.readouterr() == ("", "")


def test_film_is_whole_as_soon_as_it_is_there(tmp_path: Path) -> None:
    path = tmp_path / "monitor.webm"
    for count in (1, 2, 30):
        with FilmWriter(path, 10.0) as film:
            for number in range(count):
                film.add(picture(number % 8, 320, 180))
        assert len(shown(path)) == count
