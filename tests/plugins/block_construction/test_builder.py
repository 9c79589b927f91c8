"""What a builder does when something goes wrong, and what it answers about its tasks."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import pytest
from block_construction.team.board import TeamBoard

from rqt_mrta_py.hooks import BehaviourSetup
from rqt_mrta_py.model import Pose, Progress
from rqt_mrta_py.sim.robot_models import CARRIER
from tests.plugins.block_construction.toy_builder import ToyBuilder, a_task

SLOT = (1.02, 0.86, 0.035)


def until(builder, task, activity, action=""):
    """Let ticks pass until the builder is at something."""
    for _ in range(9000):
        assert builder.tick(task).progress is Progress.RUNNING
        told = builder.states()[-1]
        if (told["activity"], told["action"]) == (activity, action or told["action"]):
            return
    raise AssertionError(f"never {activity} {action}")


def test_block_is_fetched_and_placed():
    task = a_task()
    builder = ToyBuilder(task)
    step = builder.run(task)
    assert (step.progress, step.detail) == (Progress.DONE, "")
    assert builder.blocks["b1"] == pytest.approx(SLOT, abs=5e-4)
    assert builder.states()[-1]["placed"] == [1]
    assert builder.logs() == []


@pytest.mark.parametrize("off", [0.008, 0.025])
def test_block_is_gripped_where_it_is_seen_and_placed_in_its_slot(off):
    """It waits aside of its place, as a robot that errs so much meets it; the magnet takes nothing 20 mm away."""
    task = a_task()
    builder = ToyBuilder(task)
    aside = off * math.sqrt(0.5)
    builder.blocks["b1"] = (0.2 - aside, 0.2 + aside, 0.035)
    assert builder.run(task).progress is Progress.DONE
    assert builder.blocks["b1"] == pytest.approx(SLOT, abs=5e-4)
    assert builder.logs() == []


def test_block_is_placed_better_than_it_is_seen():
    """Single looks are off by 3 mm in x and in y, by 4.2 mm together; blocks wait 8 mm aside of where they should."""
    tasks = [a_task(level, level=level) for level in (1, 2, 3, 4)]
    builder = ToyBuilder(*tasks)
    builder.sight_noise = 0.003
    aside, off = 0.008 * math.sqrt(0.5), []
    for number, task in enumerate(tasks, 1):
        name = f"b{number}"
        builder.blocks[name] = (0.2 - aside, 0.2 + aside, 0.035)
        assert builder.run(task).progress is Progress.DONE
        x, y, _ = builder.blocks[name]
        off.append(math.hypot(x - SLOT[0], y - SLOT[1]))
    assert builder.logs() == []
    assert max(off) < 0.002


def test_cost_is_the_way_over_the_supply_place_to_the_slot():
    """From (1.1, 0.3) to (0.5889, 0.5889) and on to (1.02, 0.31): 0.587 m and 0.513 m, nothing being in the way."""
    task = a_task()
    builder = ToyBuilder(task)
    first, second = math.hypot(1.1 - 0.5889, 0.2889), math.hypot(1.02 - 0.5889, 0.2789)
    assert builder.behaviour.cost(task, builder) == pytest.approx(first + second, abs=1e-3)
    builder.behaviour.start(task, builder)
    until(builder, task, "placing")
    assert builder.behaviour.cost(task, builder) == 0.0
    builder.pose = None
    assert builder.behaviour.cost(task, builder) is None


def test_slot_that_is_taken_already_is_left_alone():
    task = a_task()
    builder = ToyBuilder(task)
    builder.blocks["other"] = SLOT
    step = builder.run(task, longest=1.0)
    assert (step.progress, step.detail) == (Progress.DONE, "its slot is taken already")
    assert builder.states()[-1]["placed"] == [1]
    assert not builder.magnet


def test_slot_that_a_block_of_another_length_lies_in_fails_the_task():
    """It is not filled, and not empty either."""
    task = a_task()
    builder = ToyBuilder(task)
    builder.blocks["short"] = SLOT
    builder.units["short"] = 1
    step = builder.run(task)
    assert step.progress is Progress.FAILED
    assert step.detail == "short lies at (1.02, 0.86) m, 0.04 m high, in the way into the slot of block 1"
    assert builder.states()[-1]["placed"] == []


def test_block_of_another_length_does_not_lie_ready():
    task = a_task()
    builder = ToyBuilder(task)
    builder.units["b1"] = 2
    step = builder.run(task)
    assert (step.progress, step.detail) == (Progress.FAILED, "no block of 3 units lies ready at (0.20, 0.20) m")


def test_slot_that_is_taken_meanwhile_gets_no_second_block():
    task = a_task()
    builder = ToyBuilder(task)
    builder.behaviour.start(task, builder)
    until(builder, task, "fetching", "retreat")
    builder.blocks["other"] = SLOT
    builder.finish(task)
    assert builder.held == "b1"


def test_robot_that_is_given_another_task_places_the_block_it_has_if_it_is_as_long():
    first, second = a_task(), a_task(2, level=2)
    builder = ToyBuilder(first, second)
    builder.behaviour.start(first, builder)
    until(builder, first, "driving")
    until(builder, first, "fetching")
    until(builder, first, "driving")
    assert builder.run(second).progress is Progress.DONE
    assert builder.blocks["b1"] == pytest.approx((1.02, 0.86, 0.105), abs=5e-4)


def test_missed_grip_is_tried_anew_three_times_and_then_told():
    task = a_task()
    builder = ToyBuilder(task)
    builder.grips = False
    step = builder.run(task)
    assert (step.progress, step.detail) == (Progress.FAILED, "nothing could be gripped at (0.20, 0.20) m")
    assert builder.logs() == ["robot=robot1 task=block1 nothing gripped at (0.20, 0.20) m; tries again"] * 3


def test_block_that_is_lost_on_the_way_is_told_and_another_one_fetched():
    task = a_task()
    builder = ToyBuilder(task)
    builder.behaviour.start(task, builder)
    until(builder, task, "fetching")
    until(builder, task, "driving")
    builder.drop(0.3, 1.9, 0.035)
    builder.blocks["b2"] = (0.2, 0.2, 0.035)
    builder.tick(task)
    assert builder.logs() == ["robot=robot1 task=block1 lost b1 on the way; fetches another"]
    assert builder.states()[-1]["missing"] == [1]
    builder.finish(task)
    assert builder.blocks["b2"] == pytest.approx(SLOT, abs=5e-4)
    assert builder.states()[-1]["missing"] == []


def test_block_that_slides_off_to_before_its_slot_is_taken_up_and_placed_again():
    task = a_task()
    builder = ToyBuilder(task)
    builder.behaviour.start(task, builder)
    until(builder, task, "placing", "retreat")
    builder.blocks["b1"] = (1.03, 0.80, 0.035)
    builder.finish(task)
    lies = "b1 lies at (1.03, 0.80) m, 0.04 m high"
    assert builder.logs() == [f"robot=robot1 task=block1 lost b1 after it was placed; {lies}; takes it up again"]
    assert builder.blocks["b1"] == pytest.approx(SLOT, abs=5e-4)


def test_what_lies_in_the_way_into_a_slot_fails_the_task_by_name_and_place():
    task = a_task()
    builder = ToyBuilder(task)
    builder.blocks["old"] = (1.0, 0.70, 0.03)
    step = builder.run(task)
    assert step.progress is Progress.FAILED
    assert step.detail == "old lies at (1.00, 0.70) m, 0.03 m high, in the way into the slot of block 1"


def test_block_that_has_gone_from_its_slot_lets_its_task_appear_anew():
    first, second = a_task(), a_task(2, level=2)
    builder = ToyBuilder(first, second)
    builder.run(first)
    builder.blocks["b1"] = (0.2, 1.9, 0.035)
    builder.blocks["b2"] = (0.2, 0.2, 0.035)
    builder.behaviour.start(second, builder)
    for _ in range(3):
        builder.tick(second)
    told = [message.fields for message in builder.said if message.topic == "/mrta/task_progress"]
    assert [(each["task_id"], each["progress"], each["detail"]) for each in told] == [
        ("block1", Progress.APPEARED.code, "block 1 is not in its slot any more")
    ]
    assert (builder.states()[-1]["placed"], builder.states()[-1]["missing"]) == ([], [1])


def test_block_under_another_one_is_not_taken_to_be_gone():
    first, second, third = a_task(), a_task(2, level=2), a_task(3, level=3)
    builder = ToyBuilder(first, second, third)
    for number, task in enumerate((first, second), 1):
        builder.blocks[f"b{number}"] = (0.2, 0.2, 0.035)
        builder.run(task)
    del builder.blocks["b1"]
    builder.behaviour.start(third, builder)
    for _ in range(20):
        builder.tick(third)
    assert [message for message in builder.said if message.topic == "/mrta/task_progress"] == []


def test_builder_without_eyes_trusts_its_magnet():
    task = a_task()
    builder = ToyBuilder(task)
    builder.sees = False
    builder._heard.pop("detections")
    assert builder.run(task).progress is Progress.DONE
    assert builder.blocks["b1"] == pytest.approx(SLOT, abs=5e-4)


@pytest.mark.parametrize(
    ("changes", "problem"),
    [
        ({"block": 0}, "data: block: must be a whole number from 1 to 65535 (found 0)"),
        ({"level": "low"}, "data: level: must be a whole number from 1 to 65535 (found 'low')"),
        ({"x": math.inf}, "data: x: must be a finite number (found inf)"),
        ({"supply": []}, "data: supply: must be a list of lists of 4 numbers (found [])"),
        ({"cells": [[1]]}, "data: cells: must be a list of lists of 2 numbers (found [[1]])"),
        ({"site": [1, 1, 0, 2]}, "data: site: must be left, bottom, right and top (found [1, 1, 0, 2])"),
        ({"arena": 0}, "data: arena: must be above 0 m (found 0)"),
        ({"level": 6}, "the arm does not reach 0.395 m; it reaches 0.024 to 0.370 m"),
    ],
)
def test_task_that_makes_no_sense_is_refused_before_anything_moves(changes, problem):
    task = a_task()
    builder = ToyBuilder()
    with pytest.raises(ValueError, match=f"^{re.escape(problem)}$"):
        builder.behaviour.applicable(replace(task, data={**task.data, **changes}), builder)


def test_task_that_lacks_something_is_refused():
    task = a_task()
    data = {name: value for name, value in task.data.items() if name != "heading"}
    with pytest.raises(ValueError, match=r"^data: heading: missing; tasks of kind place_block need it$"):
        ToyBuilder().behaviour.applicable(replace(task, data=data), ToyBuilder())


def test_robot_without_arm_does_not_build():
    from block_construction.building.place_block import PlaceBlock

    setup = BehaviourSetup("robot1", CARRIER, navigator=None, random=None)
    with pytest.raises(ValueError, match=r"^robot model carrier: tasks of kind place_block need a robot with an arm$"):
        PlaceBlock(setup)


def test_block_that_does_not_fit_is_laid_down_by_a_wall_before_another_one_is_fetched():
    first = a_task()
    second = a_task(2, units=1)
    builder = ToyBuilder(first, second)
    builder.behaviour.start(first, builder)
    until(builder, first, "fetching", "retreat")
    until(builder, first, "driving")
    builder.blocks["b2"] = (0.2, 0.2, 0.035)
    builder.units["b2"] = 1
    assert builder.run(second).progress is Progress.DONE
    x, y, z = builder.blocks["b1"]
    assert min(x, y, 2.2 - x, 2.2 - y) == pytest.approx(0.12, abs=1e-3)
    assert z == pytest.approx(0.035, abs=1e-3)
    assert math.dist((x, y), (0.2, 0.2)) > 0.35
    assert builder.logs() == [f"robot=robot1 task=block2 lays b1 down at ({x:.2f}, {y:.2f}) m"]
    assert builder.blocks["b2"] == pytest.approx(SLOT, abs=5e-4)


def test_builder_waits_a_minute_for_a_block_to_lie_ready():
    task = a_task()
    builder = ToyBuilder(task)
    builder.blocks = {"far": (1.9, 1.9, 0.035)}
    builder.behaviour.start(task, builder)
    until(builder, task, "driving")
    for _ in range(500):
        builder.tick(task)
    builder.blocks["b1"] = (0.2, 0.2, 0.035)
    builder.finish(task)
    assert builder.blocks["b1"] == pytest.approx(SLOT, abs=5e-4)


def test_empty_supply_fails_the_task_by_its_place():
    task = a_task()
    builder = ToyBuilder(task)
    builder.blocks = {"far": (1.9, 1.9, 0.035)}
    step = builder.run(task)
    assert (step.progress, step.detail) == (
        Progress.FAILED,
        "no block of 3 units lies ready at (0.20, 0.20) m",
    )


def test_other_supply_place_is_tried_where_one_stays_empty():
    task = a_task()
    far = [2, 2.0, 2.0, math.atan2(0.9, 0.9)]
    task = replace(task, data={**task.data, "supply": [*task.data["supply"], far]})
    builder = ToyBuilder(task)
    builder.blocks = {"b1": (2.0, 2.0, 0.035)}
    assert builder.run(task).progress is Progress.DONE
    assert builder.blocks["b1"] == pytest.approx(SLOT, abs=5e-4)


def test_robot_that_is_interrupted_over_and_over_stands_no_farther_off_than_once():
    """It takes 12 s to withdraw; who began anew each time would go back 10 cm each time, into a wall."""
    task = a_task()
    builder = ToyBuilder(task)
    builder.behaviour.start(task, builder)
    until(builder, task, "fetching", "approach")
    farthest = 0.0
    for _ in range(5):
        builder.behaviour.start(task, builder)
        for _ in range(100):
            builder.tick(task)
            farthest = max(farthest, math.dist((builder.pose.x, builder.pose.y), (0.2, 0.2)))
    assert farthest == pytest.approx(0.55, abs=5e-3)
    builder.finish(task)
    assert builder.blocks["b1"] == pytest.approx(SLOT, abs=5e-4)


def in_a_team(*tasks, teammate):
    """Make a builder whose only teammate stands somewhere with nothing to do."""
    builder = ToyBuilder(*tasks, board=TeamBoard("robot1", ("robot1", "robot2"), 0.03, dict))
    builder.pose = Pose(0.5, 1.7, math.pi / 2)
    builder.hear("/robot2/pose", {"pose/position/x": teammate[0], "pose/position/y": teammate[1]})
    return builder


def test_who_is_shut_in_goes_aside_before_it_leaves_its_task_to_others():
    """Who stands at the dock of the slot may have to place the block, and needs room for it."""
    task = a_task()
    builder = in_a_team(task, teammate=(1.02, 0.31))
    builder.behaviour.start(task, builder)
    until(builder, task, "waiting", "")
    waits = builder.pose
    step = builder.finish(task)
    assert (step.progress, step.detail) == (Progress.UNREACHABLE, "robots without anything to do leave no way")
    aside = (builder.pose.x, builder.pose.y)
    assert math.dist(aside, (waits.x, waits.y)) > 0.1
    assert min(abs(value - berth) for value in aside for berth in (0.38, 2.2 - 0.38)) < 5e-3
    assert math.dist(aside, (1.02, 0.31)) > 0.40
    assert builder.held == "b1"


@pytest.mark.parametrize("alone", [True, False])
def test_robot_that_is_stuck_leaves_its_task_to_teammates_if_there_are_any(alone):
    task = a_task()
    builder = ToyBuilder(task) if alone else in_a_team(task, teammate=(1.9, 1.1))
    builder.behaviour.start(task, builder)
    until(builder, task, "placing", "approach")
    stuck, step = builder.pose, builder.tick(task)
    while step.progress is Progress.RUNNING and builder.now < 900.0:
        builder.pose = replace(stuck)
        step = builder.tick(task)
    assert step.progress is (Progress.FAILED if alone else Progress.UNREACHABLE)
    assert step.detail == "something is in the way while placing"
