"""mrta new, from flags and from files of answers."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Dict, List

import pytest
import yaml

from rqt_mrta_py.app.doctor import examine, find_subjects
from tests.app.cli.conftest import Command

ABOUT = ("--description", "Looks after <a> yard & more.", "--maintainer", "Ann Example", "--email", "ann@example.org")
TYPES = ("--type", "ST-SR-IA")
MANDATORY = """<?xml version="1.0"?>
<rqt_mrta format="architecture">
  <architecture> <name>Needy</name>
    <robots> <type>ST</type> <config_id>needs</config_id> </robots>
    <tasks> <type>SR</type> </tasks> <allocations> <type>IA</type> </allocations>
  </architecture>
  <configs>
    <config_0> <id>needs</id>
      <param_0> <name>speed</name> <type>double</type> <tool_tip>Enter the speed [m/s].</tool_tip> </param_0>
    </config_0>
  </configs>
</rqt_mrta>
"""
MANIFEST = """<package format="2">
  <name>needy</name> <version>1.0.0</version> <description>d</description>
  <maintainer email="a@b.c">m</maintainer> <license>BSD</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export> <rqt_mrta_py architecture="${prefix}/rqt_mrta.xml"/> </export>
</package>
"""


@pytest.fixture
def here(tmp_path: Path, command: Command, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give the folder in which commands are run, on ROS's path."""
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "here"))
    return tmp_path / "here"


@pytest.fixture
def needy(here: Path) -> Path:
    """Write an architecture with a mandatory parameter."""
    folder = here / "needy"
    folder.mkdir()
    (folder / "package.xml").write_text(MANIFEST)
    (folder / "rqt_mrta.xml").write_text(MANDATORY)
    return folder


def finished(folder: Path, *arguments: str) -> str:
    """Run a program with this Python in a process of its own: generated modules stay there."""
    environment = {**os.environ, "ROS_PACKAGE_PATH": str(folder)}
    done = subprocess.run(
        [sys.executable, *arguments], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def tree(folder: Path) -> Dict[str, str]:
    return {path.relative_to(folder).as_posix(): path.read_text() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("architecture", ["mrta_alliance", "nearest_robot"])
def test_new_application_is_sound_and_runs_at_once(here: Path, command: Command, architecture: str) -> None:
    told = command(
        "new", "application", "yard", "--architecture", architecture, "--robots", "3", "--tasks", "4", *ABOUT
    )
    assert (told.status, told.err) == (0, "")
    found = find_subjects([str(here / "yard")], os.environ)
    assert [str(problem) for problem in (*found.problems, *examine(found.subjects))] == []
    told = command("run", "yard", "--duration", "20", "--pictures", "0", "-q", "--out", "out")
    assert told.status == 0, told.err
    summary = json.loads((here / "out" / "summary.json").read_text())
    assert [robot["id"] for robot in summary["robots"]] == ["robot1", "robot2", "robot3"]
    assert len(summary["allocations"]) >= 3


def test_new_architecture_passes_its_tests_and_shares_out_tasks(here: Path, command: Command) -> None:
    assert command("new", "architecture", "fetch_first", *TYPES, *ABOUT).status == 0
    assert " passed" in finished(here / "fetch_first", "-m", "pytest", "-q", "-p", "no:cacheprovider")
    plan = ["--architecture", "fetch_first", "--robots", "3", "--tasks", "4", *ABOUT]
    finished(here, "-m", "rqt_mrta_py", "new", "application", "yard", *plan)
    assert finished(here, "-m", "rqt_mrta_py", "doctor", "fetch_first", "yard") == ""
    finished(here, "-m", "rqt_mrta_py", "run", "yard", "--duration", "30", "--pictures", "0", "-q", "--out", "out")
    summary = json.loads((here / "out" / "summary.json").read_text())
    assert [task["state"] for task in summary["tasks"]] == ["done"] * 4
    assert {allocation["robot"] for allocation in summary["allocations"]} == {"robot1", "robot2", "robot3"}


def test_skeleton_is_clean_by_the_rules_of_this_project(here: Path, command: Command, root: Path) -> None:
    assert command("new", "architecture", "clean_one", *TYPES, *ABOUT).status == 0
    rules = ["--config", str(root / "pyproject.toml")]
    finished(here / "clean_one", "-m", "ruff", "check", "--no-cache", *rules, ".")
    finished(here / "clean_one", "-m", "ruff", "format", "--no-cache", "--check", *rules, ".")
    finished(here / "clean_one", "-m", "mypy", "--strict", "--cache-dir", os.devnull, "src")


def test_dry_run_prints_the_wizards_summary_and_writes_nothing(here: Path, command: Command) -> None:
    plan = ["new", "application", "yard", "--architecture", "mrta_alliance", "--robots", "1", "--tasks", "1", *ABOUT]
    told = command(*plan, "--workspace", "ws", "--dry-run")
    assert told.status == 0
    assert told.out.splitlines() == [
        f"A ROS workspace will be created in: {here}/ws",
        f"A ROS package will be created in: {here}/ws/src/yard",
        "The following files and folder will be generated inside this ROS package:",
        "  CMakeLists.txt",
        "  config/",
        "  config/robot1_alliance_params.yaml",
        "  config/tasks_alliance_params.yaml",
        "  launch/",
        "  launch/robot1_alliance.launch",
        "  launch/yard.launch",
        "  package.xml",
        "  rqt_mrta.xml",
        "  scenario.yaml",
        "  tasks.yaml",
    ]
    assert told.err.splitlines()[0] == f"mrta: {here}/ws: The given directory is not a ROS workspace."
    assert list(here.iterdir()) == []


def test_what_a_dry_run_lists_is_what_is_written(here: Path, command: Command) -> None:
    plan = ["new", "application", "yard", "--architecture", "mrta_alliance", "--robots", "2", "--tasks", "2", *ABOUT]
    before = json.loads(command(*plan, "--json", "--dry-run").out)
    after = json.loads(command(*plan, "--json").out)
    assert (before.pop("written"), after.pop("written")) == (False, True)
    assert before == after
    assert [name for name in after["files"] if not name.endswith("/")] == sorted(tree(here / "yard"))


def test_same_answers_write_the_same_bytes(here: Path, command: Command) -> None:
    plan = ["new", "application", "yard", "--architecture", "mrta_alliance", "--robots", "2", "--tasks", "2", *ABOUT]
    assert command(*plan).status == 0
    first = tree(here / "yard")
    (here / "yard").rename(here / ".old")
    assert command(*plan).status == 0
    assert tree(here / "yard") == first


def test_file_of_answers_gives_values_and_places_and_flags_win(here: Path, command: Command) -> None:
    answers = {
        "package": "yard",
        "description": "From a file.",
        "maintainer": "Ann",
        "email": "a@b.c",
        "architecture": "mrta_alliance",
        "robots": [{"id": "scout", "tasks": ["gate"]}, {}],
        "tasks": [
            {"id": "gate", "kind": "report", "place": {"x": 7, "y": -2.5}, "data": {"count": 2}},
            {"id": "yes", "kind": "wander"},
        ],
        "parameters": {"scout": {"spin_rate": 10, "name": "on"}, "alliance_params": {"broadcast_rate": 4.0}},
    }
    (here / "answers.yaml").write_text(yaml.safe_dump(answers))
    told = command(
        "new", "application", "--answers", "answers.yaml", "--version", "2.3.4", "--set", "scout/spin_rate=8"
    )
    assert (told.status, told.err) == (0, "")
    manifest = (here / "yard" / "package.xml").read_text()
    assert "<version>2.3.4</version>" in manifest
    assert "<description>From a file.</description>" in manifest
    scout = yaml.safe_load((here / "yard/config/scout_alliance_params.yaml").read_text())
    assert (scout["spin_rate"], scout["broadcast_rate"], scout["name"]) == (8.0, 4.0, "on")
    assert scout["behaviour_sets"]["size"] == 1
    tasks = yaml.safe_load((here / "yard/tasks.yaml").read_text())["tasks"]
    assert tasks[0] == {"id": "gate", "kind": "report", "place": {"x": 7.0, "y": -2.5}, "data": {"count": 2}}
    assert tasks[1] == {"id": "yes", "kind": "wander", "perpetual": True}


def test_missing_flags_are_named_at_once_away_from_a_terminal(here: Path, command: Command) -> None:
    told = command("new", "application", "yard")
    assert told.status == 2
    assert told.err.splitlines() == [
        "mrta: --architecture: The architecture package must be given.",
        "mrta: --description: The package description must be given.",
        "mrta: --email: The e-mail of the package maintainer must be given.",
        "mrta: --maintainer: The package maintainer must be given.",
        "mrta: --robot: Enter the system robots.",
        "mrta: --task: Enter the robot tasks.",
    ]
    assert list(here.iterdir()) == []


@pytest.mark.parametrize(
    ("flags", "message"),
    [
        (["--set", "robot1/rtae=3"], "--set: robot1/rtae: is not known; nearest is 'rate'"),
        (["--set", "robot1/rate=fast"], "--set: robot1/rate: must be a finite number (got 'fast')"),
        (["--set", "robot1/rate=0.5"], "--set: robot1/rate: must be from 2 to 100 Hz (got 0.5)"),
        (["--set", "rate"], "--set: 'rate': PATH=VALUE is expected"),
        (["--world", "plaanar"], "--world: is not known (got 'plaanar'); nearest is 'planar'"),
        (["--email", "nobody"], "--email: The e-mail of the package maintainer must be given."),
        (["--robots", "10001"], "--robots: must be up to 10000 (got '10001')"),
        (["--robots", "9" * 5000], "--robots: must be up to 10000 (got '" + "9" * 59 + "...)"),
        (["--robots", "0"], "--robots: Enter the system robots."),
        (["--tasks", ""], "--tasks: Enter the robot tasks."),
        (
            ["--architecture", "./nowhere"],
            "./nowhere: there is no such file or folder; give a registered name or an rqt_mrta.xml",
        ),
        (["--version", "1"], "--version: must be three numbers joined by dots (got '1')"),
    ],
)
def test_bad_flag_is_refused_and_nothing_written(here: Path, command: Command, flags: List[str], message: str) -> None:
    plan = ["--architecture", "nearest_robot", "--robots", "1", "--tasks", "1", *ABOUT, *flags]
    told = command("new", "application", "yard", *plan)
    assert (told.status, told.err) == (3 if "there is no such" in message else 2, f"mrta: {message}\n")
    assert list(here.iterdir()) == []


def test_a_package_with_too_long_a_name_is_refused(here: Path, command: Command) -> None:
    name = "a" * 300
    plan = ["--architecture", "nearest_robot", "--robots", "1", "--tasks", "1", *ABOUT]
    told = command("new", "application", name, *plan)
    assert (told.status, told.err) == (
        3,
        f"mrta: {here / name}: cannot be written: File name too long; nothing was changed\n",
    )
    assert list(here.iterdir()) == []


def test_a_workspace_in_the_home_of_nobody_is_a_folder_of_that_name(here: Path, command: Command) -> None:
    plan = ["--architecture", "nearest_robot", "--robots", "1", "--tasks", "1", *ABOUT]
    told = command("new", "application", "yard", *plan, "--workspace", "~no body", "--dry-run")
    assert told.status == 0
    assert f"A ROS package will be created in: {here / '~no body' / 'src' / 'yard'}" in told.out.splitlines()


@pytest.mark.parametrize(
    ("types", "lines"),
    [
        ("ST-SR", ["mrta: --type: 'ST-SR': three types joined by hyphens are expected"]),
        ("ST--XY", ["The tasks type must be selected: SR or MR.", "is not known (got 'XY'); accepted: IA, TA"]),
    ],
)
def test_bad_types_are_refused(here: Path, command: Command, types: str, lines: List[str]) -> None:
    told = command("new", "architecture", "yard", "--type", types, *ABOUT)
    assert told.status == 2
    assert [line.endswith(end) for line, end in zip(told.err.splitlines(), lines)] == [True] * len(lines)
    assert list(here.iterdir()) == []


def test_bad_places_of_tasks_are_refused(here: Path, command: Command) -> None:
    plan = ["--architecture", "nearest_robot", "--robots", "1", "--task", "gate:report:1;2", *ABOUT]
    told = command("new", "application", "yard", *plan)
    expected = "mrta: --task: 'gate:report:1;2': X,Y or X,Y,YAW is expected behind the kind, such as 1.5,-2\n"
    assert (told.status, told.err) == (2, expected)


@pytest.mark.parametrize("name", ["border_patrol", "rqt_mrta", "mine"])
def test_existing_package_is_refused(here: Path, command: Command, name: str) -> None:
    (here / "mine").mkdir()
    told = command("new", "architecture", name, *TYPES, *ABOUT)
    assert (told.status, told.err) == (2, f"mrta: NAME: The given package [{name}] already exists.\n")
    assert list((here / "mine").iterdir()) == []


def test_mandatory_parameter_is_refused_by_name(needy: Path, command: Command) -> None:
    plan = ["new", "application", "yard", "--architecture", "needy", "--robots", "2", "--tasks", "1", *ABOUT]
    told = command(*plan, "--set", "robot1/speed=0.3")
    message = "--set: robot2/speed: is mandatory and has no value; give a finite number"
    assert (told.status, told.err) == (2, f"mrta: {message}\n")
    assert not (needy.parent / "yard").exists()
    assert command(*plan, "--set", "needs/speed=0.3").status == 0
    assert yaml.safe_load((needy.parent / "yard/config/robot2_needs.yaml").read_text()) == {"speed": 0.3}


def test_unknown_run_dependencies_are_left_out(here: Path, command: Command) -> None:
    depends = ["--run-depend", "alliance_msgs", "--run-depend", "no_such_package"]
    told = command("new", "architecture", "watcher", *TYPES, *ABOUT, *depends)
    message = "Some run dependency(ies) is(are) not ROS package(s): no_such_package; left out"
    assert (told.status, told.err) == (0, f"mrta: {message}\n")
    manifest = (here / "watcher" / "package.xml").read_text()
    assert "<exec_depend>alliance_msgs</exec_depend>" in manifest
    assert "no_such_package" not in manifest


def test_architecture_without_a_plugin_is_a_description_only(here: Path, command: Command) -> None:
    topic = "meaning: busy_robots, name: /busy, type: alliance_msgs/InterRobotCommunication, field: header/frame_id"
    parameter = 'name: speed, type: double, tool_tip: "Enter the speed [m/s]."'
    plan = ["--type", "MT-MR-TA", "--no-plugin", "--topic", topic, "--parameter", parameter, *ABOUT]
    told = command("new", "architecture", "elsewhere", *plan)
    assert (told.status, told.err) == (0, "")
    assert sorted(tree(here / "elsewhere")) == ["CMakeLists.txt", "package.xml", "rqt_mrta.xml"]
    shown = json.loads(command("list", "architectures", "--json").out)
    assert [each["taxonomy"] for each in shown["architectures"] if each["name"] == "elsewhere"] == ["MT-MR-TA"]
    found = find_subjects([str(here / "elsewhere")], os.environ)
    assert [str(problem) for problem in examine(found.subjects)] == []


def test_workspace_is_made_and_shell_files_are_left_alone(
    here: Path, command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    home = tmp_path / "home"
    home.mkdir()
    (home / ".bashrc").write_text("# mine\n")
    monkeypatch.setenv("HOME", str(home))
    toplevel = tmp_path / "ros" / "share" / "catkin" / "cmake" / "toplevel.cmake"
    toplevel.parent.mkdir(parents=True)
    toplevel.write_text("")
    monkeypatch.setenv("CMAKE_PREFIX_PATH", str(tmp_path / "ros"))
    told = command("new", "architecture", "placed", *TYPES, *ABOUT, "--workspace", "a ws")
    assert told.out.splitlines()[-2:] == [f"catkin_make -C '{here}/a ws'", f"source '{here}/a ws/devel/setup.bash'"]
    assert (here / "a ws" / "src" / "CMakeLists.txt").resolve() == toplevel
    assert (here / "a ws" / "src" / "placed" / "package.xml").is_file()
    assert tree(home) == {".bashrc": "# mine\n"}


def test_without_catkin_the_workspace_is_a_folder_and_that_is_said(
    here: Path, command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("rqt_mrta_py.config.packages.workspace.find_toplevel", lambda _environ: None)
    told = command("new", "architecture", "placed", *TYPES, *ABOUT, "--workspace", "ws")
    assert "mrta: catkin is not installed: the workspace gets its folder src and no more" in told.err.splitlines()
    assert [path.name for path in (here / "ws" / "src").iterdir()] == ["placed"]


def test_line_for_the_shell_names_a_folder_that_ros_does_not_search(
    here: Path, command: Command, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_PACKAGE_PATH", "")
    told = command("new", "architecture", "unseen", *TYPES, *ABOUT)
    assert told.out.splitlines()[-1] == f'export ROS_PACKAGE_PATH={here}"${{ROS_PACKAGE_PATH:+:$ROS_PACKAGE_PATH}}"'


def test_help_tells_the_verb(command: Command) -> None:
    assert "Write a package" in command("--help").out
