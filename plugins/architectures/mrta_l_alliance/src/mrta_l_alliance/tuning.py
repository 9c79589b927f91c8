"""From what is known to the parameters that ALLIANCE goes by: those of behaviour sets, and patience with others."""

from __future__ import annotations

from dataclasses import replace
from typing import Dict, Iterable, Mapping, Optional, Sequence

from mrta_alliance.parameters import BehaviourSetParameters

from mrta_l_alliance import equations
from mrta_l_alliance.equations import Category
from mrta_l_alliance.memory import Memory
from mrta_l_alliance.parameters import LearningParameters, Phase

__all__ = ["NEVER", "Outlook", "Tuning"]

NEVER = 1e9
"""Longer than any mission; announcements of infinite durations are not believed [s]."""

# What is announced or waited for must exceed theta / delta_fast, or it would slow nobody down.
_JUST_ABOVE = 1.01


class Outlook:
    """What one robot expects of itself and the others, by task.

    Args:
        robot_id: whose outlook it is.
        team: ids in the application's order, which decides ties.
        told: see there.
        memory: what is known.
        present: ids of the other robots that count.
    """

    def __init__(
        self, robot_id: str, team: Sequence[str], told: LearningParameters, memory: Memory, present: Iterable[str]
    ) -> None:
        self._robot_id = robot_id
        self._places = {robot: place for place, robot in enumerate(team)}
        self._told = told
        self._memory = memory
        self._present = [robot for robot in present if robot != robot_id]

    def time_of(self, robot: str, task: str) -> Optional[float]:
        """Give task_time_i(k, j, t) [s]; None if unknown."""
        return equations.task_time(self._memory.of(robot, task).times, self._told.deviations, self._told.least_spread)

    def own_time(self, task: str) -> Optional[float]:
        """Give task_time_i(i, j, t) [s]; None if unknown."""
        return self.time_of(self._robot_id, task)

    def others_times(self, task: str) -> Dict[str, float]:
        """Give the task times of the robots present of which they are known [s], by robot."""
        times = ((robot, self.time_of(robot, task)) for robot in self._present)
        return {robot: time for robot, time in times if time is not None}

    def category(self, task: str) -> Category:
        """Sort a task by who is expected to be quickest; of equals the first of the team is."""
        own = self.own_time(task)
        others = self.others_times(task)
        place = self._place(self._robot_id)
        first = all(self._place(robot) > place for robot, time in others.items() if time == own)
        return equations.category(own, others.values(), wins_ties=first)

    def waiting_time(self, task: str) -> float:
        """Give how long the robot must be idle to take a task that others are better at [s]."""
        return equations.waiting_time(self._told.boredom_delay, self.own_time(task), self.others_times(task).values())

    def _place(self, robot: str) -> int:
        return self._places.get(robot, len(self._places))


class Tuning:
    """Chooses the parameters of one robot's cycle.

    Args:
        told: how to learn.
        spin_rate: of the robot [Hz].
    """

    def __init__(self, told: LearningParameters, spin_rate: float) -> None:
        self._told = told
        self._spin_rate = spin_rate

    def exploring(
        self, told: BehaviourSetParameters, attempts: int, most: int, chance: float
    ) -> BehaviourSetParameters:
        """Choose the parameters of a behaviour set in the active learning phase (TM-13000, 6.3.1).

        The robot is minimally acquiescent: it yields to nobody and gives up only when it was told to.

        Args:
            told: its parameters under ALLIANCE.
            attempts: how often the robot was seen to attempt the task.
            most: the most attempts that any robot made at any task.
            chance: in [0, 1), this mission's for the task.
        """
        delay = equations.exploration_delay(attempts, most, chance, self._told.min_delay, self._told.max_delay)
        return self._tuned(told, delay, told.task_expected_duration, told.giving_up_delay, told.giving_up_delay)

    def adapted(
        self, told: Mapping[str, BehaviourSetParameters], outlook: Outlook
    ) -> Dict[str, BehaviourSetParameters]:
        """Choose the parameters of behaviour sets in the adaptive phase (TM-13000, 6.3.2, 7.1.3; Autonomous Robots).

        Impatience orders the tasks: those that the robot expects to be quickest at come first and among them the
        longest; of the others the shortest. Acquiescence follows strategy III, which gives each robot a fighting
        chance: it may take as long as it is itself expected to.

        Differs from the paper: delays are scaled over the tasks that are still open only, and in the first category
        over this robot's own tasks in it. The longest of those left is begun after min_delay, whatever the others need.

        Args:
            told: parameters under ALLIANCE of the behaviour sets whose tasks are open, by task.
            outlook: what the robot expects.
        """
        kinds = {task: outlook.category(task) for task in told}
        own = {task: outlook.own_time(task) for task in told}
        firsts = [time for task, time in own.items() if time is not None and kinds[task] is Category.FIRST]
        team = [time for task in told for time in outlook.others_times(task).values()]
        team += [time for time in own.values() if time is not None]
        chosen: Dict[str, BehaviourSetParameters] = {}
        for task, parameters in told.items():
            kind, time = kinds[task], own[task]
            if kind is Category.UNKNOWN:
                chosen[task] = parameters
                continue
            scale = firsts if kind is Category.FIRST else team
            low, high = min(scale), max(scale)
            # Reconstructed: of a task that only others are known to do the robot expects to be slowest.
            delay = equations.fast_delay(
                kind,
                high if time is None else time,
                low=low,
                high=high,
                min_delay=self._told.min_delay,
                max_delay=self._told.max_delay,
            )
            if time is None:
                duration, yielding, giving_up = (
                    parameters.task_expected_duration,
                    parameters.yielding_delay,
                    parameters.giving_up_delay,
                )
            else:
                giving_up = equations.giving_up_delay(time, self._told.giving_up_factor)
                duration = yielding = time
            chosen[task] = self._tuned(parameters, delay, duration, yielding, giving_up)
        return chosen

    def patience(self, task_time: Optional[float], announced: float, on_it_for: float, limit: float) -> float:
        """Give the expected duration by which ALLIANCE does to another robot what phi asks for.

        ALLIANCE lets motivation grow by theta / duration a cycle until the duration has passed in seconds, and fast
        from then on. So it is phi times spin rate as long as phi has not passed, and phi afterwards.

        Args:
            task_time: phi, what the other robot is expected to need; None: what it announces itself [s].
            announced: by the other robot [s].
            on_it_for: how long ago it first announced the task [s].
            limit: theta / delta_fast of this robot, which what is given always exceeds [1].
        """
        if self._told.phase is Phase.ACTIVE:
            return NEVER
        phi = announced if task_time is None else task_time
        duration = phi * self._spin_rate if on_it_for < phi else phi
        return max(duration, _JUST_ABOVE * limit)

    def _tuned(
        self, told: BehaviourSetParameters, delay: float, duration: float, yielding: float, giving_up: float
    ) -> BehaviourSetParameters:
        rate = equations.growth(told.threshold, delay, self._spin_rate)
        return replace(
            told,
            fast_rate=rate,
            task_expected_duration=max(duration, _JUST_ABOVE * told.threshold / rate),
            yielding_delay=yielding,
            giving_up_delay=giving_up,
        )
