"""Where a builder goes during one task: to a supply place, to its slot, out of the way."""

from __future__ import annotations

import math
from typing import Optional, Union

from block_construction.building.helpers import Helpers
from block_construction.building.journey import Journey
from block_construction.building.performer import Felt
from block_construction.building.routes import nearest, stand_off
from block_construction.building.slot import BlockTask, Fetch
from block_construction.building.state import BuilderState
from block_construction.building.supply import Supply
from block_construction.building.team_journey import TeamJourney, dock_before
from block_construction.building.teamwork import RECONSIDERED, Aside, Lingering, Team, choose_fetch
from rqt_mrta_py.hooks import Perception
from rqt_mrta_py.model import Pose, Twist

__all__ = ["Travel"]


class Travel:
    """Sets out, drives, and says so.

    Args:
        helpers: whom to ask.
        slot: what is to be placed.
        state: of the builder, kept up to date.
    """

    def __init__(self, helpers: Helpers, slot: BlockTask, state: BuilderState) -> None:
        self._helpers = helpers
        self._slot = slot
        self._state = state
        self._journey: Optional[Union[Journey, TeamJourney]] = None
        self._lingering: Optional[Lingering] = None
        self._aside: Optional[Aside] = None
        self._chosen = -math.inf

    def end(self) -> None:
        """Be where it is; the next drive sets out anew."""
        self._journey = None

    def choose(self, perception: Perception, felt: Felt, supply: Supply) -> Optional[Fetch]:
        """Give the supply place to go to; among others it is thought over while the robot waits.

        Args:
            perception: of the robot.
            felt: what it knows of itself.
            supply: of the task, told what is chosen.

        Returns:
            The place; None if all are empty.
        """
        before = supply.fetch
        waits = self._journey is not None and self._journey.is_waiting and self._helpers.team is not None
        if before is not None and not (waits and felt.now - self._chosen >= RECONSIDERED):
            return before
        self._chosen = felt.now
        fetch = supply.choose(self._best(perception, felt, supply))
        if fetch != before:
            self.end()
        return fetch

    def drive(self, perception: Perception, felt: Felt, block: Pose) -> Optional[Twist]:
        """Go to where a robot stands off a block.

        Args:
            perception: of the robot.
            felt: what it knows of itself.
            block: as the robot will face it.

        Returns:
            The velocities; None once it is there.
        """
        if self._journey is None:
            self._journey = self._set_out(block)
        journey = self._journey
        twist = journey.step(perception, felt.pose, self._helpers.site.covered)
        self._say(journey, "waiting" if journey.is_waiting else "driving")
        return twist

    def is_shut_in(self, perception: Perception, felt: Felt) -> bool:
        """Tell whether the robot has waited long, and teammates that have nothing to do leave it no way."""
        journey = self._journey
        covered = self._helpers.site.covered
        return isinstance(journey, TeamJourney) and journey.is_shut_in(perception, felt.pose, covered)

    def linger(self, perception: Perception, felt: Felt, team: Team) -> Optional[Twist]:
        """Make room for others, until there is more to do or another block waits for this one.

        Args:
            perception: of the robot.
            felt: what it knows of itself.
            team: of the robot.

        Returns:
            The velocities; None once it is time to end the task.
        """
        self._lingering = self._lingering or Lingering(team, self._state.task)
        return self._make_room(self._lingering, perception, felt)

    def go_aside(self, perception: Perception, felt: Felt, team: Team) -> Optional[Twist]:
        """Go where it is in nobody's way.

        Args:
            perception: of the robot.
            felt: what it knows of itself.
            team: of the robot.

        Returns:
            The velocities; None once it is there, or has tried for long enough.
        """
        aside = self._aside = self._aside or Aside(team)
        return None if aside.is_over else self._make_room(aside, perception, felt)

    def _make_room(self, way: Union[Aside, Lingering], perception: Perception, felt: Felt) -> Optional[Twist]:
        twist = way.step(perception, felt.pose, self._helpers.site)
        if way.journey is not None:
            self._say(way.journey, "idle")
        return twist

    def _best(self, perception: Perception, felt: Felt, supply: Supply) -> Optional[Fetch]:
        helpers, slot, places = self._helpers, self._slot, supply.open
        if helpers.team is not None:
            found = choose_fetch(helpers.team, slot, perception, felt.pose, helpers.site)
            if found is not None and found in places:
                return found
        return nearest(helpers.traffic, felt.pose, slot, places, helpers.site.covered) if places else None

    def _set_out(self, block: Pose) -> Union[Journey, TeamJourney]:
        team = self._helpers.team
        if team is None:
            return Journey(self._helpers.traffic, stand_off(block))
        return TeamJourney(team.traffic, team.board, dock_before(block), block.yaw)

    def _say(self, journey: Union[Journey, TeamJourney], activity: str) -> None:
        self._state.way, self._state.activity, self._state.action = journey.way, activity, ""
        self._state.goal = journey.goal if isinstance(journey, TeamJourney) else ()
