"""Collecting, step by step in a hall made by hand."""

from __future__ import annotations

import math
from typing import Dict

import pytest
from basic_behaviours.collect import Collect

from rqt_mrta_py.hooks import Command
from rqt_mrta_py.model import Obstacle, Pose, Progress, Task
from tests.plugins.basic_behaviours.hall import Hall, Thing, collecting
from tests.plugins.basic_behaviours.perception import make_setup

CANS = {"can1": Thing("can", 2.2, 3.1), "can2": Thing("can", 3.9, 5.2), "can3": Thing("can", 2.0, 5.0)}


def cans() -> Dict[str, Thing]:
    return dict(CANS)


def commanded(hall: Hall, actuator: str) -> object:
    return {command.actuator: command.value for command in hall.newest.commands}.get(actuator)


def test_it_brings_every_thing_of_its_kind_and_no_other() -> None:
    hall = Hall({**cans(), "bottle1": Thing("bottle", 3.0, 4.0)})
    hall.start()
    ended = hall.run()
    assert ended.progress is Progress.DONE
    assert ended.detail == "brought 3; nothing is left in the area"
    assert hall.left() == []
    assert sorted(hall.held) == ["can1", "can2", "can3"]
    assert hall.things["bottle1"] == Thing("bottle", 3.0, 4.0)
    assert hall.holds == ""


def test_what_was_put_down_lies_apart() -> None:
    hall = Hall(cans())
    hall.start()
    hall.run()
    places = [Pose(thing.x, thing.y) for thing in hall.things.values()]
    # Slots are 2 * 0.15 + 0.3 = 0.6 m apart, and each is missed by 0.15 m at most, along the way to it.
    assert min(one.distance(other) for one in places for other in places if one is not other) > 0.3


def test_an_empty_area_is_done_once_it_was_searched_and_the_drop_zone_was_looked_at() -> None:
    hall = Hall({})
    hall.start()
    ended = hall.run()
    assert ended.progress is Progress.DONE
    assert ended.detail == "brought 0; nothing is left in the area"
    # Lanes at y = 3.25 and 4.75 from x = 2.25 to 3.75, reached to 0.4 m; the zone's edge and two radii are 1.4 m off.
    for x, y in ((2.25, 3.25), (3.75, 3.25), (2.25, 4.75), (3.75, 4.75)):
        assert min(math.hypot(pose.x - x, pose.y - y) for pose in hall.track) < 0.41
    assert min(math.hypot(pose.x - 9.0, pose.y - 4.0) for pose in hall.track) == pytest.approx(1.4, abs=0.05)


def test_a_robot_that_takes_over_leaves_what_lies_in_the_drop_zone() -> None:
    hall = Hall({**cans(), "can4": Thing("can", 9.2, 4.1)})
    hall.start()
    hall.run(until=lambda: len(hall.left()) == 2 and hall.holds == "")
    left = hall.left()
    second = Hall(hall.things, Pose(6.0, 1.0, 2.0))
    second.start()
    assert second.run().progress is Progress.DONE
    assert second.left() == []
    assert sorted(second.held) == left


def test_what_was_lost_on_the_way_is_fetched() -> None:
    """A robot that stopped at (6, 4.5) had taken it out of the area, where no search leads."""
    hall = Hall({"can1": Thing("can", 6.0, 4.5)}, Pose(3.0, 7.0, math.pi))
    hall.start()
    assert hall.run().progress is Progress.DONE
    assert hall.left() == []


def test_a_thing_that_is_taken_away_on_the_approach_is_given_up_and_the_area_searched_again() -> None:
    hall = Hall({"can1": Thing("can", 3.0, 4.0)}, Pose(5.0, 4.0, math.pi))
    hall.start()
    hall.run(1.0)
    del hall.things["can1"]
    ended = hall.run()
    assert (ended.progress, ended.detail) == (Progress.DONE, "brought 0; nothing is left in the area")
    assert hall.held == []


def test_what_others_hold_is_left_to_them() -> None:
    hall = Hall({"can1": Thing("can", 3.0, 4.0)})
    hall.by_others.add("can1")
    hall.start()
    assert hall.run().progress is Progress.DONE
    assert hall.held == []


def test_a_thing_that_falls_is_fetched_again() -> None:
    hall = Hall({"can1": Thing("can", 3.0, 4.0)})
    hall.start()
    hall.run(until=lambda: bool(hall.holds) and hall.pose.x > 6.0)
    hall.jammed.add("can1")
    hall.holds = ""
    hall.step()
    hall.jammed.clear()
    assert hall.left() == ["can1"]
    assert hall.run().progress is Progress.DONE
    assert hall.left() == []


def test_it_tries_a_bounded_number_of_times_to_take_hold_and_goes_on_with_the_rest() -> None:
    hall = Hall(cans(), task=collecting(tries=2))
    hall.jammed.add("can2")
    hall.start()
    ended = hall.run()
    assert ended.progress is Progress.UNREACHABLE
    assert ended.detail == "did not get can2 in 2 tries: the gripper did not take hold"
    assert hall.left() == ["can2"]


def test_what_cannot_be_taken_from_one_side_is_taken_from_another() -> None:
    pillar = Obstacle("pillar", Pose(3.4, 4.0), (0.3, 0.3, 1.0), "cylinder")
    hall = Hall({"can1": Thing("can", 3.0, 4.0)}, task=collecting(tries=2), obstacles=(pillar,))
    hall.start()
    assert hall.run().progress is Progress.DONE
    assert hall.left() == []


def test_a_slot_that_cannot_be_reached_is_passed_over() -> None:
    box = Obstacle("box", Pose(9.0, 4.0), (0.8, 0.8, 1.0))
    hall = Hall({"can1": Thing("can", 3.0, 4.0)}, obstacles=(box,))
    hall.start()
    assert hall.run().progress is Progress.DONE
    assert hall.left() == []


def test_a_robot_that_lying_things_have_closed_in_pushes_its_way_out() -> None:
    """A robot that stopped beside the drop zone left a gap that the last thing put down closed."""
    turns = [2.0 * math.pi * index / 10 for index in range(10)]
    ring = {
        f"bottle{index}": Thing("bottle", 7.0 + 0.7 * math.cos(turn), 1.5 + 0.7 * math.sin(turn))
        for index, turn in enumerate(turns)
    }
    hall = Hall(ring, Pose(7.0, 1.5), task=collecting(patience=5))
    hall.start()
    assert hall.run(200.0).progress is Progress.DONE


def test_the_wrong_thing_is_let_go() -> None:
    # Before the can by 0.1 m and aside by 0.12 m, so that it is nearer when the gripper closes, and ahead still.
    hall = Hall({"can1": Thing("can", 3.0, 4.0), "bottle1": Thing("bottle", 3.1, 4.12)}, task=collecting(tries=1))
    hall.start()
    ended = hall.run(until=lambda: "bottle1" in hall.held and hall.holds == "")
    assert ended.progress is Progress.RUNNING
    assert hall.held == ["bottle1"]
    ended = hall.run()
    assert (ended.progress, ended.detail) == (
        Progress.UNREACHABLE,
        "did not get can1 in 1 tries: took hold of bottle1 instead",
    )


def test_an_area_without_a_way_to_it_is_unreachable() -> None:
    wall = Obstacle("wall", Pose(5.0, 4.0), (0.3, 8.0, 1.0))
    hall = Hall({}, Pose(7.0, 4.0), obstacles=(wall,))
    hall.start()
    ended = hall.run(60.0)
    assert (ended.progress, ended.detail) == (Progress.UNREACHABLE, "the area: the known map has no way there")


def test_a_drop_zone_without_a_way_to_it_is_unreachable() -> None:
    wall = Obstacle("wall", Pose(6.0, 4.0), (0.3, 8.0, 1.0))
    hall = Hall({"can1": Thing("can", 3.0, 4.0)}, Pose(4.5, 4.0), obstacles=(wall,))
    hall.start()
    ended = hall.run(60.0)
    assert ended.progress is Progress.UNREACHABLE
    assert ended.detail == "cannot bring can1 to the drop zone: the known map has no way there"


def test_it_stands_still_and_keeps_what_it_holds_while_it_senses_nothing() -> None:
    hall = Hall({"can1": Thing("can", 3.0, 4.0)})
    hall.start()
    hall.run(until=lambda: bool(hall.holds) and hall.pose.x > 6.0)
    hall.sensors_work = False
    hall.run(3.0)
    where = hall.pose
    hall.run(1.0)
    assert hall.newest.commands == (Command("gripper", 1.0),)
    assert hall.pose == where
    hall.sensors_work = True
    assert hall.run().progress is Progress.DONE
    assert hall.left() == []


def test_the_gripper_is_closed_from_taking_hold_to_the_drop_zone_only() -> None:
    hall = Hall({"can1": Thing("can", 3.0, 4.0)})
    hall.start()
    hall.run(until=lambda: bool(hall.holds))
    assert commanded(hall, "gripper") == 1.0
    assert hall.pose.distance(Pose(3.0, 4.0)) <= 0.4
    hall.run(until=lambda: not hall.holds)
    assert hall.pose.distance(Pose(9.0, 4.0)) < 0.2 + 0.75 * 0.2 + 0.1 + 0.05
    hall.step()
    assert commanded(hall, "gripper") is None


def test_it_is_applicable_once_detector_and_gripper_are_heard() -> None:
    hall = Hall({})
    collect = Collect(make_setup())
    perceived = hall.perceived
    assert collect.applicable(hall.task, perceived)
    perceived.now += 1.5
    perceived.look_around()
    assert not collect.applicable(hall.task, perceived), "the detector is silent"
    hall.sense()
    assert collect.applicable(hall.task, perceived)


def test_it_costs_the_way_to_the_area_and_nothing_once_it_has_begun() -> None:
    hall = Hall({"can1": Thing("can", 3.0, 4.0)}, Pose(8.05, 4.05))
    # Along a row of cells from x = 8.05 to the area's centre in the cell [3.0, 3.1).
    assert hall.behaviour.cost(hall.task, hall.perceived) == pytest.approx(5.0, abs=0.15)
    hall.start()
    hall.run(5.0)
    assert hall.pose.x < 7.5
    assert hall.behaviour.cost(hall.task, hall.perceived) == pytest.approx(hall.pose.x - 3.05, abs=0.15)
    hall.run(until=lambda: bool(hall.holds) and hall.pose.x > 6.0)
    assert hall.behaviour.cost(hall.task, hall.perceived) == 0.0
    hall.perceived.now += 1.0
    assert hall.behaviour.cost(hall.task, hall.perceived) == pytest.approx(3.0, abs=0.3), "it was let go"


def test_a_round_area_is_searched_too() -> None:
    task = collecting(area="circle", radius=1.5)
    hall = Hall({"can1": Thing("can", 3.0, 5.4)}, task=task)
    hall.start()
    assert hall.run().progress is Progress.DONE
    assert hall.left() == []


def test_a_task_without_a_place_is_refused() -> None:
    with pytest.raises(ValueError, match="task 't1': place: a task of kind 'collect' needs one"):
        Collect(make_setup()).applicable(Task("t1", "collect"), Hall({}).perceived)
