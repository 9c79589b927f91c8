"""Small applications in the planar world whose robots and tasks lie elsewhere with every seed."""

from __future__ import annotations

import math
from enum import Enum
from pathlib import Path
from typing import Dict, List, Mapping, NamedTuple, Sequence, Tuple

import numpy as np

__all__ = ["EXPECTED_DURATION", "SENTINEL", "YARDS", "Yard", "YardKind", "write_yard"]

EXPECTED_DURATION = 25.0
"""Of each task that ends [s]; the longest way takes 15 s, and longer where robots meet."""

SENTINEL = "evening"
"""A task that appears as a mission ends: without it, the mission would end when all others are done."""

_MARGIN = 0.6
_APART = 0.9
_BESIDE = (0.5, 0.9)
"""How far a task comes up from the robot that it comes up beside [m]."""


class YardKind(Enum):
    """What there is to do.

    * ``watch``: three tasks that never end, for five robots, of which two alone can carry out the third.
    * ``errands``: six tasks that end, for three robots.
    * ``deadlines``: the same, and robots are told how long tasks take, if they can be.
    * ``arrivals``: tasks that end and come up one at a time, for five robots, beside one robot after another.
    """

    WATCH = "watch"
    ERRANDS = "errands"
    DEADLINES = "deadlines"
    ARRIVALS = "arrivals"


class Yard(NamedTuple):
    """What all yards of a kind have in common.

    Attributes:
        robots: how many.
        tasks: ids, in file order.
        perpetual: whether they never end.
        rare: the tasks that only the first two robots can carry out.
        sentinel: whether the task SENTINEL is there too.
        size: length and width [m].
        beside: whether tasks lie beside robots, one after another; else they lie anywhere.
    """

    robots: int
    tasks: Tuple[str, ...]
    perpetual: bool = False
    rare: Tuple[str, ...] = ()
    sentinel: bool = False
    size: Tuple[float, float] = (7.0, 5.0)
    beside: bool = False

    @property
    def robot_ids(self) -> Tuple[str, ...]:
        """Ids of the robots, in file order."""
        return tuple(f"robot{number}" for number in range(1, self.robots + 1))

    @property
    def every_task(self) -> Tuple[str, ...]:
        """Ids of all tasks, in file order."""
        return (*self.tasks, SENTINEL) if self.sentinel else self.tasks


_ERRANDS = Yard(3, ("bread", "coal", "letter", "milk", "salt", "wine"), sentinel=True)

YARDS: Mapping[YardKind, Yard] = {
    YardKind.WATCH: Yard(5, ("gate", "tower", "vault"), perpetual=True, rare=("vault",)),
    YardKind.ERRANDS: _ERRANDS,
    YardKind.DEADLINES: _ERRANDS,
    YardKind.ARRIVALS: Yard(5, ("first", "second", "third", "fourth", "fifth", "sixth"), size=(5.0, 4.0), beside=True),
}


def write_yard(folder: Path, kind: YardKind, seed: int) -> str:
    """Write the application to a folder of its own.

    Args:
        folder: that holds it; made if need be.
        kind: of yard.
        seed: decides where robots and tasks lie, and nothing else does.

    Returns:
        What an experiment takes for the application's name.
    """
    yard = YARDS[kind]
    random = np.random.default_rng([list(YardKind).index(kind), seed])
    starts = _strew(random, yard.size, [], yard.robots)
    if yard.beside:
        places = _beside(random, yard.size, starts, len(yard.every_task))
    else:
        places = _strew(random, yard.size, starts, len(yard.every_task))
    package = folder / f"{kind.value}_{seed}"
    package.mkdir(parents=True, exist_ok=True)
    files: Dict[str, str] = {
        "package.xml": _MANIFEST.format(name=f"{kind.value}_{seed}"),
        "rqt_mrta.xml": _application(yard),
        "tasks.yaml": "tasks:\n" + "".join(_task(yard, *each) for each in zip(yard.every_task, places)),
        "scenario.yaml": _scenario(yard) + "".join(_robot(*each) for each in zip(yard.robot_ids, starts)),
    }
    for name, text in files.items():
        (package / name).write_text(text, encoding="utf-8")
    return str(package)


_Spot = Tuple[float, float]

_DATA = "{speed: 0.5, patience: 600}"
"""Nobody gives up because something stands in the way for a while."""

_MANIFEST = """<package format="3">
  <name>{name}</name> <version>0.1.0</version> <description>A yard.</description>
  <maintainer email="nobody@example.org">nobody</maintainer> <license>Apache-2.0</license>
  <exec_depend>rqt_mrta_py</exec_depend>
  <export>
    <rqt_mrta_py application="${{prefix}}/rqt_mrta.xml" tasks="${{prefix}}/tasks.yaml"
                 scenario="${{prefix}}/scenario.yaml"/>
  </export>
</package>
"""

_SCENARIO = """world: planar
duration: 60
control_rate: 10
arena: {{min_x: -{x}, min_y: -{y}, max_x: {x}, max_y: {y}}}
obstacles: []
robot_defaults:
  sensors:
    - {{kind: localiser, topic: pose, rate: 10}}
    - {{kind: range_finder, topic: scan, rate: 5, rays: 24, fov: 6.283, max_range: 2.0}}
robots:
"""


def _scenario(yard: Yard) -> str:
    return _SCENARIO.format(x=yard.size[0] / 2.0, y=yard.size[1] / 2.0)


def _strew(random: np.random.Generator, size: Tuple[float, float], taken: Sequence[_Spot], number: int) -> List[_Spot]:
    """Find spots that are apart from each other, from those that are taken, and from the walls."""
    spots: List[_Spot] = []
    while len(spots) < number:
        spot = _spot(random, size)
        if all(math.dist(spot, other) >= _APART for other in (*taken, *spots)):
            spots.append(spot)
    return spots


def _beside(
    random: np.random.Generator, size: Tuple[float, float], starts: Sequence[_Spot], number: int
) -> List[_Spot]:
    """Find spots beside one start after another, in any order, each of them nearest to that start."""
    order = random.permutation(len(starts))
    spots: List[_Spot] = []
    while len(spots) < number:
        spot, start = _spot(random, size), starts[int(order[len(spots) % len(order)])]
        nearest = min(starts, key=lambda each: math.dist(each, spot))
        if nearest == start and _BESIDE[0] <= math.dist(spot, start) <= _BESIDE[1]:
            spots.append(spot)
    return spots


def _spot(random: np.random.Generator, size: Tuple[float, float]) -> _Spot:
    x, y = (side / 2.0 - _MARGIN for side in size)
    return round(float(random.uniform(-x, x)), 2), round(float(random.uniform(-y, y)), 2)


def _application(yard: Yard) -> str:
    robots = "".join(
        f"<robot_{number}><id>{robot}</id><tasks>"
        + "".join(f"<task_{place}><id>{task}</id></task_{place}>" for place, task in enumerate(_tasks_of(yard, number)))
        + f"</tasks></robot_{number}>"
        for number, robot in enumerate(yard.robot_ids)
    )
    return (
        '<rqt_mrta format="application"><application><name>Yard</name><architecture>mrta_alliance</architecture>'
        f"<robots>{robots}</robots></application><configs/></rqt_mrta>\n"
    )


def _tasks_of(yard: Yard, number: int) -> List[str]:
    return [task for task in yard.every_task if number < 2 or task not in yard.rare]


def _task(yard: Yard, task: str, spot: _Spot) -> str:
    ends = "perpetual: true" if yard.perpetual else f"expected_duration: {EXPECTED_DURATION}"
    place = f"{{x: {spot[0]}, y: {spot[1]}}}"
    return f"  - {{id: {task}, kind: go_to_place, place: {place}, {ends}, data: {_DATA}}}\n"


def _robot(robot: str, spot: _Spot) -> str:
    return f"  - {{id: {robot}, start: {{x: {spot[0]}, y: {spot[1]}}}}}\n"
