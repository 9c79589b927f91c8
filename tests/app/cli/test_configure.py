from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Dict, List

import pytest
import yaml

from rqt_mrta_py.config.discovery.search import discover
from rqt_mrta_py.config.mission import load_mission
from rqt_mrta_py.config.xml.writing import write_application
from rqt_mrta_py.model import ApplicationRobot, ApplicationSpec
from tests.app.cli.conftest import Command

MANIFEST = """<?xml version="1.0"?>
<package format="3">
  <name>harbour</name>
  <version>1.0.0</version>
  <description>Three robots and four tasks.</description>
  <maintainer email="a@b.c">Somebody</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend>
  <exec_depend>basic_behaviours</exec_depend>
  <exec_depend>mrta_alliance</exec_depend>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export>
    <rqt_mrta_py application="${prefix}/rqt_mrta.xml" tasks="${prefix}/tasks.yaml" scenario="${prefix}/scenario.yaml"/>
  </export>
</package>
"""
CMAKE = """cmake_minimum_required(VERSION 3.5)
project(harbour)
find_package(catkin REQUIRED)
catkin_package()
install(FILES rqt_mrta.xml scenario.yaml tasks.yaml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
install(DIRECTORY config launch DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
"""
SCENARIO = """world: planar
duration: 20
arena: {min_x: -4, min_y: -4, max_x: 4, max_y: 4}
robot_defaults:
  sensors:
    - {kind: localiser, topic: pose, rate: 10}
    - {kind: odometry, topic: odom, rate: 10}
    - {kind: range_finder, topic: scan, rate: 10, rays: 18, fov: 6.283185307179586, max_range: 4.0}
robots:
  - {id: robot1, start: {x: -3, y: 0}}
  - {id: robot2, start: {x: 0, y: 0}}
  - {id: robot3, start: {x: 3, y: 0}}
"""
TASKS = ("north", "east", "south", "west")
ROBOTS = ("robot1", "robot2", "robot3")
FAST_RATE = "robot2/behaviour_sets/behaviour_set0/motivational_behaviour/impatience/fast_rate"


@pytest.fixture
def harbour(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Write an ALLIANCE application of three robots and four tasks, with defaults for every parameter."""
    folder = tmp_path / "packages" / "harbour"
    folder.mkdir(parents=True)
    spec = ApplicationSpec("harbour", "Harbour", "mrta_alliance", tuple(ApplicationRobot(r, TASKS) for r in ROBOTS))
    places = zip(TASKS, ((0, 3), (3, 2), (0, -3), (-3, 2)))
    tasks = [f"  - {{id: {task}, kind: go_to_place, place: {{x: {x}, y: {y}}}}}\n" for task, (x, y) in places]
    texts = {
        "package.xml": MANIFEST,
        "CMakeLists.txt": CMAKE,
        "rqt_mrta.xml": write_application(spec),
        "tasks.yaml": "".join(["tasks:\n", *tasks]),
        "scenario.yaml": SCENARIO,
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(folder.parent))
    return folder


def contents(folder: Path) -> Dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def names(lines: List[str]) -> List[str]:
    return [line.rsplit("/", 1)[-1] for line in lines]


def test_what_was_written_is_said_and_then_there_is_nothing_to_change(command: Command, harbour: Path) -> None:
    told = command("configure", "harbour")
    assert (told.status, told.err) == (0, "")
    files = [*(f"robot{n}_alliance_params.yaml" for n in (1, 2, 3)), "tasks_alliance_params.yaml"]
    launches = ["harbour.launch", *(f"robot{n}_alliance.launch" for n in (1, 2, 3))]
    assert names(told.out.splitlines()) == [*files, *launches]
    assert all(line.startswith("written: ") for line in told.out.splitlines())
    assert command("configure", str(harbour)).out == "nothing to change\n"
    assert command("configure", str(harbour / "rqt_mrta.xml"), "--check").status == 0


def test_check_judges_and_a_dry_run_shows_what_would_change(command: Command, harbour: Path) -> None:
    command("configure", "harbour")
    before = contents(harbour)
    told = command("configure", "harbour", "--set", f"{FAST_RATE}=0.1", "--check")
    assert told.status == 1
    assert names(told.out.splitlines()) == ["robot2_alliance_params.yaml", "rqt_mrta.xml"]
    assert all(line.startswith("would be changed: ") for line in told.out.splitlines())
    shown = command("configure", "harbour", "--set", f"{FAST_RATE}=0.1", "--dry-run")
    assert shown.status == 0
    lines = shown.out.splitlines()
    assert "-        fast_rate: 1.0" in lines
    assert "+        fast_rate: 0.1" in lines
    assert contents(harbour) == before


@pytest.mark.skipif(shutil.which("patch") is None, reason="patch is not installed")
def test_what_a_dry_run_shows_can_be_given_to_patch(command: Command, harbour: Path) -> None:
    edits = ["--set", f"{FAST_RATE}=0.1", "--rename-task", "north=up", "--add-robot", "robot4", "--rename-robot"]
    edits.append("robot1=first")
    command("configure", "harbour")
    shown = command("configure", "harbour", *edits, "--dry-run").out
    twin = harbour.parent.parent / "twin"
    shutil.copytree(str(harbour), str(twin))
    relative = shown.replace("../packages/harbour/", "")
    subprocess.run(["patch", "-p0", "-d", str(twin), "-s"], input=relative, text=True, check=True)
    command("configure", "harbour", *edits)
    texts = {path.relative_to(harbour): text for path, text in contents(harbour).items()}
    patched = {path.relative_to(twin): text for path, text in contents(twin).items() if text}
    assert patched == texts


def test_a_value_reaches_the_runs_of_its_robot(command: Command, harbour: Path) -> None:
    command("configure", "harbour")
    assert command("configure", "harbour", "--set", f"{FAST_RATE}=0.1").status == 0
    found = load_mission(discover(os.environ), "harbour").parameters
    rates = [
        found[robot]["behaviour_sets"]["behaviour_set0"]["motivational_behaviour"]["impatience"]["fast_rate"]
        for robot in ROBOTS
    ]
    assert rates == [1.0, 0.1, 1.0]


def test_edits_of_all_kinds_are_made_in_their_order(command: Command, harbour: Path) -> None:
    """robot4 joins before the task does, so it gets it; the place belongs to the task before it."""
    told = command(
        *(
            "configure",
            "harbour",
            "--add-robot",
            "robot4:north,east",
            "--add-task",
            "dock:robot4",
            "--place",
            "1,-2,0.5",
        ),
        *("--remove-task", "south", "--rename-robot", "robot1=first", "--set", "first/spin_rate=4", "--unset"),
        "first/spin_rate",
    )
    assert (told.status, told.err) == (0, "")
    mission = load_mission(discover(os.environ), "harbour")
    assert {robot.id: robot.tasks for robot in mission.application.robots} == {
        "first": ("north", "east", "west"),
        "robot2": ("north", "east", "west"),
        "robot3": ("north", "east", "west"),
        "robot4": ("north", "east", "dock"),
    }
    dock = mission.tasks[-1]
    assert dock.place is not None
    assert (dock.id, dock.kind, dock.place.x, dock.place.y, dock.place.yaw) == ("dock", "go_to_place", 1.0, -2.0, 0.5)


def test_what_plugins_object_to_is_not_written(command: Command, harbour: Path) -> None:
    before = contents(harbour)
    told = command(
        "configure", "harbour", "--set", "robot1/spin_rate=-1", "--set", "robot9/x=1", "--set", "robot3/spin_rate=x"
    )
    assert told.status == 3
    assert told.err.splitlines() == [
        "mrta: --set: robot3/spin_rate: must be a finite number (got 'x')",
        "mrta: --set: robot9/x: 'robot9' is no robot and no config; nearest is 'robot3'",
    ]
    told = command("configure", "harbour", "--set", "robot1/spin_rate=-1")
    assert (told.status, told.err) == (3, "mrta: --set: robot1/spin_rate: must be above 0 Hz (got -1)\n")
    assert contents(harbour) == before


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--set", "robot1/spin_rate"], "argument --set: 'robot1/spin_rate': PATH=VALUE is expected"),
        (["--kind", "wander"], "argument --kind: must follow the --add-task that it belongs to"),
        (["--add-task", "x", "--place", "1"], "argument --place: '1': X,Y or X,Y,YAW is expected, such as 1.5,-2"),
        (["--add-task", "x:,"], "argument --add-task: 'x:,': names joined by commas are expected behind the colon"),
        (["--rename-robot", "robot1"], "argument --rename-robot: 'robot1': OLD=NEW is expected"),
    ],
)
def test_wrong_usage_is_told(command: Command, harbour: Path, arguments: List[str], message: str) -> None:
    told = command("configure", "harbour", *arguments)
    assert told.status == 2
    assert message in told.err


def test_json_tells_every_file_and_what_becomes_of_it(command: Command, harbour: Path) -> None:
    (harbour / "launch").mkdir()
    (harbour / "launch" / "harbour.launch").write_text("<launch/>\n")
    found = json.loads(command("configure", "harbour", "--json", "--check").out)
    assert (found["schema"], found["application"], found["written"]) == ("rqt_mrta_py/configure/1", "harbour", False)
    assert found["folder"] == str(harbour)
    actions = {Path(each["path"]).name: each["action"] for each in found["files"]}
    assert actions["robot1_alliance_params.yaml"] == "written"
    assert actions["harbour.launch"] == "left"
    command("configure", "harbour")
    again = json.loads(command("configure", "harbour", "--json").out)
    assert {each["action"] for each in again["files"]} == {"unchanged", "left"}


def test_a_folder_that_cannot_be_written_stays_as_it_is(command: Command, harbour: Path) -> None:
    (harbour / "launch").write_text("in the way\n")
    before = contents(harbour)
    told = command("configure", "harbour")
    assert told.status == 3
    assert "cannot be written: " in told.err
    assert told.err.endswith("; nothing was changed\n")
    assert contents(harbour) == before
    assert not (harbour / "config").exists()


def test_a_generated_application_passes_doctor_and_runs(command: Command, harbour: Path) -> None:
    command("configure", "harbour")
    command("configure", "harbour", "--set", f"{FAST_RATE}=0.1")
    told = command("doctor", str(harbour))
    assert (told.status, told.out) == (0, "")
    told = command("run", "harbour", "--pictures", "0", "--out", "run", "--json", "-q")
    assert told.status == 0
    summary = json.loads(told.out)["summary"]
    assert sorted(robot["id"] for robot in summary["robots"]) == list(ROBOTS)
    assert sorted(task["id"] for task in summary["tasks"]) == sorted(TASKS)
    assert summary["allocations"]


@pytest.mark.ros
def test_ros_tools_take_the_files_of_a_generated_application(command: Command, harbour: Path, root: Path) -> None:
    """Parameters stand where topics of the robots stand, in /<robot>/alliance."""
    if shutil.which("roslaunch") is None:
        pytest.skip("ROS 1 is not installed: no roslaunch on PATH")
    command("configure", "harbour")
    home = str(harbour.parent.parent / "home")
    path = f"{harbour.parent}:{root / 'plugins'}:{root}"
    environment = {**os.environ, "ROS_PACKAGE_PATH": path, "ROS_HOME": home, "ROS_LOG_DIR": home}
    for option in ("--nodes", "--dump-params"):
        finished = subprocess.run(
            ["roslaunch", option, "harbour", "harbour.launch"],
            capture_output=True,
            text=True,
            env=environment,
            timeout=60,
            check=False,
        )
        assert finished.returncode == 0, finished.stderr
    dumped = yaml.safe_load(finished.stdout)
    nested = load_mission(discover(environment), "harbour").parameters
    flat: Dict[str, object] = {}
    for robot in ROBOTS:
        pending = [(f"/{robot}/alliance", nested[robot])]
        while pending:
            prefix, value = pending.pop()
            if isinstance(value, dict):
                pending.extend((f"{prefix}/{name}", inner) for name, inner in value.items())
            else:
                flat[prefix] = value
    assert {name: value for name, value in dumped.items() if name.startswith("/robot")} == flat
