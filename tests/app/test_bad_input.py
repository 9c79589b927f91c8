"""Bad input gets one clear line and the right exit status, and leaves nothing half-written."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Optional, Tuple

import pytest

from tests.app.outputs import Mrta


def edit(path: Path, old: str, new: str) -> int:
    """Replace text that stands in a file once and give its line."""
    text = path.read_text()
    assert text.count(old) == 1
    path.write_text(text.replace(old, new))
    return text[: text.index(old)].count("\n") + 1


def test_an_unknown_application_is_told_with_the_nearest_name(mrta: Mrta, tmp_path: Path) -> None:
    status, lines = mrta("run", "border_patrl")
    assert status == 3
    assert len(lines) == 1
    assert "border_patrl" in lines[0]
    assert "border_patrol" in lines[0]
    assert list((tmp_path / "here").iterdir()) == []


def test_an_unknown_parameter_is_told_with_the_nearest_path(mrta: Mrta, tmp_path: Path) -> None:
    status, lines = mrta("run", "border_patrol", "--set", "robot2/spin_rat=5")
    assert status == 3
    assert len(lines) == 1
    assert "spin_rat" in lines[0]
    assert "spin_rate" in lines[0]
    assert list((tmp_path / "here").iterdir()) == []


def test_a_parameter_of_the_wrong_type_is_told_with_file_and_line(mrta: Mrta, yard: Path) -> None:
    line = edit(
        yard / "rqt_mrta.xml",
        "<id>robot1_alliance_params</id>\n      <param_0> <name>timeout_duration</name> "
        "<type>double</type> <value>5.0</value>",
        "<id>robot1_alliance_params</id>\n      <param_0> "
        "<name>timeout_duration</name> <type>double</type> <value>soon</value>",
    )
    status, lines = mrta("run", "yard")
    assert status == 3
    assert len(lines) == 1
    assert f"{yard / 'rqt_mrta.xml'}:{line + 1}: " in lines[0]
    assert "soon" in lines[0]


def test_a_parameter_that_the_architecture_cannot_work_with_is_told(mrta: Mrta) -> None:
    status, lines = mrta("run", "border_patrol", "--set", "robot2/timeout_duration=0.1")
    assert status == 3
    assert any("timeout_duration" in line and "0.1" in line for line in lines)


def test_a_robot_in_a_wall_is_told_by_name(mrta: Mrta, yard: Path, tmp_path: Path) -> None:
    edit(yard / "scenario.yaml", "start: {x: -1.0, y: -0.4, yaw: 0.0}", "start: {x: -5.95, y: -0.4, yaw: 0.0}")
    status, lines = mrta("run", "yard")
    assert status == 3
    assert len(lines) == 1
    assert "robot1" in lines[0]
    assert "wall" in lines[0]
    assert list((tmp_path / "here").iterdir()) == []


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("entity bomb", '<!DOCTYPE r [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;">]><rqt_mrta>&b;</rqt_mrta>'),
        ("external entity", '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/hostname">]><rqt_mrta>&x;</rqt_mrta>'),
        ("not well formed", "<rqt_mrta><application></rqt_mrta>"),
        ("empty", ""),
    ],
)
def test_a_hostile_or_broken_xml_file_is_told_with_file_and_line(mrta: Mrta, yard: Path, name: str, text: str) -> None:
    (yard / "rqt_mrta.xml").write_text(text)
    status, lines = mrta("run", "yard")
    assert status == 3, name
    assert len(lines) == 1
    assert str(yard / "rqt_mrta.xml") in lines[0]


def test_a_broken_manifest_is_reported_and_skipped(mrta: Mrta, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = tmp_path / "packages" / "broken"
    broken.mkdir(parents=True)
    (broken / "package.xml").write_text("<package format='3'><name>broken</name><!-- rqt_mrta -->")
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "packages"))
    status, lines = mrta("list")
    assert status == 0
    assert len(lines) == 1
    assert str(broken / "package.xml") in lines[0]


@pytest.mark.parametrize(
    ("name", "content"), [("missing", None), ("empty", b""), ("text", b"not a bag"), ("magic", b"#ROSBAG V2.0\n")]
)
def test_what_is_not_a_bag_is_told_by_name(mrta: Mrta, tmp_path: Path, name: str, content: Optional[bytes]) -> None:
    bag = tmp_path / f"{name}.bag"
    if content is not None:
        bag.write_bytes(content)
    status, lines = mrta("review", str(bag))
    assert status == 3
    assert len(lines) == 1
    assert str(bag) in lines[0]
    assert list((tmp_path / "here").iterdir()) == []


def test_a_bag_that_the_architecture_does_not_speak_of_is_told(
    mrta: Mrta, shared_data: Callable[[str], Path], tmp_path: Path
) -> None:
    """Such a review passed --fail-on without a word."""
    bag = shared_data("talmech_two_bidders.bag")
    arguments = ("--architecture", "mrta_alliance", "--pictures", "0", "--fail-on", "info", "--out")
    status, lines = mrta("review", str(bag), *arguments, str(tmp_path / "review"))
    assert status == 0
    assert lines == [f"mrta: {bag}: no robot was heard as mrta_alliance tells it; is the bag another architecture's?"]


@pytest.mark.parametrize(
    "arguments",
    [
        ("run",),
        ("fly", "border_patrol"),
        ("run", "border_patrol", "--seed", "-1"),
        ("run", "border_patrol", "--duration", "nan"),
        ("run", "border_patrol", "--duration", "0"),
        ("run", "border_patrol", "--duration", "1e300"),
        ("run", "border_patrol", "--pictures", "inf"),
        ("run", "border_patrol", "--robots", "0"),
        ("run", "border_patrol", "--robots", "6"),
        ("run", "border_patrol", "--world", "moon"),
        ("run", "border_patrol", "--dur", "1"),
        ("run", "border_patrol", "--fail-on", "fatal"),
        ("show", "border_patrol", "mrta_alliance"),
        ("list", "--type", "ST-SR"),
    ],
)
def test_wrong_usage_exits_with_2_and_one_line(mrta: Mrta, tmp_path: Path, arguments: Tuple[str, ...]) -> None:
    status, lines = mrta(*arguments)
    assert status == 2
    assert len(lines) == 1
    assert list((tmp_path / "here").iterdir()) == []


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (
            ("run", "border_patrol", "--duration", "-1"),
            "mrta run: argument --duration: '-1': a finite number above 0 is expected; see mrta run --help",
        ),
        (
            ("run", "border_patrol", "--robots", "1.5"),
            "mrta run: argument --robots: '1.5': a whole number from 1 is expected; see mrta run --help",
        ),
        (
            ("review", "some.bag", "--colour"),
            "mrta review: unrecognized arguments: --colour; see mrta review --help",
        ),
        (
            ("run", "border_patrol", "--world", "moon"),
            "mrta: --world moon: there is no such world; there are: bullet, planar",
        ),
        (
            ("run", "border_patrol", "--duration", "1e10"),
            "mrta: a mission of 1e+10 s ends beyond ROS time, which has 2^32 s; make it shorter",
        ),
    ],
)
def test_wrong_usage_is_told_in_the_verbs_own_name(mrta: Mrta, arguments: Tuple[str, ...], told: str) -> None:
    assert mrta(*arguments) == (2, [told])


def test_a_kind_of_task_that_nobody_carries_out_is_told_with_all_kinds(mrta: Mrta, yard: Path) -> None:
    edit(yard / "tasks.yaml", "kind: wander", "kind: stroll")
    status, lines = mrta("run", "yard")
    assert (status, lines) == (
        3,
        [
            "mrta: robot1: task 'wander': no plugin provides a behaviour for its kind 'stroll'; "
            "accepted: avoid, collect, follow_border, go_to_place, place_block, report, wander"
        ],
    )


def test_an_application_without_a_scenario_is_told_how_to_name_one(mrta: Mrta, yard: Path) -> None:
    edit(yard / "package.xml", ' scenario="${prefix}/scenario.yaml"', "")
    status, lines = mrta("run", "yard")
    assert (status, len(lines)) == (2, 1)
    assert lines[0].startswith("mrta: yard: has no scenario")
    assert 'scenario="${prefix}/scenario.yaml"' in lines[0]


def test_a_current_folder_that_is_gone_is_told(mrta: Mrta, tmp_path: Path) -> None:
    (tmp_path / "here").rmdir()
    status, lines = mrta("run", "border_patrol", "--duration", "1")
    assert status == 3
    assert lines == [
        "mrta: runs: the folder for the outputs cannot be made: No such file or directory; give another one with --out"
    ]
