"""How a team stands, as another supervisor tells it: with this a supervisor begins that comes late.

What is taken over counts as long as it would if it had been heard when it was told: robots that are silent go offline,
and allocations that nobody speaks of expire.
"""

from __future__ import annotations

from typing import Any, List, Mapping, NamedTuple, Tuple

from rqt_mrta_py.hooks import Heard
from rqt_mrta_py.model import RobotState, TaskState, normalise_id
from rqt_mrta_py.supervisor.news import ROBOT_CODES, TASK_CODES
from rqt_mrta_py.supervisor.tasks import FINAL
from rqt_mrta_py.supervisor.team import Team

__all__ = ["TASK_STATES", "Standing", "assume", "standing_of"]

_ROBOT_STATES = {code: state for state, code in ROBOT_CODES.items()}
TASK_STATES = {code: state for state, code in TASK_CODES.items()}
"""States of tasks by their codes in messages."""


class Standing(NamedTuple):
    """A team at one moment.

    Attributes:
        time: the moment [s].
        robots: ids with states.
        tasks: ids with states.
        holds: robots with the tasks that they hold, by start.
    """

    time: float
    robots: Tuple[Tuple[str, RobotState], ...] = ()
    tasks: Tuple[Tuple[str, TaskState], ...] = ()
    holds: Tuple[Tuple[str, str], ...] = ()

    def __bool__(self) -> bool:
        """Tell whether it says anything."""
        return bool(self.robots or self.tasks or self.holds)


def standing_of(fields: Mapping[str, Any]) -> Standing:
    """Read a decoded ``rqt_mrta_py/TeamState``; what has a code that nobody has defined is left out."""
    robots = [(normalise_id(each["robot_id"]), each["state"]) for each in fields["robots"]]
    tasks = [(normalise_id(each["task_id"]), each["state"]) for each in fields["tasks"]]
    holds = [(normalise_id(each["robot_id"]), normalise_id(each["task_id"])) for each in fields["allocations"]]
    return Standing(
        float(fields["header"]["stamp"]),
        tuple((robot, _ROBOT_STATES[code]) for robot, code in robots if code in _ROBOT_STATES),
        tuple((task, TASK_STATES[code]) for task, code in tasks if task and code in TASK_STATES),
        tuple(holds),
    )


def assume(team: Team, told: Standing, heard: Heard, freshness: float, hold: float) -> Standing:
    """Take over what a team does not know by itself.

    Args:
        team: that has begun.
        told: what another supervisor says.
        heard: the message that says it.
        freshness: how long a robot's state counts [s].
        hold: how long an allocation counts [s].

    Returns:
        What was taken over: states of robots that have not said anything yet, what they hold, and tasks of which
        nothing was known. Nothing, if it tells of robots that are not of this team.
    """
    if any(team.find_robot(robot) is None for robot, _ in told.robots):
        return Standing(told.time)
    age = max(0.0, team.now - told.time)
    silent = {robot for robot, _ in told.robots if team.robots[robot].state is RobotState.OFFLINE}
    robots: List[Tuple[str, RobotState]] = []
    for robot, state in told.robots:
        if robot in silent and state is not RobotState.OFFLINE and age < freshness:
            team.renew(team.robots[robot], state, freshness - age)
            robots.append((robot, state))
    tasks: List[Tuple[str, TaskState]] = []
    for name, after in told.tasks:
        if name not in team.tasks:
            team.appear(name)
        task = team.tasks[name]
        if after in FINAL and task.state is TaskState.WAITING:
            team.change_task(task, after)
            tasks.append((name, after))
    holds: List[Tuple[str, str]] = []
    for robot, name in told.holds:
        task_there = name in team.tasks and not team.tasks[name].ended
        if robot in silent and task_there and age < hold and team.book.find(robot, name) is None:
            team.hold(team.robots[robot], team.tasks[name], hold - age, heard)
            holds.append((robot, name))
    held = dict.fromkeys(name for _, name in holds)
    tasks.extend((name, team.tasks[name].state) for name in held)
    return Standing(told.time, tuple(robots), tuple(tasks), tuple(holds))
