"""What a robot would do next where the whole team keeps to one balanced plan (``planning.balanced_plan``).

Each robot makes the plan for itself, from what it believes; beliefs that differ make plans that differ. Then somebody
requests what was another's by one's own plan, the auction decides, and those to whom it is news plan anew, around what
is requested and carried out by then. A request for what another's route holds is therefore no fault, only news.
"""

from __future__ import annotations

import math
from typing import Dict, Iterable, List, Mapping, Sequence, Tuple

import numpy as np

from mrta_demir_cf.mind import Mind
from mrta_demir_cf.planning.balanced_plan import Plan, balanced_routes
from mrta_demir_cf.robot_model import RobotModel
from mrta_demir_cf.task_model import Position, TaskModel

__all__ = ["planned_route"]


def planned_route(mind: Mind, candidates: Sequence[TaskModel], rivals: Iterable[RobotModel]) -> List[TaskModel]:
    """Give what is left of the robot's own route, what it holds first; makes the plan anew if it does not stand.

    Args:
        mind: the robot's, which knows where it is; keeps the plan.
        candidates: tasks that the robot could carry out and that nobody else has claimed.
        rivals: the other robots that count.
    """
    places = {robot.id: robot.position for robot in rivals if robot.position is not None}
    places[mind.robot_id] = mind.position or (0.0, 0.0)
    claims = {model.id: model.holder for model in mind.tasks.values() if model.is_claimed and model.holder in places}
    if mind.mine is not None:
        claims[mind.mine] = mind.robot_id
    open_tasks = {model.id for model in candidates if mind.cost(model.id) is not None} | claims.keys()
    if not mind.plan.stands(places.keys(), open_tasks, claims):
        mind.plan = _planned(mind, places, sorted(open_tasks - claims.keys()), claims)
    return [mind.tasks[task] for task in mind.plan.left(mind.robot_id, open_tasks)]


def _planned(
    mind: Mind, places: Mapping[str, Position], free: Sequence[str], claims: Mapping[str, str]
) -> Plan[str, str]:
    """Plan for all from where each will be when it has done what it has claimed."""
    robots = sorted(places)
    heads: Dict[str, Tuple[str, ...]] = {}
    starts: List[Position] = []
    begun: List[float] = []
    for robot in robots:
        heads[robot] = tuple(sorted(task for task, holder in claims.items() if holder == robot))
        start, way = places[robot], 0.0
        for task in heads[robot]:
            place = mind.tasks[task].place or start
            start, way = place, way + math.dist(start, place)
        starts.append(start)
        begun.append(way)
    here = places[mind.robot_id]
    goals = [mind.tasks[task].place or here for task in free]
    routes = balanced_routes(np.array(starts), np.array(goals, dtype=np.float64).reshape(-1, 2), np.array(begun))
    return Plan({robot: (*heads[robot], *(free[row] for row in route)) for robot, route in zip(robots, routes)})
