"""An extension, off by default: perpetual tasks share a robot's time.

By the equations the set with the greatest fast rate wins each time that the robot is free, so a perpetual task with
a smaller one is never carried out while there are more tasks than robots. Parker leaves that to the designer; the
recording of the original nodes shows it. Here impatience is multiplied by

    1 + fairness_j x (served of the task served longest - served_j) / lambda_j

where served_j is for how long this robot knows the task to have been carried out, by itself or by others [s], and
the quotient is by how many turns of its own a task is behind. It quickens and never slows, so what the equations
promise of take-over still holds; and differences in served time stay bounded, so that shares of time become equal in
the long run. A task that becomes applicable begins at the least of those that are: nobody waits until it has made up
for its absence.
"""

from __future__ import annotations

from typing import Dict, Iterable, Mapping

from mrta_alliance.parameters import BehaviourSetParameters

__all__ = ["FairShares", "quickening"]


def quickening(fairness: float, behind: float, turn: float) -> float:
    """Give the factor on impatience of a task that is behind others.

    Args:
        fairness: of its behaviour set, at least 0; 0 follows the equations [1].
        behind: by how much less it has been carried out than the task served longest, at least 0 [s].
        turn: lambda, how long the robot carries it out at a stretch, above 0 [s].
    """
    return 1.0 + fairness * behind / turn


class FairShares:
    """How long each perpetual task has been carried out, as far as one robot knows."""

    def __init__(self) -> None:
        """Start with nothing carried out."""
        self._told: Dict[str, BehaviourSetParameters] = {}
        self._served: Dict[str, float] = {}
        self._open: Dict[str, None] = {}
        self._most = 0.0

    def follow(self, told: BehaviourSetParameters) -> None:
        """Let a perpetual task take part, or change its parameters.

        Args:
            told: parameters of its behaviour set; without fairness the task is counted but never quickened.
        """
        self._told[told.task_id] = told
        self._served.setdefault(told.task_id, 0.0)

    def pass_time(self, passed: float, applicable: Mapping[str, bool], carried_out: Iterable[str]) -> None:
        """Count the time since the cycle before.

        Args:
            passed: how long that is [s].
            applicable: by task, as of this cycle.
            carried_out: tasks that this robot or one that it heard of is on.
        """
        least = min((self._served[task] for task in self._open), default=0.0)
        now_open = {task: None for task in self._told if applicable.get(task, False)}
        for task in now_open:
            if task not in self._open:
                self._served[task] = max(self._served[task], least)
        self._open = now_open
        for task in carried_out:
            if task in self._open:
                self._served[task] += passed
        self._most = max((self._served[task] for task in self._open), default=0.0)

    def factor(self, task: str) -> float:
        """Give the factor on a task's impatience in this cycle, at least 1.

        Args:
            task: id of any task.
        """
        if task not in self._open:
            return 1.0
        told = self._told[task]
        return quickening(told.fairness, self._most - self._served[task], told.giving_up_delay)
