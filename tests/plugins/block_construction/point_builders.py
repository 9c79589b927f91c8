"""Builders as points that follow their ways exactly: coordination without a simulated world.

All step at the same moments; what one says in a step the others hear in the next. Fetching and placing take fixed
times, in which a robot goes from its dock to the place ahead of it and back. Tasks go to whoever is free and has the
least trip.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Dict, FrozenSet, List, Optional, Sequence, Set, Tuple

import numpy as np
from block_construction.diagram.diagram import AssemblyDiagram
from block_construction.execution.arena import Arena
from block_construction.execution.problem import BuildProblem
from block_construction.execution.supply import SupplyPlace, corner_places, stand_point
from block_construction.team.berth import find_berth
from block_construction.team.choice import Trip, best_trip
from block_construction.team.driver import Driver
from block_construction.team.lingering import Placement, is_done
from block_construction.team.peers import Dock, Peer, dock_at
from block_construction.team.timed_way import place_at
from block_construction.team.traffic import Post, Traffic

SPEED, RADIUS, STAND_OFF = 0.03, 0.18, 0.55
FETCHING, PLACING, LINGERING = 40.0, 55.0, 60.0
STEP = 0.5
NOWHERE = Dock(0.0, 0.0, 0.0, 0.0)
REACH = 0.42
"""From the middle of a block to that of the robot that holds it."""


@dataclass
class Build:
    """What is built, and where."""

    problem: BuildProblem
    below: Dict[int, Set[int]] = field(default_factory=dict)
    docks: Dict[int, Dock] = field(default_factory=dict)
    supplies: List[Tuple[Dock, FrozenSet[int]]] = field(default_factory=list)
    cells: Dict[int, FrozenSet[Tuple[int, int]]] = field(default_factory=dict)


def build_of(diagram: AssemblyDiagram, all_types: bool = True) -> Build:
    """Prepare a build with supply places in all corners."""
    arena = Arena(stand_off=STAND_OFF, start=(1.1, 0.2))
    units = [(1, 2, 3)] * 4 if all_types else [(2,), (1,), (3,), (3,)]
    problem = BuildProblem(diagram, corner_places(arena, units), arena)
    build = Build(problem)
    for block, approach in zip(diagram.blocks, problem.approaches):
        number, cells = block.number, {(cell.x, cell.y) for cell in block.placement.cells()}
        build.cells[number] = frozenset(cells)
        build.below[number] = {
            other.number
            for other in diagram.blocks
            if other.placement.z == block.placement.z - 1
            and cells & {(cell.x, cell.y) for cell in other.placement.cells()}
        }
        step = STAND_OFF - REACH
        ahead = (approach.point.x - approach.side.x * step, approach.point.y - approach.side.y * step)
        build.docks[number] = Dock(*approach.point, *ahead)
    for place in problem.places:
        build.supplies.append((_supply_dock(arena, place), frozenset(place.stock)))
    return build


def _supply_dock(arena: Arena, place: SupplyPlace) -> Dock:
    stand = stand_point(arena, place)
    share = REACH / STAND_OFF
    return Dock(*stand, place.x + (stand.x - place.x) * share, place.y + (stand.y - place.y) * share)


@dataclass
class Builder:
    """One robot."""

    id: str
    driver: Driver
    here: Tuple[float, float]
    task: int = 0
    until: float = 0.0
    doing: str = "idle"
    dock: Dock = NOWHERE
    slot: Dock = NOWHERE
    waited: float = 0.0
    driven: float = 0.0
    busy: float = 0.0

    def peer(self, docks: Sequence[Dock]) -> Peer:
        end = self.driver.way[-1]
        target = self.slot if self.doing in ("to_supply", "fetching", "to_slot") else None
        dock = dock_at((end.x, end.y), docks)
        task = str(self.task) if self.task else ""
        lingers = self.doing == "lingering"
        return Peer(self.id, self.driver.way, dock, self.driver.goal, target, self.doing == "idle", task, lingers)


class PointBuilders:
    """A team that builds."""

    def __init__(self, build: Build, robots: int, seed: int = 0) -> None:
        problem = build.problem
        self.build, self.now = build, 0.0
        posts = [Post(place.x, place.y, 0.06) for place in problem.places]
        self.traffic = Traffic(2.2, problem.site, RADIUS, SPEED, posts=posts, closed=robots > 1)
        chance = np.random.default_rng(seed)
        # Beside the supply docks, in the four sides' middles.
        starts = [(1.1, 0.25), (1.1, 1.95), (0.25, 1.1), (1.95, 1.1)]
        self.robots = []
        for number in range(robots):
            x, y = (value + chance.uniform(-0.05, 0.05) for value in starts[number])
            builder = Builder(f"robot{number + 1}", Driver(f"robot{number + 1}", self.traffic, SPEED), (x, y))
            builder.driver.stand(0.0, (x, y))
            self.robots.append(builder)
        self.placed: Set[int] = set()
        self.done: Set[int] = set()
        self.nearest = math.inf
        self.docks = [*build.docks.values(), *(dock for dock, _ in build.supplies)]
        self.tasks = {
            str(number): Placement(number, tuple(sorted(build.below[number])), dock)
            for number, dock in build.docks.items()
        }
        self._said: Dict[str, Peer] = {each.id: each.peer(self.docks) for each in self.robots}

    @property
    def covered(self) -> FrozenSet[Tuple[int, int]]:
        return frozenset(cell for number in self.placed for cell in self.build.cells[number])

    def run(self, longest: float = 20_000.0) -> bool:
        """Build until all is placed and everybody is done, or it takes too long, or nothing has moved for long."""
        quiet, count = 0.0, 0
        while len(self.done) < len(self.build.docks):
            before = (len(self.placed), tuple(each.here for each in self.robots))
            self.step()
            after = (len(self.placed), tuple(each.here for each in self.robots))
            quiet = quiet + STEP if after == before else 0.0
            count += 1
            if self.now > longest or quiet > 600.0:
                return False
        return True

    def step(self) -> None:
        self.now += STEP
        self._assign()
        said = {}
        for robot in self.robots:
            self._advance(robot)
            said[robot.id] = robot.peer(self.docks)
        self._said = said
        places = [each.here for each in self.robots]
        for number, one in enumerate(places):
            for other in places[:number]:
                self.nearest = min(self.nearest, math.dist(one, other))

    def _peers(self, robot: Builder) -> List[Peer]:
        return [peer for name, peer in self._said.items() if name != robot.id]

    def _open(self) -> List[int]:
        taken = {each.task for each in self.robots}
        return [
            number
            for number, below in self.build.below.items()
            if number not in self.placed and number not in taken and below <= self.done
        ]

    def _assign(self) -> None:
        free = [each for each in self.robots if not each.task]
        while free:
            offers = []
            for robot in free:
                for number in self._open():
                    trip = self._trip(robot, number)
                    if trip is not None:
                        offers.append((trip.cost, robot.id, number, trip.supply))
            if not offers:
                break
            _, name, number, supply = min(offers)
            robot = next(each for each in free if each.id == name)
            robot.task, robot.doing = number, "to_supply"
            robot.dock, robot.slot = self._supplies(number)[supply], self.build.docks[number]
            free.remove(robot)

    def _supplies(self, number: int) -> List[Dock]:
        units = self.build.problem.block(number).units
        return [dock for dock, types in self.build.supplies if units in types]

    def _trip(self, robot: Builder, number: int) -> Optional[Trip]:
        docks = (self._supplies(number), self.build.docks[number])
        return best_trip(self.traffic, robot.here, docks, self.covered, self._peers(robot))

    def _linger(self, robot: Builder) -> None:
        """After placing: be done once it is time, make room meanwhile."""
        own = (robot.id, str(robot.task), robot.here)
        # It may be there because it has not set out yet.
        lingers = self.now - robot.until
        is_aside = (lingers > STEP and robot.driver.is_there(self.now, robot.dock)) or lingers >= LINGERING
        if is_done(own, self.tasks, self.placed, self._peers(robot), is_aside=is_aside):
            self._finish(robot)
            return
        found = find_berth(self.traffic, robot.here, self.covered, self._peers(robot))
        if found is not None and robot.driver.way[-1].time <= self.now:
            robot.dock = Dock(*found, *found)

    def _finish(self, robot: Builder) -> None:
        self.done.add(robot.task)
        robot.task, robot.doing = 0, "idle"
        robot.driver.stand(self.now, robot.here)

    def _advance(self, robot: Builder) -> None:
        driver, dock = robot.driver, robot.dock
        if robot.doing in ("fetching", "placing"):
            robot.busy += STEP
            duration = FETCHING if robot.doing == "fetching" else PLACING
            share = 1.0 - abs(2.0 * (robot.until - self.now) / duration - 1.0)
            robot.here = _between(dock.place, dock.ahead, max(0.0, min(1.0, share * 1.5)))
            if self.now >= robot.until:
                robot.here = dock.place
                if robot.doing == "fetching":
                    robot.doing, robot.dock = "to_slot", self.build.docks[robot.task]
                else:
                    self.placed.add(robot.task)
                    robot.doing = "lingering"
                    robot.dock = Dock(*robot.here, *robot.here)
            return
        if robot.doing == "lingering":
            self._linger(robot)
            dock = robot.dock
        if robot.doing == "to_supply" and driver.goal is not None and (self.now * 2) % 10 == 0:
            trip = self._trip(robot, robot.task)
            if trip is not None:
                dock = robot.dock = self._supplies(robot.task)[trip.supply]
        if robot.doing == "idle":
            return
        before = robot.here
        driver.steer(self.now, robot.here, dock, self.covered, self._peers(robot))
        robot.here = place_at(driver.way, self.now)
        moved = math.dist(before, robot.here)
        assert moved <= SPEED * STEP * 1.001, (robot.id, before, robot.here)
        robot.driven += moved
        if moved == 0.0:
            robot.waited += STEP
        if driver.is_there(self.now, dock):
            if robot.doing == "lingering":
                return
            robot.doing = "fetching" if robot.doing == "to_supply" else "placing"
            robot.until = self.now + (FETCHING if robot.doing == "fetching" else PLACING)


def _between(one: Tuple[float, float], other: Tuple[float, float], share: float) -> Tuple[float, float]:
    return one[0] + share * (other[0] - one[0]), one[1] + share * (other[1] - one[1])
