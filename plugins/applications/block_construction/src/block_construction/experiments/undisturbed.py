"""Builds by teams whose robots are never in each other's way, to hold what teams came to against."""

from __future__ import annotations

from functools import lru_cache
from typing import Mapping, NamedTuple, Tuple

from block_construction.building.place_block import PLANNED_SPEED, posts_of
from block_construction.building.procedures import STAND_OFF
from block_construction.diagram.block_set import PITCH
from block_construction.exact.planner import EXACT
from block_construction.mission.drawing import draw
from block_construction.mission.fetching import ready_blocks
from block_construction.mission.precedence import precedence
from block_construction.mission.settings import SETTINGS, read_build_settings
from block_construction.mission.starts import start_poses
from block_construction.team.speed_up import Handling, Job, Length, Schedule, list_schedule
from block_construction.team.traffic import Traffic

__all__ = ["Undisturbed", "undisturbed"]


class Undisturbed(NamedTuple):
    """A build without interference.

    Attributes:
        jobs: blocks by number.
        starts: where robots begin [m].
        length: measures ways.
        speed: of robots on their ways [m/s].
    """

    jobs: Mapping[int, Job]
    starts: Tuple[Tuple[float, float], ...]
    length: Length
    speed: float

    def schedule(self, robots: int, handling: Handling) -> Schedule:
        """Give the schedule of the first robots."""
        return list_schedule(self.jobs, self.starts[:robots], handling, self.length)

    def handling(self, time: float, fetching: float) -> Handling:
        """Fit what a block takes beside ways to what one robot took.

        Args:
            time: that one robot took for the build [s].
            fetching: of this, until blocks were drawn back from supply places [s].

        Returns:
            With it, and its own ways, the schedule of one robot takes as long; the part at supply places is what
            fetching took beyond the ways to them, never more than there is.
        """
        ways = self.schedule(1, Handling(0.0, 0.0, self.speed))
        whole = max(0.0, (time - ways.time) / len(self.jobs))
        there = (fetching - ways.fetching / self.speed) / len(self.jobs)
        at_supply = min(whole, max(0.0, there))
        return Handling(at_supply, whole - at_supply, self.speed)


@lru_cache(maxsize=None)
def undisturbed(structure: str, robots: int) -> Undisturbed:
    """Give the build of a structure of the library by up to so many robots, all lengths in all corners."""
    given = {"structure": structure, "supply": "corners_all", "order": "free"}
    values = {setting.name: given.get(setting.name, setting.default) for setting in SETTINGS}
    drawn = draw(read_build_settings(values, frozenset(given), robots), {"exact": EXACT}, lambda _: None)
    problem, ready = drawn.problem, ready_blocks(drawn.problem)
    before = precedence(problem)
    jobs = {
        block.number: Job(
            tuple(sorted(before[block.number])),
            problem.approaches[block.number - 1].point,
            tuple((each.place, each.stand(STAND_OFF)) for each in ready if each.units == block.units),
            frozenset((cell.x, cell.y) for cell in block.placement.cells()),
        )
        for block in problem.diagram.blocks
    }
    starts = tuple((pose.x, pose.y) for pose in start_poses(problem, ready, robots))
    arena = problem.arena
    posts = posts_of([(each.x, each.y) for each in ready])
    traffic = Traffic(arena.side, problem.site, arena.robot_radius, PLANNED_SPEED, PITCH, posts=posts)
    return Undisturbed(jobs, starts, traffic.length, PLANNED_SPEED)
