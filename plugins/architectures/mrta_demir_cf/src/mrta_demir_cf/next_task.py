"""What a robot would do next: Algorithm 2 (DPTSS) of Sariel, Erdogan and Balch (2007), over what it believes.

The branches of the print are garbled; as read here:

    (T_R, t_S) = FormRoughSchedule(T_U)
    if t_S is none:                       wait idle
    elif t_S is my current task:          continue
    elif t_S is executed by another:      propose an exchange (T_U holds it only where that makes sense)
    else:                                 cancel what I hold, then REQUEST(t_S)

T_U are the tasks that are INITIAL or UNCERTAIN and the robot's current one, as far as it could carry them out now.
Differs from the paper:

* A task that is done anywhere is where the robot is.
* A robot that carries out a task that never ends counts in nobody's Eq. 1: it will not come.
* A task that nobody has taken for T_exec is passed over by those nearer to it that have been idle for as long: they
  cannot carry it out, whatever the reason, so Eq. 1 leaves them out for it. This serves only who has nothing else.
* With ``looks_ahead``, under the time objective, a robot that has nothing else takes what it reaches before each of the
  others, where those who carry something out come by way of that.
* What a robot holds is changed only for a task that is nearer by the margin.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Iterable, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from mrta_demir_cf.joint_plan import planned_route
from mrta_demir_cf.mind import Mind
from mrta_demir_cf.parameters import BALANCED, GREEDY, ROLLOUT
from mrta_demir_cf.planning.rough_schedule import rough_schedule
from mrta_demir_cf.planning.selection import select
from mrta_demir_cf.robot_model import RobotModel
from mrta_demir_cf.task_model import Position, TaskModel
from mrta_demir_cf.task_states import TaskBelief

if TYPE_CHECKING:
    from numpy.typing import NDArray

__all__ = ["Choice", "find_next"]


class Choice(NamedTuple):
    """What a robot would do next.

    Attributes:
        model: of the task.
        cost: what it costs the robot now [m].
    """

    model: TaskModel
    cost: float


def find_next(mind: Mind) -> Optional[Choice]:
    """Form the rough schedule and select; remembers the schedule in ``mind``.

    Args:
        mind: the robot's.

    Returns:
        The selected task; None if there is none.
    """
    if mind.position is None:
        return None
    candidates = [mind.tasks[task] for task in mind.definitions if _is_open(mind, mind.tasks[task])]
    rivals = [robot for robot in mind.robots.values() if robot.is_present and not _is_bound(mind, robot)]
    if mind.told.cost == ROLLOUT:
        schedule, choice = _imagined(mind, candidates, rivals)
    elif mind.told.cost == BALANCED:
        schedule = planned_route(mind, [model for model in candidates if not model.is_claimed], rivals)
        choice = Choice(schedule[0], mind.held_cost(schedule[0])) if schedule else None
    else:
        # Differs from the paper where the robot is greedy: Eq. 1 leaves nothing to those who are nearer.
        greedy = mind.told.cost == GREEDY
        schedule = candidates if greedy else _rough_schedule(mind, candidates, rivals)
        choice = _cheapest(mind, schedule)
    mind.schedule = tuple(_place(mind, model) for model in schedule)
    if choice is None and mind.mine is None and mind.told.looks_ahead and not mind.told.keeps_paths_short:
        choice = _cheapest(
            mind, [model for model in candidates if model.is_free and _reaches_first(mind, model, rivals)]
        )
    if choice is None and mind.mine is None:
        patience = mind.told.execution_timeout
        waiting = [model for model in candidates if model.is_free and mind.now - model.since > patience]
        awake = [robot for robot in rivals if mind.now - robot.active <= patience]
        choice = _cheapest(mind, _rough_schedule(mind, waiting, awake))
    return choice


def _is_open(mind: Mind, model: TaskModel) -> bool:
    """Tell whether a task of this robot is one of T_U."""
    if not (model.is_free or model.id == mind.mine or _is_worth_an_offer(mind, model)):
        return False
    # Tasks for several robots are not this architecture's (SR); one may still appear on line.
    return mind.definitions[model.id].robots == 1 and mind.is_applicable(model.id)


def _is_worth_an_offer(mind: Mind, model: TaskModel) -> bool:
    offers = mind.told.exchange and mind.mine is None and model.belief is TaskBelief.EXECUTING_OTHER
    if not offers or model.ordered or mind.now < model.offered + mind.told.execution_timeout:
        return False
    cost = mind.cost(model.id)
    return cost is not None and cost < (1.0 - mind.told.margin) * model.cost


def _is_bound(mind: Mind, robot: RobotModel) -> bool:
    task = mind.tasks.get(robot.task)
    return task is not None and task.perpetual and task.belief is TaskBelief.EXECUTING_OTHER


def _reaches_first(mind: Mind, model: TaskModel, rivals: Iterable[RobotModel]) -> bool:
    """Tell whether this robot's way to a task is shorter than that of all rivals by way of what they carry out."""
    goal = _place(mind, model)
    own = (math.dist(mind.position or goal, goal), mind.robot_id)
    return all(own < (_way_by_its_task(mind, robot, goal), robot.id) for robot in rivals)


def _way_by_its_task(mind: Mind, robot: RobotModel, goal: Position) -> float:
    start = robot.position or goal
    task = mind.tasks.get(robot.task)
    if task is None or task.place is None or task.holder != robot.id:
        return math.dist(start, goal)
    return math.dist(start, task.place) + math.dist(task.place, goal)


def _imagined(
    mind: Mind, models: Sequence[TaskModel], rivals: Iterable[RobotModel]
) -> Tuple[List[TaskModel], Optional[Choice]]:
    """Give what an imagined auction leaves to the robot, and the first task of its route (``planning.rollout``)."""
    from mrta_demir_cf.planning.rollout import Rollout

    told = [(model, cost) for model, cost in ((model, mind.cost(model.id)) for model in models) if cost is not None]
    if not told:
        return [], None
    place, robots = _places(mind, rivals)
    targets = np.array([_place(mind, model) for model, _ in told], dtype=np.float64)
    costs = np.array([cost for _, cost in told], dtype=np.float64)
    rule = Rollout(balance=not mind.told.keeps_paths_short)
    selection = rule(place, robots, targets, np.ones(len(told), np.bool_), distances=costs)
    schedule = [told[index][0] for index in selection.schedule.tolist()]
    return schedule, None if selection.chosen is None else Choice(*told[selection.chosen])


def _rough_schedule(mind: Mind, models: Sequence[TaskModel], rivals: Iterable[RobotModel]) -> List[TaskModel]:
    """Give the tasks that no rival is nearer to (Eq. 1), in their order."""
    if not models:
        return []
    place, robots = _places(mind, rivals)
    targets = np.array([_place(mind, model) for model in models], dtype=np.float64)
    mine = rough_schedule(place, robots, targets, np.ones(len(models), np.bool_))
    return [models[index] for index in mine.tolist()]


def _places(mind: Mind, rivals: Iterable[RobotModel]) -> Tuple[int, NDArray[np.float64]]:
    """Give which row this robot is, and where it and its rivals are, in the order of ids."""
    places = {robot.id: robot.position for robot in rivals}
    places[mind.robot_id] = mind.position
    ids = sorted(places)
    return ids.index(mind.robot_id), np.array([places[robot] for robot in ids], dtype=np.float64)


def _cheapest(mind: Mind, schedule: Sequence[TaskModel]) -> Optional[Choice]:
    """Give the task of a rough schedule that costs least by the robot's cost function."""
    told = [(model, cost) for model, cost in ((model, mind.cost(model.id)) for model in schedule) if cost is not None]
    if not told or mind.position is None:
        return None
    targets = np.array([_place(mind, model) for model, _ in told], dtype=np.float64)
    costs = np.array([cost for _, cost in told], dtype=np.float64)
    alone = np.array([mind.position], dtype=np.float64)
    everything = np.ones(len(told), np.bool_)
    chosen = select(0, alone, targets, everything, mind.told.cost_function(), distances=costs).chosen
    return None if chosen is None else Choice(*told[chosen])


def _place(mind: Mind, model: TaskModel) -> Position:
    return model.place or mind.position or (0.0, 0.0)
