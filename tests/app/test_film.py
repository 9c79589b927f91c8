"""The film of a run or review, and what is left of it when a mission stops."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.app.outputs import Mrta, Outputs


def frames(path: Path) -> int:
    """Count the pictures of a film by decoding it."""
    cv2 = pytest.importorskip("cv2")
    film = cv2.VideoCapture(str(path))
    count = 0
    while film.read()[0]:
        count += 1
    film.release()
    return count


@pytest.mark.parametrize("processes", ["1", "2"])
def test_a_run_leaves_a_film_of_all_its_pictures(mrta: Mrta, tmp_path: Path, processes: str) -> None:
    out = tmp_path / "out"
    arguments = ("--duration", "2", "--pictures", "0.5", "--video", "--processes", processes, "--out", str(out))
    assert mrta("run", "border_patrol", *arguments)[0] == 0
    assert len(list((out / "monitor").iterdir())) == 5
    assert frames(out / "monitor.webm") == 5


def test_a_review_leaves_the_film_that_its_run_would_have_left(
    mrta: Mrta, short_patrol: Outputs, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    assert mrta("review", str(short_patrol.bag), "--pictures", "0.5", "--video", "--out", str(out))[0] == 0
    assert frames(out / "monitor.webm") == 5


def test_another_run_without_a_film_leaves_no_old_one(mrta: Mrta, tmp_path: Path) -> None:
    out = tmp_path / "out"
    arguments = ("run", "border_patrol", "--duration", "1", "--out", str(out))
    assert mrta(*arguments, "--video")[0] == 0
    assert (out / "monitor.webm").exists()
    assert mrta(*arguments, "--force")[0] == 0
    assert not (out / "monitor.webm").exists()


def test_a_film_of_no_pictures_is_refused_before_anything_is_written(mrta: Mrta, tmp_path: Path) -> None:
    out = tmp_path / "out"
    status, lines = mrta("run", "border_patrol", "--pictures", "0", "--video", "--out", str(out))
    assert (status, lines) == (
        2,
        ["mrta: --video: there are no pictures to make a film of; give --pictures a time above 0"],
    )
    assert not out.exists()
