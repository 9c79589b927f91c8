"""The devel and install spaces of a workspace that holds this repository, and packages that mrta made."""

from __future__ import annotations

import json
import os
import re
import socket
from pathlib import Path
from typing import Dict, Set, Tuple
from xml.etree import ElementTree

import pytest

from tests.conftest import ROOT
from tests.packaging.spaces import MADE, Space, Workspace

pytestmark = pytest.mark.ros

PLUGINS = {
    "basic_behaviours",
    "block_construction",
    "csv_tables",
    "mcap_recordings",
    "mission_journal",
    "mrta_alliance",
    "mrta_baselines",
    "mrta_demir_cf",
    "mrta_l_alliance",
    "mtrp_allocators",
    "nearest_robot",
    "parquet_tables",
    "team_measures",
}
ARCHITECTURES = {
    "mrta_alliance",
    "mrta_baselines",
    "mrta_demir_cf",
    "mrta_l_alliance",
    "nearest_robot",
    "talmech_auction",
}
PROGRAMS = {"mrta", "recorder", "review", "robot_agent", "simulation", "supervisor"}
COMPLETE = """\
source /usr/share/bash-completion/completions/rosbash
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMP_LINE="$*"; COMP_POINT=${#COMP_LINE}
$(complete -p "$1" | sed -E 's/.*-F "?([A-Za-z_]+)"?.*/\\1/') "$1" "${@: -1}" ""
printf '%s\\n' "${COMPREPLY[@]}"
"""
"""Presses the tabulator behind its arguments."""
SAME = ("mission.bag", "summary.json", "events.jsonl", "incidents.jsonl")


@pytest.fixture(scope="module", params=["devel", "install"])
def space(workspace: Workspace, request: pytest.FixtureRequest) -> Space:
    return Space(workspace.folder / request.param)


def plugin_folders(space: Space) -> Dict[str, Path]:
    """Say where each package under plugins is to be found."""
    packages = space.folder.parent / "src/rqt_mrta_py/plugins"
    folders = {manifest.parent.name: manifest.parent for manifest in packages.glob("*/*/package.xml")}
    if space.folder.name == "devel":
        return folders
    share = space.folder / "share"
    stubs = share / "rqt_mrta_py" / "stubs"
    return {name: (stubs if folder.parent.name == "stubs" else share) / name for name, folder in folders.items()}


def test_cmake_has_nothing_to_warn_of(workspace: Workspace) -> None:
    assert re.findall(r"CMake .*Warning.*\n.*", workspace.log) == []
    assert "left out" not in workspace.log


def test_rospack_finds_every_package(space: Space) -> None:
    listed = dict(line.split(" ", 1) for line in space.run("rospack", "list").splitlines())
    expected = plugin_folders(space)
    assert {name: Path(listed[name]) for name in expected} == expected


@pytest.mark.parametrize(
    ("attribute", "names"),
    [
        ("architecture", ARCHITECTURES),
        ("application", {"block_construction", "border_patrol", "cleanup", "target_visiting"}),
        ("plugin", PLUGINS),
    ],
)
def test_rospack_lists_what_is_registered(space: Space, attribute: str, names: set[str]) -> None:
    listed = space.run("rospack", "plugins", f"--attrib={attribute}", "rqt_mrta_py").splitlines()
    exported = dict(line.split(" ", 1) for line in listed)
    assert set(exported) - MADE == names
    assert attribute == "plugin" or all(Path(file).is_file() for file in exported.values())


def test_message_classes_of_every_package_are_imported(space: Space, tree: Path) -> None:
    definitions = [*tree.glob("msg/*.msg"), *tree.glob("plugins/messages/*/msg/*.msg")]
    modules = {path: ElementTree.parse(path.parents[1] / "package.xml").findtext("name") for path in definitions}
    classes = " ".join(f"{package}/{path.stem}" for path, package in sorted(modules.items()))
    script = (
        "import sys, roslib.message\n"
        "for name in sys.argv[1].split():\n"
        "    print(sys.modules[roslib.message.get_message_class(name).__module__].__file__)\n"
    )
    files = [Path(line) for line in space.run("/usr/bin/python3", "-c", script, classes).splitlines()]
    assert len(files) == len(definitions) > 10
    assert [file for file in files if space.folder / "lib" not in file.parents] == []


def test_rosmsg_shows_a_plugins_message(space: Space) -> None:
    assert "float64[] costs" in space.run("rosmsg", "show", "nearest_robot_msgs/Bid")


def test_service_classes_are_imported_and_shown(space: Space, tree: Path) -> None:
    names = sorted(path.stem for path in tree.glob("srv/*.srv"))
    assert len(names) >= 6
    script = "import sys, rqt_mrta_py.srv as srv; print(*[hasattr(srv, name) for name in sys.argv[1:]])"
    assert set(space.run("/usr/bin/python3", "-c", script, *names).split()) == {"True"}
    assert "rqt_mrta_py/TeamState state" in space.run("rossrv", "show", "rqt_mrta_py/GetState")
    assert space.run("rossrv", "package", "rqt_mrta_py").split() == [f"rqt_mrta_py/{name}" for name in names]


def test_rosrun_finds_every_program(space: Space) -> None:
    # Of an architecture that is nothing but a description there is no agent.
    agents = sorted(name for name in ARCHITECTURES if (ROOT / "plugins/architectures" / name / "src").is_dir())
    assert len(agents) > 1
    wanted = [*(("rqt_mrta_py", name) for name in sorted(PROGRAMS)), *((name, "agent") for name in agents)]
    script = 'while [ $# -gt 0 ]; do rosrun --prefix echo "$1" "$2"; shift 2; done'
    arguments = [word for pair in wanted for word in pair]
    found = [Path(line.split()[-1]) for line in space.run("/bin/sh", "-c", script, "sh", *arguments).splitlines()]
    assert [path.name for path in found] == [name for _, name in wanted]
    assert [path for path in found if not os.access(path, os.X_OK)] == []


def test_a_node_of_the_space_runs(space: Space) -> None:
    done = space.finished("rosrun", "rqt_mrta_py", "review", "_bag:=nowhere.bag")
    assert done.returncode == 3, done.stderr
    assert "nowhere.bag: no such file" in done.stderr


@pytest.mark.parametrize(
    ("words", "among"),
    [
        (("roslaunch", "rqt_mrta_p"), {"rqt_mrta_py"}),
        (("roslaunch", "border_p"), {"border_patrol"}),
        (("roslaunch", "rqt_mrta_py", "superv"), {"supervisor.launch"}),
        (("roslaunch", "border_patrol", ""), {"team.launch"}),
        (("roslaunch", "rqt_mrta_py", "supervisor.launch", ""), {"architecture", "record", "topics"}),
        (("rosrun", "rqt_mrta_py", "superv"), {"supervisor"}),
        (("rosrun", "mrta_alliance", "a"), {"agent"}),
        (("rosmsg", "show", "demir_cf_m"), {"demir_cf_msgs/Bid"}),
        (("rossrv", "show", "rqt_mrta_py/"), {"rqt_mrta_py/GetState"}),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_the_tabulator_completes_what_is_ours(space: Space, words: Tuple[str, ...], among: Set[str]) -> None:
    if not Path("/usr/share/bash-completion/completions/rosbash").exists():
        pytest.skip("rosbash has no completions here")
    assert among <= set(space.run("bash", "-c", COMPLETE, "bash", *words).split())


def test_configurations_are_in_the_space(space: Space) -> None:
    package = Path(space.run("rospack", "find", "rqt_mrta_py").strip())
    assert (package / "config" / "rviz" / "team.rviz").is_file()
    assert (package / "config" / "diagnostic_aggregator.yaml").is_file()


def test_roslaunch_runs_a_team_of_nodes(space: Space, tmp_path: Path) -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    options = ["robots:=1", "duration:=2", "factor:=0", "pictures:=0", f"out:={tmp_path / 'run'}"]
    done = space.finished("roslaunch", "-p", port, "border_patrol", "team.launch", *options)
    assert "finished cleanly" in done.stdout + done.stderr, done.stdout + done.stderr
    summary = json.loads((tmp_path / "run" / "summary.json").read_text(encoding="utf-8"))
    assert [robot["id"] for robot in summary["robots"]] == ["robot1"]


def test_mrta_lists_every_plugin_of_the_space(space: Space) -> None:
    listing = json.loads(space.run("rosrun", "rqt_mrta_py", "mrta", "list", "--json"))
    found = {entry["folder"] for entry in listing["plugins"] if entry["name"] not in {"rqt_mrta_py", *MADE}}
    assert {Path(folder) for folder in found} == {plugin_folders(space)[name] for name in PLUGINS}


def test_rosrun_runs_a_mission_to_the_same_bytes_in_both_spaces(workspace: Workspace) -> None:
    outs = []
    for space in workspace.spaces:
        outs.append(workspace.folder / f"{space.folder.name}-run")
        plan = ["run", "border_patrol", "--duration", "3", "--pictures", "0", "-q", "--out", str(outs[-1])]
        space.run("rosrun", "rqt_mrta_py", "mrta", *plan)
    for name in SAME:
        assert (outs[0] / name).read_bytes() == (outs[1] / name).read_bytes(), name
    assert (outs[0] / "mission.bag").stat().st_size > 0


def test_roslaunch_runs_a_mission_under_another_architecture(space: Space, tmp_path: Path) -> None:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = str(probe.getsockname()[1])
    out = tmp_path / "run"
    options = "options:=--duration 2 --pictures 0 --architecture nearest_robot"
    launch = ["application:=border_patrol", f"out:={out}", options]
    done = space.finished("roslaunch", "-p", port, "rqt_mrta_py", "run.launch", *launch)
    assert "finished cleanly" in done.stdout + done.stderr, done.stdout + done.stderr
    assert json.loads((out / "summary.json").read_text(encoding="utf-8"))["architecture"] == "nearest_robot"


def test_every_exported_file_is_installed(workspace: Workspace) -> None:
    share = workspace.folder / "install" / "share"
    exported = []
    for manifest in share.glob("*/package.xml"):
        for element in ElementTree.parse(manifest).iter("rqt_mrta_py"):
            values = (value for value in element.attrib.values() if value.startswith("${prefix}/"))
            exported += [manifest.parent / value[len("${prefix}/") :] for value in values]
    assert len(exported) >= 5
    assert [path for path in exported if not path.is_file()] == []


def test_install_space_keeps_run_bits(workspace: Workspace) -> None:
    assert (workspace.folder / "install/lib/rqt_mrta_py/mrta").stat().st_mode & 0o111
    assert (workspace.folder / "install/bin/mrta").stat().st_mode & 0o111


def test_setup_file_may_be_sourced_twice(space: Space) -> None:
    twice = space.run("/bin/sh", "-c", f'. "{space.folder}/setup.sh"; echo "$ROS_PACKAGE_PATH"').strip().split(":")
    assert len(twice) == len(set(twice))
