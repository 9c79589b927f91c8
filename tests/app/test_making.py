"""Missions that a package's maker makes of what the user sets."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Dict, List, Tuple

import pytest
import yaml

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.live.live_run import node_arguments
from rqt_mrta_py.app.live.mission_parameters import StrictReader, mission_choice
from rqt_mrta_py.app.making import making_of
from rqt_mrta_py.app.mission_message import mission_from_fields, mission_message
from rqt_mrta_py.app.run.choice import MissionChoice, chosen_mission
from rqt_mrta_py.app.run.request import RunRequest
from rqt_mrta_py.hooks import MadeMission, MissionMaker, MissionRequest, MissionSetting
from tests.app.outputs import Mrta

PLUGIN = """from rqt_mrta_py.hooks import MadeMission, MissionMaker, MissionSetting, UsageError, hookimpl

ASKED = []


def make(request):
    ASKED.append(request)
    if request.settings["distance"] == "far":
        raise UsageError("distance: 'far'; a number is expected")
    {body}
    tasks = request.tasks_yaml.replace("distance: 0.6", "distance: " + request.settings["distance"])
    return MadeMission(tasks, request.scenario_yaml)


SETTINGS = (MissionSetting("distance", "from walls [m]", "0.6"), MissionSetting("colour", "of nothing"))


@hookimpl
def mrta_register_mission_makers():
    return {{"border_patrol": MissionMaker(SETTINGS, make{robots})}}
"""
RUN = ("run", "border_patrol", "--duration", "1", "--pictures", "0", "--processes", "1", "--out", "out")


def write(stranger: Path, body: str = "pass", robots: str = "") -> None:
    stranger.write_text(PLUGIN.format(body=body, robots=robots))


def distance(host: Host, *overrides: str) -> float:
    mission, _ = chosen_mission(host, MissionChoice("border_patrol", overrides=overrides))
    return float(next(task.data["distance"] for task in mission.tasks if "distance" in task.data))


def asked() -> List[Dict[str, object]]:
    from stranger_plugin import ASKED  # type: ignore[import-not-found]

    return [{"settings": dict(each.settings), "given": sorted(each.given), "team": each.team} for each in ASKED]


def test_files_are_used_as_they_are_where_no_setting_is_given(stranger: Path) -> None:
    write(stranger)
    assert distance(compose(), "robot1/timeout_duration=9") == 0.6
    assert asked() == []


def test_a_maker_is_told_all_settings_and_asked_once_for_the_same(stranger: Path) -> None:
    write(stranger)
    host = compose()
    assert [distance(host, " distance = 0.9 ", "robot1/timeout_duration=9") for _ in range(2)] == [0.9, 0.9]
    team = tuple(f"robot{number}" for number in range(1, 6))
    assert asked() == [{"settings": {"distance": "0.9", "colour": ""}, "given": ["distance"], "team": team}]
    assert distance(host, "distance=0.9", "distance=0.7") == 0.7


@pytest.mark.parametrize(
    ("robots", "wanted", "team", "is_made"),
    [("", None, 5, False), ("", 2, 2, False), (", robots=2", None, 2, False), (", robots=2", 2, 2, False)]
    + [(", robots=2", 4, 4, True)],
)
def test_a_maker_says_for_how_many_robots_its_files_are(
    stranger: Path, robots: str, wanted: int, team: int, is_made: bool
) -> None:
    write(stranger, robots=robots)
    mission, _ = chosen_mission(compose(), MissionChoice("border_patrol", robots=wanted))
    assert (len(mission.application.robots), len(asked())) == (team, is_made)


def test_the_message_of_a_mission_carries_what_was_made(stranger: Path) -> None:
    """So that a bag can be reviewed where the plugin is not installed."""
    write(stranger)
    mission, _ = chosen_mission(compose(), MissionChoice("border_patrol", overrides=("distance=0.9",)))
    fields = mission_message(mission, now=0.0, duration=1.0).fields
    assert "distance: 0.9" in fields["tasks_yaml"]
    assert mission_from_fields(fields) == mission


WRONG = {
    "unknown": (
        "pass",
        "distence=1",
        "--set: distence=1: is no setting of border_patrol; nearest is 'distance'; accepted are distance=..., "
        "colour=... and <robot>/<parameter>=<value>",
    ),
    "raises": ("1 / 0", "distance=1", "mission maker border_patrol: ZeroDivisionError: division by zero"),
    "no mission": (
        "return 5",
        "distance=1",
        "mission maker border_patrol: made 5; a MadeMission of two texts is needed",
    ),
    "no YAML": ("pass", "distance={", "tasks.yaml made of distance={:10:"),
    "unknown key": (
        "return MadeMission('tasks: [{id: a, kind: b, colour: red}]', request.scenario_yaml)",
        "colour=red",
        "tasks.yaml made of colour=red:1: ",
    ),
    "bad scenario": (
        "return MadeMission(request.tasks_yaml, 'arena: 5')",
        "colour=red",
        "scenario.yaml made of colour=red:1: ",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_with_a_made_mission_is_told_by_what_it_is_made_of(mrta: Mrta, stranger: Path, name: str) -> None:
    body, setting, line = WRONG[name]
    write(stranger, body)
    status, lines = mrta(*RUN, "--set", setting)
    assert (status, lines[0][: len(line) + 6]) == (3, f"mrta: {line}")
    assert not Path("out").exists()


def test_what_a_maker_refuses_is_told_with_its_own_status(mrta: Mrta, stranger: Path) -> None:
    write(stranger)
    assert mrta(*RUN, "--set", "distance=far") == (2, ["mrta: distance: 'far'; a number is expected"])


def test_nodes_are_given_settings_as_the_command_was(stranger: Path) -> None:
    """By the text of a private parameter, which YAML reads, also of what holds blanks, commas and quotes."""
    write(stranger)
    given = ("distance=0.9", "colour=it's red, or not", "robot1/timeout_duration=9")
    (text,) = [
        each.partition(":=")[2]
        for each in node_arguments(RunRequest("border_patrol", overrides=given), {}, "__ns:=/")
        if each.startswith("_settings:=")
    ]
    reader = StrictReader({"~settings": yaml.safe_load(text)}.get, str)
    assert mission_choice(reader, "border_patrol").overrides == given[:2]


def test_tasks_that_robots_name_and_nobody_makes_are_told(mrta: Mrta, stranger: Path) -> None:
    write(stranger, "return MadeMission('tasks: [{id: wander, kind: wander}]', request.scenario_yaml)")
    status, lines = mrta(*RUN, "--set", "colour=a/b.vox")
    assert status == 3
    told = "robot1/tasks: 'border_protection' is not in tasks.yaml made of colour=a/b.vox; accepted: wander"
    assert lines[0].endswith(told)


def test_one_who_makes_another_number_of_robots_than_there_are_is_refused(mrta: Mrta, stranger: Path) -> None:
    write(stranger)
    status, lines = mrta(*RUN, "--set", "distance=1", "--robots", "9")
    assert (status, lines) == (2, ["mrta: --robots 9: border_patrol has 5 robots; give 1 to 5"])


def test_a_recorded_mission_is_reviewed_without_the_maker(
    mrta: Mrta, stranger: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(stranger)
    assert mrta(*RUN, "--set", "distance=0.9")[0] == 0
    monkeypatch.setenv("RQT_MRTA_PY_BLOCK_PLUGINS", "stranger")
    assert mrta("review", "out/mission.bag", "--out", "again", "--pictures", "0", "-q")[0] == 0
    first, again = (json.loads(Path(each, "summary.json").read_text()) for each in ("out", "again"))
    assert first["tasks"] == again["tasks"]


def test_show_lists_settings(stranger: Path, capsys: pytest.CaptureFixture[str]) -> None:
    write(stranger, robots=", robots=2")
    assert main(["show", "border_patrol"]) == 0
    shown = capsys.readouterr().out
    assert "robots by default: 2 of 5\n" in shown
    assert (
        "settings of the mission: --set NAME=...\nNAME      DEFAULT  TEXT\ndistance  0.6      from walls [m]\n" in shown
    )


def test_settings_are_parted_for_benchmarks(stranger: Path) -> None:
    """Where parameters for all robots have no robot's name before them."""
    write(stranger)
    making = making_of(compose(), "border_patrol", ("distance=1", "spin_rate=2"), 3, strict=False)
    assert (making.overrides, making.robots, making.rewrite is not None) == (("spin_rate=2",), 3, True)


@pytest.mark.parametrize(
    ("settings", "robots", "complaint"),
    [
        (("a-b",), None, "setting 'a-b': lower case letters, digits and '_' are accepted, a letter first"),
        (("a", "a"), None, "setting 'a': stands there twice"),
        ((), 0, "robots: must be 1 or more (found 0)"),
    ],
)
def test_a_maker_that_makes_no_sense_is_refused(settings: Tuple[str, ...], robots: int, complaint: str) -> None:
    def make(request: MissionRequest) -> MadeMission:
        return MadeMission(request.tasks_yaml, request.scenario_yaml)

    with pytest.raises(ValueError, match=re.escape(complaint)):
        MissionMaker(tuple(MissionSetting(name, "") for name in settings), make, robots)
