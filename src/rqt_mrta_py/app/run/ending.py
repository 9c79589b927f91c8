"""When a mission is over: at its duration, or a while after its last task has ended."""

from __future__ import annotations

import math
from typing import Optional

from rqt_mrta_py.hooks import Heard, Subscription
from rqt_mrta_py.model import Mission, Progress, normalise_id

__all__ = ["MissionEnd"]

_ENDS = (Progress.DONE, Progress.FAILED, Progress.WITHDRAWN)


class MissionEnd:
    """Notices that every task of a mission has ended, where its scenario lets it end then.

    Tasks that never end by themselves are not waited for; tasks that are still to appear are. A mission none of whose
    tasks ends by itself goes on to its duration.

    It goes by the stamps of what is told of tasks, so that a mission ends at the same tick however long messages take.

    Args:
        mission: with a scenario.
    """

    SUBSCRIPTION = Subscription(
        "/mrta/task_progress", "rqt_mrta_py/TaskProgress", ("task_id", "progress", "header/stamp")
    )
    """What has to be heard for it."""

    def __init__(self, mission: Mission) -> None:
        scenario = mission.scenario
        self._linger: Optional[float] = None if scenario is None else scenario.linger
        self._ending = frozenset(task.id for task in mission.every_task if not task.perpetual)
        self._unended = set(self._ending)
        self._newest = -math.inf

    @property
    def is_awaited(self) -> bool:
        """Tell whether the mission may end before its duration; otherwise nothing has to be heard."""
        return self._linger is not None and bool(self._ending)

    def hear(self, heard: Heard) -> None:
        """Take in a message of what is subscribed to."""
        self.take_in(*map(heard.fields.__getitem__, self.SUBSCRIPTION.fields))

    def take_in(self, task_id: str, code: int, stamp: float) -> None:
        """Take in what is told of a task.

        Args:
            task_id: as it was told.
            code: of its progress.
            stamp: of what was told [s].
        """
        progress, task = Progress.of_code(code), normalise_id(task_id)
        if progress is Progress.APPEARED and task in self._ending:
            self._unended.add(task)
        elif progress in _ENDS and task in self._unended:
            self._unended.remove(task)
            self._newest = max(self._newest, stamp)

    def is_over(self, now: float) -> bool:
        """Tell whether the mission is over.

        Args:
            now: stamp of the tick that has passed [s].
        """
        linger = self._linger
        return linger is not None and bool(self._ending) and not self._unended and now >= self._newest + linger
