"""Avoid above wander: near a wall the higher layer drives, in the open the lower one; told in either file, it is so."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, NamedTuple

import pytest

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.compose import compose
from rqt_mrta_py.transport import read_bag
from tests.app.outputs import Mrta

SLOWLY, NEAR, RELIEF, RADIUS = 0.1, 0.8, 0.1, 0.2
TASK = "tasks:\n- id: roam\n  kind: {kind}\n  perpetual: true\n{more}"
TOLD = f"  layers: [avoid]\n  data: {{speed: 0.3, layers: {{avoid: {{speed: {SLOWLY}, distance: {NEAR}}}}}}}\n"
SCENARIO = """world: planar
duration: 14
arena: {min_x: -4.0, min_y: -4.0, max_x: 4.0, max_y: 4.0}
robots:
  - id: robot1
    model: diff_drive
    start: {x: -3.4, y: 0.0, yaw: 0.0}
    sensors:
      - {kind: localiser, topic: pose, rate: 10}
      - {kind: odometry, topic: odom, rate: 10}
      - {kind: range_finder, topic: scan, rate: 10, rays: 36, fov: 6.283185307179586, max_range: 4.0}
"""
APPLICATION = (
    '<rqt_mrta format="application"><application><name>Yard</name><architecture>mrta_alliance</architecture>'
    "<robots><robot_0><id>robot1</id></robot_0></robots></application><configs/></rqt_mrta>"
)


class Drive(NamedTuple):
    """What the robot was commanded, and how near the nearest thing was when it was [m/s], [m]."""

    speed: float
    nearest: float


def drive(mrta: Mrta, package: Path, out: str) -> List[Drive]:
    """Run the yard; give the commands from the robot's first on."""
    status, lines = mrta("run", "yard", "--pictures", "0", "--processes", "1", "--out", out)
    assert status == 0, lines
    codec = compose().codec()
    driven: List[Drive] = []
    nearest = float("inf")
    for each in read_bag(Path(out) / "mission.bag"):
        if each.connection.topic == "/robot1/scan":
            fields: Dict[str, Any] = codec.decode(each.connection, each.raw)
            nearest = min(fields["ranges"])
        elif each.connection.topic == "/robot1/cmd_vel":
            driven.append(Drive(codec.decode(each.connection, each.raw)["linear"]["x"], nearest))
    return driven


@pytest.fixture
def roaming(yard: Path) -> Path:
    (yard / "rqt_mrta.xml").write_text(APPLICATION)
    (yard / "scenario.yaml").write_text(SCENARIO)
    (yard / "tasks.yaml").write_text(TASK.format(kind="wander", more=TOLD))
    return yard


def test_avoid_suppresses_wander_while_something_is_near(mrta: Mrta, roaming: Path) -> None:
    driven = drive(mrta, roaming, "layered")
    near = [each.speed for each in driven if each.nearest < RADIUS + NEAR]
    far = [each.speed for each in driven if each.nearest > RADIUS + NEAR + RELIEF]
    assert near
    assert SLOWLY / 2 < max(near) <= SLOWLY + 1e-9
    assert max(far) > 2 * SLOWLY

    (roaming / "tasks.yaml").write_text(TASK.format(kind="wander", more="  data: {speed: 0.3}\n"))
    alone = drive(mrta, roaming, "alone")
    assert max(each.speed for each in alone if each.nearest < RADIUS + NEAR) > 2 * SLOWLY


def test_layers_in_the_teams_parameters_drive_as_those_in_tasks_yaml_do(mrta: Mrta, roaming: Path) -> None:
    (roaming / "tasks.yaml").write_text(TASK.format(kind="wander", more="  layers: [avoid]\n"))
    told = drive(mrta, roaming, "told")
    (roaming / "tasks.yaml").write_text(TASK.format(kind="roaming", more=""))
    (roaming / "config").mkdir()
    listed = roaming / "config" / "tasks_alliance_params.yaml"
    layers = "{size: 2, layer0: {plugin_name: alliance_test/wander}, layer1: {plugin_name: avoid}}"
    listed.write_text(f"tasks:\n  size: 1\n  task0: {{id: roam, name: Roam, layers: {layers}}}\n")
    assert drive(mrta, roaming, "listed") == told


def doctor(capsys: pytest.CaptureFixture[str]) -> List[str]:
    """Give what the doctor finds wrong in the yard's files of tasks."""
    capsys.readouterr()
    assert main(["doctor", "yard"]) == 1
    lines = [line.partition("packages/")[2] for line in capsys.readouterr().out.splitlines()]
    return [line for line in lines if line.startswith(("yard/tasks.yaml", "yard/config/tasks_alliance_params.yaml"))]


def test_layers_that_cannot_stand_are_told_with_their_line(
    mrta: Mrta, roaming: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    more = "  layers: [avoyd, report]\n  data:\n    layers:\n      reprot: {count: 2}\n"
    (roaming / "tasks.yaml").write_text(TASK.format(kind="wander", more=more))
    amiss = "no plugin provides a behaviour for its layer 'avoyd'; nearest is 'avoid'"
    assert mrta("run", "yard", "--pictures", "0") == (3, [f"mrta: robot1: task 'roam': {amiss}"])
    assert doctor(capsys) == [
        f"yard/tasks.yaml:5: tasks[0]/layers: {amiss}",
        "yard/tasks.yaml:8: tasks[0]/data/layers/reprot: is no layer of the task; nearest is 'report'",
    ]


@pytest.mark.parametrize(
    ("listed", "told"),
    [
        (
            "{id: roam, layers: {layer0: {plugin_name: avoyd}}}",
            "layers/layer0/plugin_name: no plugin provides a behaviour for the layer 'avoyd'; nearest is 'avoid'",
        ),
        (
            "{id: roam, layers: {layer0: {plugin_name: avoid}, layer1: {plugin_name: wander}}}",
            "layers/layer1/plugin_name: names 'wander' twice, or above the task's own kind; give each layer once",
        ),
        (
            "{id: raom, layers: {layer0: {plugin_name: avoid}}}",
            "id: 'raom' is no task of the mission; nearest is 'roam'",
        ),
    ],
)
def test_layers_in_the_teams_parameters_that_cannot_stand_are_told_with_their_line(
    mrta: Mrta, roaming: Path, capsys: pytest.CaptureFixture[str], listed: str, told: str
) -> None:
    (roaming / "tasks.yaml").write_text(TASK.format(kind="wander", more=""))
    (roaming / "config").mkdir()
    file = roaming / "config" / "tasks_alliance_params.yaml"
    file.write_text(f"tasks:\n  size: 1\n  task0: {listed}\n")
    problem = f"3: tasks_alliance_params/tasks/task0/{told}"
    assert mrta("run", "yard", "--pictures", "0") == (3, [f"mrta: {file}:{problem}"])
    assert f"yard/config/tasks_alliance_params.yaml:{problem}" in doctor(capsys)
