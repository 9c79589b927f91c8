"""What is taken from /opt/ros."""

from __future__ import annotations

from pathlib import Path

from tests.bootstrap.conftest import Miniature


def distribution(folder: Path, name: str) -> Path:
    (folder / name).mkdir(parents=True)
    script = f'[ -n "$NEVER_SET" ]; false; CHOSEN="${{CHOSEN:-}}{name}"\necho said\n'
    (folder / name / "setup.bash").write_text(script, encoding="utf-8")
    return folder / name


def chosen(miniature: Miniature, folder: Path, **changes: str) -> str:
    return miniature.shell(f"source_ros '{folder}'; printf '%s' \"${{CHOSEN:-}}\"", **changes).stdout


def test_ros_is_sourced_though_its_script_minds_no_errors(miniature: Miniature, tmp_path: Path) -> None:
    distribution(tmp_path, "noetic")
    assert chosen(miniature, tmp_path) == "noetic"


def test_of_several_the_users_distribution_is_sourced_else_the_last(miniature: Miniature, tmp_path: Path) -> None:
    for name in ("melodic", "kinetic", "noetic"):
        distribution(tmp_path, name)
    assert chosen(miniature, tmp_path) == "noetic"
    assert chosen(miniature, tmp_path, ROS_DISTRO="melodic") == "melodic"


def test_ros_2_is_left_alone(miniature: Miniature, tmp_path: Path) -> None:
    (distribution(tmp_path, "rolling") / "share/ament_index").mkdir(parents=True)
    assert chosen(miniature, tmp_path) == ""


def test_a_workspace_that_is_already_sourced_is_kept(miniature: Miniature, tmp_path: Path) -> None:
    distribution(tmp_path, "noetic")
    assert chosen(miniature, tmp_path, CMAKE_PREFIX_PATH=f"/mine/devel:{tmp_path}/noetic") == ""


def test_without_ros_nothing_is_sourced(miniature: Miniature, tmp_path: Path) -> None:
    assert chosen(miniature, tmp_path / "none") == ""
