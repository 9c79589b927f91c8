"""Where outputs go, and what of earlier ones stays."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.app.outputs import Mrta, Outputs


def test_a_folder_that_is_not_empty_needs_force(mrta: Mrta, tmp_path: Path) -> None:
    folder = tmp_path / "full"
    folder.mkdir()
    (folder / "mission.bag").write_text("precious")
    status, lines = mrta("run", "border_patrol", "--duration", "1", "--out", str(folder))
    assert status == 2
    assert len(lines) == 1
    assert "--force" in lines[0]
    assert (folder / "mission.bag").read_text() == "precious"


def test_force_replaces_the_outputs_of_an_earlier_run_and_nothing_else(mrta: Mrta, tmp_path: Path) -> None:
    folder = tmp_path / "full"
    (folder / "monitor").mkdir(parents=True)
    (folder / "mission.bag").write_text("earlier")
    (folder / "monitor" / "000009.000.png").write_text("earlier")
    (folder / "notes.txt").write_text("mine")
    (folder / "monitor" / "photograph.png").write_text("mine")
    status, _ = mrta("run", "border_patrol", "--duration", "1", "--out", str(folder), "--force")
    assert status == 0
    assert (folder / "mission.bag").read_bytes().startswith(b"#ROSBAG V2.0")
    pictures = ["000000.000.png", "000001.000.png", "photograph.png"]
    assert sorted(path.name for path in (folder / "monitor").iterdir()) == pictures
    assert (folder / "notes.txt").read_text() == "mine"


@pytest.mark.parametrize("verb", ["run", "review"])
def test_force_leaves_no_picture_of_an_earlier_mission(
    mrta: Mrta, short_patrol: Outputs, tmp_path: Path, verb: str
) -> None:
    """Without pictures of its own a run once lay beside those of another."""
    folder = tmp_path / "full"
    (folder / "monitor").mkdir(parents=True)
    (folder / "monitor" / "000009.000.png").write_text("earlier")
    (folder / "dashboard.png").write_text("earlier")
    what = ("border_patrol", "--duration", "1") if verb == "run" else (str(short_patrol.bag),)
    status, _ = mrta(verb, *what, "--pictures", "0", "--out", str(folder), "--force")
    assert status == 0
    assert (folder / "summary.json").exists()
    assert [name for name in ("monitor", "dashboard.png") if (folder / name).exists()] == []


def test_the_folder_runs_counts_up_where_none_is_given(mrta: Mrta, tmp_path: Path) -> None:
    for _ in range(2):
        assert mrta("run", "border_patrol", "--duration", "1", "--pictures", "0", "--seed", "3")[0] == 0
    runs = tmp_path / "here" / "runs"
    assert sorted(path.name for path in runs.iterdir()) == ["border_patrol-seed3", "border_patrol-seed3-2"]
    bag = runs / "border_patrol-seed3" / "mission.bag"
    assert mrta("review", str(bag), "--pictures", "0")[0] == 0
    assert (runs / "mission-review" / "summary.json").exists()
