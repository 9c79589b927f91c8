"""Missions made of drawings: tasks, scenario, and what is refused."""

from __future__ import annotations

import dataclasses
import json
import math
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any, Dict, List

import pytest
import yaml
from block_construction.execution.arena import Arena
from block_construction.execution.plan_file import plan_document
from block_construction.execution.planners import plan_build
from block_construction.execution.problem import BuildProblem
from block_construction.execution.supply import corner_places
from block_construction.mission.limits import most_levels
from block_construction.mission.maker import BUILDING
from block_construction.mission.numbers import number
from block_construction.mission.published_wall import wall_diagram

from rqt_mrta_py.app.cli.main import main
from rqt_mrta_py.app.compose import Host, compose
from rqt_mrta_py.app.run.choice import MissionChoice, chosen_mission
from rqt_mrta_py.hooks import ArmModel, MadeMission, MissionRequest, MrtaError, PlacedRobot
from rqt_mrta_py.sim.body_placement import body_problems
from rqt_mrta_py.sim.placement import placement_problems
from rqt_mrta_py.transport import RosCodec, read_bag
from tests.app.outputs import Outputs
from tests.transport.support import lookup

pytest.importorskip("scipy", reason="SciPy finds ways")

ROBOTS = tuple(f"robot{number}" for number in range(1, 5))
TWO = "###\n\n###\n"
"""Two blocks of three units, one on the other."""


@pytest.fixture(scope="module")
def host() -> Host:
    return compose()


def made(host: Host, robots: int = 1, **given: str) -> MadeMission:
    settings = {each.name: given.get(each.name, each.default) for each in BUILDING.settings}
    return BUILDING.make(
        MissionRequest(settings, frozenset(given), ROBOTS, ROBOTS[:robots], "", "", host.manager.registered)
    )


def tasks(mission: MadeMission) -> List[Dict[str, Any]]:
    return list(yaml.safe_load(mission.tasks_yaml)["tasks"])


def scenario(mission: MadeMission) -> Dict[str, Any]:
    return dict(yaml.safe_load(mission.scenario_yaml))


def test_files_of_the_application_are_what_is_made_of_nothing(host: Host, root: Path) -> None:
    folder = root / "plugins" / "applications" / "block_construction"
    files = [(folder / name).read_text(encoding="utf-8") for name in ("tasks.yaml", "scenario.yaml")]
    assert list(made(host)) == files


def test_the_same_is_made_whatever_strings_hash_to(host: Host) -> None:
    script = (
        "from rqt_mrta_py.app.compose import compose\n"
        "from rqt_mrta_py.app.run.choice import MissionChoice, chosen_mission\n"
        "import sys\n"
        "choice = MissionChoice('block_construction', robots=3, overrides=('structure=dam',))\n"
        "texts = chosen_mission(compose(), choice)[0].texts\n"
        "sys.stdout.write(texts.tasks_yaml + texts.scenario_yaml)\n"
    )
    for seed in ("1", "2"):
        environment = {**os.environ, "PYTHONHASHSEED": seed}
        done = subprocess.run(
            [sys.executable, "-c", script], env=environment, capture_output=True, text=True, timeout=120, check=True
        )
        assert done.stdout == "".join(made(host, 3, structure="dam"))


def test_a_task_says_all_of_its_block(host: Host) -> None:
    """The two units in row 4 of the wall: its site begins at 1.1 - 0.12 m and 1.1 - 0.16 m; placed from above."""
    (found,) = [task for task in tasks(made(host)) if task["id"] == "block3"]
    assert found["place"] == {"x": 1.06, "y": 1.77, "yaw": pytest.approx(1.5 * math.pi, abs=1e-6)}
    assert (found["kind"], found["capabilities"]) == ("place_block", ["magnet"])
    heading = pytest.approx(-0.75 * math.pi, abs=1e-6)
    assert found["data"] == {
        "block": 3,
        "units": 2,
        "level": 1,
        "x": 1.06,
        "y": 1.22,
        "yaw": 0.0,
        "heading": pytest.approx(1.5 * math.pi, abs=1e-6),
        "cells": [[1, 4], [2, 4]],
        "supply": [[1, 0.2, 0.2, heading]],
        "site": [0.98, 0.94, 1.22, 1.26],
        "arena": 2.2,
    }


def test_one_robot_follows_a_plan_and_a_team_is_free(host: Host) -> None:
    alone, team = (tasks(made(host, robots, structure="wall", supply="corners_all")) for robots in (1, 2))
    assert [each.get("predecessors", []) for each in alone] == [[], *([each["id"]] for each in alone[:-1])]
    assert {each["id"]: each.get("predecessors", []) for each in team} == {
        "block1": [],
        "block2": [],
        "block3": [],
        "block4": ["block1"],
        "block5": ["block1", "block2"],
        "block6": ["block2", "block3"],
    }
    assert {len(each["data"]["supply"]) for each in alone} == {1}
    assert {len(each["data"]["supply"]) for each in team} == {4}


def test_order_can_be_set_for_any_team(host: Host) -> None:
    free, planned = (tasks(made(host, robots, order=order)) for robots, order in ((1, "free"), (4, "plan")))
    assert [sum(not each.get("predecessors") for each in found) for found in (free, planned)] == [3, 1]


def test_all_lengths_lie_side_by_side_in_a_corner(host: Host) -> None:
    """Of 6, 12 and 18 cm with 4 cm between them, across the diagonal: 44 cm, their middles at -19, -6 and 13 cm."""
    lying = {each["id"]: each for each in scenario(made(host, supply="corners_all"))["dispensers"]}
    assert len(lying) == 12
    # A robot that looks to the lower left has the lower right at its left hand.
    diagonal = math.sqrt(0.5)
    for units, along in ((1, -0.19), (2, -0.06), (3, 0.13)):
        found = lying[f"supply1u{units}"]
        assert (found["x"], found["y"]) == (
            pytest.approx(0.2 + along * diagonal, abs=1e-6),
            pytest.approx(0.2 - along * diagonal, abs=1e-6),
        )
        assert found["size"] == [pytest.approx(0.06 * units), 0.07, 0.07]
        assert math.cos(2 * found["yaw"] - math.pi * 1.5) == pytest.approx(1.0)


@pytest.mark.parametrize("supply", ["corners", "corners_all"])
@pytest.mark.parametrize("structure", ["wall", "tower", "dam", "pyramid", "station", "cistern", "station_b"])
def test_robots_and_blocks_have_room_in_every_mission(host: Host, structure: str, supply: str) -> None:
    settings = (f"structure={structure}", f"supply={supply}")
    if structure != "wall":
        pytest.importorskip("ortools", reason="other planners take long")
    _, found = chosen_mission(host, MissionChoice("block_construction", robots=4, overrides=settings))
    models = host.manager.registered("mrta_register_robot_models")
    placed = [PlacedRobot(robot.id, models[robot.model], robot.start) for robot in found.robots]
    assert len(placed) == 4
    assert list(placement_problems(found.arena, found.obstacles, placed)) == []
    assert list(body_problems(found.bodies, found.arena, found.obstacles, placed, found.dispensers)) == []
    choice = MissionChoice("block_construction", robots=1, overrides=(*settings, "order=free"))
    alone, _ = chosen_mission(host, choice)
    assert found.duration > sum(task.expected_duration or 0.0 for task in alone.tasks)


def test_in_a_team_a_task_is_expected_to_last_longer_by_the_longest_one_and_the_mission_no_longer(host: Host) -> None:
    alone, team = (made(host, robots, structure="wall", order="free") for robots in (1, 3))
    own = [each["expected_duration"] for each in tasks(alone)]
    assert len(set(own)) > 1
    assert [each["expected_duration"] for each in tasks(team)] == pytest.approx(
        [each + max(own) for each in own], abs=0.11
    )
    assert scenario(team)["duration"] == scenario(alone)["duration"]


def test_the_wall_is_built_from_the_sources_place_as_the_source_has_it(host: Host) -> None:
    """Table 19 in metres, all y 0.5 m more."""
    mission = made(host, structure="wall", supply="wall_source")
    slots = [
        (each["data"]["x"], each["data"]["y"], each["data"]["units"], each["data"]["level"]) for each in tasks(mission)
    ]
    assert slots == [
        (1.46, 1.62, 2, 1),
        (1.58, 1.54, 3, 1),
        (1.5, 1.38, 3, 1),
        (1.58, 1.46, 3, 2),
        (1.54, 1.62, 2, 2),
        (1.5, 1.38, 1, 2),
    ]
    assert {each["data"]["supply"][0][0] for each in tasks(mission)} == {1}
    lying = scenario(mission)["dispensers"]
    assert {(each["kind"], each["x"]) for each in lying} == {("block1", 2.8), ("block2", 2.8), ("block3", 2.8)}
    assert scenario(mission)["arena"]["max_x"] == 3.0


def test_the_sources_diagram_of_the_wall_is_one_of_least_cost() -> None:
    """Its six blocks make no connection fault, and none has fewer."""
    assert (wall_diagram().cost, wall_diagram().counts) == (6, {1: 1, 2: 2, 3: 3})


def test_a_limited_stock_is_laid_out_as_such(host: Host, tmp_path: Path) -> None:
    supply = tmp_path / "supply.yaml"
    supply.write_text("places:\n  - {x: 0.2, y: 0.2, blocks: {3: 7, 2: null, 1: null, 5: null}}\n")
    lying = scenario(made(host, supply=str(supply)))["dispensers"]
    assert [(each["id"], each.get("stock")) for each in lying] == [
        ("supply1u1", None),
        ("supply1u2", None),
        ("supply1u3", 7),
    ]


@pytest.mark.parametrize(
    ("places", "message"),
    [
        # 6, 12 and 18 cm with 4 cm between are 44 cm: 22 cm to either side of the middle, across the heading.
        (
            "[{x: 0.78, y: 1.1, yaw: 1.5708, blocks: [1, 2, 3]}]",
            "supply place 1: blocks of 1 units reach into the site, which reaches from (0.98, 0.94) to (1.22, 1.26) m",
        ),
        (
            "[{x: 0.02, y: 1.1, yaw: 3.1416, blocks: [1, 2, 3]}]",
            "supply place 1: blocks of 1 units reach beyond a wall of the arena, which measures 2.2 m",
        ),
        (
            "[{x: 0.2, y: 0.2, blocks: [1, 2, 3]}, {x: 0.25, y: 0.2, blocks: [1, 2, 3]}]",
            "supply place 2: blocks of 1 units lie where those of 1 units of place 1 do; keep them apart",
        ),
        # For who looks left, those of 12 cm lie up to 12 cm above the middle: 5 cm above the start at y 0.3.
        (
            "[{x: 1.1, y: 0.35, yaw: 3.1416, blocks: [1, 2, 3]}]",
            "supply place 1: blocks of 2 units lie 0.05 m from (1.1, 0.3) m, where a robot begins; at least 0.18 m",
        ),
    ],
)
def test_blocks_that_would_lie_in_the_way_are_refused_by_place(
    host: Host, tmp_path: Path, places: str, message: str
) -> None:
    supply = tmp_path / "supply.yaml"
    supply.write_text(f"places: {places}\n")
    with pytest.raises(MrtaError) as caught:
        made(host, supply=str(supply))
    assert str(caught.value).startswith(message)


def test_blocks_may_not_lie_where_a_robot_places_others(host: Host, tmp_path: Path) -> None:
    """The wall's lower row is at y 0.98, so that it is placed from 0.43; those of 6 cm lie from 0.51 to 0.57."""
    supply = tmp_path / "supply.yaml"
    supply.write_text("arena: {start: [0.3, 0.3]}\nplaces:\n  - {x: 1.1, y: 0.35, yaw: 3.1416, blocks: [1, 2, 3]}\n")
    message = "supply place 1: blocks of 1 units lie 0.08 m from (1.1, 0.43) m, where a robot places block 1"
    with pytest.raises(MrtaError, match=f"^{re.escape(message)}"):
        made(host, supply=str(supply))


def test_nothing_lies_ready_of_what_there_is_none(host: Host, tmp_path: Path) -> None:
    supply = tmp_path / "supply.yaml"
    supply.write_text(
        "places:\n  - {x: 0.2, y: 0.2, blocks: {1: 0, 2: null, 3: null}}\n  - {x: 2.0, y: 2.0, blocks: {1: 1, 3: 0}}\n"
    )
    mission = made(host, supply=str(supply), order="free")
    assert [each["id"] for each in scenario(mission)["dispensers"]] == ["supply1u2", "supply1u3", "supply2u1"]
    places = {each["data"]["units"]: [one[0] for one in each["data"]["supply"]] for each in tasks(mission)}
    assert places == {1: [2], 2: [1], 3: [1]}


def test_a_build_is_planned_with_what_supply_places_have(host: Host, tmp_path: Path) -> None:
    """Both would be fetched from the one place, which has one, by the exact method: it does not count them."""
    supply, drawing = tmp_path / "supply.yaml", tmp_path / "two.txt"
    drawing.write_text(TWO)
    supply.write_text("places:\n  - {x: 0.2, y: 0.2, blocks: {3: 1}}\n  - {x: 2.0, y: 2.0, blocks: {3: 1}}\n")
    fetched = [each["data"]["supply"][0][0] for each in tasks(made(host, structure=str(drawing), supply=str(supply)))]
    assert sorted(fetched) == [1, 2]
    with pytest.raises(MrtaError, match="take the method local or greedy"):
        made(host, structure=str(drawing), supply=str(supply), planner="exact")


def test_pose_noise_is_that_of_localisers(host: Host) -> None:
    localiser = scenario(made(host, pose_noise="0.008"))["robot_defaults"]["sensors"][0]
    assert (localiser["kind"], localiser["uniform_noise"]) == ("localiser", 0.008)
    assert "uniform_hold" not in localiser
    lasting = scenario(made(host, pose_noise="0.008", pose_hold="60"))["robot_defaults"]["sensors"][0]
    assert (lasting["uniform_noise"], lasting["uniform_hold"]) == (0.008, 60.0)


def test_sight_noise_is_that_of_detectors(host: Host) -> None:
    """The third sensor of every robot."""
    exact, noisy = (scenario(made(host, sight_noise=value)) for value in ("0", "0.003"))
    eyes = [each["robot_defaults"]["sensors"][2] for each in (exact, noisy)]
    assert [(each["kind"], each["position_noise"]) for each in eyes] == [("detector", 0.0), ("detector", 0.003)]


def test_bumpers_feel_at_every_tick(host: Host) -> None:
    """Two robots that graze each other touch for less than half a second."""
    site = scenario(made(host))
    (bumper,) = [each for each in site["robot_defaults"]["sensors"] if each["kind"] == "bumper"]
    assert bumper["rate"] == site["control_rate"]


def test_diagrams_and_plans_of_the_verbs_are_built(host: Host, tmp_path: Path) -> None:
    drawing = tmp_path / "two.txt"
    drawing.write_text(TWO)
    diagram, plan = tmp_path / "diagram", tmp_path / "plan"
    planner = ["--method", "pla", "--set", "iterations=50"]
    assert main(["plan-structure", str(drawing), *planner, "--out", str(diagram), "--json"]) == 0
    command = ["plan-build", str(diagram / "diagram.json"), "--supply", "corners", "--method", "greedy"]
    assert main([*command, "--out", str(plan), "--json"]) == 0
    blocks = len(json.loads((diagram / "diagram.json").read_text())["placements"])
    of_diagram = tasks(made(host, diagram=str(diagram / "diagram.json")))
    of_plan = tasks(made(host, plan=str(plan / "plan.json")))
    steps = json.loads((plan / "plan.json").read_text())["steps"]
    assert len(of_diagram) == len(of_plan) == blocks
    assert [(each["data"]["block"], each["data"]["supply"][0][0]) for each in of_plan] == [
        (step["block"], step["place"]) for step in steps
    ]


def files(folder: Path) -> Dict[str, str]:
    """Write what cannot be built; gives paths by name."""
    texts = {
        "bad.vox": "VOX broken",
        "empty.txt": "...\n",
        "floats.txt": "#.\n\n##\n",
        "wide.txt": "############\n",
        "few.yaml": "places: [{x: 0.2, y: 0.2, blocks: {3: 1, 2: 9, 1: 9}}]\n",
        "inside.yaml": "places: [{x: 1.1, y: 1.1, blocks: [1, 2, 3]}]\n",
        "thin.yaml": "{arena: {robot_radius: 0.01}, places: [{x: 0.2, y: 0.2, blocks: [1, 2, 3]}]}\n",
        "coarse.yaml": "{arena: {cell: 0.2}, places: [{x: 0.2, y: 0.2, blocks: [1, 2, 3]}]}\n",
        "backwards.yaml": "places: [{x: 0.2, y: 0.2, yaw: 0.785, blocks: [1, 2, 3]}]\n",
        "sideways.yaml": "places: [{x: 0.2, y: 0.2, yaw: 3.142, blocks: [1, 2, 3]}]\n",
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
    return {name: str(folder / name) for name in texts}


WRONG = {
    "broken": (3, ["structure=bad.vox"], "bad.vox: version "),
    "empty": (3, ["structure=empty.txt"], "empty.txt: no cell is filled"),
    "floating": (3, ["structure=floats.txt"], "floats.txt: the voxel at x 2, y 1, level 2 floats"),
    "too wide": (3, ["structure=wide.txt"], "wide.txt: measures 0.96 m x 0.08 m; the robot needs an arena of 2.34 m"),
    "too high": (
        3,
        ["structure=vertical_extension"],
        "vertical_extension: voxel x 1, y 1, level 5 is higher than mecanum_arm builds, which is 4 levels (14",
    ),
    "no structure": (3, ["structure=castle"], "castle: neither a file *.npy, *.txt, *.vox nor one of"),
    "too few": (3, ["supply=few.yaml"], "wall: 3 blocks of 3 units are needed, and there are 1 in the supply; block 2"),
    "inside": (3, ["supply=inside.yaml"], "supply place 1 at (1.1, 1.1) m: lies inside the site"),
    "no room": (
        3,
        ["supply=backwards.yaml"],
        "supply place 1 at (0.2, 0.2) m: a robot would fetch from (-0.189, -0.189) m, nearer than 0.18 m to a wall",
    ),
    "no room for the longest": (
        3,
        ["supply=sideways.yaml"],
        "supply place 1: a robot fetches blocks of 3 units from (0.75, 0.0702) m, nearer than 0.18 m to a wall",
    ),
    "thin": (
        3,
        ["supply=thin.yaml"],
        "thin.yaml: arena: robot_radius: 0.01 m; accepted is at least that of mecanum_arm",
    ),
    "coarse": (
        3,
        ["supply=coarse.yaml"],
        "coarse.yaml: arena: cell: 0.2 m; accepted is at most the radius of mecanum_arm",
    ),
    "unused planner": (2, ["planner=exact", "order=free"], "planner=exact: plans an order, and with order=free"),
    "no supply": (3, ["supply=none.yaml"], "none.yaml: cannot be read: No such file or directory; accepted are"),
    "no diagram": (3, ["diagram=none.json"], "none.json: cannot be read: No such file or directory"),
    "twice": (2, ["plan=a.json", "supply=corners"], "plan=a.json: says already what supply=corners does; give one"),
    "order": (2, ["order=any"], "order=any: there is no such order; accepted are plan, free"),
    "planner": (2, ["planner=best"], "planner=best: there is no such planner; accepted are exact, greedy, local, pla"),
    "method": (2, ["method=best"], "method=best: there is no such planner; accepted are "),
    "noise": (2, ["pose_noise=nan"], "pose_noise=nan: a number from 0 to 0.5 m is expected"),
    "sight": (2, ["sight_noise=1"], "sight_noise=1: a number from 0 to 0.5 m is expected"),
    "hold": (2, ["pose_hold=-1"], "pose_hold=-1: a number from 0 to 86400 s is expected"),
    "seed": (2, ["seed=-1"], "seed=-1: a whole number from 0 to 2^63 - 1 is expected"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_cannot_be_built_is_told_in_one_line_before_anything_moves(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    status, settings, line = WRONG[name]
    known = files(tmp_path)
    given = []
    for each in settings:
        key, _, value = each.partition("=")
        given += ["--set", f"{key}={known.get(value, value)}"]
    out = tmp_path / "out"
    assert main(["run", "block_construction", *given, "--out", str(out)]) == status
    (said,) = capsys.readouterr().err.splitlines()
    assert said.startswith(f"mrta: {line}")
    assert not out.exists()


@pytest.mark.parametrize(
    ("joint_height", "lowest", "levels"),
    [(0.20, -0.611, 4), (0.13, -0.611, 3), (0.42, -0.611, 0), (0.20, -0.4, 0)],
    ids=["ours", "lower", "too high for the floor", "not low enough"],
)
def test_an_arm_builds_as_high_as_it_carries(joint_height: float, lowest: float, levels: int) -> None:
    """Ours carries a block's middle at 0.37 m, its lower side at 0.335 m: above four levels of 7 cm and a centimetre.

    With the joint 7 cm lower there is one level less; 22 cm higher it is out of reach of the floor, as it is if the arm
    does not sink to -31.5 degrees (-0.55 rad).
    """
    assert most_levels(ArmModel(0.22, 0.12, 0.06, joint_height, 0.05, lowest, math.pi / 2, 0.5)) == levels


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.1 + 0.2, "0.3"),
        (-1e-9, "0.0"),
        (1 / 3, "0.333333"),
        (5e-6, "0.000005"),
        (2.0, "2.0"),
        (-0.5, "-0.5"),
        (-1e16, "-10000000000000000.0"),
    ],
)
def test_numbers_are_written_short_and_never_with_an_exponent(value: float, text: str) -> None:
    assert number(value) == text


def test_a_robot_begins_where_the_supply_file_says(host: Host, tmp_path: Path) -> None:
    """Even if that is what plans begin with where nothing is said."""
    for arena, start in (("{start: [1.1, 0.2]}", (1.1, 0.2)), ("{}", (1.1, 0.3)), ("{side: 2.6}", (1.3, 0.3))):
        supply = tmp_path / "supply.yaml"
        supply.write_text(f"{{arena: {arena}, places: [{{x: 0.2, y: 0.2, blocks: [1, 2, 3]}}]}}\n")
        found = scenario(made(host, supply=str(supply)))["robots"][0]["start"]
        assert (found["x"], found["y"]) == start


def test_all_supplies_that_are_known_are_named(host: Host) -> None:
    with pytest.raises(MrtaError, match=r"none\.yaml: cannot be read: .* or corners, corners_all, wall_source$"):
        made(host, supply="none.yaml")


def test_a_plan_for_a_smaller_robot_is_refused(host: Host, tmp_path: Path) -> None:
    arena = dataclasses.replace(Arena(), robot_radius=0.1)
    problem = BuildProblem(wall_diagram(), corner_places(arena, [(1, 2, 3)]), arena)
    plan = tmp_path / "thin.json"
    plan.write_text(json.dumps(plan_document(plan_build("greedy", problem).plan)))
    with pytest.raises(MrtaError, match=r"^thin\.json: arena: robot_radius: 0\.1 m; accepted is at least"):
        made(host, plan=str(plan))


def test_a_drawing_may_be_called_anything(host: Host, tmp_path: Path) -> None:
    drawing = tmp_path / "two\nlines: {.txt"
    drawing.write_text(TWO)
    mission = made(host, structure=str(drawing), method="pla")
    assert mission.tasks_yaml.startswith("# two?lines: {.txt: ")
    assert len(tasks(mission)) >= 2


def test_two_blocks_are_built_of_a_drawing(tmp_path: Path) -> None:
    pytest.importorskip("pybullet", reason="blocks are simulated")
    drawing = tmp_path / "two.txt"
    drawing.write_text(TWO)
    out = tmp_path / "out"
    command = ["run", "block_construction", "--set", f"structure={drawing}", "--set", "supply=corners_all"]
    assert main([*command, "--duration", "320", "--pictures", "0", "--out", str(out), "-q"]) == 0
    assert [task["state"] for task in Outputs(out).summary["tasks"]] == ["done", "done"]
    codec, bodies = RosCodec(lookup), []
    for connection, _, raw in read_bag(out / "mission.bag"):
        if connection.topic == "/simulation/bodies":
            bodies = codec.decode(connection, raw)["detections"]
    lying = sorted(tuple(each["position"][axis] for axis in "zxy") for each in bodies)
    on_site = [each for each in lying if abs(each[1] - 1.1) < 0.2 and abs(each[2] - 1.1) < 0.2]
    assert on_site == [pytest.approx((0.035, 1.1, 1.1), abs=0.003), pytest.approx((0.105, 1.1, 1.1), abs=0.003)]
