"""What a builder does that is not alone: it fetches where nobody is, and makes room once it has placed its block."""

from __future__ import annotations

import math
from typing import Mapping, NamedTuple, Optional

from block_construction.building.site_map import SiteMap
from block_construction.building.slot import BlockTask, Fetch
from block_construction.building.team_journey import TeamJourney, team_trip
from block_construction.team.berth import find_berth
from block_construction.team.board import TeamBoard
from block_construction.team.lingering import Placement, is_done
from block_construction.team.peers import Dock
from block_construction.team.traffic import Traffic
from rqt_mrta_py.hooks import Perception
from rqt_mrta_py.model import Pose, Twist

__all__ = ["RECONSIDERED", "Aside", "Lingering", "Team", "choose_fetch"]

RECONSIDERED = 5.0
"""Who waits thinks anew about where to fetch, or where to wait, after so long [s]."""
_LONGEST = 60.0
"""Who has not come aside after so long has tried for long enough [s]."""


class Team(NamedTuple):
    """What a builder needs that is not alone.

    Attributes:
        robot: its id.
        board: knows the teammates.
        traffic: plans ways among them.
        tasks: of the build, by id.
    """

    robot: str
    board: TeamBoard
    traffic: Traffic
    tasks: Mapping[str, Placement]


def choose_fetch(team: Team, slot: BlockTask, perception: Perception, pose: Pose, site: SiteMap) -> Optional[Fetch]:
    """Choose where a block is fetched, with teammates where they are; None if they leave no way to any place.

    Args:
        team: of the builder.
        slot: of the block.
        perception: of the robot.
        pose: where it is.
        site: what it knows of blocks.
    """
    trip, fetches = team_trip(team.board, team.traffic, slot, (perception, pose), site.covered)
    return None if trip is None else fetches[trip.supply]


class Aside:
    """Goes where it is in nobody's way, and stays there.

    Attributes:
        journey: to where it waits; None before the first step.
        is_over: whether it is there, or has tried for a minute.

    Args:
        team: of the builder.
    """

    def __init__(self, team: Team) -> None:
        self._team = team
        self._chosen = -math.inf
        self._begun = math.inf
        self.journey: Optional[TeamJourney] = None
        self.is_over = False

    def step(self, perception: Perception, pose: Pose, site: SiteMap) -> Twist:
        """Carry out one control tick.

        Args:
            perception: of the robot.
            pose: where it is.
            site: what it knows of blocks.
        """
        team, now, here = self._team, perception.now, (pose.x, pose.y)
        peers, driver = team.board.peers(perception), team.board.driver(team.traffic)
        self._begun = min(self._begun, now)
        at_rest = not driver.way or driver.way[-1].time <= now
        if self.journey is None or (at_rest and now - self._chosen >= RECONSIDERED):
            self._chosen = now
            berth = find_berth(team.traffic, here, site.covered, peers) or here
            self.journey = TeamJourney(team.traffic, team.board, Dock(*berth, *berth))
        twist = self.journey.step(perception, pose, site.covered)
        self.is_over = twist is None or now - self._begun >= _LONGEST
        return twist or Twist()


class Lingering:
    """Waits where it is in nobody's way, until there is more to do or another block waits for the one placed.

    Args:
        team: of the builder.
        task: id of the task whose block was placed.
    """

    def __init__(self, team: Team, task: str) -> None:
        self._team, self._task = team, task
        self._aside = Aside(team)

    @property
    def journey(self) -> Optional[TeamJourney]:
        """To where it waits; None before the first step."""
        return self._aside.journey

    def step(self, perception: Perception, pose: Pose, site: SiteMap) -> Optional[Twist]:
        """Carry out one control tick.

        Args:
            perception: of the robot.
            pose: where it is.
            site: what it knows of blocks.

        Returns:
            The velocities; None once the task is done.
        """
        team, aside, here = self._team, self._aside, (pose.x, pose.y)
        peers = team.board.peers(perception)
        if is_done((team.robot, self._task, here), team.tasks, site.standing, peers, is_aside=aside.is_over):
            team.board.driver(team.traffic).stand(perception.now, here)
            return None
        return aside.step(perception, pose, site)
