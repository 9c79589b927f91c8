"""Missions of robots that map what they see, with a stranger's planner that knows nothing of it."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import List, Tuple

import pytest

from tests.app.outputs import Mrta

PLANNER = """
from rqt_mrta_py.hooks import *

MADE = []


class Straight:
    def __init__(self, setup):
        MADE.append((len(setup.obstacles), setup.previous is not None))
        {made}

    def path(self, start, goal):
        return (goal,)

    def cost_field(self, goal):
        self.goal = goal
        return self

    def at(self, place):
        return place.distance(self.goal)

    def observe(self, obstacles):
        pass


@hookimpl
def mrta_register_planners():
    return {{"astar": Straight}}
"""
RUN = ("run", "target_visiting", "--world", "planar", "--architecture", "nearest_robot", "--robots", "1")
SHORT = ("--duration", "4", "--pictures", "0", "--processes", "1")


def made() -> List[Tuple[int, bool]]:
    """Give of each planner that was made how many obstacles it was told of, and whether it followed another one."""
    return list(sys.modules["stranger_plugin"].MADE)


def test_any_planner_is_told_what_a_robot_has_seen_so_far(mrta: Mrta, stranger: Path) -> None:
    stranger.write_text(PLANNER.format(made="pass"))
    assert mrta(*RUN, "--map", "unknown", *SHORT) == (0, [])
    first, *others = made()
    assert first == (0, False)
    # At most once a second, from 0 s to 4 s.
    assert 1 <= len(others) <= 5
    assert all(obstacles > 0 and follows for obstacles, follows in others)


def test_a_planner_of_a_known_map_is_made_once(mrta: Mrta, stranger: Path) -> None:
    stranger.write_text(PLANNER.format(made="pass"))
    assert mrta(*RUN, *SHORT) == (0, [])
    assert made() == [(7, False)]


def test_a_planner_that_cannot_be_made_again_stops_the_run_by_its_name(mrta: Mrta, stranger: Path) -> None:
    stranger.write_text(PLANNER.format(made="().index(1) if setup.previous else None"))
    assert mrta(*RUN, "--map", "unknown", *SHORT) == (
        3,
        ["mrta: robot1: planner astar: ValueError: tuple.index(x): x not in tuple"],
    )


@pytest.mark.parametrize("word", ["unkown", ""])
def test_a_map_is_known_or_unknown(mrta: Mrta, word: str) -> None:
    status, lines = mrta(*RUN, "--map", word, *SHORT)
    assert status == 2
    assert "known" in lines[-1]


def test_robots_without_a_range_finder_cannot_be_asked_to_map(mrta: Mrta, yard: Path) -> None:
    scenario = yard / "scenario.yaml"
    scenario.write_text(scenario.read_text().replace("topic: scan", "topic: ranges"))
    status, lines = mrta("run", "yard", "--map", "unknown", *SHORT)
    assert (status, lines) == (
        2,
        [
            "mrta: --map unknown: robot1 has no sensor on the topic scan, by which it could map; "
            "give it sensors on pose and scan, or let the map be known"
        ],
    )
